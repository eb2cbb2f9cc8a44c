#!/usr/bin/env bash
# Fills docs/minima.csv for at most SECONDS (default 1500) and writes docs/minima.md from it.
# It can be stopped and goes on where it was. Rows that are settled stay; open ones are tried again
# only with more CONFLICTS for a number of blocks (default 100000). Needs a release build.
# usage: docs/tools/minima.sh [SECONDS [CONFLICTS]]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
seconds=${1:-1500} conflicts=${2:-100000}
program=build/release/changeover
# Strength 3 has few constructions to start from, so it is kept small and comes first.
nice "$program" minima --data docs/minima.csv --strength 3 --k-from 4 --k-to 6 --v 9 \
  --conflicts "$conflicts" --time $((seconds / 5)) -o docs/minima.md
nice "$program" minima --data docs/minima.csv --conflicts "$conflicts" \
  --time $((seconds - seconds / 5)) -o docs/minima.md
