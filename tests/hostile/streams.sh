#!/usr/bin/env bash
# Standard streams that are closed, full, a pipe whose reader left, or a terminal that vanished, for
# every verb: a documented exit code, no signal, the answer in its file as if nothing had been, and
# no silence about an answer that could not be written.
# shellcheck source=support/attack.sh
source "$(dirname "$0")/support/attack.sh"
CHANGEOVER=$(program CHANGEOVER) || exit
CHECKDESIGN=$(program CHECKDESIGN) || exit
[[ -c /dev/full ]] || skip "there is no /dev/full"

"$CHANGEOVER" design 6 4 --circular --format text >good.txt ||
  skip "changeover design does not work"
printf '0 1 3\n1 2 4\n2 3 5\n3 4 6\n4 5 0\n5 6 1\n6 0 2\n' >fano.txt
printf 'part,change cost\nA,1\nB,2\nC,3\nD,4\nE,5\n' >parts.csv
printf '# changeover design v=6 k=4 change=2 kind=linear\n0 1 2 3\n4 1 2 3\n4 5 0 1\n' >broken.txt
printf '# changeover design v=7 k=3 change=1 kind=linear\n0 1 2\n0 1 3\n' >part.txt

commands=(
  'design 13 4 --format text' 'design 13 4' 'verify good.txt --json' 'verify good.txt' 'bounds 20 5'
  'explain 20 5 --json' 'search 9 4 -m 1 --format text' 'search 8 4 -m 1 --exact --format json'
  'search --order fano.txt --format text' 'search --extend part.txt --time 300ms --format text'
  'search --repair broken.txt --time 300ms --format text' 'search 11 4 --base-blocks --format text'
  'search 30 6 --time 300ms --format text' 'classify 7 3 --json' 'same good.txt good.txt'
  'table --k 3..4 --v 5..9 --json' \
    'plan --items 9 --at-once 3 --test-cost 1 --change-cost 5 --time 300ms --json'
  'plan parts.csv -k 3 --test-cost 2 --time 300ms --format csv' 'expand good.txt --format json'
  'factorize 8' 'constructions --json' 'paper --format markdown' \
    'loadorder --items 20 --room 5 --json'
  'loadorder --items 12 --room 4 --time 300ms' 'completion bash' 'manual design' 'describe' \
    '--help' '--version'
  'search --help' 'design 4 2' 'design x' 'verify missing.txt'
)

# with STREAMS COMMAND: runs it with redirections; sets code and said. Files are $out and $err.
with() {
  attacks=$((attacks + 1))
  : >"$out"
  : >"$err"
  tried="changeover $2 $1"
  {
    # shellcheck disable=SC2086 # the words of the command
    eval "timeout -s KILL $((20 * slower)) \"\$CHANGEOVER\" $2 </dev/null >\"\$out\" 2>\"\$err\" $1"
    code=$?
  } 2>/dev/null
  heard
}

complain_unless_documented() {
  documented "$code" || fault "$tried: exit code $code ${said:0:200}"
}

# The quick round takes every sixth command.
turn=$((RANDOM % 6))
for command in "${commands[@]}"; do
  turn=$((turn + 1))
  ((rounds > 1 || turn % 6 == 0)) || continue
  with '' "$command"
  usual=$code
  complain_unless_documented
  for streams in '>&-' '2>&-' '<&-' '<&- >&- 2>&-' '2>/dev/full' '>/dev/full 2>/dev/full'; do
    with "$streams" "$command"
    complain_unless_documented
    if [[ $streams == '2>/dev/full' || $streams == '2>&-' || $streams == '<&-' ]] &&
      ((code != usual)); then
      fault "$tried: exit code $code, but $usual with all streams"
    fi
  done
  with '>/dev/full' "$command"
  complain_unless_documented
  # What refuses or writes to standard error has nothing to say there.
  if ((usual == 0 || usual == 1 || usual == 10 || usual == 30)) && ((code != 4)); then
    fault "$tried: exit code $code, but the answer was not written"
  fi
  # A reader that left, as the shell has it, and with SIGPIPE ignored.
  for ignored in '' PIPE; do
    attacks=$((attacks + 1))
    tried="changeover $command | true${ignored:+ (SIGPIPE ignored)}"
    exec {gone}> >(true)
    wait $!
    # shellcheck disable=SC2086
    {
      (
        [[ -z $ignored ]] || trap '' PIPE
        timeout -s KILL $((20 * slower)) "$CHANGEOVER" $command 2>"$err" </dev/null 1>&"$gone"
      )
      code=$?
    } 2>/dev/null
    exec {gone}>&-
    heard
    # As other filters, it may end by the signal, unless that is ignored.
    [[ $code == 141 && -z $ignored ]] || complain_unless_documented
  done
done

# The answer in a file is the same, byte by byte, whatever the streams are: no descriptor is
# mistaken.
for command in 'design 13 4 --format text' 'search 9 4 -m 1 --format text' \
  'table --k 3..4 --v 5..9 --json' \
  'search 8 4 -m 1 --exact --format text' 'loadorder --items 20 --room 5 --json' \
  'plan --items 9 --at-once 3 --test-cost 1 --change-cost 5 --time 200ms --seed 1 --threads 1 --json'; do
  rm -f usual.txt
  with '' "$command -o usual.txt"
  usual=$code
  for streams in '>&-' '2>&-' '<&-' '<&- >&- 2>&-' '>/dev/full' '2>/dev/full' \
    '>/dev/full 2>/dev/full'; do
    rm -f x.txt
    with "$streams" "$command -o x.txt"
    complain_unless_documented
    if [[ ! -e x.txt ]]; then
      fault "$tried: no file (exit code $code ${said:0:200})"
    elif [[ $command == plan* || $command == search* ]]; then # They tell how long it took.
      [[ $command == plan* ]] || whole_design x.txt || fault "$tried: not a design"
      ! grep -q 'changeover:' x.txt || fault "$tried: messages in the file"
    else
      cmp -s usual.txt x.txt || fault "$tried: another file"
    fi
    ((code == usual)) || fault "$tried: exit code $code, but $usual with all streams"
  done
done
for streams in '>&-' '2>&-' '<&- >&- 2>&-' '2>/dev/full'; do
  rm -rf proofs
  with "$streams" 'search 12 4 --linear --exact --proof proofs'
  complain_unless_documented
  [[ $said != 'changeover: :'* ]] || fault "$tried: names nothing: $said"
  [[ -z $(find proofs -empty -type f 2>/dev/null) ]] || fault "$tried: an empty proof"
done

# Progress that cannot be written: the first line in a log comes after ten seconds.
long_enough=$((rounds > 1 ? 12 : 1))
with '2>/dev/full' "search 41 6 --time ${long_enough}s --format text -o found.txt"
((code == 10 || code == 30)) || fault "$tried: exit code $code"
whole_design found.txt || fault "$tried: no design in found.txt"
if ((rounds > 1)); then
  with '2>/dev/full' "search 30 5 --exact --time 12s --format text -o exact.txt"
  ((code == 10 || code == 30)) || fault "$tried: exit code $code"
  with '2>/dev/full' \
    "plan --items 30 --at-once 5 --test-cost 1 --change-cost 1 --time 12s --json -o plan.json"
  [[ $code == 0 && -s plan.json ]] || fault "$tried: exit code $code"
  with '2>/dev/full' "loadorder --items 40 --room 6 --time 12s --json -o order.jsonl"
  [[ ($code == 0 || $code == 30) && -s order.jsonl ]] || fault "$tried: exit code $code"
fi

# The checker must not say "valid" into nothing.
for streams in '>/dev/full' '2>/dev/full' '>&-' '<&-'; do
  attacks=$((attacks + 1))
  { eval "\"\$CHECKDESIGN\" good.txt >\"\$out\" $streams"; code=$?; } 2>/dev/null
  documented "$code" || fault "checkdesign good.txt $streams: exit code $code"
  [[ $streams != '>/dev/full' || $code == 4 ]] ||
    fault "checkdesign good.txt $streams: exit code $code, not 4"
done

# A terminal that vanishes in the middle of a search: its hang-up ignored, as under nohup, and not.
terminal=$scratch/tools/terminal.sh
cat >"$terminal" <<END
#!/usr/bin/env bash
[[ \$1 != ignore ]] || trap '' HUP
"$CHANGEOVER" \$2 -o vanished.txt >/dev/null </dev/null &
child=\$!
trap 'kill -HUP \$child' HUP
[[ \$1 != ignore ]] || trap '' HUP
printf '%s\n' \$child >child
wait \$child || code=\$?
while kill -0 \$child 2>/dev/null; do wait \$child; code=\$?; done
printf '%s\n' \${code:-0} >code.new && mv code.new code
END
if ! script -qec true /dev/null >/dev/null 2>&1 </dev/null; then
  printf 'no pseudo-terminal can be opened here: terminals that vanish were left out\n'
else
  for hangup in ignore obey; do
    for command in 'search 41 6 --time 2500ms --format text' \
      'search 30 5 --exact --time 2500ms --format text' \
      'plan --items 30 --at-once 5 --test-cost 1 --change-cost 1 --time 2500ms --json' \
      'loadorder --items 40 --room 6 --time 2500ms --json'; do
      ((rounds > 1)) ||
        [[ $hangup$command == ignoresearch\ 41* || $hangup$command == obeyplan* ]] || continue
      attacks=$((attacks + 1))
      rm -f vanished.txt code child
      tried="changeover $command -o vanished.txt on a terminal that vanishes ($hangup its hang-up)"
      setsid script -qec "bash $terminal $hangup '$command'" /dev/null >/dev/null 2>&1 </dev/null &
      session=$!
      for ((i = 0; i < 50; ++i)); do [[ ! -s child ]] || break; sleep 0.1; done
      sleep 1
      { kill -9 "$session"; wait "$session"; } 2>/dev/null
      for ((i = 0; i < 150; ++i)); do [[ ! -s code ]] || break; sleep 0.1; done
      ended=$(cat code 2>/dev/null)
      code=${ended:-none}
      if [[ $hangup == ignore ]]; then
        documented "$code" || fault "$tried: exit code $code"
        [[ -s vanished.txt ]] || [[ $command == *--exact* ]] || fault "$tried: no result"
      elif ! documented "$code" && ((code != 129)); then
        fault "$tried: exit code $code"
      fi
      [[ -z $(temporaries_in .) ]] || fault "$tried: left $(temporaries_in .)" && rm -f .*.tmp
      [[ ! -s vanished.txt || $command != search* ]] || whole_design vanished.txt ||
        fault "$tried: vanished.txt is no design"
    done
  done
fi
left=$(temporaries_in .)
[[ -z $left ]] || fault "left ${left//$'\n'/ }"
finish
