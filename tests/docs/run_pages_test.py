"""What runs the pages can fail: each kind of mark and of wrong output, on pages made here."""

import contextlib
import io
import pathlib
import tempfile
import unittest

import run_pages


class Pages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "examples").mkdir()
        (self.root / "part.txt").write_text("one\ntwo\nthree\n", encoding="utf-8")

    def ran(self, text, slow=False, write=False):
        """How many examples of a page were run, how many were wrong, and the page afterwards."""
        page = self.root / "page.md"
        page.write_text(text, encoding="utf-8")
        session = run_pages.Session(self.root, self.root, slow)
        with contextlib.redirect_stdout(io.StringIO()) as said:
            ran, wrong = run_pages.run_page(page, session, write)
        session.close()
        self.assertEqual(said.getvalue().count("page.md:"), wrong)
        return ran, wrong, page.read_text(encoding="utf-8")

    def right(self, text, examples=1, **how):
        self.assertEqual(self.ran(text, **how)[:2], (examples, 0), text)

    def wrong(self, text, **how):
        self.assertEqual(self.ran(text, **how)[1], 1, text)

    def test_output(self):
        self.right("    $ echo here\n    here\n")
        self.wrong("    $ echo here\n    there\n")
        self.wrong("    $ printf 'here\\nand there\\n'\n    here\n")
        self.wrong("    $ echo here\n    here\n    there\n")
        self.right("    $ printf 'a\\n\\nb\\n'\n    a\n\n    b\n\nText.\n")
        self.wrong("    $ echo here >&2\n    there\n")
        self.right("    $ echo a\n    a\n    $ echo b\n    b\n", 2)

    def test_what_may_differ(self):
        self.right("    $ printf 'a\\nb\\nc\\n'\n    a\n    …\n")
        self.right("    $ printf 'a\\nb\\nc\\n'\n    …\n    b\n    …\n")
        self.right("    $ echo a\n    a\n    …\n")
        self.wrong("    $ printf 'a\\nb\\nc\\n'\n    …\n    d\n    …\n")
        self.right("    $ echo 'a label 123abc'\n    a label …\n")
        self.wrong("    $ echo 'no label 123abc'\n    a label …\n")
        self.right(
            "    $ echo '3 blocks in 0.25 s on 2026-01-02'\n    3 blocks in 7.1 s on 2025-12-31\n"
        )
        self.wrong("    $ echo '4 blocks in 0.25 s'\n    3 blocks in 0.25 s\n")
        self.right(
            "    $ echo 'changeover: search; 9 k moves; 1:11 min, 4 s left' >&2; echo done\n    "
            "done\n"
        )

    def test_commands_without_output(self):
        self.right("    $ echo anything\n")
        self.right("    $ exit 10\n")
        self.wrong("    $ exit 3\n")

    def test_files(self):
        self.right("    $ cat new.txt\n    x y\n    $ wc -l < new.txt\n    1\n", 2)
        self.wrong("    $ echo x > new.txt\n\n    $ cat new.txt\n    y\n")

    def test_marks(self):
        self.right("<!-- not run: no such thing -->\n    $ no_such_thing\n", 0)
        self.right("<!-- slow -->\n    $ echo a\n    b\n", 0)
        self.wrong("<!-- slow -->\n    $ echo a\n    b\n", slow=True)
        self.right("<!-- first: echo a > given -->\n    $ cat given\n    a\n")
        self.wrong("<!-- first: exit 1 -->\n    $ echo a\n    a\n")
        self.right("<!-- needs: no_such_program -->\n    $ no_such_program\n    a\n", 0)
        self.right("<!-- needs: echo -->\n    $ echo a\n    a\n")
        with self.assertRaises(ValueError):
            self.ran("Text.\n<!-- slow -->\n\nText.\n")

    def test_options_of_quick_runs(self):
        program = self.root / "changeover"
        program.write_text('#!/bin/sh\necho "$@"\n', encoding="utf-8")
        program.chmod(0o755)
        page = "<!-- quick: --few 3 -->\n    $ changeover a\n    {}\n    $ echo b\n    b\n"
        self.right(page.format("a --few 3"), 2)
        self.wrong(page.format("a"))
        self.right(page.format("a"), 2, slow=True)
        self.wrong(page.format("a --few 3"), slow=True)

    def test_a_session_is_no_part_of_a_list(self):
        for before in ("- An item.\n", "1. An item\n   that goes on.\n"):
            with self.assertRaises(ValueError):
                self.ran(before + "\n    $ echo a\n    a\n")
        self.right("- An item.\n\nA sentence.\n\n    $ echo a\n    a\n")

    def test_code(self):
        self.right("<!-- is in: part.txt -->\n```c\none\ntwo\n```\n")
        self.wrong("<!-- is in: part.txt -->\n```c\none\nthree\n```\n")
        self.wrong("<!-- is in: missing.txt -->\n```c\none\n```\n")
        self.right("```cpp\nint one() { return 1; }\n```\n")
        self.wrong("```cpp\nint one() { return none; }\n```\n")
        self.right("```json\n{}\n```\n", 0)

    def test_writing(self):
        page = self.ran(
            "Before.\n\n    $ echo a\n    b\n    $ printf 'c\\n\\nd\\n'\n    ?\n\nAfter.\n",
            write=True,
        )[2]
        self.assertEqual(
            page,
            "Before.\n\n    $ echo a\n    a\n    $ printf 'c\\n\\nd\\n'\n    c\n\n    "
            "d\n\nAfter.\n",
        )


if __name__ == "__main__":
    unittest.main()
