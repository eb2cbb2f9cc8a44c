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
  BEGIN { n = split(demanded, demand, " "); m = split(shown, show, " ")
          for (i = 1; i <= n; ++i) is_demanded["src/" demand[i]] = 1
          for (i = 1; i <= m; ++i) is_shown["src/" show[i]] = 1 }
  NR > 1 { sub(/^include\/changeover\//, "src/", $1); split($1, part, "/"); room = part[1] "/" part[2]
           if (m > 0 && !(room in is_shown)) next
           lines[room] += $2; reached[room] += $3; all += $2; all_reached += $3 }
  END { for (room in lines) if (lines[room]) printf "%-20s %6d of %6d lines %6.1f %%%s\n", room, reached[room],
            lines[room], 100 * reached[room] / lines[room],
            (room in is_demanded) && 100 * reached[room] < least * lines[room] ? "  below " least " %" : "" | "sort"
        close("sort")
        if (all) printf "%-20s %6d of %6d lines %6.1f %%\n", "all", all_reached, all, 100 * all_reached / all
        for (room in is_demanded) if (!lines[room] || 100 * reached[room] < least * lines[room]) exit 3 }' "$1"
