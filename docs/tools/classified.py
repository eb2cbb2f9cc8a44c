#!/usr/bin/env python3
"""Writes src/catalog/entry/classified.cpp anew: how many designs there are with as few blocks as possible, cell by cell, as
`changeover classify` counts them within some seconds each.

    docs/tools/classified.py build/release/changeover | clang-format-14 > src/catalog/entry/classified.cpp
"""

import json
import os
import subprocess
import sys

SECONDS = 12
GIVE_UP_AFTER = 3  # cells in a row, of one block size, that take longer

HEAD = """// How many designs there are: written by docs/tools/classified.py, checked by tests/search/enumerate.
#include <array>

#include "changeover/catalog/catalog.hpp"

namespace changeover {
namespace {

constexpr Kind in_line = Kind::linear;
constexpr Kind in_circle = Kind::circular;

// Parameters, blocks, standard forms, classes, tight classes; then for each order of a group how many classes have it.
constexpr std::array classified_counts{
"""

FOOT = """};

}  // namespace

std::optional<Classified> classified(const Parameters& p, std::uint64_t b) {
  for (const Classified& each : classified_counts) {
    if (each.parameters == p && each.b == b) {
      return each;
    }
  }
  return std::nullopt;
}

std::span<const Classified> classified_cells() { return classified_counts; }

}  // namespace changeover
"""


def answer(program, *arguments):
    done = subprocess.run([program, *arguments], capture_output=True, text=True, env=dict(os.environ, CHANGEOVER_CATALOG=""))
    return json.loads(done.stdout)


def cells(program):
    found = []
    for change in (1, 2, 3):
        for kind in ("circular", "linear"):
            table = answer(program, "table", "--k", "3..8", "--v", "4..24", "--change", str(change), f"--{kind}", "--json")
            found += [(c["b"] * c["v"] * c["k"], change, kind, c["k"], c["v"], c["b"]) for c in table
                      if c["status"] == "minimum" and c["b"] <= 60 and c["v"] > c["k"]]
    return [cell[1:] for cell in sorted(found)]


def row(counted):
    groups = " ".join(f"{order}:{classes}" for order, classes in sorted(counted["group_orders"].items(), key=lambda each: int(each[0])))
    kind = "in_circle" if counted["kind"] == "circular" else "in_line"
    parameters = f'{counted["v"]}, {counted["k"]}, {counted["change"]}, {kind}'
    numbers = f'{counted["b"]}, {counted["standard_forms"]}, {counted["classes"]}, {counted["tight"]}'
    return f'    Classified{{{{{parameters}}}, {numbers}, "{groups}"}},'


def main():
    program = sys.argv[1]
    rows, late = [], {}
    for change, kind, k, v, b in cells(program):
        if late.get((change, kind, k), 0) >= GIVE_UP_AFTER:
            continue
        counted = answer(program, "classify", str(v), str(k), str(b), "--change", str(change), f"--{kind}", "--json", "--quiet",
                         "--time", f"{SECONDS}s", "--threads", "1")
        if counted.get("complete"):
            rows.append(((change, kind, k, v), row(counted)))
        late[change, kind, k] = 0 if counted.get("complete") else late.get((change, kind, k), 0) + 1
    print(HEAD + "\n".join(text for _, text in sorted(rows)) + "\n" + FOOT, end="")


if __name__ == "__main__":
    main()
