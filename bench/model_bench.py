#!/usr/bin/python3
"""Models of parameters against PICT, in one run: how many tests, and how many values they change in
their order.

usage: python3 bench/model_bench.py CHANGEOVER PICT [SECONDS]

CHANGEOVER and PICT are programs. The models are those that PICT's authors publish figures of:
parameters by their numbers of values, without rules. PICT runs with its own seed and with twenty
others, and the run with the fewest tests, and then the fewest changes, counts. Ours has one thread
and SECONDS for a model. Changes are counted here, from the tests that both write.
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import time

models = {
    "3^4": {3: 4},
    "3^13": {3: 13},
    "4^15 3^17 2^29": {4: 15, 3: 17, 2: 29},
    "4^1 3^39 2^35": {4: 1, 3: 39, 2: 35},
    "2^100": {2: 100},
    "10^20": {10: 20},
}
seeds = 20


def text_of(shape):
    sizes = [size for size, count in shape.items() for _ in range(count)]
    return (
        "".join(
            f"P{i}: {', '.join(f'v{i}_{j}' for j in range(size))}\n" for i, size in enumerate(sizes)
        ),
        sizes,
    )


def changes(rows):
    """Values that are set: all of the first test, and then those that are others than before."""
    return len(rows[0]) + sum(
        a != b for before, row in zip(rows, rows[1:]) for a, b in zip(before, row)
    )


def check(rows, sizes):
    met = {(i, row[i], j, row[j]) for row in rows for i in range(len(row)) for j in range(i)}
    wanted = sum(sizes[i] * sizes[j] for i in range(len(sizes)) for j in range(i))
    if len(met) != wanted or any(len(row) != len(sizes) for row in rows):
        sys.exit(f"{len(met)} of {wanted} pairs")


def main():
    ours, pict = (str(pathlib.Path(program).resolve()) for program in sys.argv[1:3])
    seconds = float(sys.argv[3]) if len(sys.argv) > 3 else 20
    print(
        "| model | PICT: tests | changes | s | ours: tests | no fewer than | changes | of PICT's | "
        "s |"
    )
    print("|:---|---:|---:|---:|---:|---:|---:|---:|---:|")
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "model.txt"
        for name, shape in models.items():
            text, sizes = text_of(shape)
            file.write_text(text)
            runs = []
            begun = time.monotonic()
            for seed in range(seeds + 1):
                out = subprocess.run(
                    [pict, file, *([f"/r:{seed}"] if seed else [])],
                    check=True,
                    capture_output=True,
                    text=True,
                ).stdout
                rows = [line.split("\t") for line in out.splitlines()[1:]]
                check(rows, sizes)
                runs.append((len(rows), changes(rows)))
            theirs, their_time = min(runs), (time.monotonic() - begun) / len(runs)
            begun = time.monotonic()
            words = ["--time", f"{seconds}s", "--threads", "1", "--format", "csv"]
            sheet = planned(ours, file, *words)
            our_time = time.monotonic() - begun
            table = list(csv.DictReader(sheet.splitlines()))
            rows = [[row[f"P{i}"] for i in range(len(sizes))] for row in table]
            check(rows, sizes)
            bound = bound_of(ours, file)
            print(
                f"| {name} | {theirs[0]} | {theirs[1]} | {their_time:.1f} | {len(rows)} | {bound} "
                f"| {changes(rows)} | "
                f"{changes(rows) / theirs[1]:.0%} | {our_time:.1f} |",
                flush=True,
            )


def planned(ours, file, *words):
    command = [ours, "plan", "--model", file, "--objective", "tests", "--quiet", *words]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def bound_of(ours, file):
    answer = planned(ours, file, "--steps", "1", "--json")
    return json.loads(answer)["lower_bound"]["tests"]


if __name__ == "__main__":
    main()
