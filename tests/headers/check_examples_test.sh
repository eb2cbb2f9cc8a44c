#!/usr/bin/env bash
# check_examples_test.sh SCRIPT: proves that the check of the examples passes a good tree and fails
# each of several trees with one fault.
set -euo pipefail

script=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree=$work/tree

# Runs the check on a good tree after the given file got the given contents; no file: left out.
check_with() {
  rm -rf "$tree"
  mkdir -p "$tree/include/changeover/core" "$tree/tests/examples"
  cat >"$tree/include/changeover/changeover.hpp" <<'END'
// All of it.
//
//     begin();
#pragma once
END
  echo 'begin();' >"$tree/tests/examples/changeover_examples_test.cpp"
  cat >"$tree/include/changeover/core/block.hpp" <<'END'
// Blocks.
//
//     Block block = make(3);      // three elements
//     block.size();  use(block);
//
//   - An item of a list
//     that goes on.
#pragma once

///     int again = 0;
int count();
END
  cat >"$tree/include/changeover/core/c.h" <<'END'
/* For C.
 *
 *     c();
 */
END
  cat >"$tree/tests/examples/core_examples_test.cpp" <<'END'
  const int before = 0;
  Block block =
      make(3);
  EXPECT_EQ(block.size(), 3);
  use(block);
  int again = 0;
END
  echo 'void run(void) { c(); }' >"$tree/tests/examples/core_c_example.c"
  if [[ $# -eq 2 ]]; then
    printf '%s\n' "$2" >"$tree/$1"
  elif [[ $# -eq 1 ]]; then
    rm "$tree/$1"
  fi
  bash "$script" "$tree"
}

must_pass() {
  check_with "$@" || { echo "wrongly refused: $*"; exit 1; }
}

must_fail() {
  if check_with "$@" >"$work/output"; then
    echo "wrongly accepted: $*"
    exit 1
  fi
  [[ $(wc -l <"$work/output") -eq 1 ]] ||
    { echo "expected one fault:"; cat "$work/output"; exit 1; }
}

program=tests/examples/core_examples_test.cpp
header=include/changeover/core/block.hpp
must_pass
must_pass $program 'Block block=make(3); f(block.size()); use(block); int again = 0; // the end'
must_fail $program 'Block block = make(3); block.size(); int again = 0;'
must_fail $program 'Block block = make(3); block.size(); // use(block); int again = 0;
  int again = 0;'
must_fail $program 'Block block = make(4); block.size(); use(block); int again = 0;'
must_fail $program 'int again = 0; Block block = make(3); block.size(); use(block);'
must_fail $program
must_fail $header '// Blocks.'
must_fail $header '//     for (int i = 0; …; ++i) {'
must_fail $header '// It is used so:
//     never();'
must_fail include/changeover/core/another.hpp '//     another();'
must_fail include/changeover/changeover.hpp '//     end();'
must_fail tests/examples/core_c_example.c 'void run(void) {}'
