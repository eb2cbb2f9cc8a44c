#!/usr/bin/env bash
# Every verb with less and less memory, and searches with room for some of their threads only: they
# get through, or say in one line that memory or threads are missing and end with exit code 4. Files
# stay whole.
#
# A round is a limit for every command; the limits get closer with more rounds.
# shellcheck source=support/attack.sh
source "$(dirname "$0")/support/attack.sh"
CHANGEOVER=$(program CHANGEOVER) || exit
CHECKDESIGN=$(program CHECKDESIGN) || exit
[[ -z ${HOSTILE_SANITIZED:-} ]] ||
  skip 'the sanitizers need more address space than there is memory'

"$CHANGEOVER" design 253 13 --format text >large.txt || skip 'changeover design does not work'
"$CHANGEOVER" design 24 5 --format text --linear >part.txt
printf 'part,change cost\nA,1\nB,2\nC,3\nD,4\nE,5\n' >parts.csv
printf 'precious\n' >"$scratch/tools/old"

# The least that a program starts with, in kilobytes; what it does with little more is in question.
least_of() { # PROGRAM WORDS
  local least=2000
  while ((least < 400000)) && ! (ulimit -v $least && exec "$@") >/dev/null 2>&1; do
    least=$((least + 1000))
  done 2>/dev/null
  printf '%s\n' $least
}
least=$(least_of "$CHANGEOVER" describe)
checker_least=$(least_of "$CHECKDESIGN" --version)
((least < 400000)) || skip 'the program does not start with 400 MB'

# Text that verifies, JSON with its end, or a table with its last line.
is_whole_answer() { # FILE
  case $(head -c 1 "$1") in
    '#') "$CHANGEOVER" verify "$1" >/dev/null 2>&1 ;;
    '{') [[ $(tail -c 2 "$1") == '}' ]] ;;
    *) [[ -s $1 && -z $(tail -c 1 "$1") ]] ;;
  esac
}

commands=(
  'design 1001 10 --format text' 'design 253 13 --json' 'design 61 4 --format svg' \
    'verify large.txt --json'
  'verify large.txt -t 3' 'bounds 2000 40' 'explain 900 7' 'table --k 3..9 --v 5..60 --json'
  'search 41 6 --time 200ms --format text' 'search 41 6 --time 200ms --threads 64 --format text'
  'search 30 5 --exact --time 300ms --threads 8 --format text' \
    'search 13 6 --linear --exact --proof proofs --time 1s'
  'search 40 5 --base-blocks --time 200ms --threads 32 --format text' \
    'search --order part.txt --time 200ms --threads 16'
  'search --extend part.txt --time 200ms --threads 16 --format text' \
    'search 24 5 --checkpoint state --time 200ms'
  'classify 9 4 12 -m 1 --circular --threads 16' 'same large.txt large.txt' 'expand part.txt -w 0'
  'plan --items 40 --at-once 6 --test-cost 1 --change-cost 1 --time 200ms --threads 32 --json'
  'plan parts.csv -k 3 --test-cost 1 --time 100ms --what-if' \
    'loadorder --items 2000 --room 20 --json'
  'loadorder --items 30 --room 6 --time 200ms --threads 32' 'factorize 400' 'constructions' \
    'paper --format json'
)
step=$((40000 / (rounds + 1)))
((step >= 500)) || step=500
for ((beyond = 1500; beyond < 1500 + rounds * step; beyond += step)); do
  for command in "${commands[@]}"; do
    attacks=$((attacks + 1))
    cp "$scratch/tools/old" old
    # The quick round takes another limit for each command.
    extra=$((rounds > 1 ? beyond : beyond + attacks * 7919 % 50000))
    # shellcheck disable=SC2086 # the words of the command
    {
      (ulimit -v $((least + extra)) &&
        exec timeout -s KILL 30 "$CHANGEOVER" $command -o old >"$out" 2>"$err" </dev/null)
      code=$?
    } 2>/dev/null
    heard
    judge_ending
    tried="ulimit -v $((least + extra)); changeover $command -o old"
    # A team of threads may tell of more than one missing thing.
    [[ -z $defect ]] || fault "$tried: $defect"
    if [[ $code == [2345] || $code -gt 30 ]]; then
      # What was known before memory ran out may have been delivered.
      cmp -s old "$scratch/tools/old" || is_whole_answer old ||
        fault "$tried: the old file was lost; exit code $code"
    fi
    left=$(temporaries_in .)
    [[ -z $left ]] || { fault "$tried: left ${left//$'\n'/ }"; find . -name '.*.tmp' -delete; }
    rm -rf proofs state
  done
  for file in large.txt part.txt; do
    attacks=$((attacks + 1))
    { (ulimit -v $((checker_least + beyond)) &&
      exec "$CHECKDESIGN" $file >"$out" 2>"$err"); code=$?; } 2>/dev/null
    [[ $code == 0 || $code == 4 || $code == 127 ]] ||
      fault "ulimit -v $((checker_least + beyond)); checkdesign $file: exit code $code $(head -c \
      200 "$err")"
  done
done
finish
