#!/usr/bin/env bash
# A folder of state that lives on while one verb after another works in it and is killed,
# interrupted, terminated or left alone: searches with checkpoints and proofs, run sheets, tables,
# designs, a catalog that is added to, imported into, improved, exported and verified, jobs of all
# pairs with a journal, a server that keeps designs. After each end: every file that no process was
# writing is as it was, what was written is whole, what was acknowledged is there, the database
# holds, the next run goes on from what is kept, and what kills leave behind does not grow without
# bound.
#
# Two verbs run at a time. SOAK_SECONDS says how long (default 10, and three minutes for each
# further round).
# shellcheck source=support/attack.sh
# shellcheck disable=SC2317 # what is called by a name that is put together
source "$(dirname "$0")/support/attack.sh"
CHANGEOVER=$(program CHANGEOVER) || exit
ALL_PAIRS=${ALL_PAIRS:+$(program ALL_PAIRS)} || exit
seconds=${SOAK_SECONDS:-$((10 + 180 * (rounds - 1)))}
export CHANGEOVER_CATALOG=$scratch/ground/mine.db

tools=$scratch/tools
mkdir "$tools/designs" "$tools/sums" "$tools/best"
: >"$tools/acknowledged"

# --------------------------------------------------------------------------- what the verbs work on

# A design under other names of its elements, and as far as it likes beyond its end, so that there
# is always another one to add.
"$CHANGEOVER" design 8 4 --change 1 --linear --format text | grep -v '^#' >"$tools/blocks"
another_design() { # FILE
  awk -v seed="$((RANDOM * 32768 + RANDOM))" '
    function below(n) { return int(rand() * n) }
    function show(   text, i) {
      for (i = 1; i <= 4; ++i) text = text (i > 1 ? " " : "") name[block[i]]
      print text
    }
    BEGIN { srand(seed); for (i = 0; i < 8; ++i) name[i] = i
            for (i = 7; i > 0; --i) { j = below(i + 1); t = name[i]; name[i] = name[j]; name[j] = t } }
    { for (i = 1; i <= 4; ++i) block[i] = $i
      show() }
    END { for (more = below(8); more > 0; --more) {
            do { x = below(8); there = 0; for (i = 1; i <= 4; ++i) there += block[i] == x } while (there)
            block[1 + below(4)] = x
            show() } }' "$tools/blocks" >"$1"
}
for i in 1 2 3 4 5 6; do another_design "$tools/designs/import$i"; done
"$CHANGEOVER" catalog add "$tools"/designs/import* --even-isomorphic --catalog "$tools/theirs.db" >/dev/null 2>&1
"$CHANGEOVER" catalog export --users --catalog "$tools/theirs.db" -o "$tools/theirs.jsonl" 2>/dev/null ||
  fault 'a catalog cannot be exported'
printf 'Pump,3\nFan,2\nBelt,2\nMotor,7\nValve,1\nPipe,1\nTank,9\n' >"$tools/parts.csv"
if [[ -n $ALL_PAIRS ]]; then
  { "$ALL_PAIRS" make data 40 300 && "$ALL_PAIRS" run data 300 --chunk 3 --memory 40K; } >/dev/null ||
    fault 'all_pairs does not work'
  mv data.gram "$tools/right.gram"
  mv data.dist "$tools/right.dist"
fi

# --------------------------------------------------------------------------------------- what holds

# The last word on each file: its name, and its checksum while no process was writing to it.
remember() { # FILE...
  local file
  for file in "$@"; do
    if [[ -e $file ]]; then
      sha256sum <"$file" >"$tools/sums/${file//\//@}"
    else
      rm -f "$tools/sums/${file//\//@}"
    fi
  done
}
# Files that no running verb may write are as they were. Those of the other one are its own affair.
others_are_as_they_were() { # TRIED FILE... of those that may have changed
  local tried=$1 sum file name
  shift
  for sum in "$tools"/sums/*; do
    [[ -e $sum ]] || continue
    name=${sum##*/}
    file=${name//@//}
    [[ " $* ${files_of[0]} ${files_of[1]} " != *" $file "* ]] || continue
    if [[ ! -e $file ]]; then
      fault "$tried: $file is gone"
      rm -f "$sum"
    elif [[ $(sha256sum <"$file") != "$(<"$sum")" ]]; then
      fault "$tried: $file is not what it was"
      remember "$file"
    fi
  done
}
json_is_whole() { [[ $(head -c 1 "$1")$(tail -c 2 "$1") == @('{}'|'[]') ]]; }
# How many blocks a design in text has.
blocks_of() { grep -cv '^#' "$1"; }
labels_there() {
  "$CHANGEOVER" catalog list --users --all --format csv 2>"$tools/list.err" | tail -n +2 | cut -d, -f1 | sort
}
acknowledge() { # FILE: what a verb said
  sed -nE 's/^(added|there already): ([^, ]*).*/\2/p' "$1" >>"$tools/acknowledged"
}
# Everything that was said to be there is there, and the file is one.
the_catalog_holds() { # TRIED
  local missing
  labels_there >"$tools/there"
  [[ ! -s $tools/list.err ]] || fault "$1: $(head -c 300 "$tools/list.err")"
  sort -u -o "$tools/acknowledged" "$tools/acknowledged"
  missing=$(comm -23 "$tools/acknowledged" "$tools/there")
  [[ -z $missing ]] || fault "$1: was acknowledged and is lost: ${missing//$'\n'/ }"
  if [[ -n $missing ]]; then comm -12 "$tools/acknowledged" "$tools/there" >"$tools/kept" && mv "$tools/kept" "$tools/acknowledged"; fi
}
the_catalog_is_right() { # TRIED
  local verified=$tools/verify.out
  timeout -s KILL 120 "$CHANGEOVER" catalog verify --users --quiet >"$verified" 2>&1 ||
    fault "$1: catalog verify: exit code $?: $(head -c 300 "$verified")"
}
# The most that was found of a cell so far is never lost. keeps_the_best TRIED FILE CELL
keeps_the_best() {
  local found best=$tools/best/$3
  [[ -e $2 ]] || return
  whole_design "$2" || { fault "$1: $2 is no design"; return; }
  found=$(blocks_of "$2")
  if [[ -e $best ]] && ((found > $(<"$best"))); then
    fault "$1: $2 has $found blocks, and $(<"$best") were found before"
  fi
  printf '%s' "$found" >"$best"
}

# ---------------------------------------------------------------------------------------- the verbs
# Each kind has words_KIND, which sets `words` (the command) and `files` (what it may change, in the
# folder of state), and judge_KIND TRIED, which looks at what it left.

cells=('20 5' '24 6' '15 4' '30 6' '18 5 --circular')
words_search() {
  cell=${cells[RANDOM % ${#cells[@]}]}
  local stem=${cell// /-}
  # shellcheck disable=SC2206 # the words of the cell
  words=("$CHANGEOVER" search $cell --time $((1 + RANDOM % 8))s --threads 1 --quiet --format text
    --checkpoint "state-$stem" -o "best-$stem")
  files="state-$stem best-$stem"
}
judge_search() {
  local state=${files%% *} design=${files##* } moves before
  before=$tools/best/$state.moves
  keeps_the_best "$1" "$design" "$design"
  [[ -e $state ]] || return
  moves=$(sed -n 's/^moves //p' "$state")
  [[ $(tail -n 1 "$state") == check\ * && -n $moves ]] || fault "$1: $state is not whole"
  [[ ! -e $before ]] || ((moves >= $(<"$before"))) || fault "$1: $state went back from $(<"$before") moves to $moves"
  printf '%s' "$moves" >"$before"
  # What the checkpoint has is at least as good as what was handed out.
  # shellcheck disable=SC2086 # the words of the cell
  run 60 "$CHANGEOVER" search $cell --time 100ms --threads 1 --quiet --format text --checkpoint "$state" -o again
  [[ $code == 10 || $code == 30 ]] || fault "$1, then the same again: exit code $code ${said:0:200}"
  keeps_the_best "$1, then the same again" again "$design"
  rm -f again
  sed -n 's/^moves //p' "$state" >"$before"
}
words_exact() {
  cell=$((9 + RANDOM % 3))
  words=("$CHANGEOVER" search "$cell" 4 --change 1 --exact --proof proofs --time $((1 + RANDOM % 8))s --quiet --format text -o "exact-$cell")
  files="exact-$cell"
}
judge_exact() {
  local file
  keeps_the_best "$1" "$files" "$files"
  for file in proofs/*; do
    [[ ! -e $file || -s $file ]] || fault "$1: $file is empty"
  done
}
words_design() {
  cell=$((300 + RANDOM % 3))
  words=("$CHANGEOVER" design "$cell" 5 --format text -o "design-$cell")
  files="design-$cell"
}
judge_design() {
  [[ ! -e $files ]] || whole_design "$files" || fault "$1: $files is no design"
  keeps_the_best "$1" "$files" "$files"
}
words_table() {
  words=("$CHANGEOVER" table --k 3..6 --v "5..$((20 + RANDOM % 20))" --json -o table.json)
  files=table.json
}
judge_table() { [[ ! -e $files ]] || json_is_whole "$files" || fault "$1: $files is not whole"; }
words_plan() {
  words=("$CHANGEOVER" plan "$tools/parts.csv" --at-once 3 --test-cost $((1 + RANDOM % 20)) --time $((1 + RANDOM % 4))s --quiet
    --format csv -o sheet.csv)
  files=sheet.csv
}
judge_plan() {
  [[ -e $files ]] || return
  run 60 "$CHANGEOVER" plan "$tools/parts.csv" --at-once 3 --test-cost 1 --done "$files" --time 100ms --quiet
  [[ $code == 0 || $code == 30 ]] || fault "$1, then --done $files: exit code $code ${said:0:200}"
}
words_orders() {
  words=("$CHANGEOVER" loadorder --items $((40 + RANDOM % 40)) --room 8 --time $((1 + RANDOM % 4))s --quiet --json -o order.jsonl)
  files=order.jsonl
}
judge_orders() {
  [[ ! -e $files ]] || { [[ $(tail -c 2 "$files") == '}' ]] && ! grep -qv '^{.*}$' "$files"; } || fault "$1: $files is not whole"
}
words_classify() {
  words=("$CHANGEOVER" classify $((9 + RANDOM % 3)) 4 --change 1 --time $((1 + RANDOM % 6))s --quiet --json -o classes.json)
  files=classes.json
}
judge_classify() { [[ ! -e $files ]] || json_is_whole "$files" || fault "$1: $files is not whole"; }
words_minima() {
  words=("$CHANGEOVER" minima --data minima.csv --v 7 --k-to 4 --conflicts 2000 --time $((1 + RANDOM % 5))s --quiet --json -o minima.json)
  files='minima.csv minima.json'
}
judge_minima() {
  local rows before=$tools/best/minima
  [[ -e minima.csv ]] || return
  run 60 "$CHANGEOVER" minima --data minima.csv --quiet --json
  [[ $code == 0 ]] || fault "$1: minima.csv is not read: exit code $code ${said:0:200}"
  rows=$(wc -l <minima.csv)
  [[ ! -e $before ]] || ((rows >= $(<"$before"))) || fault "$1: minima.csv went back from $(<"$before") lines to $rows"
  printf '%s' "$rows" >"$before"
}
# What is added, imported or found is in one database, which all writers share.
words_add() {
  local n=$((1 + RANDOM % 3)) i
  words=("$CHANGEOVER" catalog add --even-isomorphic)
  for ((i = 0; i < n; ++i)); do
    another_design "$tools/designs/add$slot-$i"
    words+=("$tools/designs/add$slot-$i")
  done
  files=
}
judge_add() { acknowledge "$scratch/said/slot$slot"; }
words_import() {
  words=("$CHANGEOVER" catalog import "$tools/theirs.jsonl" --quiet)
  files=
}
judge_import() { :; }
words_improve() {
  words=("$CHANGEOVER" catalog improve --k 6..7 --v 13..17 --change 3 --each 300ms --time $((2 + RANDOM % 5))s --threads 1 --quiet)
  files=
}
judge_improve() {
  sed -nE 's/^better: .* ([0-9a-z]+\.[0-9.a-z]+); .*/\1/p' "$scratch/said/slot$slot" >>"$tools/acknowledged"
}
words_export() {
  words=("$CHANGEOVER" catalog export --users -o mine.jsonl)
  files=mine.jsonl
}
judge_export() {
  [[ -e $files ]] || return
  run 60 "$CHANGEOVER" catalog diff "$files" "$files"
  [[ $code == 0 ]] || fault "$1: $files is no catalog: ${said:0:200}"
}
words_verify() {
  words=("$CHANGEOVER" catalog verify --k 5..5 --v 5..60 --threads 1 --quiet --resume verified.txt --time $((1 + RANDOM % 4))s)
  files=verified.txt
}
# What was done is not done again, as long as the same is asked.
judge_verify() {
  local before=$tools/best/verified
  [[ -e $files ]] || return
  if [[ -e $before && $(head -n 1 "$before") == "$(head -n 1 "$files")" ]]; then
    [[ -z $(comm -23 <(tail -n +2 "$before" | sort) <(tail -n +2 "$files" | sort)) ]] || fault "$1: $files has forgotten what was done"
  fi
  # The last line may be half a line, and does not count.
  sed '$d' "$files" >"$before"
  [[ -s $before ]] || rm -f "$before"
}
words_pairs() {
  words=("$ALL_PAIRS" run data 300 --chunk 3 --memory 40K --journal journal)
  files='journal data.gram data.dist'
}
judge_pairs() {
  if [[ $ended == 0 ]]; then
    if ! cmp -s data.gram "$tools/right.gram" || ! cmp -s data.dist "$tools/right.dist"; then fault "$1: wrong results"; fi
    rm -f journal data.gram data.dist # from the beginning
  elif [[ $ended != 137 && $ended != 130 && $ended != 143 && $ended != 30 ]]; then
    fault "$1: exit code $ended: $(head -c 200 "$scratch/said/slot$slot.err")"
  fi
}
words_serve() {
  words=("$CHANGEOVER" serve --port 0)
  files=
}
# While it runs, it is given designs to keep; what it answers 200 to is acknowledged.
visit_server() {
  local line port token body reply tries
  for ((tries = 0; tries < 100; ++tries)); do
    [[ ! -s $scratch/said/slot$slot ]] || break
    sleep 0.05
  done
  read -r line <"$scratch/said/slot$slot" || return
  port=${line#http://127.0.0.1:}
  token=${line##*token=}
  port=${port%%/*}
  for tries in 1 2 3; do
    another_design "$tools/designs/served"
    body=$(<"$tools/designs/served")
    exec {server}<>"/dev/tcp/127.0.0.1/$port" || return
    printf 'POST /api/catalog/add?kind=linear HTTP/1.1\r\nHost: 127.0.0.1:%s\r\nConnection: close\r\nX-Changeover-Token: %s\r\nContent-Length: %d\r\n\r\n%s' \
      "$port" "$token" "${#body}" "$body" 1>&"$server"
    reply=$(timeout 60 cat <&"$server" | tr -d '\0')
    exec {server}>&-
    if [[ $reply == 'HTTP/1.1 200'* ]]; then
      # One that the program comes with, or that differs in its names only, is none of ours.
      sed -nE 's/^\{"label":"([^"]*)","already":false.*/\1/p' <<<"$reply" >>"$tools/acknowledged"
      served=$((served + 1))
    fi
  done
}
judge_serve() { :; }

# ----------------------------------------------------------------------------------------- the soak

kinds=(search search exact design table plan orders classify minima add add import improve export verify serve)
[[ -z $ALL_PAIRS ]] || kinds+=(pairs)
declare -a process_of=('' '') kind_of files_of=('' '') tried_of cell_of
declare -A ends tried_kinds
served=0
trap '' PIPE
exec 3>&2 2>/dev/null # the shell tells of processes that were killed
shopt -s execfail

begin() { # SLOT: another verb, of another kind than the other one
  slot=$1
  local kind other=${kind_of[1 - slot]:-}
  kind=${kinds[RANDOM % ${#kinds[@]}]}
  [[ -n ${process_of[1 - slot]} && $kind == "$other" ]] && return
  cell=
  "words_$kind"
  : >"$scratch/said/slot$slot" # The process may be killed before it does so itself.
  env --default-signal=INT "${words[@]}" >"$scratch/said/slot$slot" 2>"$scratch/said/slot$slot.err" </dev/null &
  process_of[slot]=$!
  kind_of[slot]=$kind
  files_of[slot]=$files
  cell_of[slot]=$cell
  words[0]=${words[0]##*/}
  tried_of[slot]=$(quoted "${words[@]}")
  tried_kinds[$kind]=$((${tried_kinds[$kind]:-0} + 1))
}

end() { # SLOT: by a signal, or of itself
  slot=$1
  local process=${process_of[slot]} signal=none waited kind=${kind_of[slot]} tried
  case $((RANDOM % 10)) in
    0 | 1 | 2 | 3 | 4) signal=KILL ;;
    5 | 6) signal=INT ;;
    7) signal=TERM ;;
    *) [[ $kind != serve ]] || signal=KILL ;;
  esac
  [[ $kind != serve ]] || visit_server
  [[ $signal == none ]] || kill -s "$signal" "$process"
  for ((waited = 0; waited < 600; ++waited)); do
    kill -0 "$process" || break
    sleep 0.1
  done
  tried="${tried_of[slot]}, SIG$signal"
  if kill -0 "$process"; then
    fault "$tried: still running a minute later"
    kill -9 "$process"
  fi
  wait "$process"
  ended=$?
  attacks=$((attacks + 1))
  ends[$signal]=$((${ends[$signal]:-0} + 1))
  # An answer, a limit, or the signal.
  documented "$ended" || ((ended > 128)) || fault "$tried: exit code $ended: $(head -c 300 "$scratch/said/slot$slot.err")"
  case $ended in
    3 | 4 | 5 | 134 | 136 | 139) fault "$tried: exit code $ended: $(head -c 300 "$scratch/said/slot$slot.err")" ;;
  esac
  files=${files_of[slot]} cell=${cell_of[slot]}
  process_of[slot]='' files_of[slot]=''
  "judge_$kind" "$tried"
  # shellcheck disable=SC2086 # names
  others_are_as_they_were "$tried" $files
  # shellcheck disable=SC2086
  remember $files
  the_catalog_holds "$tried"
  ((attacks % 8 != 0)) || the_catalog_is_right "$tried"
}

# A temporary file of each name at most, which the next process that writes that name takes away; a
# proof for each question; nothing more.
nothing_piles_up() {
  local left
  left=$(temporaries_in . | wc -l)
  ((left <= 40)) || fault "$left temporary files are left: $(temporaries_in . | head -5 | tr '\n' ' ')"
  left=$(find . -mindepth 1 | wc -l)
  ((left <= 200)) || fault "$left files are in the folder: $(find . -mindepth 1 | sed 's/[0-9]\+/N/g' | sort | uniq -c | sort -rn | head -4 | tr '\n' ' ')"
}

end_of_soak=$((SECONDS + seconds))
while ((SECONDS < end_of_soak)); do
  for turn in 0 1; do
    [[ -n ${process_of[turn]} ]] || begin "$turn"
  done
  printf -v pause '%d.%03d' $((RANDOM % 4)) $((RANDOM % 1000))
  ((seconds > 60)) || pause=0.$((300 + RANDOM % 600))
  sleep "$pause"
  turn=$((RANDOM % 2))
  [[ -z ${process_of[turn]} ]] || end "$turn"
  ((attacks % 25 != 0)) || nothing_piles_up
  if ((attacks % 200 == 0)); then
    # So that the catalog does not take longer and longer to verify; nothing else writes to it.
    for turn in 0 1; do [[ -z ${process_of[turn]} ]] || end "$turn"; done
    the_catalog_is_right 'before a new catalog'
    rm -f mine.db mine.db-wal mine.db-shm
    : >"$tools/acknowledged"
  fi
done
for turn in 0 1; do [[ -z ${process_of[turn]} ]] || end "$turn"; done
the_catalog_is_right 'at the end'
nothing_piles_up
exec 2>&3
for name in "${!ends[@]}"; do printf '%s %d; ' "$name" "${ends[$name]}"; done
for name in "${!tried_kinds[@]}"; do printf '%s %d, ' "$name" "${tried_kinds[$name]}"; done
printf '%d designs kept by a server, %s acknowledged in the catalog now, %d temporary files left\n' "$served" \
  "$(wc -l <"$tools/acknowledged")" "$(temporaries_in . | wc -l)"
finish
