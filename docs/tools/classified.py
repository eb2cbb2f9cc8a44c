#!/usr/bin/env python3
"""Writes catalog/classified.txt anew: how many designs there are with as few blocks as possible, cell by cell, as
`changeover classify` counts them within some seconds each.

    docs/tools/classified.py build/release/changeover > catalog/classified.txt
"""

import json
import os
import subprocess
import sys

SECONDS = 12
GIVE_UP_AFTER = 3  # cells in a row, of one block size, that take longer

HEAD = """# How many designs there are with as few blocks as possible: written by docs/tools/classified.py, checked by
# tests/search/enumerate. v, k, change, kind, blocks, standard forms, classes, tight classes; then for each order of a group
# how many classes have it.
"""


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


def main():
    program = sys.argv[1]
    rows, late = [], {}
    for change, kind, k, v, b in cells(program):
        if late.get((change, kind, k), 0) >= GIVE_UP_AFTER:
            continue
        counted = answer(
            program, "classify", str(v), str(k), str(b), "--change", str(change), f"--{kind}",
            "--json", "--quiet", "--time", f"{SECONDS}s", "--threads", "1",
        )
        if counted.get("complete"):
            rows.append(((change, kind, k, v), row(counted)))
        late[change, kind, k] = 0 if counted.get("complete") else late.get((change, kind, k), 0) + 1
    print(HEAD + "\n".join(text for _, text in sorted(rows)))


if __name__ == "__main__":
    main()
