#!/bin/sh
# Looks for a design with as many blocks and change numbers as a given one, but with more disjoint
# unchanged subsets beside a hinge, which concatenation with groups needs (docs/theorems.md, Theorem
# 15).
#
#     docs/tools/find_parts.sh 65 4 circular step 30 > FILE        30 parts beside a hinge at a step
#     docs/tools/find_parts.sh 44 6 linear end 10 200 7 > FILE     10 parts, the hinge in the last
# block; 200 tries, seed 7
#
# It starts from the best double-change design known, and leaves with 1 if it finds none, 4
# if the tool does not compile.
# docs/tools/keep_design.sh FILE keeps the design.
set -eu
[ $# -ge 5 ] || {
  echo "usage: docs/tools/find_parts.sh V K circular|linear step|end PARTS [TRIES] [SEED]" >&2
  exit 2
}
CDPATH='' cd -- "$(dirname "$0")/../.."
. docs/tools/compiled.sh
compile find_parts -O3
build/release/changeover design "$1" "$2" "--$3" --format text -o "$work/design.txt"
run find_parts "$@" < "$work/design.txt"
