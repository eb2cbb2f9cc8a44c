# For the tools that are one C++ file, docs/tools/NAME/NAME.cpp, to be read with "." from the folder
# of the project: a folder $work that is removed at the end, and
#
#     compile NAME [OPTION...]    leaves with 4 if it cannot be compiled
#     run NAME [ARGUMENT...]      reads standard input
#
# A signal ends what runs, and then the tool, with 1.
# shellcheck shell=sh
work=$(mktemp -d) || exit 4
running=
trap 'rm -rf "$work"' EXIT
trap 'test -z "$running" || kill "$running" 2>/dev/null; exit 1' HUP INT QUIT PIPE TERM

compile() {
  name=$1
  shift
  ${CXX:-c++} -std=c++20 "$@" -o "$work/$name" "docs/tools/$name/$name.cpp" || exit 4
}

run() {
  name=$1
  shift
  # What runs in the background reads nothing unless it is asked to.
  exec 3<&0
  "$work/$name" "$@" <&3 &
  running=$!
  exec 3<&-
  wait "$running"
}
