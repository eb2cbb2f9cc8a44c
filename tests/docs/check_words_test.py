"""The check of words can fail: for each word of its list, wherever it stands, and for no others."""

import contextlib
import io
import pathlib
import tempfile
import unittest

import check_words

# Each of the forbidden ways once, in the order of the list.
EXAMPLES = [
    "Nobody waits", "whoever asks", "if somebody writes", "it gives leave to write",
    "labels are not given away", "it began anew", "planned anew", "the dearest parts",
    "a file of its own", "wait for its end", "nothing else can come beside", "make items larger", "characters which are no text",
    "x is no key of an entry", "which format is that?", "what came of it",
    "is it one, and how good", "What is known is said here", "What the words mean",
    "Colour says what", "Point at a cell", "write a set-up a line", "9 parts called 1",
    "the results of --done blame", "Of course it is", "in order to see", "utilize it",
    "the length thereof",
]


class Words(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def checked(self, text, name="src/core/a.cpp"):
        """The lines that the check prints of a tree with one file, and its exit code."""
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        with contextlib.redirect_stdout(io.StringIO()) as said:
            code = check_words.main([str(self.root)])
        path.unlink()
        return said.getvalue().splitlines(), code

    def test_each_word_is_found(self):
        self.assertEqual(len(EXAMPLES), len(check_words.WORDS))
        for example, (_, better) in zip(EXAMPLES, check_words.WORDS):
            lines, code = self.checked(f"\n// Here {example}.\n")
            self.assertEqual((len(lines), code), (1, 1), example)
            self.assertTrue(lines[0].startswith("src/core/a.cpp:2: '"), lines[0])
            self.assertTrue(lines[0].endswith(f"; say: {better}"), lines[0])

    def test_each_room_is_read(self):
        for name in [
            "README.md", "src/a/b.hpp", "apps/a/main.c", "include/a.hpp", "python/a/b.py",
            "docs/schema/a.json", "docs/a.md", "docs/tools/a.sh", "web/src/a/b.ts", "CHANGELOG.md",
            "HACKING.md", "CONTRIBUTING.md", "SECURITY.md", "CMakeLists.txt", "dev", ".ci/run",
            ".ci/hooks/pre-commit", ".github/workflows/a.yml", "examples/a.cpp",
            "examples/lab/README.md", "pyproject.toml", "CITATION.cff", "bench/README.md",
            "cmake/a.cmake", "fuzz/a.cpp", "tests/a/b_test.cpp",
        ]:
            self.assertEqual(
                self.checked("nobody", name),
                ([f"{name}:1: 'nobody'; say: {check_words.WORDS[0][1]}"], 1),
            )

    def test_one_per_each(self):
        for words in ["a file a picture", "A colour a factor", "a script a kind", "a test a bench"]:
            self.assertEqual(self.checked(f"\n{words}\n")[1], 1, words)

    def test_over_the_end_of_a_line(self):
        for text in [
            "// they begin\n// anew\n",
            "/* begin\n * anew */\n",
            "# begin\n# anew\n",
            '"begin "\n    "anew"\n',
            "/// begin\n  ///    anew\n",
        ]:
            self.assertEqual(
                self.checked("\n" + text)[0],
                ["src/core/a.cpp:2: 'begin anew'; say: restart, start again"],
            )

    def test_each_place_is_named_in_order(self):
        lines, _ = self.checked("whoever\n\nwhoever, nobody\n")
        self.assertEqual(
            [line.split(";")[0] for line in lines],
            [
                "src/core/a.cpp:1: 'whoever'",
                "src/core/a.cpp:3: 'nobody'",
                "src/core/a.cpp:3: 'whoever'",
            ],
        )

    def test_plain_words_pass(self):
        for text in [
            "No thread waits; it is planned again.\n", "nobody_else, some-body, whoevers\n",
            "their whoever_\n", "one set-up per line; parts named 1\n", "the order to take\n",
        ]:
            self.assertEqual(self.checked(text), ([], 0), text)

    def test_what_is_left_out(self):
        (self.root / "README.md").write_text("Plain.\n", encoding="utf-8")
        for name in [
            "docs/theorems.md", "docs/style.md", "web/dist/a.js", "examples/corpus/a.txt",
            "tests/data/a.txt", "python/__pycache__/a.py", "docs/img/a.png",
        ]:
            self.assertEqual(self.checked("nobody", name), ([], 0), name)

    def test_an_empty_tree_is_no_success(self):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            self.assertEqual(check_words.main([str(self.root)]), 1)
        self.assertIn("nothing to read", said.getvalue())
        with contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertEqual(check_words.main([]), 2)
        self.assertIn("usage", said.getvalue())


if __name__ == "__main__":
    unittest.main()
