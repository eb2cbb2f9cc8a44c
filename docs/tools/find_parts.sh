#!/bin/sh
# Looks for a design with as many blocks and change numbers as a given one, but with more disjoint
# unchanged subsets beside a hinge, which concatenation with groups needs (docs/theorems.md, Theorem
# 15).
#
#     docs/tools/find_parts.sh 65 4 circular step 30 > FILE        30 parts beside a hinge at a step
#     docs/tools/find_parts.sh 44 6 linear end 10 200 7 > FILE     10 parts, the hinge in the last
# block; 200 tries, seed 7
#
# It starts from the best double-change design known, and leaves with 1 if it finds none.
# docs/tools/keep_design.sh FILE keeps the design.
set -eu
CDPATH='' cd -- "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT QUIT PIPE TERM
${CXX:-c++} -std=c++20 -O3 -o "$work/find_parts" docs/tools/find_parts/find_parts.cpp
build/release/changeover design "$1" "$2" "--$3" --format text -o "$work/design.txt"
"$work/find_parts" "$@" < "$work/design.txt"
