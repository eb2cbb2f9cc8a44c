#!/usr/bin/env bash
# Puts a design that a search found into the collection that the registry offers, src/construct/found.
# FILE is what `changeover search … --format text -o FILE` wrote: its recipe has the blocks and where they
# come from. The tests refuse a design that is wrong, or no better than what constructions give.
# usage: docs/tools/keep_design.sh FILE…
set -euo pipefail
folder=$(dirname "${BASH_SOURCE[0]}")/../../src/construct/found
for file in "$@"; do
  header=$(sed -n 's/^# \(changeover design .*\)$/\1/p;T;q' "$file")
  recipe=$(sed -n 's/^# recipe: \(.*\)$/\1/p;T;q' "$file")
  provenance=$(sed -n 's/.*"provenance":"\([^"]*\)".*/\1/p' <<<"$recipe")
  if [[ -z $header || -z $provenance ]]; then
    printf '%s: no header or no recipe with a provenance; write it by changeover search -f text -o\n' "$file" >&2
    exit 1
  fi
  name=$(sed 's/.* v=\([0-9]*\) k=\([0-9]*\) change=\([0-9]*\) kind=\([a-z]*\)\( strength=\([0-9]*\)\)\?$/\1_\2_\3_\4_\6/; s/_$//' <<<"$header")
  {
    printf '# %s\n# provenance: %s\n' "$header" "$provenance"
    if [[ $recipe == *'"construction":"developed"'* ]]; then
      sed 's/.*"arguments":{"f":\([0-9]*\),"n":\([0-9]*\),"shift":\([0-9]*\)}.*/# developed: n=\2 f=\1 shift=\3/' <<<"$recipe"
    fi
    sed 's/.*"blocks":\[\[\(.*\)\]\].*/\1/; s/\],\[/\n/g' <<<"$recipe" | tr ',' ' '
  } >"$folder/$name.txt.new"
  mv "$folder/$name.txt.new" "$folder/$name.txt"
  printf 'kept %s\n' "$name.txt"
done
