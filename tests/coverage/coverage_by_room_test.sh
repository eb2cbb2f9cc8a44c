#!/usr/bin/env bash
# coverage_by_room_test.sh SCRIPT: the demand passes rooms that meet it and fails each that does
# not, or is not there.
set -euo pipefail

script=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
table=$work/files.csv
printf '%s\n' 'filename,line_total,line_covered' 'src/core/a.cpp,80,71' \
  'include/changeover/core/a.hpp,20,19' \
  'src/io/b.cpp,100,89' 'apps/changeover/main.cpp,10,0' >"$table"

# expect CODE PATTERN ARGUMENTS...
expect() {
  local code=0 wanted=$1 pattern=$2 out
  shift 2
  out=$(bash "$script" "$table" "$@" 2>&1) || code=$?
  [[ $code -eq $wanted ]] || { echo "exit code $code, not $wanted: $*"; exit 1; }
  grep -Eq "$pattern" <<<"$out" || { echo "no '$pattern' in: $out"; exit 1; }
}

expect 0 '^src/core +90 of +100 lines +90.0 %$' 90 core
expect 3 '^src/core +90 of +100 lines +90.0 %  below 91 %$' 91 core
expect 3 '^src/io +89 of +100 lines +89.0 %  below 90 %$' 90 'core io'
expect 0 '^all +179 of +210 lines' 89 'core io'
expect 3 '^all' 50 'core proof' # no line of proof was counted
expect 0 '^all +90 of +100 lines' 90 core core
code=0
bash "$script" "$work/none.csv" 90 core 2>/dev/null || code=$?
[[ $code -eq 2 ]] || { echo "exit code $code without a table"; exit 1; }
echo "the demand holds and fails where it must"
