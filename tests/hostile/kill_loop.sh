#!/usr/bin/env bash
# Searches, tables and plans are killed, interrupted, terminated and hung up at random moments while
# they have an older file to replace: it is the old one or the new one, whole, whatever happens; but
# for kill -9 nothing is left beside it; a search that is asked to stop does so in time and delivers
# what it has; and after kill -9 the next run goes on from what was kept.
#
# A round kills each job once; the signals take turns.
# shellcheck source=support/attack.sh
source "$(dirname "$0")/support/attack.sh"
CHANGEOVER=$(program CHANGEOVER) || exit

# What each job is, and how its file is known to be whole.
jobs_to_kill=(
  'design|search 30 6 --time 30s --format text'
  'design|search 24 5 --time 30s --format text --checkpoint state'
  'found|search 30 5 --exact --time 30s --format text --proof proofs'
  'found|search 28 6 --base-blocks --tight --time 30s --format text'
  'json|classify 13 5 22 -m 1 --time 30s --json'
  'json|plan --items 40 --at-once 6 --test-cost 1 --change-cost 1 --time 30s --json'
  'lines|loadorder --items 60 --room 7 --time 30s --json'
  'json|table --k 3..40 --v 5..160 --json'
  'design|design 4001 6 --format text'
)
signals=(INT KILL TERM HUP TWICE)

whole() { # KIND FILE
  case $1 in
    design | found) whole_design "$2" ;;
    json) [[ $(head -c 1 "$2")$(tail -c 2 "$2") =~ ^(\{\}|\[\])$ ]] ;;
    lines) [[ $(tail -c 2 "$2") == '}' ]] && ! grep -qv '^{.*}$' "$2" ;;
  esac
}

printf 'precious\n' >"$scratch/tools/old"
for ((round = 0; round < rounds; ++round)); do
  for ((j = 0; j < ${#jobs_to_kill[@]}; ++j)); do
    kind=${jobs_to_kill[j]%%|*}
    command=${jobs_to_kill[j]#*|}
    signal=${signals[(round + j) % ${#signals[@]}]}
    attacks=$((attacks + 1))
    cp "$scratch/tools/old" precious
    moment=$((RANDOM % 1800)) # milliseconds
    ((rounds > 1)) || moment=$((1000 + moment / 6))
    tried="changeover $command -o precious, SIG$signal after $moment ms"
    # A shell lets what it starts in the background ignore interrupts.
    # shellcheck disable=SC2086 # the words of the command
    env --default-signal=INT "$CHANGEOVER" $command -o precious >"$out" 2>"$err" </dev/null &
    process=$!
    printf -v pause '%d.%03d' $((moment / 1000)) $((moment % 1000))
    sleep "$pause"
    began=$SECONDS
    {
      if [[ $signal == TWICE ]]; then
        kill -INT $process
        sleep 0.05
        kill -INT $process
      else
        kill -"$signal" $process
      fi
      # Long enough for a busy machine; two or three seconds are meant.
      for ((i = 0; i < 100; ++i)); do kill -0 $process || break; sleep 0.1; done
      ! kill -9 $process || fault "$tried: still running 10 s later"
      wait $process
    } 2>/dev/null
    code=$?
    took=$((SECONDS - began))
    heard
    # Started long ago, so that its handlers are there, and not asked twice.
    asked=no
    [[ $signal == KILL || $signal == TWICE ]] || ((moment < 1000)) || asked=yes
    by_signal=$((128 + $(kill -l "${signal/TWICE/INT}")))
    if ! documented "$code" && ((code != by_signal)); then
      fault "$tried: exit code $code ${said:0:200}"
    elif [[ $asked == yes && $command =~ ^(search|classify|plan|loadorder) && $signal != HUP ]]; then
      documented "$code" || fault "$tried: exit code $code"
    fi
    ((took <= 8)) || fault "$tried: took $took s to stop"
    if cmp -s precious "$scratch/tools/old"; then
      # A search that had something when it was asked to stop hands it out.
      [[ $asked != yes || $signal == HUP || ! $command =~ ^(search.*\ 6\ --time|search\ 24|plan|loadorder) ]] ||
        fault "$tried: what was found is not in the file; exit code $code"
    elif [[ ! -e precious ]]; then
      fault "$tried: the old file is gone"
    elif ! whole "$kind" precious; then
      fault "$tried: the file is neither the old nor a new one"
    fi
    left=$(temporaries_in .)
    [[ -z $left || $signal == KILL ]] || fault "$tried: left ${left//$'\n'/ }"
    [[ -z $left ]] || find . "$TMPDIR" -mindepth 1 \( -name '.*.tmp' -o -path "$TMPDIR/*" \) -delete
    # What was kept serves the next run.
    if [[ $command == *--checkpoint* && -e state ]]; then
      run 15 "$CHANGEOVER" search 24 5 --checkpoint state --time 200ms --format text -o next
      [[ $code == 10 || $code == 30 ]] ||
        fault "$tried, then --checkpoint again: exit code $code ${said:0:200}"
      whole_design next || fault "$tried, then --checkpoint again: no design"
      ((RANDOM % 4 > 0)) || rm -f state
    elif [[ $command == *--proof* ]]; then
      run 15 "$CHANGEOVER" search 12 4 --linear --exact --proof proofs --format text -o next
      [[ $code == 10 ]] || fault "$tried, then --proof again: exit code $code ${said:0:200}"
      for file in proofs/*; do
        [[ -s $file ]] || fault "$tried: $file is empty"
      done
      rm -rf proofs
    fi
    rm -f next
  done
done
finish
