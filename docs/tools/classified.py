#!/usr/bin/env python3
"""Writes catalog/classified.txt: how many designs there are with as few blocks as possible, cell by
cell, as `changeover classify` counts them within some seconds each.

    docs/tools/classified.py build/release/changeover > classified.txt

What takes longer is counted apart and added to the lines that are there:

    changeover classify 13 4 --change 1 --linear --json -o 13.4.json
    docs/tools/classified.py --add catalog/classified.txt 13.4.json > classified.txt
"""

import json
import os
import subprocess
import sys

SECONDS = 12
GIVE_UP_AFTER = 3  # cells in a row, of one block size, that take longer

HEAD = (
    "# How many designs there are with as few blocks as possible: written by "
    "docs/tools/classified.py, checked by\n"
    "# tests/search/enumerate. v, k, change, kind, blocks, standard forms, classes, tight classes; "
    "then for each order of a group\n"
    "# how many classes have it.\n"
)


def answer(program, *arguments):
    done = subprocess.run(
        [program, *arguments],
        capture_output=True,
        text=True,
        env=dict(os.environ, CHANGEOVER_CATALOG=""),
    )
    return json.loads(done.stdout)


def cells(program):
    found = []
    for change in (1, 2, 3):
        for kind in ("circular", "linear"):
            table = answer(
                program, "table", "--k", "3..8", "--v", "4..24", "--change", str(change),
                f"--{kind}", "--json",
            )
            found += [
                (c["b"] * c["v"] * c["k"], change, kind, c["k"], c["v"], c["b"])
                for c in table
                if c["status"] == "minimum" and c["b"] <= 60 and c["v"] > c["k"]
            ]
    return [cell[1:] for cell in sorted(found)]


def row(counted):
    groups = " ".join(
        f"{order}:{classes}"
        for order, classes in sorted(counted["group_orders"].items(), key=lambda each: int(each[0]))
    )
    keys = ("v", "k", "change", "kind", "b", "standard_forms", "classes", "tight")
    return " ".join(str(counted[key]) for key in keys) + " " + groups


def place(line):
    v, k, change, kind, *_ = line.split()
    return int(change), kind, int(k), int(v)


def whole(path):
    with open(path, encoding="utf-8") as file:
        counted = json.load(file)
    if not counted["complete"]:
        sys.exit(f"{path}: the count was stopped; only whole counts are kept")
    return row(counted)


def added(known, paths):
    with open(known, encoding="utf-8") as file:
        lines = [line.strip() for line in file if not line.startswith("#")]
    return {place(line): line for line in [*lines, *map(whole, paths)] if line}


def counted_anew(program):
    rows, late = {}, {}
    for change, kind, k, v, b in cells(program):
        if late.get((change, kind, k), 0) >= GIVE_UP_AFTER:
            continue
        counted = answer(
            program, "classify", str(v), str(k), str(b), "--change", str(change), f"--{kind}",
            "--json", "--quiet", "--time", f"{SECONDS}s", "--threads", "1",
        )
        if counted.get("complete"):
            rows[change, kind, k, v] = row(counted)
        late[change, kind, k] = 0 if counted.get("complete") else late.get((change, kind, k), 0) + 1
    return rows


def main():
    first, *rest = sys.argv[1:] or sys.exit(__doc__)
    rows = added(*rest[:1], rest[1:]) if first == "--add" and rest else counted_anew(first)
    print(HEAD + "\n".join(text for _, text in sorted(rows.items())))


if __name__ == "__main__":
    main()
