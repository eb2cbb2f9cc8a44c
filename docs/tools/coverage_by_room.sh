#!/usr/bin/env bash
# Line coverage by room, of a table that gcovr --csv wrote; ./dev coverage asks for it.
# usage: coverage_by_room.sh FILES.CSV PERCENT "DEMANDED ROOM..." ["ROOM..."]
# A room is the folder below include/changeover, src and apps. Only the last rooms are shown, all
# without them. Exit code 3 if a demanded room is below PERCENT, or is not in the table; 2 if there
# is no table.
set -euo pipefail
[[ $# -ge 3 && -r $1 ]] || {
  printf 'usage: coverage_by_room.sh FILES.CSV PERCENT "DEMANDED ROOM..." ["ROOM..."]\n' >&2
  exit 2
}
awk -F, -v least="$2" -v demanded="$3" -v shown="${4:-}" '
  function show(room, reached, lines, remark) {
    return sprintf("%-20s %6d of %6d lines %6.1f %%%s", room, reached, lines,
                   100 * reached / lines, remark)
  }
  function too_few(room) { return 100 * reached[room] < least * lines[room] }
  BEGIN {
    n = split(demanded, demand, " ")
    m = split(shown, some, " ")
    for (i = 1; i <= n; ++i) is_demanded["src/" demand[i]] = 1
    for (i = 1; i <= m; ++i) is_shown["src/" some[i]] = 1
  }
  NR > 1 {
    sub(/^include\/changeover\//, "src/", $1)
    split($1, part, "/")
    room = part[1] "/" part[2]
    if (m > 0 && !(room in is_shown)) next
    lines[room] += $2
    reached[room] += $3
    all += $2
    all_reached += $3
  }
  END {
    for (room in lines) {
      remark = (room in is_demanded) && too_few(room) ? "  below " least " %" : ""
      if (lines[room]) print show(room, reached[room], lines[room], remark) | "sort"
    }
    close("sort")
    if (all) print show("all", all_reached, all, "")
    for (room in is_demanded) if (!lines[room] || too_few(room)) exit 3
  }' "$1"
