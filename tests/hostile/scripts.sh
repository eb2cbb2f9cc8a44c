#!/usr/bin/env bash
# The scripts of the tree with words that they do not know: one line, exit code 2, and nothing is
# begun.
tree=$(realpath -- "$(dirname "$0")/../..")
# shellcheck source=support/attack.sh
source "$(dirname "$0")/support/attack.sh"
cd "$tree" || exit

refused() { # COMMAND...
  local said code
  attacks=$((attacks + 1))
  said=$("$@" 2>&1)
  code=$?
  [[ $code == 2 && -n $said && $said != *$'\n'* ]] ||
    fault "$*: exit code $code, $(head -c 300 <<<"$said")"
}

for word in nonsense '' 'slow address' ../fuzz/read $'a\nb'; do
  refused ./dev fuzz 1 "$word"
  refused .ci/nightly "$word"
  refused .ci/nightly docs "$word"
done
if /usr/bin/python3 -c 'import clang.cindex' 2>/dev/null; then
  for words in nonsense --nonsense '-j x' '-j 0'; do
    # shellcheck disable=SC2086 # two words
    refused /usr/bin/python3 tests/mutation/mutate.py --understood $words
  done
fi
finish
