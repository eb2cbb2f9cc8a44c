#!/usr/bin/env bash
# presets_test.sh SOURCES CMAKE: configures every preset, in its own folder, with warnings as
# errors. One whose compiler is not installed is left out, and that is said.
set -euo pipefail
sources=$1 cmake=$2
cd "$sources"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mapfile -t presets < <("$cmake" --list-presets | sed -n 's/^  "\([^"]*\)".*/\1/p')
[[ ${#presets[@]} -ge 5 ]] || {
  echo "cmake --list-presets names ${#presets[@]} presets only"
  exit 1
}
tried=0 faults=0
settings=(-DCHANGEOVER_WERROR=ON)
for preset in "${presets[@]}"; do
  compiler=$("$cmake" --preset "$preset" -N | sed -n 's/^ *CMAKE_CXX_COMPILER="\(.*\)"/\1/p')
  if [[ -n $compiler ]] && ! command -v "$compiler" >/dev/null; then
    echo "$preset: left out, there is no $compiler"
    continue
  fi
  tried=$((tried + 1))
  if "$cmake" --preset "$preset" -B "$folder/$preset" "${settings[@]}" >"$folder/log" 2>&1 &&
    [[ -f $folder/$preset/build.ninja ]]; then
    echo "$preset: configured"
    # Optional packages that worked for one preset are not tried again: a trial takes seconds.
    mapfile -t worked < <(sed -n 's/^\(CHANGEOVER_[A-Za-z]*_WORKS\):.*=TRUE$/-D\1=TRUE/p' \
      "$folder/$preset/CMakeCache.txt")
    settings=(-DCHANGEOVER_WERROR=ON "${worked[@]}")
  else
    faults=$((faults + 1))
    echo "$preset: not configured"
    cat "$folder/log"
  fi
  rm -rf "${folder:?}/$preset"
done
echo "$tried presets, $faults faults"
[[ $tried -gt 0 && $faults -eq 0 ]]
