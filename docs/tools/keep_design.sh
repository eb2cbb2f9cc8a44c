#!/usr/bin/env bash
# Puts designs that searches found into the catalog that comes with the program,
# catalog/written/*.jsonl. FILE is what `changeover search … --format text -o FILE` wrote: its
# recipe has the blocks and where they come from. What is wrong, or there already, is refused by
# `changeover catalog add`; the tests refuse what is no better than what constructions give.
# usage: [WHO=NAME] docs/tools/keep_design.sh FILE…
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")/../..
program=$here/build/release/changeover
own=$(mktemp -d)
trap 'rm -r "$own"' EXIT
"$program" catalog add "$@" --who "${WHO:-The Changeover developers}" --catalog "$own/catalog.db"
"$program" catalog export --users --catalog "$own/catalog.db" -o "$own/lines.jsonl"
tail -n +2 "$own/lines.jsonl" | while IFS= read -r line; do
  label=${line#*'"label":"'}
  IFS=. read -r v k change kind rest <<<"${label%%'"'*}"
  strength=
  [[ $rest != t* ]] || strength=-${rest%%.*}
  file=$here/catalog/written/m$change-$kind$strength.jsonl
  printf '%s\n' "$line" >>"$file"
  printf 'kept %s.%s.%s.%s in %s\n' "$v" "$k" "$change" "$kind" "$(basename "$file")"
done
