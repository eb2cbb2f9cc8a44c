#!/bin/sh
# Looks for a list of base blocks over five orbits between which opposite points can pass
# (docs/theorems.md, Theorem 32): for tight circular DCCD(5n,4), or DCCD(5n+1,4) if FIXED is 1, for
# every odd n from some on. TOTAL is the sum of the numbers x_c; a list has TOTAL+2+FIXED blocks.
#
#     docs/tools/find_tournament.sh 0 6 > LIST          DCCD(25,4), DCCD(35,4), ...
#     docs/tools/find_tournament.sh 0 6 4 900 > LIST    seed 4, at most 900 seconds
#
# It takes a minute or so. It leaves with 1 if it finds none or is stopped, 2 for numbers that
# cannot be, 3 if the list could not be written, 4 if the tool does not compile. A list goes into
# src/construct/tools/tournament_lists.cpp.
set -eu
[ $# -ge 2 ] || {
  echo "usage: docs/tools/find_tournament.sh FIXED TOTAL [SEED] [SECONDS]" >&2
  exit 2
}
CDPATH='' cd -- "$(dirname "$0")/../.."
. docs/tools/compiled.sh
compile find_tournament -O3 -march=native
run find_tournament "$@"
