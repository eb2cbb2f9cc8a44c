"""What Doxygen is given in the place of a header says what the header says."""

import pathlib
import sys
import unittest

root = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(root / "docs" / "site"))
import doxygen_comments  # noqa: E402 (the path comes first)


class Comments(unittest.TestCase):
    def of(self, *lines):
        return doxygen_comments.of_cpp(list(lines))

    def test_the_head_of_a_header_is_its_file(self):
        self.assertEqual(
            self.of("// Blocks.", "//", "// More.", "#pragma once"),
            ["/// @file", "///", "/// Blocks.", "///", "/// More.", "", "#pragma once"],
        )

    def test_an_example_is_code_with_its_own_indentation(self):
        self.assertEqual(
            self.of(
                "/// Does:", "///", "///     if (a) {", "///       b();", "///     }", "void f();"
            ),
            [
                "/// Does:", "///", "///", "/// @code{.cpp}", "/// if (a) {", "///   b();", "/// }",
                "/// @endcode", "void f();",
            ],
        )

    def test_items(self):
        said = "\n".join(
            self.of(
                "// With:", "//   counting  linear", "//             and so on",
                "//   degree    even", "#pragma once",
            )
        )
        self.assertIn("- counting: linear", said)
        self.assertIn("- degree: even", said)
        self.assertNotIn("@code", said)

    def test_words_that_are_not_for_doxygen(self):
        self.assertIn(
            r"/// a \\hline, \<b>, \@home, `<b>`", self.of("// a \\hline, <b>, @home, `<b>`")
        )
        self.assertIn("/// @throws BadInput", self.of("/// @throws BadInput"))
        self.assertEqual(self.of("int a;  ///< for \\label"), ["int a;  ///< for \\\\label"])

    def test_a_comment_that_stands_alone_is_of_the_file_and_one_before_a_declaration_is_not(self):
        said = self.of(
            "// Head.", "#pragma once", "", "// Other formats.", "// And more.", "", "// private",
            "int a;",
        )
        self.assertEqual(
            said[5:],
            [
                "", "/// @file", "/// @details", "/// Other formats.", "/// And more.", "", "",
                "// private", "int a;",
            ],
        )

    def test_c(self):
        said = doxygen_comments.of_c(
            "/* Orders.\n *\n *     open();\n */\n/* One step. */\nstruct step {\n  int number; /* "
            "from 1 */\n};"
        )
        self.assertEqual(
            said,
            [
                "/// @file", "///", "/// Orders.", "///", "///", "/// @code{.c}", "/// open();",
                "/// @endcode", "", "/// One step.", "struct step {",
                "  int number; /**< from 1 */", "};",
            ],
        )

    def test_no_header_loses_words(self):
        headers = sorted((root / "include").rglob("*.hpp"))
        self.assertGreater(len(headers), 40)
        for header in headers:
            lines = header.read_text(encoding="utf-8").split("\n")
            before = "".join(c for c in "".join(lines) if c.isalnum())
            after = "".join(
                c
                for c in "".join(
                    line
                    for line in doxygen_comments.of_cpp(lines)
                    if not line.lstrip().startswith(
                        ("/// @file", "/// @code", "/// @endcode", "/// @details")
                    )
                )
                if c.isalnum()
            )
            self.assertEqual(before, after, header)


if __name__ == "__main__":
    unittest.main()
