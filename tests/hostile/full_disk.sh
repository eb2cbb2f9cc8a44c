#!/usr/bin/env bash
# Results, checkpoints, proofs and temporaries on a disk that is full, becomes full or goes away
# while a search runs, and under a limit on the size of files: exit code 4 with one line that says
# so, the old file intact, nothing half-written left, and what was searched for is never lost: it is
# in the current folder or on standard output.
#
# The full disk is a small tmpfs, which needs root; without, the limits on sizes (ulimit -f) remain.
# shellcheck source=support/attack.sh
source "$(dirname "$0")/support/attack.sh"
CHANGEOVER=$(program CHANGEOVER) || exit

printf 'precious\n' >"$scratch/tools/old"

# Runs in the background with standard output through a pipe, which no limit on files meets.
# start LIMIT COMMAND: LIMIT in kilobytes or "unlimited".
start() {
  rm -f "$scratch/said/code"
  (
    {
      ulimit -f "$1"
      # shellcheck disable=SC2086 # the words of the command
      timeout -s KILL $((60 * slower)) "$CHANGEOVER" $2 2>"$err" </dev/null
      printf '%s\n' $? >"$scratch/said/code"
    } | cat >"$out"
  ) 2>/dev/null &
  process=$!
}
await() {
  wait "$process" 2>/dev/null
  code=none
  [[ ! -s $scratch/said/code ]] || read -r code <"$scratch/said/code"
  heard
}
ended() { [[ -s $scratch/said/code ]]; }

# The design is on standard output or in a file of this folder that was not there.
delivered() {
  local name
  whole_design "$out" && return 0
  while IFS= read -r name; do
    [[ ! -f $name || $name == blocks.txt || $name == part.txt ]] || { whole_design "$name" &&
      return 0; }
  done < <(names_here)
  return 1
}

refused() { # what was tried
  if [[ $code != 4 ]]; then
    fault "$1: exit code $code ${said:0:200}"
  elif [[ $said != *changeover:\ * ]]; then
    fault "$1: exit code 4 without a word"
  fi
}

nothing_left() { # what was tried, folders
  local left
  left=$(temporaries_in "${@:2}" "$TMPDIR" -mindepth 1)
  [[ -z $left ]] ||
    { fault "$1: left ${left//$'\n'/ }"; find "${@:2}" "$TMPDIR" -mindepth 1 -name '.*.tmp' \
    -delete; }
}

clear_folder() {
  find . -mindepth 1 -maxdepth 1 ! -name disk -exec rm -rf {} +
}

writers=(
  'design 253 13 --json' 'design 61 4 --format svg' 'table --k 3..8 --v 5..60 --json' \
    'paper --format json'
  'loadorder --items 200 --room 20 --json' 'factorize 120'
  'plan --items 20 --at-once 4 --test-cost 1 --change-cost 1 --time 200ms --format html'
  'classify 9 4 15 -m 1 --time 500ms --designs --json'
)
time=--time\ ${slower}s
searches=(
  "search 41 6 $time --format text" "search --order blocks.txt -m 2 $time --format text"
  "search --extend part.txt $time --format text" "search 30 5 $time --format text"
)
# after TENTHS: of a second, in which a search has begun, but has not ended.
after() {
  sleep "$(($1 * slower / 10)).$(($1 * slower % 10))"
}
inputs() {
  "$CHANGEOVER" design 40 5 --linear --format text | sed '/^#/d' >blocks.txt
  printf '# changeover design v=24 k=4 change=2 kind=linear\n0 1 2 3\n0 1 4 5\n' >part.txt
}

# The quick round takes every other command.
turn=$((RANDOM % 2))
due() {
  turn=$((turn + 1))
  ((rounds > 1 || turn % 2 == 0))
}

# A limit on the size of files, for any user: a file that was there stays.
attack_old() {
  attacks=$((attacks + 1))
  cp "$scratch/tools/old" old
  start 1 "$1 -o old"
  await
  tried="ulimit -f 1; changeover $1 -o old"
  refused "$tried"
  cmp -s old "$scratch/tools/old" || fault "$tried: the old file was lost"
}
for command in "${writers[@]}"; do
  due || continue
  attack_old "$command"
  nothing_left "$tried" .
  clear_folder
done
inputs
for command in "${searches[@]}"; do
  due || continue
  attack_old "$command"
  delivered || fault "$tried: the design was lost"
  nothing_left "$tried" .
done
clear_folder
attacks=$((attacks + 2))
start 1 "search 41 6 $time --checkpoint state --format text"
await
documented "$code" ||
  fault "ulimit -f 1; changeover search 41 6 --checkpoint state: exit code $code ${said:0:200}"
delivered || fault "ulimit -f 1; changeover search 41 6 --checkpoint state: the design was lost"
nothing_left "ulimit -f 1; changeover search 41 6 --checkpoint state" .
start 1 'search 13 6 --linear --exact --proof proofs --time 3s --format text'
await
refused "ulimit -f 1; changeover search 13 6 --linear --exact --proof proofs"
nothing_left "ulimit -f 1; changeover search --exact --proof proofs" .
clear_folder

disk=$scratch/ground/disk
mkdir "$disk"
if [[ $(id -u) != 0 ]] || ! mount -t tmpfs -o size=256k hostile "$disk" 2>/dev/null; then
  printf 'a tmpfs cannot be mounted here: full disks were left out\n'
  ((attacks > 0)) || skip 'nothing to do'
  finish
fi
at_exit+=("umount -l '$disk' 2>/dev/null")

# fill BYTES: leaves so much of it.
fill() {
  head -c 1000000 /dev/zero >"$disk/filler" 2>/dev/null
  truncate -s $(($(stat -c %s "$disk/filler") - $1)) "$disk/filler"
}
fresh_disk() {
  find "$disk" -mindepth 1 -delete
  cp "$scratch/tools/old" "$disk/old"
}

for command in "${writers[@]}"; do
  for left in 0 4096; do
    ((rounds > 1)) || { [[ $left == 0 ]] && due; } || continue
    attacks=$((attacks + 1))
    fresh_disk
    fill $left
    start unlimited "$command -o disk/old"
    await
    tried="changeover $command -o disk/old with $left bytes left"
    if ((left == 0)) || [[ $code != 0 ]]; then # A small answer may fit.
      refused "$tried"
      cmp -s "$disk/old" "$scratch/tools/old" || fault "$tried: the old file was lost"
    fi
    nothing_left "$tried" . "$disk"
  done
done

inputs
for ((round = 0; round < rounds; ++round)); do
  for command in "${searches[@]}"; do
    # Full at once and from the middle on; the folder taken away.
    for how in full fills vanishes; do
      due || continue
      attacks=$((attacks + 1))
      fresh_disk
      mkdir "$disk/folder"
      cp "$scratch/tools/old" "$disk/folder/old"
      [[ $how != full ]] || fill 0
      start unlimited "$command -o disk/folder/old"
      after $((3 + RANDOM % 4))
      if [[ $how != full ]] && ended; then # Found sooner than that: nothing to attack.
        await
        whole_design "$disk/folder/old" || fault "changeover $command: exit code $code, no design"
        continue
      fi
      [[ $how != fills ]] || fill 0
      [[ $how != vanishes ]] || rm -rf "$disk/folder"
      if [[ $how != full ]] && ended; then # In between.
        await
        find . -maxdepth 1 -type f ! -name blocks.txt ! -name part.txt -delete
        continue
      fi
      await
      tried="changeover $command -o disk/folder/old, the disk $how"
      [[ $how != vanishes ]] ||
        tried="changeover $command -o disk/folder/old, the folder is removed"
      refused "$tried"
      [[ $how == vanishes ]] || cmp -s "$disk/folder/old" "$scratch/tools/old" ||
        fault "$tried: the old file was lost"
      # What fails before any work has nothing to lose.
      [[ $how == full ]] || delivered || fault "$tried: the design was lost"
      nothing_left "$tried" . "$disk"
      find . -maxdepth 1 -type f ! -name blocks.txt ! -name part.txt -delete
    done
  done
  # A checkpoint that cannot be kept is no reason to stop searching.
  for how in full fills; do
    attacks=$((attacks + 1))
    fresh_disk
    [[ $how != full ]] || fill 0
    start unlimited "search 41 6 $time --checkpoint disk/state --format text -o x.txt"
    after 5
    [[ $how != fills ]] || fill 0
    await
    tried="changeover search 41 6 $time --checkpoint disk/state -o x.txt, the disk $how"
    documented "$code" || fault "$tried: exit code $code"
    # Refused before it began, or the result is there.
    [[ $how == full && $code == 4 && $said == changeover:\ * ]] || whole_design x.txt ||
      fault "$tried: the design was lost; exit code $code ${said:0:200}"
    [[ $said == *changeover:\ * ]] || fault "$tried: nothing was said"
    nothing_left "$tried" . "$disk"
    rm -f x.txt
  done
  # Proofs, and temporaries of searches that keep none.
  for how in full fills; do
    for place in 'proof' 'tmp'; do
      attacks=$((attacks + 1))
      fresh_disk
      mkdir "$disk/proofs"
      [[ $how != full ]] || fill 0
      usual_tmpdir=$TMPDIR
      option='--proof disk/proofs'
      [[ $place != tmp ]] || { option=; TMPDIR=$disk; }
      start unlimited "search 11 4 -m 1 --exact $time $option --format text -o x.txt"
      after 4
      [[ $how != fills ]] || fill 0
      await
      export TMPDIR=$usual_tmpdir
      tried="changeover search 11 4 -m 1 --exact $option -o x.txt, the disk of its ${place}s $how"
      documented "$code" || fault "$tried: exit code $code ${said:0:200}"
      [[ $code != 4 || $said == *changeover:\ * ]] || fault "$tried: exit code 4 without a word"
      [[ $code != 20 && $code != 10 ]] || [[ -s x.txt ]] ||
        fault "$tried: exit code $code without a result"
      nothing_left "$tried" . "$disk"
      [[ $place != proof ]] || [[ -z $(find "$disk/proofs" -type f -empty) ]] ||
        fault "$tried: an empty proof is left"
      rm -f x.txt
    done
  done
  attacks=$((attacks + 1))
  fresh_disk
  fill 8192
  start unlimited 'paper --figures disk/figures'
  await
  refused 'changeover paper --figures disk/figures, the disk full'
  nothing_left 'changeover paper --figures disk/figures, the disk full' . "$disk"
done
finish
