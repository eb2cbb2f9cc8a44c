#!/bin/sh
# Searches for better shares of groups and puts the table of them in place; without arguments checks
# the table that is there.
#
#     docs/tools/find_shares.sh 20000 7        20,000 tries, seed 7
#
# Then build, run test_loadorder and measure again with docs/tools/share_region.py.
set -eu
CDPATH='' cd -- "$(dirname "$0")/../.."
table=src/loadorder/shares/groups/share_table.inc
. docs/tools/compiled.sh
compile find_shares -O2
run find_shares "$@" < "$table" > "$work/table.inc"
mv "$work/table.inc" "$table"
