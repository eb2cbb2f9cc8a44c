#!/usr/bin/env bash
# Writes what constructions and closure rules know today into the catalog that comes with the program: catalog/planned/*.jsonl gets a line for
# each cell of its range (construct/standard_catalog.hpp) that has no design yet, or a better one. Lines that are there stay: labels last.
# Takes some minutes; build the program anew afterwards, and once more from here if designs were added, until nothing is added.
# usage: docs/tools/plan_catalog.sh [M…]   change numbers, all if none is named
set -euo pipefail
[[ $# -gt 0 ]] || set -- 1 2 3
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export CHANGEOVER_CATALOG=
program=${CHANGEOVER_PROGRAM:-build/release/changeover}
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
mkdir -p catalog/planned
for change in "$@"; do
  for kind in linear circular; do
    file=catalog/planned/m$change-$kind.jsonl
    : >"$work/new"
    for range in '3..12 5..100' '13..40 15..160'; do
      "$program" table --k "${range% *}" --v "${range#* }" --change "$change" "--$kind" --format catalog -o "$work/table"
      [[ -e $file ]] || head -n 1 "$work/table" | sed 's/,"command":.*/}}/' >"$file"
      tail -n +2 "$work/table" >>"$work/new"
    done
    # The fewest blocks of each cell, by labels v.k.m.kind.b.digits; lines that are news are appended.
    cat catalog/written/m"$change-$kind".jsonl "$file" |
      awk -v lines="$work/new" '
        function look(line) {
          match(line, /"label":"[^"]*"/)
          split(substr(line, RSTART + 9, RLENGTH - 10), part, ".")
          cell = part[1] "." part[2] "." part[3] "." part[4]
          b = part[5] + 0
        }
        /"label"/ { look($0); if (!(cell in best) || b < best[cell]) best[cell] = b }
        END {
          while ((getline line < lines) > 0) {
            look(line)
            if (!(cell in best) || b < best[cell]) { print line; best[cell] = b }
          }
        }' >"$work/news"
    printf '%s: %s news\n' "$file" "$(wc -l <"$work/news")"
    cat "$work/news" >>"$file"
  done
done
