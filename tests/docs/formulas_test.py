"""Formulas of the pages as TeX: nothing is lost, nothing is guessed."""

import pathlib
import re
import sys
import unittest

root = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(root / "docs" / "site"))
import formulas  # noqa: E402 (the path comes first)


class Formulas(unittest.TestCase):
    def same(self, text, latex):
        self.assertEqual(formulas.to_latex(text).replace(" ", ""), latex.replace(" ", ""))

    def test_signs(self):
        self.same("b ≥ ⌈(v−k)/m⌉ + 1", r"b \ge \lceil (v-k)/m \rceil + 1")
        self.same("Σ_x max(0, s² − i_x)", r"\sum_{x} \max(0, s^2 - i_{x})")
        self.same("A = {0, …, n−1} ⊂ Z_v", r"A = \{0, \dots, n-1\} \subset Z_{v}")
        self.same("x_p − x\u0304_q = B_{c−1,j}", r"x_{p} - \bar{x}_{q} = B_{c-1,j}")
        self.same(
            "x_p = pN,   *for every* s ≥ 1", r"x_{p} = pN, \quad \text{for}\text{every} s \ge 1"
        )

    def test_rows(self):
        self.same(
            "2v    *if v ≤ 2k,*\n3v    *if v > 2k.*",
            "\\begin{array}{ll}\n2v & \\text{if} v \\le 2k, \\\\\n3v & \\text{if} v > "
            "2k.\n\\end{array}",
        )

    def test_nothing_is_guessed(self):
        for unknown in ("a ⊕ b", "the minimum", "a & b", "\\alpha", "50 %"):
            with self.assertRaises(ValueError, msg=unknown):
                formulas.to_latex(unknown)

    def test_every_formula_of_the_theorems(self):
        blocks = re.findall(
            r"(?:^    \S.*\n)+", (root / "docs/theorems.md").read_text(encoding="utf-8"), re.M
        )
        self.assertGreater(len(blocks), 8)
        for block in blocks:
            text = "\n".join(line[4:] for line in block.rstrip("\n").split("\n"))
            latex = formulas.to_latex(text)
            # Every digit and every letter that is not of a word is there, in the same order.
            plain = re.sub(r"\\begin\{array\}\{ll\}|\\end\{array\}", "", latex)
            plain = re.sub(
                r"\\text\{([^}]*)\}|\\bar\{(.)\}|\\(max|min)|\\[a-z]+",
                lambda m: m.group(1) or m.group(2) or m.group(3) or "",
                plain,
            )
            kept = "".join(re.findall(r"[A-Za-z0-9]", plain))
            wanted = "".join(re.findall(r"[A-Za-z0-9]", text.replace("²", "2").replace("³", "3")))
            self.assertEqual(kept, wanted)

    def test_indices(self):
        self.assertEqual(
            formulas.scripts("B_{i+1} of a_file"), [("", "B"), ("_", "i+1"), ("", " of a_file")]
        )
        self.assertEqual(
            formulas.scripts("Z_13, n^2 and i_x(k−1)"),
            [
                ("", "Z"),
                ("_", "13"),
                ("", ", n"),
                ("^", "2"),
                ("", " and i"),
                ("_", "x"),
                ("", "(k−1)"),
            ],
        )
        self.assertEqual(formulas.scripts("all_pairs and _x"), [("", "all_pairs and _x")])


if __name__ == "__main__":
    unittest.main()
