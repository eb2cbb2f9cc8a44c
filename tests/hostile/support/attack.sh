# shellcheck shell=bash
# What the attacks share; each script begins with `source "$(dirname "$0")/support/attack.sh"`.
#
#     CHANGEOVER, CHECKDESIGN, ALL_PAIRS   paths of the programs
#     HOSTILE_ROUNDS                       how often each attack is repeated with other values
#                                          (default 1)
#     HOSTILE_SEED                         of the random choices (default 1)
#
# A script works in a fresh folder that goes away with it, counts every attempt in `attacks`, tells
# each fault in one line with the command that shows it, and ends with `finish`: "N attacks, M
# faults", exit code 0 or 1. Exit code 77 means that this machine cannot be attacked in that way,
# and why.
set -u
export LC_ALL=C

rounds=${HOSTILE_ROUNDS:-1}
RANDOM=${HOSTILE_SEED:-1}
attacks=0
faults=0
own_pid=$BASHPID

skip() {
  printf 'skipped: %s\n' "$*" >&2
  exit 77
}

program() {
  [[ -n ${!1:-} ]] || skip "$1 does not say where the program is"
  [[ -x ${!1} ]] || skip "${!1} ($1) cannot be run"
  realpath -- "${!1}"
}

scratch=$(mktemp -d "${TMPDIR:-/tmp}/changeover-hostile-XXXXXX") || exit 1
at_exit=() # commands of the script that must not be forgotten, such as umount
clean() {
  local command process
  [[ $BASHPID == "$own_pid" ]] || return
  for process in $(jobs -p); do kill -9 "$process" 2>/dev/null; done
  for command in "${at_exit[@]}"; do eval "$command"; done
  cd / && chmod -R u+rwx "$scratch" 2>/dev/null
  rm -rf "$scratch"
}
trap clean EXIT
trap 'exit 143' TERM INT HUP

mkdir "$scratch/ground" "$scratch/tmp" "$scratch/said" "$scratch/tools"
cd "$scratch/ground" || exit 1
export TMPDIR=$scratch/tmp
unset COLUMNS NO_COLOR

# With sanitizers everything takes several times as long.
slower=1
case ${HOSTILE_SANITIZED:-} in
  '') ;;
  *thread*) slower=20 ;;
  *) slower=6 ;;
esac

# An address space that the sanitizers do not fit into is no fair limit for them.
limit_memory() {
  [[ -n ${HOSTILE_SANITIZED:-} ]] || ulimit -v "$1"
}

# As it would be typed, with what is too long cut.
quoted() {
  local word line=
  for word in "$@"; do
    ((${#word} <= 200)) || word="${word:0:40}…(${#word} bytes)"
    printf -v word '%q' "$word"
    line+="${line:+ }$word"
  done
  printf '%s' "$line"
}

fault() {
  faults=$((faults + 1))
  printf 'fault: %s\n' "$*"
}

finish() {
  printf '%d attacks, %d faults\n' "$attacks" "$faults"
  ((faults == 0)) || exit 1
  exit 0
}

# run SECONDS PROGRAM ARGUMENT...: sets code, out, err (files) and said (the text on standard
# error).
out=$scratch/said/out
err=$scratch/said/err
run() {
  local seconds=$1
  shift
  # The shell tells of processes that were killed; that is for the script to judge.
  { timeout -s KILL $((seconds * slower)) "$@" >"$out" 2>"$err" </dev/null; } 2>/dev/null
  code=$?
  heard
}
heard() {
  said=
  IFS= read -r -d '' -n 20000 said <"$err"
}

documented() {
  case $1 in 0 | 1 | 2 | 3 | 4 | 10 | 20 | 30) return 0 ;; *) return 1 ;; esac
}

# True if the text holds control characters (C0 but for line ends and tabs, DEL, C1) or is not
# UTF-8.
unclean() {
  local text=$1
  [[ $text != *[$'\x01'-$'\x08'$'\x0b'-$'\x1f'$'\x7f']* ]] || return 0
  [[ $text == *[$'\x80'-$'\xff']* ]] || return 1
  [[ $text != *$'\xc2'[$'\x80'-$'\x9f']* ]] || return 0
  ! printf '%s' "$text" | iconv -f UTF-8 -t UTF-8 >/dev/null 2>&1
}

# What is wrong with how the program ended, into `defect`; empty if nothing is. `code`, `said` are
# of `run`.
judge_ending() {
  defect=
  local lines=${said//[!$'\n']/}
  if ! documented "$code"; then
    defect="exit code $code"
    ((code != 137)) || defect="did not end in time (or was killed)"
    ((code != 139)) || defect="segmentation fault"
    ((code != 5)) || defect="exit code 5: ${said:0:200}"
    # An answer of gigabytes takes its time: then it has begun.
    ((code != 137 || $(stat -c %s "$out" 2>/dev/null || echo 0) <= 1000000)) || defect=
  elif ((${#said} >= 20000 && code >= 2 && code <= 4)); then
    defect="exit code $code with more than 20,000 bytes on standard error: ${said:0:200}"
  elif ((code == 4)) && [[ -z $said && -s $out ]]; then
    : # "No such design is known" is an answer.
  elif ((code >= 2 && code <= 4)) && ((${#lines} != 1)); then
    defect="exit code $code with ${#lines} lines on standard error: ${said:0:200}"
  elif ((code >= 2 && code <= 4)) && [[ $said != changeover:\ * ]]; then
    defect="exit code $code, but its line does not begin with its name: ${said:0:200}"
  elif unclean "$said"; then
    printf -v defect 'raw bytes on standard error: %q' "${said:0:200}"
  fi
}

# Every name in the folder, hidden ones too, one a line.
names_here() {
  local names
  shopt -s nullglob dotglob
  names=(*)
  shopt -u nullglob dotglob
  printf '%s\n' "${names[@]}"
}

# Temporary files are called .NAME.PROCESS-NUMBER.tmp.
temporaries_in() {
  find "$@" \( -name '.*.tmp' -o -path "$TMPDIR/*" \) 2>/dev/null
}

whole_design() {
  timeout -s KILL 60 "$CHANGEOVER" verify "$1" >/dev/null 2>&1
}
