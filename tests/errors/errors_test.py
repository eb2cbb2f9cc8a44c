#!/usr/bin/env python3
"""errors_test.py BUILD: the checks of messages fail where they must."""

import pathlib
import sys
import tempfile
import unittest

import check_messages
import errors
import messages

BUILD = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
SOURCE = """\
// throw BadInput("this is a comment; leave it alone");
void f(const std::string& name, char c) {
  if (c == '"') {
    throw BadInput(fmt::format("{}: the colour is {{{}}}, "
                               "not red; paint it", name, c));
  }
}
"""
ROW = "# Paint\n\n$ changeover -x\n2 a.txt: the colour is {blue}, not red; paint it\n"


class Check(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("src/paint.cpp", SOURCE)
        self.write("tests/data/errors/paint.txt", ROW)
        self.write(
            "tests/paint_test.cpp", 'TEST(Paint, Is) { says("other words of a message"); }\n'
        )

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def faults(self):
        return check_messages.faults(self.root)[1]

    def throws(self, words):
        self.write("src/other.cpp", f"void g() {{ throw {words}; }}\n")

    def test_a_row_says_a_message_that_is_written_in_pieces(self):
        self.assertEqual(self.faults(), [])

    def test_a_row_with_other_words_does_not(self):
        self.write("tests/data/errors/paint.txt", ROW.replace("not red", "not green"))
        self.assertEqual(len(self.faults()), 1)
        self.assertIn("src/paint.cpp:4", self.faults()[0])

    def test_a_new_message_needs_a_row(self):
        self.throws('MissingResource("no paint is left; buy some")')
        self.assertEqual(len(self.faults()), 1)
        self.write(
            "tests/data/errors/more.txt",
            "# More\n\n$ changeover paint\n4 no paint is left; buy some\n",
        )
        self.assertEqual(self.faults(), [])

    def test_or_a_test_that_has_its_words(self):
        self.throws('BadInput("other words of a message; read them")')
        self.assertEqual(self.faults(), [])

    def test_words_of_two_messages_are_those_of_none(self):
        self.throws('BadInput("a brush is lost; some words of a message")')
        self.assertEqual(len(self.faults()), 1)
        self.write("tests/lost_test.cpp", 'TEST(Lost, Is) { says("; some words of a message"); }\n')
        self.assertEqual(self.faults(), [])
        self.write(
            "src/ladder.cpp",
            'void h() { throw BadInput("a ladder is lost; some words of a message"); }\n',
        )
        self.assertEqual(len(self.faults()), 2)

    def test_words_with_what_fills_them_do(self):
        self.throws('BadInput(fmt::format("row {} has {} twice", n, m))')
        self.assertEqual(len(self.faults()), 1)
        self.write("tests/row_test.cpp", 'TEST(Row, Is) { says("row 1 has column 0 twice"); }\n')
        self.assertEqual(self.faults(), [])

    def test_and_so_does_the_page_of_limits(self):
        self.throws('BadInput(fmt::format("{} pots; buy {} at most", n, m))')
        self.write("docs/limits.md", "| pots | 9 | `10 pots; buy 9 at most` |\n")
        self.assertEqual(self.faults(), [])

    def test_a_reason_for_what_a_test_holds_is_a_fault(self):
        self.throws('BadInput("other words of a message; read them")')
        self.write(
            "tests/data/errors/elsewhere.txt",
            "other words of a message; read them\n    needs luck\n",
        )
        self.assertEqual(len(self.faults()), 1)

    def test_or_a_reason_and_a_test_that_is_there(self):
        self.throws('MissingResource("no paint is left; buy some")')
        for reason, faults in (
            ("    needs an empty shop\n", 0),
            ("", 2),
            ("    tests/shop_test.cpp\n", 1),
            ("    tests/paint_test.cpp\n", 0),
        ):
            self.write("tests/data/errors/elsewhere.txt", "no paint is left; buy some\n" + reason)
            self.assertEqual(len(self.faults()) > 0, faults > 0, (reason, self.faults()))

    def test_a_reason_for_nothing_is_a_fault(self):
        self.write("tests/data/errors/elsewhere.txt", "no such words; find them\n    needs luck\n")
        self.assertEqual(len(self.faults()), 1)

    def test_words_are_found_behind_variables_and_functions(self):
        for source in (
            'void g() { const std::string why = first ? "no paint is left" : "no brush is left";\n throw BadInput(why); }\n',
            'std::string paint_defect(int n) { return "no paint is left"; }\n',
            '[[noreturn]] void stop(int n);\nvoid g() { stop("no paint is left"); }\n',
            'void g() { fail(at, fmt::format("no paint {} left", n)); }\n',
        ):
            self.write("src/other.cpp", source)
            self.assertGreaterEqual(len(self.faults()), 1, source)

    def test_words_that_come_from_nowhere_are_a_fault(self):
        self.throws("BadInput(secret(n))")
        self.assertEqual(len(self.faults()), 1)

    def test_a_bug_of_ours_needs_no_row(self):
        self.throws('InternalError("paint ran uphill somehow")')
        self.assertEqual(self.faults(), [])

    def test_python_is_read_too(self):
        self.write(
            "python/changeover/paint.py",
            'def f(n):\n    raise ValueError(f"{n} colours are too many; mix them")\n',
        )
        found, _ = messages.of_sources(self.root)
        self.assertIn("{} colours are too many; mix them", [message.shown for message in found])


class Table(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / errors.TABLE / "x.txt"
        self.path.parent.mkdir(parents=True)
        self.root = pathlib.Path(folder.name)

    def run_table(self, text):
        self.path.write_text(text, encoding="utf-8")
        return errors.run_section(errors.parsed(self.path), BUILD, False)

    def test_what_is_said_is_compared_word_for_word(self):
        row = "# X\n\nfile a.txt\n    0 1\n    0\n\n$ changeover verify a.txt\n{} {}\n"
        self.assertEqual(self.run_table(row.format(3, "…")), [])
        said = "a.txt:2:2: "
        self.assertEqual(self.run_table(row.format(3, said + "…")), [])
        self.assertEqual(len(self.run_table(row.format(4, said + "…"))), 1)
        self.assertEqual(len(self.run_table(row.format(3, "a.txt:2:3: …"))), 1)
        self.assertEqual(len(self.run_table(row.format(3, said))), 1)

    def test_a_command_that_succeeds_is_a_fault(self):
        self.assertEqual(len(self.run_table("# X\n\n$ changeover --version\n2 …\n")), 1)

    def test_a_message_beside_an_answer_is_a_fault(self):
        self.assertEqual(len(self.run_table("# X\n\n$ echo no >&2; echo yes; exit 2\n2 no\n")), 1)

    def test_python_says_its_class(self):
        self.assertEqual(
            self.run_table("# X\n\n>>> changeover.design(4, 9)\nImpossibleParameters k = 9 …\n"), []
        )
        self.assertEqual(
            len(self.run_table("# X\n\n>>> changeover.design(4, 9)\nBadInput k = 9 …\n")), 1
        )

    def test_what_is_not_understood_is_said(self):
        for text in (
            "no heading\n",
            "# X\n\n$ changeover\n",
            "# X\n\n$ changeover\nno code\n",
            "# X\n\nfiles a\n",
        ):
            self.path.write_text(text, encoding="utf-8")
            with self.assertRaises(ValueError, msg=text):
                errors.parsed(self.path)

    def test_the_page_has_each_row(self):
        self.path.write_text(
            "# X\nText.\n\n$ changeover `x`\n2 no; stop\n  Why.\n", encoding="utf-8"
        )
        page = errors.page(self.root)
        for words in ("## X", "Text.", "`no; stop`", "`` changeover `x` ``", "Why."):
            self.assertIn(words, page)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
