#!/usr/bin/env bash
# A catalog of one's own whose writers are killed at random moments, write at once, or find the disk
# full: it opens and is whole afterwards, what was said to be added is there, what was not is there
# whole or not at all, and nothing is there in parts.
#
# `catalog add` of a design that is there checks the whole file (SQLite's quick_check) before it
# answers.
# shellcheck source=support/attack.sh
source "$(dirname "$0")/support/attack.sh"
CHANGEOVER=$(program CHANGEOVER) || exit

# The same design under 400 namings and, in their own folder, 2500: other labels.
"$CHANGEOVER" design 8 4 --change 1 --linear --format text | grep -v '^#' >"$scratch/tools/blocks"
mkdir "$scratch/tools/designs" "$scratch/tools/many"
namings() { # COUNT FOLDER
  awk -v count="$1" -v seed="$RANDOM" -v folder="$2" '
  { line[NR] = $0 }
  END {
    srand(seed)
    for (n = 1; n <= count; ++n) {
      for (i = 0; i < 8; ++i) name[i] = i
      for (i = 7; i > 0; --i) { j = int(rand() * (i + 1)); t = name[i]; name[i] = name[j]; name[j] = t }
      file = folder "/" n
      for (l = 1; l <= NR; ++l) {
        k = split(line[l], x, " "); text = ""
        for (i = 1; i <= k; ++i) text = text (i > 1 ? " " : "") name[x[i]]
        print text > file
      }
      close(file)
    }
  }' "$scratch/tools/blocks"
}
namings 400 "$scratch/tools/designs"
namings 2500 "$scratch/tools/many"
designs=$scratch/tools/designs
known=$designs/400

add() { # CATALOG FILE…
  "$CHANGEOVER" catalog add "${@:2}" --even-isomorphic --catalog "$1"
}
labels_in() { # CATALOG
  "$CHANGEOVER" catalog list --users --all --format csv --catalog "$1" 2>"$err" | tail -n +2 |
    cut -d, -f1 | sort
}
# The labels that an answer says are there.
said_in() { # FILE
  sed -nE 's/^(added|there already): ([^, ]*).*/\2/p' "$1" | sort
}
# What was said is there, and the file is whole. whole TRIED CATALOG SAID
whole() {
  run 60 "$CHANGEOVER" catalog add "$known" --even-isomorphic --catalog "$2"
  [[ $code == 0 ]] || fault "$1: the catalog cannot be written to any more: ${said:0:300}"
  labels_in "$2" >"$scratch/tools/there"
  [[ ! -s $err ]] || fault "$1: $(head -c 300 "$err")"
  missing=$(comm -23 "$3" "$scratch/tools/there")
  [[ -z $missing ]] || fault "$1: was said to be added and is lost: ${missing//$'\n'/ }"
}

# Everything that is added at once, for import; the labels of it.
# shellcheck disable=SC2046 # numbers
add all.db $(seq -f "$designs/%g" 1 200) >"$scratch/tools/answer" ||
  fault "designs cannot be added: $(cat "$scratch/tools/answer")"
"$CHANGEOVER" catalog export --users --catalog all.db -o all.jsonl
labels_in all.db >"$scratch/tools/all"
count=$(wc -l <"$scratch/tools/all")
((count >= 190)) || fault "only $count of 200 designs were added"

# Killed while they write.
kills=$((rounds > 1 ? rounds * 25 : 6))
: >"$scratch/tools/said_added"
add own.db "$known" >/dev/null
for ((i = 1; i <= kills; ++i)); do
  attacks=$((attacks + 1))
  printf -v pause '0.%03d' $((RANDOM % 120))
  at=$((1 + (i * 3) % 390))
  answer=$scratch/said/answer
  : >"$answer" # The process may be killed before it does so itself.
  if ((i % 3 == 0)); then
    tried="catalog import all.jsonl, killed after $pause s"
    rm -f import.db import.db-wal import.db-shm
    [[ $((i % 2)) == 0 ]] || add import.db "$known" >/dev/null
    "$CHANGEOVER" catalog import all.jsonl --quiet --catalog import.db >"$answer" 2>/dev/null \
      </dev/null &
  else
    tried="catalog add of two designs, killed after $pause s"
    # Not by the function: the shell that runs it would be killed, and the program go on.
    "$CHANGEOVER" catalog add "$designs/$at" "$designs/$((at + 1))" --even-isomorphic --catalog \
      own.db \
      >"$answer" 2>/dev/null </dev/null &
  fi
  process=$!
  sleep "$pause"
  { kill -9 $process; wait $process; } 2>/dev/null
  if ((i % 3 == 0)); then
    touch import.db
    : >"$scratch/tools/none"
    whole "$tried" import.db "$scratch/tools/none"
    there=$(comm -12 "$scratch/tools/all" "$scratch/tools/there" | wc -l)
    ((there == 0 || there == count)) || fault "$tried: $there of $count designs are there"
    if grep -q '^added' "$answer" && ((there != count)); then
      fault "$tried: it said \"$(head -1 \
        "$answer")\", and $there of $count are there; the list has $(wc -l \
        <"$scratch/tools/there") lines"
    fi
  else
    said_in "$answer" >>"$scratch/tools/said_added"
    sort -u -o "$scratch/tools/said_added" "$scratch/tools/said_added"
    whole "$tried" own.db "$scratch/tools/said_added"
  fi
done
((rounds == 1)) || [[ -s $scratch/tools/said_added ]] || fault 'nothing was ever added: the moments are too early'

# An import of several batches, killed, while another process writes: what is there is whole, the
# other gets its turn, and importing the file again adds the rest.
(cd "$scratch/tools/many" && add "$scratch/ground/many.db" ./*) >"$scratch/tools/answer" ||
  fault "designs cannot be added: $(head -c 300 "$scratch/tools/answer")"
"$CHANGEOVER" catalog export --users --catalog many.db -o many.jsonl
labels_in many.db >"$scratch/tools/many.labels"
many=$(wc -l <"$scratch/tools/many.labels")
((many >= 2100)) || fault "only $many of 2500 designs were added"
rm -f many.db many.db-wal many.db-shm
for ((i = 1; i <= (rounds > 1 ? rounds * 4 : 2); ++i)); do
  attacks=$((attacks + 1))
  rm -f import.db import.db-wal import.db-shm
  add import.db "$known" >/dev/null
  printf -v pause '0.%03d' $((RANDOM % 500))
  tried="catalog import of $many designs, killed after $pause s"
  "$CHANGEOVER" catalog import many.jsonl --quiet --catalog import.db >/dev/null 2>&1 </dev/null &
  process=$!
  add import.db "$designs/$i" >"$scratch/tools/beside" 2>&1 || fault "$tried: another writer: $(head -c 300 "$scratch/tools/beside")"
  sleep "$pause"
  { kill -9 $process; wait $process; } 2>/dev/null
  run 60 "$CHANGEOVER" catalog verify --users --quiet --catalog import.db
  [[ $code == 0 ]] || fault "$tried: the catalog is not as it says: $(head -c 300 "$out") ${said:0:300}"
  run 60 "$CHANGEOVER" catalog import many.jsonl --quiet --catalog import.db
  [[ $code == 0 ]] || fault "$tried: it cannot be imported again: exit code $code ${said:0:300}"
  said_in "$scratch/tools/beside" | sort -u - "$scratch/tools/many.labels" >"$scratch/tools/wanted"
  whole "$tried" import.db "$scratch/tools/wanted"
done

# Names of a catalog are paths, whatever they look like: a file of that name, or one line.
mkfifo fifo
mkdir folder
ln -s loop loop
for name in ':memory:' 'file:zz.db?mode=memory' 'file:' 'file:x.db' 'file::memory:?cache=shared' '?' '%00' '~' 'a b' \
  folder fifo loop /dev/null /dev/full /dev/stdin "$(printf 'd/%.0s' {1..300})" "$(printf 'x%.0s' {1..300})"; do
  for command in 'add' 'import' 'list' 'retract' 'alias' 'verify'; do
    attacks=$((attacks + 1))
    case $command in
      add) arguments=("$known" --even-isomorphic) ;;
      import) arguments=(all.jsonl) ;;
      retract) arguments=(26.4.2.circular.65 --why attack) ;;
      alias) arguments=(word 26.4.2.circular.65) ;;
      *) arguments=(--users) ;;
    esac
    run 60 "$CHANGEOVER" catalog $command "${arguments[@]}" --catalog "$name"
    judge_ending
    [[ -z $defect ]] || fault "catalog $command --catalog $(quoted "$name"): $defect"
    if [[ $command == add && $code == 0 ]]; then
      [[ -f $name ]] || fault "catalog add --catalog $(quoted "$name") ends with 0, and there is no such file"
    fi
  done
done

# An alias cannot be the beginning of a label; an answer without a place changes nothing.
label=$(head -1 "$scratch/tools/all")
for ((length = 1; length <= ${#label}; ++length)); do
  attacks=$((attacks + 1))
  run 60 "$CHANGEOVER" catalog alias "${label:0:length}" 26.4.2.circular.65 --catalog own.db
  [[ $code == 3 ]] || fault "catalog alias ${label:0:length}: exit code $code ${said:0:300}"
done
for place in folder nowhere/x own.db/x; do
  attacks=$((attacks + 1))
  rm -f fresh.db
  run 60 "$CHANGEOVER" catalog add "$known" --even-isomorphic --catalog fresh.db -o $place
  [[ $code == 4 && ! -e fresh.db ]] || fault "catalog add -o $place: exit code $code, and the design was added"
done

# All k-subsets in an order in which one element changes: of strength 3, and so many blocks that a
# search finds fewer at once.
subsets() { # V K
  awk -v v="$1" -v k="$2" '
    function door(n, k,   kept, others, lines, i, text) {
      if (k == n) {
        for (i = 0; i < n; ++i) text = text (i > 0 ? " " : "") i
        return text "\n"
      }
      kept = door(n - 1, k)
      others = k == 1 ? "\n" : door(n - 1, k - 1)
      for (i = split(others, lines, "\n") - 1; i >= 1; --i) text = text lines[i] (lines[i] == "" ? "" : " ") (n - 1) "\n"
      return kept text
    }
    BEGIN { printf "%s", door(v, k) }'
}
for cell in '10 5' '10 6' '11 5' '11 6' '12 6'; do
  # shellcheck disable=SC2086 # two numbers
  subsets $cell >"$scratch/tools/weak-${cell/ /-}"
done
"$CHANGEOVER" catalog add "$scratch"/tools/weak-* --strength 3 --catalog weak.db >"$out" 2>"$err" ||
  fault "weak designs cannot be added: $(head -c 300 "$err")"
weak=$(labels_in weak.db | wc -l)
((weak == 5)) || fault "$weak of 5 weak designs are in the catalog"
improve() { # CATALOG TIME
  exec env --default-signal=INT "$CHANGEOVER" catalog improve --users --strength 3 --each 500ms --time "$2" --threads 1 --quiet --catalog "$1"
}
# What is there is what it says, and what was there is there. improved TRIED CATALOG
improved() {
  run 60 "$CHANGEOVER" catalog verify --users --quiet --catalog "$2"
  [[ $code == 0 ]] || fault "$1: the catalog is not as it says: ${said:0:300}"
  labels_in "$2" >"$scratch/tools/there"
  missing=$(comm -23 "$scratch/tools/weak" "$scratch/tools/there")
  [[ -z $missing ]] || fault "$1: is lost: ${missing//$'\n'/ }"
}
labels_in weak.db >"$scratch/tools/weak"

# Killed, and stopped by Ctrl-C, while it searches and writes.
for ((i = 1; i <= (rounds > 1 ? rounds * 4 : 2); ++i)); do
  attacks=$((attacks + 1))
  rm -f search.db search.db-wal search.db-shm
  cp weak.db search.db
  printf -v pause '%d.%03d' $((RANDOM % 3)) $((RANDOM % 1000))
  signal=$((i % 2 == 0 ? 9 : 2))
  tried="catalog improve, signal $signal after $pause s"
  (improve search.db 20s) >"$scratch/said/search" 2>"$scratch/said/search.err" </dev/null &
  process=$!
  sleep "$pause"
  kill -$signal $process 2>/dev/null
  { wait $process; } 2>/dev/null
  ended=$?
  improved "$tried" search.db
  if ((signal == 2)); then
    # An answer, or one line if it came before there was anything to answer; a signal before the
    # program minds it ends it.
    [[ $ended == 10 || $ended == 30 || $ended == 130 ]] || fault "$tried: exit code $ended: $(head -c 300 "$scratch/said/search.err")"
    if ((ended == 10)); then
      sed -nE 's/^better: .* ([0-9a-z]+\.[0-9.a-z]+); .*/\1/p' "$scratch/said/search" | sort >"$scratch/tools/found"
      missing=$(comm -23 "$scratch/tools/found" "$scratch/tools/there")
      [[ -s $scratch/tools/found && -z $missing ]] || fault "$tried: was said to be found and is not there: $missing"
    fi
  fi
done

# Two that search for the same catalog.
attacks=$((attacks + 1))
cp weak.db search.db
rm -f search.db-wal search.db-shm
for searcher in 1 2; do
  (improve search.db 4s) >"$scratch/said/searcher$searcher" 2>&1 </dev/null &
  searchers[searcher]=$!
done
for searcher in 1 2; do
  wait "${searchers[searcher]}"
  ended=$?
  [[ $ended == 10 || $ended == 30 ]] || fault "two improve at once: exit code $ended: $(head -c 300 "$scratch/said/searcher$searcher")"
done
improved 'two improve at once' search.db

# Two that write at once.
attacks=$((attacks + 1))
each=$((rounds > 1 ? 30 : 4))
for writer in 0 1; do
  for ((i = 1; i <= each; ++i)); do
    add both.db "$designs/$((writer * 200 + i))" || printf 'exit code %d\n' $?
  done >"$scratch/said/writer$writer" 2>&1 &
done
wait
if grep -qvE '^(added:|there already:|  )' "$scratch"/said/writer?; then
  fault "two writers at once: $(grep -hvE '^(added:|there already:|  )' "$scratch"/said/writer? | head -3)"
fi
cat "$scratch"/said/writer? >"$scratch/tools/answer"
said_in "$scratch/tools/answer" | sort -u >"$scratch/tools/added"
whole 'two writers at once' both.db "$scratch/tools/added"
for writer in 0 1; do
  (($(said_in "$scratch/said/writer$writer" | wc -l) == each)) || fault "two writers at once: one did not add all"
done

# A limit on the size of files, for any user: refused, and what was there is there.
attacks=$((attacks + 1))
labels_in own.db >"$scratch/tools/before"
run 60 bash -c "ulimit -f 1; '$CHANGEOVER' catalog add '$designs/399' --even-isomorphic --catalog fresh.db"
[[ $code == 4 && $said == changeover:\ * ]] || fault "ulimit -f 1; catalog add: exit code $code ${said:0:200}"

# A full disk.
disk=$scratch/ground/disk
mkdir "$disk"
if [[ $(id -u) != 0 ]] || ! mount -t tmpfs -o size=256k hostile "$disk" 2>/dev/null; then
  printf 'a tmpfs cannot be mounted here: full disks were left out\n'
  finish
fi
at_exit+=("umount -l '$disk' 2>/dev/null")
for ((round = 0; round < rounds; ++round)); do
  for left in 0 4096 16384 40000 80000; do
    attacks=$((attacks + 1))
    find "$disk" -mindepth 1 -delete
    add disk/own.db "$designs/1" "$designs/2" >/dev/null
    labels_in disk/own.db >"$scratch/tools/before"
    head -c 1000000 /dev/zero >"$disk/filler" 2>/dev/null
    truncate -s $(($(stat -c %s "$disk/filler") - left)) "$disk/filler"
    # shellcheck disable=SC2046 # numbers
    run 60 "$CHANGEOVER" catalog add $(seq -f "$designs/%g" 3 60) --even-isomorphic --catalog disk/own.db
    ended=$code
    tried="catalog add of 58 designs with $left bytes left"
    if ((code == 0)); then
      said_in "$out" | sort -u >"$scratch/tools/before"
    else
      judge_ending
      [[ $code == 4 && -z $defect ]] || fault "$tried: exit code $code ${said:0:300}"
    fi
    rm "$disk/filler"
    whole "$tried" disk/own.db "$scratch/tools/before"
    ((ended == 0)) || (($(wc -l <"$scratch/tools/there") <= 3)) || fault "$tried: half of them are there"
  done
done

# Searching with hardly any room: one clean line, or an answer, and what was there is there.
for left in 0 8192 40000; do
  attacks=$((attacks + 1))
  find "$disk" -mindepth 1 -delete
  cp weak.db disk/own.db
  head -c 1000000 /dev/zero >"$disk/filler" 2>/dev/null
  truncate -s $(($(stat -c %s "$disk/filler") - left)) "$disk/filler"
  tried="catalog improve with $left bytes left"
  run 60 "$CHANGEOVER" catalog improve --users --strength 3 --each 500ms --time 3s --threads 1 --quiet --catalog disk/own.db
  [[ $code == 4 || $code == 10 || $code == 30 ]] || fault "$tried: exit code $code ${said:0:300}"
  rm "$disk/filler"
  improved "$tried" disk/own.db
done
finish
