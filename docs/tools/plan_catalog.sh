#!/usr/bin/env bash
# Writes what constructions and closure rules know today into the catalog that comes with the
# program: catalog/planned/mM-KIND-kK.jsonl, a file for block sizes from K up to the next, gets a
# line for each cell of its range (construct/registry.hpp) that has no design yet, or a better one.
# Lines that are there stay: labels last. New lines carry the day on which they came. Takes some
# minutes. Build the program again afterwards, and run this again until no design is added.
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
    files=catalog/planned/m$change-$kind
    : >"$work/new"
    for range in '3..12 5..160' '13..40 15..160'; do
      "$program" table --k "${range% *}" --v "${range#* }" --change "$change" "--$kind" --anew \
        --format catalog -o "$work/table"
      for from in 03 08 13 20 27 34; do
        file=$files-k$from.jsonl
        [[ -e $file ]] || head -n 1 "$work/table" | sed 's/,"command":.*/}}/' >"$file"
      done
      tail -n +2 "$work/table" >>"$work/new"
    done
    credit=$(head -n 1 "$work/table" | sed 's/.*\("credit":{.*\),"command":.*/\1}/')
    # The fewest blocks of each cell, by labels v.k.m.kind.b.digits; lines that are news are
    # appended. Their credit is that of the file's first line, or their own.
    cat catalog/written/m"$change-$kind".jsonl "$files"-k*.jsonl |
      awk -v lines="$work/new" -v files="$files" -v credit="$credit" '
        function look(line) {
          match(line, /"label":"[^"]*"/)
          split(substr(line, RSTART + 9, RLENGTH - 10), part, ".")
          cell = part[1] "." part[2] "." part[3] "." part[4]
          b = part[5] + 0
          k = part[2]
          from = k < 8 ? "03" : k < 13 ? "08" : k < 34 ? 13 + 7 * int((k - 13) / 7) : "34"
        }
        function dated(line, file) {
          if (!(file in header)) {
            getline header[file] < file
            close(file)
          }
          if (index(header[file], credit)) return line
          return substr(line, 1, length(line) - 1) "," credit "}"
        }
        /"label"/ { look($0); if (!(cell in best) || b < best[cell]) best[cell] = b }
        END {
          while ((getline line < lines) > 0) {
            look(line)
            if (!(cell in best) || b < best[cell]) {
              file = files "-k" from ".jsonl"
              print dated(line, file) >> file
              ++news
              best[cell] = b
            }
          }
          printf "%s: %d news\n", files, news
        }'
  done
done
