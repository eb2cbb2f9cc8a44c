#!/usr/bin/env bash
# Stop means stop: --time and the first Ctrl-C end the largest questions within seconds, wherever
# they are (building a formula, a table, a known design), with a documented exit code; and memory
# stays within what --memory says, or the program declines in one line with exit code 4.
#
# The limits here leave room for a busy machine: what is meant is a second or two.
# shellcheck source=support/attack.sh
source "$(dirname "$0")/support/attack.sh"
CHANGEOVER=$(program CHANGEOVER) || exit
patience=$((8 * slower))
limit_memory 12000000

# "time": with --time; "ask": with an interrupt; both for the others. A star: in the quick round
# too.
questions=(
  '*both|search 60 5 --exact' 'both|search 100 4 --exact' '*both|search 65535 4 --exact'
  '*time|search 10 4 -b 65536 --exact' '*both|search --order long.txt' \
    'both|search --order long.txt -m 2'
  '*both|search 120 6 -t 4' '*both|search 4000 4' 'both|search 65535 4' 'both|search 3000 5 -m 1'
  '*time|plan --items 9 -k 9223372036854775807 --test-cost 1 --change-cost 1'
  'both|plan --items 3000 -k 12 --test-cost 1 --change-cost 1'
  '*both|plan --model pigeons.txt --test-cost 1 --change-cost 1'
  '*both|classify 40 6' 'both|classify 12 5 19 -m 1' '*both|loadorder --items 3000 --room 12'
  'both|search 200 8 --base-blocks' 'both|search 1001 4 --base-blocks --tight'
  'both|search --extend part.txt' 'both|search --repair broken.txt' \
    '*ask|table --k 3..60 --v 5..900'
  '*ask|design 65535 4 --format text -o x.txt' 'ask|design 65535 3 --format text -o x.txt' \
    'ask|explain 65535 4' 'ask|bounds 65535 4'
  'ask|expand large.txt --count' 'ask|expand large.txt --partial' 'ask|expand large.txt -w 0'
  'ask|verify long.txt -t 4 -v 600' 'ask|same large.txt large.txt' 'ask|factorize 20000 -o x.txt'
  '*time|minima --v 16' 'ask|minima --v 16 --time 60'
)

# 60,000 blocks, and a design that is large for expansion.
awk 'BEGIN { for (i = 0; i < 60000; ++i) print i % 500, 500 + (i * 7) % 400, 900 + (i * 11) % 300, 1200 + i % 7 }' |
  sort -u >long.txt
"$CHANGEOVER" design 601 4 --format text >large.txt || fault 'changeover design does not work'
printf '# changeover design v=900 k=6 change=2 kind=linear\n0 1 2 3 4 5\n0 1 2 3 6 7\n' >part.txt
printf '# changeover design v=900 k=6 change=2 kind=linear\n0 1 2 3 4 5\n0 1 2 8 6 7\n' >broken.txt
# Twelve parameters that must all be different, and eleven values.
for i in {1..12}; do
  echo "P$i: 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11"
done >pigeons.txt
for ((i = 1; i <= 12; ++i)); do
  for ((j = i + 1; j <= 12; ++j)); do echo "[P$i] <> [P$j];"; done
done >>pigeons.txt

# Verbs that know --memory.
declare -A has_memory=()
for verb in search plan classify loadorder minima table design explain bounds expand verify same \
  factorize; do
  has_memory[$verb]=no
  ! "$CHANGEOVER" $verb --help | grep -q -e '--memory' || has_memory[$verb]=yes
done

# ask SECONDS COMMAND: interrupts it after so long (0: never); sets code, took (ms after the limit)
# and peak (kilobytes).
ask() {
  local limit=$1 began now line
  shift
  # A shell lets what it starts in the background ignore interrupts.
  { env --default-signal=INT "$CHANGEOVER" "$@" >"$out" 2>"$err" </dev/null & } 2>/dev/null
  process=$!
  peak=0 took=0 asked=no
  began=${EPOCHREALTIME/./}
  while kill -0 $process 2>/dev/null; do
    while read -r line; do
      [[ $line != VmHWM:* ]] || { line=${line//[!0-9]/}; ((line <= peak)) || peak=$line; }
    done 2>/dev/null </proc/$process/status
    now=$(((${EPOCHREALTIME/./} - began) / 1000))
    took=$((now - 1000))
    if [[ $limit == ask && $asked == no ]] && ((took > 0)); then
      asked=yes
      kill -INT $process 2>/dev/null
    fi
    if ((took > patience * 1000)); then
      kill -9 $process 2>/dev/null
      break
    fi
    sleep 0.03
  done
  wait $process 2>/dev/null
  code=$?
  heard
}

turns=(time ask)
for question in "${questions[@]}"; do
  [[ $question == \** ]] || ((rounds > 1)) || continue
  question=${question#\*}
  read -r -a words <<<"${question#*|}"
  how=${question%%|*}
  if [[ $how == both ]]; then # In the quick round one of the two, in turn.
    how='time ask'
    ((rounds > 1)) || how=${turns[attacks % 2]}
  fi
  for limit in $how; do
    attacks=$((attacks + 1))
    more=()
    [[ ${words[0]} != search && ${words[0]} != plan && ${words[0]} != loadorder || $question == *--exact* ]] ||
      more=(--seed 1)
    if [[ $limit == time ]]; then
      more+=(--time 1)
    elif [[ ${words[0]} =~ ^(search|plan|loadorder|classify)$ ]]; then
      more+=(--time 60)
    fi
    [[ ${has_memory[${words[0]}]} == no ]] || more+=(--memory 600M)
    tried="changeover ${words[*]} ${more[*]}"
    [[ $limit != ask ]] || tried+=', SIGINT after 1 s'
    ask "$limit" "${words[@]}" "${more[@]}"
    ((took <= patience * 1000)) || fault "$tried: still running $patience s after that"
    # Verbs that have nothing to hand out are ended by the signal itself, and say so.
    if ((took <= patience * 1000)) && ! documented "$code"; then
      [[ $limit == ask && $code == 130 && $said == *'stopped by Ctrl-C before the end'* ]] ||
        fault "$tried: exit code $code ${said:0:200}"
    fi
    # A question that is not understood is no attack.
    [[ $code != 2 || ${words[0]} == plan ]] || fault "$tried: exit code 2: ${said:0:200}"
    ((code != 4)) || [[ $said == changeover:\ * ]] || [[ -s $out ]] ||
      fault "$tried: exit code 4 without a word"
    # A third more for what no count of large tables sees.
    if [[ ${has_memory[${words[0]}]} == yes && -z ${HOSTILE_SANITIZED:-} ]]; then
      ((peak <= 800000)) || fault "$tried: $((peak / 1000)) MB"
    else
      ((peak <= 4000000)) || fault "$tried: $((peak / 1000)) MB"
    fi
    [[ -z $(temporaries_in .) ]] || { fault "$tried: left $(temporaries_in .)"; rm -f .*.tmp; }
    printf '%6d ms over, %5d MB, exit code %3d: %s\n' $((took > 0 ? took : 0)) $((peak / 1000)) \
      "$code" "$tried"
  done
done
[[ ${has_memory[search]} == yes ]] || fault 'changeover search has no --memory'
finish
