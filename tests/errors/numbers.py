#!/usr/bin/env python3
"""A number, size or duration that is refused is refused by the name of its option, at every verb.

usage: numbers.py PROGRAM

Options are those of `changeover describe`; each is given far too large, beyond 64 bits, zero,
negative and unreadable beside arguments that are right. The program takes the value, or its message
names the option (or the parameter: "change = 0").
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

VALUES = {
    "number": ("18446744073709551615", "18446744073709551616", "10000000000", "0", "-1"),
    "size": ("99999999999T", "18446744073709551615", "x", "0"),
    "duration": ("1e300h", "99999999999999h", "x", "-1s"),
    "range": ("x", "9..3", "1..18446744073709551615", "0"),
}
CELLS = "--k 3 --v 5..6"
# What is right for a verb; those left out have a server, or no such option.
RIGHT = {
    "design": "9 4",
    "verify": "d.txt",
    "bounds": "9 4",
    "explain": "9 4",
    "search": "7 3 --time 0.1s",
    "classify": "6 3 5 --time 0.1s",
    "table": CELLS,
    "minima": "--k-from 3 --k-to 3 --v 5 --time 0.1s",
    "plan": "parts.csv --at-once 3 --test-cost 1 --change-cost 1 --time 0.1s",
    "expand": "d.txt",
    "draw": "9 4",
    "dossier": "9 4",
    "factorize": "6",
    "loadorder": "--items 9 --room 5",
    "catalog show": "9 4",
    "catalog list": CELLS,
    "catalog completeness": CELLS,
    "catalog export": CELLS,
    "catalog verify": CELLS + " --time 0.1s",
    "catalog improve": CELLS + " --time 0.1s --each 0.1s",
}
BESIDE = {
    ("loadorder", "--item-bytes"): "--items 9 --room 5 --fast-room 3",
    ("loadorder", "--worker"): "--items 9 --room 5 --workers 2",
    ("loadorder", "--memory"): "--sizes sizes.csv",
    ("loadorder", "--fast-memory"): "--sizes sizes.csv --memory 9",
    ("loadorder", "--threads"): "--items 9 --room 5 --time 0.1s",
}
ANSWERED = (0, 1, 10, 11, 12, 20, 21, 22, 30)
LONGEST = 120  # seconds


def commands(described):
    """Each verb with an option and its value, and the words one of which a refusal has."""
    for verb in described["verbs"]:
        typed = verb["typed"]
        right = RIGHT.get(typed)
        if right is None:
            continue
        for option in verb["options"]:
            name = option["names"][-1]
            for value in VALUES.get(option["kind"], ()):
                words = BESIDE.get((typed, name), right).split()
                if name in words:
                    at = words.index(name)
                    del words[at : at + 2]
                yield typed.split() + words + [name, value], (name, f"{name[2:]} = {value}")
        for at, argument in enumerate(verb["arguments"]):
            for value in VALUES["number"] if argument["kind"] == "number" else ():
                words = right.split()
                words[at] = value
                yield typed.split() + words, (value, argument["name"])


def main(program):
    faults = 0
    with tempfile.TemporaryDirectory() as folder:
        home = pathlib.Path(folder)
        environment = {
            **os.environ,
            "HOME": folder,
            "XDG_DATA_HOME": folder,
            "CHANGEOVER_CATALOG": str(home / "catalog.db"),
        }

        def run(words):
            return subprocess.run(
                [program, *words], cwd=folder, env=environment, capture_output=True, check=False,
                timeout=LONGEST,
            )

        (home / "d.txt").write_bytes(run(["design", "7", "3", "--format", "text"]).stdout)
        (home / "parts.csv").write_text("part,cost\na,1\nb,2\nc,3\nd,4\ne,5\n")
        (home / "sizes.csv").write_text("3\n4\n2\n5\n")
        tried = 0
        for words, names in commands(json.loads(run(["describe"]).stdout)):
            tried += 1
            done = run(words)
            said = done.stderr.decode(errors="replace").strip().split("\n")[-1]
            if done.returncode not in ANSWERED and not any(name in said for name in names):
                print(f"changeover {' '.join(words)}\n  exit code {done.returncode}: {said}")
                faults += 1
        print(f"{tried} command lines, {faults} refusals without the name of the option")
    return 1 if faults > 0 or tried == 0 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
