#!/bin/sh
# Looks for a list of base blocks that can be stretched (docs/theorems.md, Theorem 30): over G
# orbits of Z_N, with H residues of each orbit kept together, for tight circular SCCD(GN,GH+1) with
# N and every N+2H, N+4H, ... in its place.
#
#     docs/tools/find_stretched.sh 5 1 7 > LIST         SCCD(35,6) and SCCD(45,6), SCCD(55,6), ...
#     docs/tools/find_stretched.sh 3 2 15 4 900 > LIST  SCCD(45,7), ...; seed 4, at most 900 seconds
#
# Both take a minute or two. It leaves with 1 if it finds none or is stopped, 2 for numbers that
# cannot be, 3 if the list could not be written, 4 if the tool does not compile. A list goes into
# src/construct/tools/stretched_lists.cpp.
set -eu
[ $# -ge 3 ] || {
  echo "usage: docs/tools/find_stretched.sh G H N [SEED] [SECONDS]" >&2
  exit 2
}
CDPATH='' cd -- "$(dirname "$0")/../.."
. docs/tools/compiled.sh
compile find_stretched -O3 -march=native
run find_stretched "$@"
