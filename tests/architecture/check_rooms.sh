#!/usr/bin/env bash
# check_rooms.sh ROOT ROOM:KNOWN,KNOWN...
# Fails with one line for each include by which a room reaches a room that it may not know, for
# each include of apps/ from a room, for each folder that is no room, and for each include of ours
# in the independent checker. The public door, include/changeover/, is closed in itself: its headers
# include each other and the standard library, changeover.hpp includes all of them, and what shows
# strangers how to use the library (examples/, the consumer of tests/install) includes nothing else
# of ours. What lies in src/ is internal by its place, so no namespace says so again.
set -euo pipefail

root=$1
shift
declare -A known
for entry in "$@"; do
  known[${entry%%:*}]=,${entry#*:},
done

faults=0
fault() {
  printf '%s\n' "$*"
  faults=$((faults + 1))
}

# Prints FILE:LINE:PATH for each include in the given folder or file.
includes_in() {
  [[ -e $1 ]] || return 0
  grep -rHnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"]' "$1" |
    sed -E 's|^([^:]*:[0-9]+):[^<"]*[<"]([^>"]*)[>"].*|\1:\2|' || true
}

cd "$root"
for folder in include/changeover/*/ src/*/; do
  [[ -d $folder ]] || continue
  room=$(basename "$folder")
  if [[ -z ${known[$room]+set} ]]; then
    fault "$folder: no such room; rooms are listed in cmake/rooms.cmake"
    continue
  fi
  while IFS= read -r found; do
    [[ -n $found ]] || continue
    path=${found##*:}
    # "changeover/room/x.hpp" names a room; so do "../room/x.hpp" and "room/x.hpp" (src/ is on the
    # private include path).
    other=$path
    while [[ $other == ../* ]]; do other=${other#../}; done
    other=${other#changeover/}
    if [[ $other == apps/* || $other == tests/* ]]; then
      fault "${found%:*}: a room includes $path"
      continue
    fi
    [[ $other == */* ]] || continue
    other=${other%%/*}
    if [[ $path != changeover/* && -z ${known[$other]+set} ]]; then
      continue  # another library, or a subfolder of the room itself
    fi
    [[ $other == "$room" ]] && continue
    if [[ ${known[$room]} != *",$other,"* ]]; then
      fault "${found%:*}: $room may not know $other, but includes $path"
    fi
  done < <(includes_in "$folder")
done

while IFS= read -r found; do
  [[ -n $found ]] || continue
  path=${found##*:}
  if [[ $path == changeover/* ]]; then
    [[ -f include/$path || $path == changeover/core/version.hpp ]] ||
      fault "${found%:*}: $path is no public header"
  elif [[ ! $path =~ ^[a-z0-9_]+(\.h)?$ ]]; then
    fault "${found%:*}: a public header includes $path"
  fi
done < <(includes_in include/changeover)

while IFS= read -r header; do
  grep -qxF "#include \"$header\"" include/changeover/changeover.hpp ||
    fault "include/$header: is not in changeover.hpp"
done < <(cd include && find changeover/*/ -name '*.h' -o -name '*.hpp' | sort)

while IFS= read -r found; do
  [[ -z $found ]] || fault "$found: internals lie in namespace changeover"
done < <(grep -rnE '^[[:space:]]*namespace .*detail' src | cut -d: -f1,2 || true)

for folder in examples tests/install/consumer; do
  while IFS= read -r found; do
    [[ -n $found ]] || continue
    path=${found##*:}
    file=${found%%:*}
    if [[ $path == changeover/* && $path != changeover/*/*/* ]]; then continue; fi
    if [[ -e $folder/$path || -e ${file%/*}/$path ]]; then continue; fi
    for place in include/changeover src apps tests bench; do
      if [[ -e $place/$path ]]; then
        fault "${found%:*}: a stranger cannot include $path"
        break
      fi
    done
  done < <(includes_in "$folder")
done

while IFS= read -r found; do
  [[ -n $found ]] || continue
  path=${found##*:}
  if [[ $path == *changeover* || $path == ../* ]]; then
    fault "${found%:*}: the independent checker includes $path"
  fi
done < <(includes_in apps/checkdesign)

[[ $faults -eq 0 ]]
