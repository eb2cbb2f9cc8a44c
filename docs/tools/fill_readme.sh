#!/usr/bin/env bash
# Runs the commands that README.md shows and puts what they print beneath them, so that the tour is true.
# A shown command is an indented line that starts with "$ changeover", "$ printf" …; its output is the
# indented lines that follow, up to the first line that is not indented. Needs a release build.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
root=$PWD
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export PATH="$root/build/release:$PATH" COLUMNS=100 CHANGEOVER_CATALOG=
in_output=false
while IFS= read -r line || [[ -n $line ]]; do
  if [[ $line == '    $ '* ]]; then
    printf '%s\n' "$line"
    { (cd "$scratch" && bash -c "${line#    \$ }" 2>&1) || true; } | sed -e 's/^\(.\)/    \1/'
    in_output=true
  elif $in_output && [[ $line == '    '* || -z $line ]]; then
    continue
  else
    if $in_output; then
      printf '\n'
      in_output=false
    fi
    printf '%s\n' "$line"
  fi
done < README.md > "$scratch/README.md"
cat "$scratch/README.md" > README.md
