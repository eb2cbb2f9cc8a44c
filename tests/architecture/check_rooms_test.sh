#!/usr/bin/env bash
# check_rooms_test.sh SCRIPT: proves that the check of the rooms passes a good tree and fails each
# of several trees with one fault.
set -euo pipefail

script=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree=$work/tree

# Runs the check on a tree in which FILE holds LINE.
check_with() {
  rm -rf "$tree"
  mkdir -p "$tree"/include/changeover/{core,io} "$tree"/src/{core,io} "$tree/apps/checkdesign"
  echo '#include <vector>' >"$tree/include/changeover/core/block.hpp"
  echo '#include "changeover/core/block.hpp"' >"$tree/include/changeover/io/text.hpp"
  printf '#include "changeover/%s.hpp"\n' core/block io/text \
    >"$tree/include/changeover/changeover.hpp"
  touch "$tree/src/io/rows.hpp"
  echo '#include "changeover/core/block.hpp"' >"$tree/src/io/text.cpp"
  echo '#include <fmt/format.h>' >"$tree/src/core/block.cpp"
  mkdir -p "$tree/$(dirname "$1")"
  echo "$2" >"$tree/$1"
  bash "$script" "$tree" core: io:core
}

must_pass() {
  check_with "$@" || { echo "wrongly refused: $1 with $2"; exit 1; }
}

must_fail() {
  if check_with "$@" >"$work/output"; then
    echo "wrongly accepted: $1 with $2"
    exit 1
  fi
  [[ $(wc -l <"$work/output") -eq 1 ]] ||
    { echo "expected one fault:"; cat "$work/output"; exit 1; }
}

must_pass src/io/more.cpp '#include "changeover/core/design.hpp"'
must_pass src/io/more.cpp '#include "detail/rows.hpp"'
must_pass src/core/more.cpp '// #include "changeover/io/text.hpp"'
must_fail src/core/more.cpp '#include "changeover/io/text.hpp"'
must_fail include/changeover/core/block.hpp '#  include <changeover/io/text.hpp>  // oh'
must_pass include/changeover/io/text.hpp '#include <stdint.h>'
must_fail include/changeover/io/text.hpp '#include "io/rows.hpp"'
must_fail include/changeover/io/text.hpp '#include "changeover/io/rows.hpp"'
must_fail include/changeover/io/text.hpp '#include <fmt/format.h>'
must_fail include/changeover/io/more.hpp '#include "changeover/io/text.hpp"'
must_fail include/changeover/changeover.hpp '#include "changeover/core/block.hpp"'
must_pass src/io/more.cpp 'namespace changeover {'
must_fail src/io/more.cpp 'namespace changeover::io_detail {'
must_pass examples/walk.cpp '#include "changeover/io/text.hpp"'
must_pass examples/walk.cpp '#include <mpi.h>'
must_fail examples/walk.cpp '#include "io/rows.hpp"'
must_fail tests/install/consumer/main.cpp '#include <io/rows.hpp>'
must_fail src/core/more.cpp '#include "../io/rows.hpp"'
must_fail src/core/more.cpp '#include "io/rows.hpp"'
must_fail src/core/more.cpp '#include "changeover/unheard/of.hpp"'
must_fail src/io/more.cpp '#include "../../apps/changeover/main.hpp"'
must_fail src/attic/more.cpp '#include <vector>'
must_fail apps/checkdesign/checkdesign.c '#include "changeover/core/block.hpp"'
