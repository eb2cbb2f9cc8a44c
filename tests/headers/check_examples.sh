#!/usr/bin/env bash
# check_examples.sh ROOT
# Fails with one line for each example of a public header that no test runs as it stands there.
#
# An example is a run of comment lines that begin with five blanks, unless they go on with an item
# of a list, whose text begins with two to four. The examples of a room's headers, in the order of
# the headers' names, are demanded in tests/examples/ROOM_examples_test.cpp (those of a C header in
# ROOM_c_example.c): each statement, whatever its white space and without its comments, after the
# one before it. A statement may stand inside of a check, and checks between statements. Every
# public header has an example, and none leaves anything open with an ellipsis.
set -euo pipefail

cd "$1"
faults=0
fault() {
  printf '%s\n' "$*"
  faults=$((faults + 1))
}

# Prints FILE:LINE<tab>CODE for each line of the examples of a header, comments taken away.
examples_of() {
  awk '
    !/^[[:space:]]*(\/\/|\/?\*)/ { state = ""; next }
    { text = $0; sub(/^[[:space:]]*(\/\/\/?|\/\*|\*)/, "", text) }
    text !~ /[^[:space:]]/ { state = ""; next }
    text !~ /^     / { state = (text ~ /^  /) ? "list" : ""; next }
    state != "list" {
      sub(/\/\/.*/, "", text)
      print FILENAME ":" FNR "\t" text
    }' "$1"
}

# Reads what examples_of() prints and looks for each statement in the given file.
demand_in() {
  awk -v file="$1" '
    BEGIN {
      FS = "\t"
      while ((getline line < file) > 0) {
        sub(/\/\/.*/, "", line)
        gsub(/[[:space:]]/, "", line)
        code = code line
      }
    }
    /…/ { print $1 ": the example leaves something open"; next }
    {
      count = split($2, statements, ";")
      for (i = 1; i <= count; ++i) {
        statement = statements[i]
        gsub(/[[:space:]]/, "", statement)
        place = index(substr(code, seen + 1), statement)
        if (statement != "" && place == 0) {
          print $1 ": not in " file ", or not in this order: " statements[i]
          next
        }
        seen += statement == "" ? 0 : place + length(statement) - 1
      }
    }'
}

check() {  # TEST HEADER...
  local test=$1 header
  shift
  [[ -f $test ]] || { fault "$test: is missing"; return; }
  for header in "$@"; do
    [[ -n $(examples_of "$header") ]] || fault "$header: has no example"
  done
  while IFS= read -r line; do
    fault "$line"
  done < <(for header in "$@"; do examples_of "$header"; done | demand_in "$test")
}

export LC_ALL=C
check tests/examples/changeover_examples_test.cpp include/changeover/changeover.hpp
for folder in include/changeover/*/; do
  room=$(basename "$folder")
  headers=("$folder"*.hpp)
  [[ $room != core || ! -f cmake/version.hpp.in ]] || headers+=(cmake/version.hpp.in)
  check "tests/examples/${room}_examples_test.cpp" "${headers[@]}"
  for header in "$folder"*.h; do
    [[ ! -f $header ]] || check "tests/examples/${room}_c_example.c" "$header"
  done
done

[[ $faults -eq 0 ]]
