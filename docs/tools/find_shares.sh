#!/bin/sh
# Searches for better shares of groups and puts the table of them in place; without arguments checks
# the table that is there.
#
#     docs/tools/find_shares.sh 20000 7        20,000 tries, seed 7
#
# Then build, run test_loadorder and measure again with docs/tools/share_region.py.
set -eu
CDPATH='' cd -- "$(dirname "$0")/../.."
table=src/loadorder/shares/share_table.inc
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT QUIT PIPE TERM
${CXX:-c++} -std=c++20 -O2 -o "$work/find_shares" docs/tools/find_shares/find_shares.cpp
"$work/find_shares" "$@" < "$table" > "$work/table.inc"
mv "$work/table.inc" "$table"
