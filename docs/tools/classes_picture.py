#!/usr/bin/env python3
"""Draws docs/img/classes.svg: SCCD(v,5) by v modulo 16, blocks of the best known over the bound.

    docs/tools/classes_picture.py build/release/changeover > docs/img/classes.svg
"""
import json
import subprocess
import sys

COLOURS = ["#440154", "#21908C", "#FDE725"]  # none, one, two or more blocks over
SIDE, LEFT, TOP, BETWEEN = 22, 60, 104, 70
FIRST, LAST, CLASSES = 5, 160, 16


def cells(program: str, kind: str) -> dict[int, tuple[int, int]]:
    """Blocks, and blocks over the bound, by v."""
    answer = subprocess.run(
        [
            program, "table", "--k", "5..5", "--v", f"{FIRST}..{LAST}", "--change", "1",
            "--" + kind,
            "--json",
        ],
        check=True,
        capture_output=True,
        text=True,
    )
    return {
        row["v"]: (row["b"], row["b"] - row["lower_bound"])
        for row in json.loads(answer.stdout)
        if row["b"]
    }


def text(x: float, y: float, words: str, what: str = "") -> str:
    return f'<text x="{x:g}" y="{y:g}"{what}>{words}</text>'


def over(blocks: int) -> str:
    return "the lower bound" if blocks == 0 else f"{blocks} over the lower bound"


def main(program: str) -> None:
    width = LEFT + 2 * CLASSES * SIDE + BETWEEN + 16
    rows = LAST // CLASSES + 1
    height = TOP + rows * SIDE + 24
    muted, middle = (
        ' fill="#5A5A5A" font-size="11"',
        ' text-anchor="middle" fill="#5A5A5A" font-size="11"',
    )
    print(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
        f'viewBox="0 0 {width} {height}" role="img" fill="#1A1A1A" font-size="12" '
        "font-family=\"'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif\">"
    )
    print("<title>SCCD(v,5) by classes of v modulo 16</title>")
    print(
        "<desc>A square for each v, a column for each class modulo 16; its colour says how many "
        "blocks the best known design is over the lower bound.</desc>"
    )
    print(f'<rect width="{width}" height="{height}" fill="#FFFFFF"/>')
    print(text(16, 28, "SCCD(v,5) by classes of v modulo 16", ' font-size="14" font-weight="bold"'))
    x = 16
    for colour, words in zip(
        COLOURS, ("minimum: the lower bound", "one block over", "two blocks over")
    ):
        print(
            f'<rect x="{x}" y="40" width="12" height="12" fill="{colour}"/>'
            + text(x + 18, 50, words, muted)
        )
        x += 18 + 7 * len(words) + 12
    for number, kind in enumerate(("linear", "circular")):
        left = LEFT + number * (CLASSES * SIDE + BETWEEN)
        print(text(left, 78, kind, ' font-weight="bold"'))
        for c in range(CLASSES):
            print(text(left + (c + 0.5) * SIDE, TOP - 6, str(c), middle))
        for row in range(rows):
            print(
                text(
                    left - 8,
                    TOP + (row + 0.7) * SIDE,
                    str(CLASSES * row),
                    ' text-anchor="end" fill="#5A5A5A" font-size="11"',
                )
            )
        for v, (blocks, more) in sorted(cells(program, kind).items()):
            print(
                f'<rect x="{left + v % CLASSES * SIDE + 0.5:g}" '
                f'y="{TOP + v // CLASSES * SIDE + 0.5:g}" width="{SIDE - 1}" '
                f'height="{SIDE - 1}" fill="{COLOURS[min(more, 2)]}">'
                f"<title>{kind} SCCD({v},5): {blocks} blocks, {over(more)}</title></rect>"
            )
    print("</svg>")


if __name__ == "__main__":
    main(sys.argv[1])
