#!/usr/bin/env python3
"""Measures shares of all pairs: loads of the busiest worker over the bound, by C·sqrt(W)/P.

    docs/tools/share_region.py build/release/changeover region.csv

One run of the program for each number of items, room and workers: items 256, 1024, 4096; rooms P/32
… P in half octaves; 4 to 64 workers (every fifth with a last argument 5). Prints a summary; the
file has a row for each.
"""

import concurrent.futures
import csv
import json
import math
import subprocess
import sys


def measured(program, items, room, workers):
    made = subprocess.run(
        [
            program, "loadorder", "--items", str(items), "--room", str(room), "--workers",
            str(workers), "--worker", "0", "--json", "--quiet",
        ],
        capture_output=True,
        text=True,
        check=True,
    )
    head = json.loads(made.stdout.split("\n", 1)[0])
    pairs = head["pairs_per_worker"]
    return {
        "items": items,
        "room": room,
        "workers": workers,
        "x": room * math.sqrt(workers) / items,
        "loads": head["makespan"],
        "bound": head["makespan_bound"],
        "over": head["makespan"] / head["makespan_bound"],
        "pairs_over_mean": pairs["max"] / pairs["mean"],
        "method": head["method"],
    }


def main():
    program, path = sys.argv[1], sys.argv[2]
    step = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    cases = [(items, max(2, round(items / 2 ** (i / 2))), workers)
             for items in (256, 1024, 4096) for workers in range(4, 65, step) for i in range(11)]
    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        rows = list(pool.map(lambda case: measured(program, *case), cases))
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, rows[0].keys())
        table.writeheader()
        table.writerows(rows)
    for items in (256, 1024, 4096):
        of = [row for row in rows if row["items"] == items]
        worst = max(of, key=lambda row: row["over"])
        print(
            f"P = {items}: mean {sum(row['over'] for row in of) / len(of):.4f}, "
            f"worst {worst['over']:.3f} "
            f"at C = {worst['room']}, W = {worst['workers']} ({worst['method']}); "
            f"{sum(row['over'] > 1.15 for row in of)} of {len(of)} above 1.15, "
            f"{sum(row['over'] > 1.25 for row in of)} above 1.25; "
            f"pairs at most {max(row['pairs_over_mean'] for row in of):.3f} of the mean"
        )


main()
