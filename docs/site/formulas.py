"""Formulas that pages write as plain text, for a site that can show them as formulas.

docs/theorems.md is also shown by the explorer and read in editors, so its formulas are text:
B_{i+1}, s², ⌈v/k⌉. Nothing is guessed here: what is not known is refused, and the page has to be
mended or the table below extended.
"""

import re

WORDS = {"if", "or", "and", "for", "blocks", "every", "hence"}
SYMBOLS = {
    "≤": r"\le ",
    "≥": r"\ge ",
    "<": "<",
    ">": ">",
    "=": "=",
    "+": "+",
    "−": "-",
    "±": r"\pm ",
    "·": r"\cdot ",
    "/": "/",
    "⌈": r"\lceil ",
    "⌉": r"\rceil ",
    "⌊": r"\lfloor ",
    "⌋": r"\rfloor ",
    "…": r"\dots ",
    "⊂": r"\subset ",
    "∪": r"\cup ",
    "Σ": r"\sum ",
    "ℓ": r"\ell ",
    "²": "^2",
    "³": "^3",
    "′": "'",
    "∎": r"\blacksquare ",
    "{": r"\{",
    "}": r"\}",
    "∈": r"\in ",
    "∋": r"\ni ",
    "∌": r"\not\ni ",
    "∩": r"\cap ",
    "|": "|",
    "π": r"\pi ",
    "(": "(",
    ")": ")",
    ",": ",",
    ".": ".",
    ":": ":",
    "*": "",
}


def line_to_latex(line: str) -> str:
    """One line of a formula. Raises ValueError at a sign or word that has no translation."""
    out, i = [], 0
    while i < len(line):
        here = line[i]
        script = re.match(r"[_^](\{[^{}]*\}|\d+|[A-Za-zℓ])", line[i:])
        word = re.match(r"[A-Za-z]+", line[i:])
        if script:
            inside = script.group(1)
            out.append(
                here + "{" + line_to_latex(inside[1:-1] if inside.startswith("{") else inside) + "}"
            )
            i += script.end()
        elif here == " ":
            gap = len(line[i:]) - len(line[i:].lstrip(" "))
            out.append(r"\quad " if gap >= 2 and out else " ")
            i += gap
        elif line[i + 1:i + 2] == "\u0304":
            out.append(rf"\bar{{{here}}}")
            i += 2
        elif word:
            letters = word.group()
            if letters in ("max", "min"):
                out.append("\\" + letters)
            elif letters in WORDS:
                out.append(rf"\text{{ {letters} }}")
            elif len(letters) <= 2:
                out.append(letters)
            else:
                raise ValueError(f"no translation of the word {letters!r} in the formula {line!r}")
            i += len(letters)
            if line[i:i + 1] == "\u0304":  # The mark is on the last letter only.
                i -= 1
                out[-1] = letters[:-1]
        elif here in SYMBOLS or here.isdigit():
            out.append(SYMBOLS.get(here, here))
            i += 1
        else:
            raise ValueError(f"no translation of {here!r} in the formula {line!r}")
    return "".join(out).strip()


def to_latex(text: str) -> str:
    """An indented formula; several lines are rows, and what is behind a * in a row is a column."""
    rows = []
    for line in text.split("\n"):
        formula, mark, condition = line.partition("*")
        if "\n" in text and mark:
            rows.append(f"{line_to_latex(formula.rstrip())} & {line_to_latex(condition)}")
        else:
            rows.append(line_to_latex(line))
    if len(rows) == 1:
        return rows[0]
    return "\\begin{array}{ll}\n" + " \\\\\n".join(rows) + "\n\\end{array}"


SCRIPT = re.compile(r"(?<=[\w)\]′*\u0304∞])(?<!_)([_^])(\{[^{}]*\}|\d+|[^\W\d_](?![^\W\d_])′?)")


def scripts(text: str) -> list:
    """The text in pieces ("", text), ("_", subscript), ("^", superscript), as the explorer has it:
    B_{i+1}, x_p, n^2; a word after a word is a name and no subscript (a_file)."""
    pieces, seen = [], 0
    for match in SCRIPT.finditer(text):
        if match.start() > seen:
            pieces.append(("", text[seen:match.start()]))
        inside = match.group(2)
        pieces.append((match.group(1), inside[1:-1] if inside.startswith("{") else inside))
        seen = match.end()
    if seen < len(text):
        pieces.append(("", text[seen:]))
    return pieces
