"""The check of lines can fail: in prose, Python and CMake; it lets tables, code and data pass."""

import contextlib
import io
import pathlib
import tempfile
import unittest

import check_lines

LONG = "word " * 20 + "w"  # 101 columns
EDGE = LONG[:-1]  # 100 columns


class Lines(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def checked(self, text, name="docs/a.md"):
        """The lines that the check prints of a tree with one file, and its exit code."""
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        with contextlib.redirect_stdout(io.StringIO()) as said:
            code = check_lines.main([str(self.root)])
        path.unlink()
        return said.getvalue().splitlines(), code

    def test_prose(self):
        self.assertEqual(len(LONG), 101)
        for before in ("", "Words.\n", "- item\n    goes on\n    ", "```\ncode\n```\n", "$$x$$\n"):
            lines, code = self.checked(before + LONG + "\n")
            self.assertEqual((len(lines), code), (1, 1), before)
            self.assertTrue(lines[0].startswith("docs/a.md:"), lines[0])
        self.assertEqual(self.checked(EDGE + "\n"), ([], 0))

    def test_umlauts_are_one_column(self):
        self.assertEqual(self.checked("ü" * 100 + "\n"), ([], 0))

    def test_each_kind_of_file(self):
        for name in [
            "CMakeLists.txt", "dev", ".ci/run", "docs/site/a.py", "python/a.py", "src/CMakeLists.txt",
            "examples/lab/README.md", "CHANGELOG.md", "tests/docs/a.py", "python/a/b.pyi",
        ]:
            lines, code = self.checked("# short\n" + LONG + "\n", name)
            self.assertEqual(
                (lines, code), ([f"{name}:2: 101 columns; break the line at 100"], 1)
            )

    def test_what_may_be_longer(self):
        for text in [
            f"| {LONG} |\n", f"    {LONG}\n", f"<!-- slow -->\n    {LONG}\n", f"```\n{LONG}\n```\n", f"$$\n{LONG}\n$$\n",
            f"<!-- first: {LONG} -->\n", f"![{LONG}](a.svg)\n", f"## {LONG}\n",
        ]:
            self.assertEqual(self.checked(text), ([], 0), text)
        self.assertEqual(self.checked(f'    f"{LONG}",\n', "docs/a.py"), ([], 0))
        self.assertEqual(self.checked(f'    """{LONG}"""\n', "docs/a.py")[1], 1)

    def test_what_is_left_out(self):
        (self.root / "README.md").write_text("Short.\n", encoding="utf-8")
        for name in ["docs/errors.md", "python/changeover/a.py", "web/a.md", "docs/img/a.svg"]:
            self.assertEqual(self.checked(LONG, name), ([], 0), name)

    def test_an_empty_tree_is_no_success(self):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            self.assertEqual(check_lines.main([str(self.root)]), 1)
        self.assertIn("nothing to read", said.getvalue())
        with contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertEqual(check_lines.main([]), 2)
        self.assertIn("usage", said.getvalue())


if __name__ == "__main__":
    unittest.main()
