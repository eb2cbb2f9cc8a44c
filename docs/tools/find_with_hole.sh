#!/bin/sh
# Looks for a linear single-change design, or for a list with open ends, in two lists, the second
# with a hole (docs/theorems.md, Theorem 13): a list on W elements that lacks some pairs, with
# disjoint unchanged subsets, and one after it that brings NEW elements in and meets these pairs.
#
#     docs/tools/find_with_hole.sh 5 16 12 2 2 > FILE       SCCD(28,5): k, W, NEW, subsets, pairs
#     docs/tools/find_with_hole.sh 5 16 12 2 2 2 900        the same; seed 2, at most 900 seconds
#     docs/tools/find_with_hole.sh open 5 18 13 2 12        a list with open ends on 31 elements
#
# The second one found SCCD(28,5,93) in four minutes on a busy core.
#
# It leaves with 1 if it finds none or is stopped, 2 for numbers that cannot be, 3 if the list could
# not be written, 4 if the tool does not compile.
# docs/tools/keep_design.sh FILE keeps a design; a list with open ends goes into
# src/construct/tools/concatenation/written_pieces.cpp.
set -eu
[ $# -ge 5 ] || {
  echo "usage: docs/tools/find_with_hole.sh [open] K W NEW PARTS LACKING [SEED] [SECONDS]" >&2
  exit 2
}
CDPATH='' cd -- "$(dirname "$0")/../.."
. docs/tools/compiled.sh
compile find_with_hole -O3 -march=native
run find_with_hole "$@"
