#!/usr/bin/env bash
# half_installed_test.sh SOURCES CMAKE: what is optional may be there by half, and the programs are
# configured all the same; where it is there as a whole it is used.
set -euo pipefail
sources=$1 cmake=$2
cd "$sources"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
faults=0

# program PATH: one that is there and fails.
program() {
  mkdir -p "$(dirname "$1")"
  # shellcheck disable=SC2016 # the script that is made reads it
  printf '#!/bin/sh\necho "$0: a file that it needs is missing" >&2\nexit 1\n' >"$1"
  chmod +x "$1"
}

# configured WHAT [OPTIONS]: whether the programs and the Python package can be asked for.
configured() {
  local what=$1
  shift
  rm -rf "$folder/build"
  if "$cmake" --preset release -B "$folder/build" "$@" >"$folder/log" 2>&1 &&
    "$cmake" --build "$folder/build" --target changeover changeover_python_package -- -n \
    >"$folder/log2" 2>&1; then
    echo "$what: configured"
  else
    fault "$what: not configured" "$(tail -n 30 "$folder/log")"
  fi
}

fault() {
  faults=$((faults + 1))
  printf '%s\n' "$@"
}

# uses WHAT TEXT yes|no: whether the build has it.
uses() {
  local is=no
  ! grep -q -e "$2" "$folder/build/build.ninja" || is=yes
  [[ $is == "$3" ]] || fault "$1: used: $is, expected: $3" "$(cat "$folder/log")"
}

# As it is here: parts that are there are used, or leaving out would be no news.
configured 'nothing taken away'
has_mpi=no
! printf '#include <mpi.h>\nint main() { return MPI_Finalize(); }\n' |
  mpicxx -x c++ - -o "$folder/mpi" 2>/dev/null || has_mpi=yes
uses MPI CHANGEOVER_WITH_MPI "$has_mpi"
[[ ! -e /usr/include/pybind11/pybind11.h || ! -e $(/usr/bin/python3 -c 'import sysconfig; print(sysconfig.get_path("include"))')/Python.h ]] ||
  uses Python 'python/changeover/_core' yes

# Configured again with what was found before, lists among it.
"$cmake" --preset release -B "$folder/build" -U 'CHANGEOVER_*_WORKS' >"$folder/log" 2>&1 ||
  fault 'configured again: failed' "$(tail -n 30 "$folder/log")"
uses 'MPI, configured again' CHANGEOVER_WITH_MPI "$has_mpi"

# openmpi-bin without libopenmpi-dev: the compiler's wrapper names folders and libraries that are
# not there.
mkdir -p "$folder/mpi-bin/bin"
cat >"$folder/mpi-bin/bin/mpicxx" <<'END'
#!/bin/sh
include=-I/nonexistent/openmpi/include
link='-L/nonexistent/openmpi/lib -lmpi_cxx -lmpi'
case $1 in
-showme:compile) echo "$include -pthread" ;;
-showme:link) echo "$link -pthread" ;;
-showme:incdirs) echo /nonexistent/openmpi/include ;;
-showme:libdirs) echo /nonexistent/openmpi/lib ;;
-showme:libs) echo mpi_cxx mpi ;;
-show*) echo "c++ $include -pthread $link" ;;
*) exec c++ $include "$@" $link ;;
esac
END
chmod +x "$folder/mpi-bin/bin/mpicxx"
program "$folder/mpi-bin/bin/mpiexec"
MPI_HOME=$folder/mpi-bin configured 'MPI without its headers'
uses 'MPI without its headers' CHANGEOVER_WITH_MPI no

program "$folder/mpi-none/bin/mpicxx"
program "$folder/mpi-none/bin/mpiexec"
MPI_HOME=$folder/mpi-none configured 'MPI whose wrapper fails'

# pybind11 whose files are gone, and one without Python's headers.
mkdir -p "$folder/pybind11"
printf 'message(FATAL_ERROR "pybind11Targets.cmake is missing")\n' \
  >"$folder/pybind11/pybind11Config.cmake"
printf 'set(PACKAGE_VERSION 2.11)\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n' \
  >"$folder/pybind11/pybind11ConfigVersion.cmake"
configured 'half of pybind11' -D pybind11_DIR="$folder/pybind11"
uses 'half of pybind11' 'python/changeover/_core' no
configured 'Python without its headers' -D Python_INCLUDE_DIR=/nonexistent/python
uses 'Python without its headers' 'python/changeover/_core' no
program "$folder/python3"
configured 'a Python that does not start' -D Python_EXECUTABLE="$folder/python3"

# What makes builds faster.
program "$folder/bin/ccache"
program "$folder/bin/ld.mold"
PATH=$folder/bin:$PATH configured 'ccache and mold that do not start'
uses 'a ccache that does not start' "$folder/bin/ccache" no

# And all at once.
PATH=$folder/bin:$PATH MPI_HOME=$folder/mpi-bin configured 'all of it by half' -D \
  pybind11_DIR="$folder/pybind11"
echo "$faults faults"
[[ $faults -eq 0 ]]
