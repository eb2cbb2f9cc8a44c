#!/usr/bin/env bash
# Damaged files of every kind that the program reads, through every verb that reads them: a
# documented exit code in time, one clean line, no file changed but what was named. A checkpoint
# with a right checksum and wrong contents is either refused or leads to a design that is verified.
#
# A round is some 250 attacks.
# shellcheck source=support/attack.sh
source "$(dirname "$0")/support/attack.sh"
CHANGEOVER=$(program CHANGEOVER) || exit
CHECKDESIGN=$(program CHECKDESIGN) || exit
MUTATE=$(program HOSTILE_MUTATE) || exit
limit_memory 4000000

seed=$((${HOSTILE_SEED:-1} * 1000))
mutants=$scratch/tools/mutants
mkdir "$mutants"

# mutated COUNT FILE [checkpoint]: damaged copies in $mutants, others each time.
mutated() {
  seed=$((seed + 1))
  rm -f "$mutants"/*
  "$MUTATE" $seed "$1" "$2" "$mutants" ${3:+"$3"} || fault "mutate $seed $*: exit code $?"
}

# Keeps what failed, so that it can become a test.
keep() {
  [[ -z ${HOSTILE_KEEP:-} ]] || cp "$1" "$HOSTILE_KEEP/$2"
}

# attack FILE WORDS: the verb, with FILE for every @.
attack() {
  local file=$1 text
  shift
  attacks=$((attacks + 1))
  local words=("${@//@/$file}")
  run 10 "$CHANGEOVER" "${words[@]}"
  judge_ending
  if [[ -z $defect && -s $out ]]; then
    IFS= read -r -d '' -n 20000 text <"$out"
    ! unclean "$text" || printf -v defect 'raw bytes on standard output: %q' "${text:0:200}"
  fi
  if [[ -n $defect ]]; then
    fault "changeover $(quoted "$@") with ${origin##*/}, mutant ${file##*/} of seed $seed: $defect"
    keep "$file" "$1-$seed-${file##*/}"
  fi
}

"$CHANGEOVER" design 9 4 --circular --format text >good.txt ||
  skip 'changeover design does not work'
"$CHANGEOVER" design 9 4 --format json >good.json
"$CHANGEOVER" design 7 3 --format csv >good.csv
"$CHANGEOVER" design 12 4 -m 1 --linear --format text >single.txt
printf '# changeover design v=6 k=4 change=2 kind=circular\n# labels: ∞_s 0_l a "b" =c d\n%s\n%s\n%s\n' \
  '∞_s 0_l a "b"' '=c d a "b"' '=c d ∞_s 0_l' >labels.txt
printf 'part,change cost\n"Pump, large",1.5\nB,2\n=1+1,3\nD,0.25\nE,5\n' >parts.csv
printf '"Pump, large",B\nD,E\n' >pairs.csv
"$CHANGEOVER" plan parts.csv -k 3 --test-cost 1 --time 100ms --quiet --format csv >sheet.csv
"$CHANGEOVER" search 24 5 --time 200ms --quiet --checkpoint state >/dev/null
printf 'strength,change,kind,k,v,on_paper,lower,upper,by,seconds,solve_seconds,check_seconds,%s\n' \
  'proof_bytes,proof_steps,limit' >minima.csv
printf '2,1,linear,2,%s,cut,0.00,0.00,0.00,0,0,100000\n' 3,3,3,3 4,6,6,6 >>minima.csv
cp -r . "$scratch/pristine"

designs=(good.txt good.json good.csv single.txt labels.txt)
readers=(
  'verify @' 'verify @ --json' 'verify @ -t 3 --elements' 'expand @' 'expand @ --count --nodes 1000'
  'expand @ -w 2 --nodes 1000 --format json' 'same @ good.txt' 'same good.txt @ --reversal'
  'search --order @ --time 50ms --quiet' 'search --repair @ --time 50ms --quiet --format text'
  'search --extend @ --time 50ms --quiet --json'
)
planners=(
  'parts.csv|plan @ -k 3 --test-cost 1 --change-cost 1 --time 50ms --quiet --format csv'
  'parts.csv|plan @ -k 3 --test-cost 1 --time 50ms --quiet --format html'
  'pairs.csv|plan parts.csv --pairs @ -k 3 --test-cost 1 --time 50ms --quiet'
  'pairs.csv|plan parts.csv --never @ -k 3 --test-cost 1 --time 50ms --quiet --json'
  'sheet.csv|plan parts.csv --done @ -k 3 --test-cost 1 --time 50ms --quiet --format markdown'
)

turn=0
for ((round = 0; round < rounds; ++round)); do
  for origin in "${designs[@]}"; do
    mutated 12 "$origin"
    for file in "$mutants"/*; do
      # Searches cost more than readings, so each file meets some verbs only.
      for ((i = 0; i < 2; ++i)); do
        turn=$((turn + 1))
        read -r -a words <<<"${readers[turn % ${#readers[@]}]}"
        attack "$file" "${words[@]}"
      done
      attacks=$((attacks + 1))
      run 10 "$CHECKDESIGN" "$file"
      [[ $code == [0-4] ]] ||
        fault "checkdesign ${origin##*/}, mutant ${file##*/} of seed $seed: exit code $code"
      ! unclean "$said" ||
        fault "checkdesign ${origin##*/}, mutant ${file##*/} of seed $seed: raw bytes: $(quoted \
        "$said")"
    done
  done
  for entry in "${planners[@]}"; do
    origin=${entry%%|*}
    read -r -a words <<<"${entry#*|}"
    mutated 6 "$origin"
    for file in "$mutants"/*; do
      attack "$file" "${words[@]}"
    done
  done
  origin=state
  mutated 20 state checkpoint
  for file in "$mutants"/*; do
    cp "$file" before
    rm -f x.txt
    attack "$file" search 24 5 --checkpoint @ --time 150ms --quiet --format text -o x.txt
    if [[ $code == 3 ]]; then
      cmp -s before "$file" || fault "search --checkpoint, mutant ${file##*/} of seed $seed: refused, but changed"
    elif [[ $code == 10 || $code == 30 ]]; then
      whole_design x.txt || fault "search --checkpoint, mutant ${file##*/} of seed $seed: no design"
    fi
  done
  rm -f before x.txt
  origin=minima.csv
  mutated 10 minima.csv
  for file in "$mutants"/*; do
    attack "$file" minima --data @ --v 4
  done
  # Nothing that was only read has changed.
  for file in "$scratch"/pristine/*; do
    cmp -s "$file" "${file##*/}" || fault "${file##*/} was changed"
  done
  extra=$(diff <(ls -A "$scratch/pristine") <(ls -A .))
  [[ -z $extra ]] || fault "the folder changed: ${extra//$'\n'/ }"
done
finish
