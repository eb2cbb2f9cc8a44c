#!/usr/bin/env bash
# Attacks on the example all_pairs, $1 or $ALL_PAIRS: whatever happens to it and its files, a run
# that says 0 must have the right results, and what is refused must have changed nothing. Works in
# the current folder. KILLS says how often a run is killed, MUTATIONS how many changed journals are
# tried.
set -u
all_pairs=${1:-${ALL_PAIRS:-}}
if [ -z "$all_pairs" ] || [ ! -x "$all_pairs" ]; then
  echo "all_pairs is not there"
  exit 77
fi
kills=${KILLS:-15}
mutations=${MUTATIONS:-48}
RANDOM=${SEED:-${HOSTILE_SEED:-1}}
attacks=0
lost=0

# One attack that went as it should if the rest of the words succeed.
attack() {
  local what=$1
  shift
  attacks=$((attacks + 1))
  if ! "$@"; then
    lost=$((lost + 1))
    echo "LOST: $what"
    sed 's/^/  /' err 2>/dev/null | head -3
  fi
}

# The job, with further options; the code is in $code.
run() {
  timeout 60 "$all_pairs" run v 300 --chunk 3 --memory 40K "$@" >out 2>err
  code=$?
}

is_right() { [ "$code" = 0 ] && cmp -s v.gram right.gram && cmp -s v.dist right.dist; }
is_refused() { [ "$code" = "$1" ] && [ "$(wc -l <err)" = 1 ]; }
earlier() { sed -n 's/.*steps, \([0-9]*\) of them earlier.*/\1/p' out; }
# The code is one of those given, there is one line, and the result that was there still is.
is_refused_unharmed() { is_refused "$1" && cmp -s v.gram right.gram; }

flip() { # file offset
  local byte
  byte=$(od -An -tu1 -j "$2" -N 1 "$1")
  printf "%b" "\\x$(printf %02x $((byte ^ 16)))" |
    dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}

"$all_pairs" make v 60 300 || exit 1
cp -p v v.kept
run --check
[ "$code" = 0 ] || exit 1
cp v.gram right.gram
cp v.dist right.dist
run --journal right.journal
cp right.journal j
size=$(stat -c %s v.gram)
lines=$(wc -l <right.journal)

# A job that is refused.
timeout 60 "$all_pairs" run v 600 --chunk 3 --memory 40K --journal j >out 2>err
code=$?
attack "another job's journal" is_refused_unharmed 3
run --journal j
attack "after another job was refused" is_right
attack "all steps were found again" [ "$(earlier)" = $((lines - 1)) ]
for victim in v v.gram v.dist; do
  cp "$victim" victim
  run --journal "$victim"
  attack "$victim as a journal" is_refused_unharmed 2
  attack "$victim as a journal is intact" cmp -s "$victim" victim
done

# Results that were changed behind the journal's back.
rm v.gram
run --journal j
attack "result removed" is_right
truncate -s $((size / 3)) v.gram
run --journal j
attack "result cut" is_right
truncate -s $((size * 2)) v.gram
run --journal j
attack "result too long" is_right
truncate -s 0 v.gram
truncate -s "$size" v.gram
run --journal j
attack "result all zeros" is_right
for _ in 1 2 3 4 5 6 7 8; do
  flip v.gram $(((RANDOM * 32768 + RANDOM) % size))
  run --journal j
  attack "one bit of the result" is_right
  attack "only one step was done again" [ "$(earlier)" = $((lines - 2)) ]
done

# Data that were changed.
before=$(mktemp -p . before.XXXXXX)
touch -r v "$before"
flip v 35000
touch -r "$before" v
run --journal j
attack "data changed, time set back" is_refused_unharmed 3
cp -p v.kept v
run --journal j
attack "other file with the same data" is_refused_unharmed 3
rm -f j
run --journal j
attack "new journal" is_right
cp j right.journal

# Journals that were changed: whatever is believed of them, the result is right.
"$all_pairs" make w 60 300
"$all_pairs" run w 300 --chunk 3 --memory 40K --journal other >/dev/null
for ((i = 0; i < mutations; ++i)); do
  at=$((2 + RANDOM % (lines - 1)))
  to=$((2 + RANDOM % (lines - 1)))
  case $((i % 8)) in
    0) sed "${at}d" right.journal >j ;;
    1) awk -v a=$at -v b=$to 'NR==FNR{l[NR]=$0;next}{print FNR==a?l[b]:FNR==b?l[a]:$0}' \
      right.journal right.journal >j ;;
    2) cp right.journal j && flip j $((RANDOM * 3 % $(stat -c %s j))) ;;
    3) head -c $((RANDOM * 3 % $(stat -c %s right.journal))) right.journal >j ;;
    4) { head -n $at right.journal; tail -n +$((at + 1)) other; } >j ;;
    5) sed "${at}s/ [0-9a-f]\{64\} / $(printf %064d $i) /" right.journal >j ;;
    6) { cat right.journal; sed -n "${at}p" right.journal; echo "step 1 - $(printf %032d $i)"; } \
      >j ;;
    7) { head -n 1 right.journal; seq -f "step %g" $((lines - 1)); } >j ;;
  esac
  cp j forged
  # Nothing that is believed falsely stays unseen.
  truncate -s 0 v.gram
  truncate -s "$size" v.gram
  run --journal j
  if [ "$code" = 0 ]; then
    attack "changed journal $i" is_right
  else
    attack "changed journal $i" is_refused 3
    attack "changed journal $i is intact" cmp -s j forged
  fi
done
rm -f j

# Two at the same time. The data are larger, so that a run takes a while.
"$all_pairs" make big 80 40000
big() { timeout 60 "$all_pairs" run big 40000 --chunk 2 --memory 2M "$@"; }
big --check >/dev/null 2>&1 || exit 1
cp big.gram right.big
big --journal first >out.first 2>&1 &
first=$!
for _ in $(seq 200); do
  [ -s first ] && break
  sleep 0.01
done
timeout 60 "$all_pairs" run big 20000 --chunk 2 --memory 2M >out 2>err
code=$?
kill -0 $first 2>/dev/null && attack "another job at the same time" is_refused 4
big --journal second >out 2>err
code=$?
kill -0 $first 2>/dev/null && attack "the same job at the same time" is_refused 4
wait $first
code=$?
attack "the first of two" [ "$code" = 0 ]
attack "the result of the first of two" cmp -s big.gram right.big
rm -f big.gram first second
big --share 0/2 >/dev/null 2>err &
first=$!
big --share 1/2 >/dev/null 2>&1
code=$?
wait $first
attack "shares at the same time" [ "$code$?" = 00 ]
attack "result of shares at the same time" cmp -s big.gram right.big
rm -f big.gram
big --share 1/2 >/dev/null 2>err && big --share 0/2 >/dev/null 2>err
code=$?
attack "shares one after another" cmp -s big.gram right.big

# Killed at any moment, until a run comes to its end; then from the beginning.
killed=0
for ((round = 0; killed < kills && round < 10 * kills; ++round)); do
  # The program itself, without anything around it that would be killed in its place.
  "$all_pairs" run big 40000 --chunk 2 --memory 2M --journal k >/dev/null 2>err &
  child=$!
  sleep "0.$(printf %03d $((RANDOM % 400)))"
  kill -KILL $child 2>/dev/null
  wait $child 2>/dev/null
  code=$?
  if [ "$code" = 137 ]; then
    killed=$((killed + 1))
  else
    attack "run between kills" [ "$code" = 0 ]
    attack "result after kills" cmp -s big.gram right.big
    rm -f k big.gram
  fi
done
big --journal k >/dev/null 2>err
code=$?
attack "end after kills" [ "$code" = 0 ]
attack "result after $killed kills" cmp -s big.gram right.big

# Nowhere to speak.
rm -f v.gram
run_closed() { timeout 60 "$all_pairs" run v 300 --chunk 3 --memory 40K; }
run_closed >/dev/full 2>err
code=$?
attack "standard output full" [ "$code" = 4 ]
attack "standard output full: result" cmp -s v.gram right.gram
rm -f v.gram
run_closed >&- 2>err
code=$?
attack "standard output closed" [ "$code" = 4 ]
attack "standard output closed: result" cmp -s v.gram right.gram
rm -f v.gram
run_closed >out 2>/dev/full
code=$?
attack "standard error full" is_right
rm -f v.gram
run_closed <&- >&- 2>&-
attack "all streams closed: result" cmp -s v.gram right.gram
rm -f v.gram
(run_closed; echo $? >code) 2>err | :
code=$(cat code)
attack "reader gone: result" cmp -s v.gram right.gram

# No space, by limits on the length of files.
limited() { # kilobytes, then the command
  (
    ulimit -f "$1"
    shift
    exec timeout 60 "$all_pairs" "$@"
  ) >/dev/null 2>err
  code=$?
}
cp v.kept m
limited 20 make m 60 300
attack "make over the limit" is_refused 4
attack "make over the limit: the old file" cmp -s m v.kept
cp right.gram v.gram
truncate -s 100 v.gram
limited 20 run v 300 --chunk 3 --memory 40K
attack "result over the limit" is_refused 4
attack "result over the limit: the old file" [ "$(stat -c %s v.gram)" = 100 ]
cp right.gram v.gram

# A file system that is full, where one may be mounted.
mkdir -p small
if mount -t tmpfs -o size=100k none small 2>/dev/null; then
  cp v small/v
  "$all_pairs" make small/m 6 300 && cp small/m little
  (cd small && exec timeout 60 "$all_pairs" make m 60 300 >/dev/null 2>../err)
  code=$?
  attack "make on a full file system" is_refused 4
  attack "make on a full file system: the old file" cmp -s small/m little
  rm small/m
  (cd small && exec timeout 60 "$all_pairs" run v 300 --chunk 3 --memory 40K >/dev/null 2>../err)
  code=$?
  attack "result on a full file system" is_refused 4
  attack "result on a full file system: nothing is left" [ ! -e small/v.gram ]
  rm small/v && ln -s ../v small/v
  (cd small && exec timeout 60 "$all_pairs" run v 300 --chunk 3 --memory 40K >../out 2>../err)
  code=$?
  attack "then with less beside it" [ "$code" = 0 ]
  attack "then with less beside it: the result" cmp -s small/v.gram right.gram
  head -c 1M /dev/zero >small/filler 2>/dev/null
  cp right.dist v.dist
  run --journal small/j
  attack "journal on a full file system" is_refused_unharmed 4
  umount small
fi

# Absurd numbers.
huge=18446744073709551615
for words in "make m $huge $huge" "make m $huge 1" "make m 1 $huge" "make m 4611686018427387904 4" \
  "make m 1099511627776 1048576" "make m 0 3" "make m 3 0"; do
  # shellcheck disable=SC2086 # words are several.
  timeout 60 "$all_pairs" $words >/dev/null 2>err
  code=$?
  attack "$words" [ "$code" = 2 -o "$code" = 4 ]
  attack "$words: one line" [ "$(wc -l <err)" = 1 ]
  attack "$words: the old file" cmp -s m v.kept
done
cp right.gram v.gram
for words in "--threads 0" "--threads $huge" "--threads 4294967297" "--threads 1000000" \
  "--readers 0" \
  "--readers $huge" "--readers 1000000" "--chunk 0" "--chunk $huge" "--memory 0" \
  "--memory 18446744073709551616"; do
  run $words
  attack "$words" [ "$code" = 2 -o "$code" = 3 -o "$code" = 4 ]
  attack "$words: one line" is_refused_unharmed "$code"
done
run --memory $huge
attack "all memory" is_right
timeout 60 "$all_pairs" run v $huge >/dev/null 2>err
code=$?
attack "dimension $huge" is_refused_unharmed 2
if [[ -z ${HOSTILE_SANITIZED:-} ]]; then # A sanitizer does not fit into what keeps root from starting threads.
  (
    ulimit -u 20 2>/dev/null
    ulimit -v 400000
    exec timeout 60 "$all_pairs" run v 300 --chunk 3 --memory 40K --threads 1000 >/dev/null 2>err
  )
  code=$?
  attack "more threads than there may be" is_refused_unharmed 4
fi

echo "killed $killed times"
echo "$attacks attacks, $lost faults"
[ "$lost" = 0 ]
