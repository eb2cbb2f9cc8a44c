#!/usr/bin/env bash
# Absurd values for every argument and every option of every verb, as the program describes them
# itself: numbers at the edges of every type, what is no number, text that a terminal would obey,
# paths to what is no file. Each ends in time with a documented exit code, never 5, says one clean
# line if it refuses, and leaves nothing in the folder but what it was told to write.
#
# A round is one attack in 600 of all; with 600 rounds every value meets every option in every
# setting.
# shellcheck source=support/attack.sh
source "$(dirname "$0")/support/attack.sh"
CHANGEOVER=$(program CHANGEOVER) || exit
every=$((rounds >= 600 ? 1 : 600 / rounds))

description=$scratch/tools/description
"$CHANGEOVER" describe --format text >"$description" ||
  { fault "changeover describe --format text: exit code $?" && finish; }

# Good command lines of each verb, to which a wrong word is added. A verb that is not here is
# attacked with plausible arguments by their kind.
declare -A settings=(
  [design]='9 5|105 9 --circular|7 3 -m 1'
  [verify]='good.txt|good.json|good.csv'
  [bounds]='20 5|4 2'
  [explain]='20 5'
  [search]='9 4 -m 1|9 4 -m 1 --exact|9 4 --exact -b 12|16 4 --base-blocks|--order fano.txt|--extend part.txt|--repair broken.txt|12 5 --checkpoint state|12 4 -t 3'
  [classify]='9 4 12 -m 1 --circular|7 3'
  [same]='good.txt good.json'
  [table]='|--k 3..4 --v 5..9'
  [minima]='--data minima.csv --v 6'
  [plan]='--items 9 --at-once 3 --test-cost 1 --change-cost 5|parts.csv -k 3 --test-cost 2 --change-cost 1|--items 6 --at-once 3 --test-cost 1 --change-cost 1 --what-if'
  [expand]='good.txt|good.txt -w 2'
  [draw]='good.txt|6 4|8 --picture factorization|good.txt --picture stays|--picture heatmap --k 3 --v 5..9'
  [factorize]='8|7 --near'
  [constructions]=''
  [paper]=''
  [loadorder]='--items 20 --room 5|--items 12 --room 4 --workers 3|--items 9 --room 4 --prefetch'
  [completion]='bash'
  [manual]='design|--into pages'
  [serve]='good.txt --assets pages|--export site --assets pages --k 3 --v 5..6 -m 2'
  [describe]=''
)

printf -v long '%0100000d' 7
# shellcheck disable=SC2016,SC2054 # commas and dollars are meant
values=(
  0 1 -1 2 3 7 64 65 1000 65534 65535 65536 1000000 2147483647 2147483648 4294967295 4294967296
  1e9 1000000000 9223372036854775807 9223372036854775808 18446744073709551614 18446744073709551615
  18446744073709551616 1000000000000000000000000000000 0x10 010 +5 1.5 -0 1e308 1e-308 NaN inf -inf
  '' ' ' x - -- --x '7 ' ' 7' 7,7 1,2,3 ,,, 3.. ..3 9..3 3..18446744073709551615 ..65536 1s 1e9h \
    99999999d
  9999999999G 1K "$long" "x$long" $'\e[2J\e]0;x\a' $'\r' $'\x7f' $'\xc2\x9b31m' $'\xff\xfe' \
    $'a\xc3' $'x\ny'
  $'\xe2\x80\xae' '%s%n' '$(id)' '=1+1'
  missing missing/file . / /dev/null /dev/zero /dev/full /dev/stdin loop folder closed good.txt \
    empty
  precious/ ../ground/good.txt
)

mkdir "$scratch/pristine"
prepare() {
  printf '# changeover design v=6 k=4 change=2 kind=circular\n0 1 2 3\n4 5 2 3\n4 5 0 1\n' >good.txt
  printf '{"format":"changeover-design/1","v":6,"k":4,"change":2,"kind":"circular",%s}\n' \
    '"blocks":[[0,1,2,3],[4,5,2,3],[4,5,0,1]]' >good.json
  "$CHANGEOVER" design 7 3 --format csv >good.csv
  printf '0 1 3\n1 2 4\n2 3 5\n3 4 6\n4 5 0\n5 6 1\n6 0 2\n' >fano.txt
  printf '# changeover design v=7 k=3 change=1 kind=linear\n0 1 2\n0 1 3\n' >part.txt
  printf '# changeover design v=6 k=4 change=2 kind=linear\n0 1 2 3\n4 1 2 3\n4 5 0 1\n' >broken.txt
  printf 'part,change cost\nA,1\nB,2\nC,3\nD,4\nE,5\n' >parts.csv
  printf 'strength,change,kind,k,v,on_paper,lower,upper,by,seconds,solve_seconds,check_seconds,%s\n' \
    'proof_bytes,proof_steps,limit' >minima.csv
  printf '2,1,linear,2,3,3,3,3,cut,0.00,0.00,0.00,0,0,100000\n' >>minima.csv
  : >empty
  ln -s loop loop
  mkdir folder closed precious pages
  printf '<html><head></head></html>\n' >pages/index.html
  printf 'precious\n' >precious/file
  chmod 000 closed
}
prepare
limit_memory 4000000 # kilobytes
before=$(names_here)
declare -A pristine=()
for name in *; do
  [[ ! -f $name || -L $name ]] || { IFS= read -r -d '' text <"$name"; pristine[$name]=$text; }
done

restore() {
  local name text
  chmod -R u+rwx . 2>/dev/null
  find . -mindepth 1 -delete
  prepare
}

# Words after -o, --output, --proof, --checkpoint, --resume, --data, --figures, --export and --into
# may appear or change.
named() {
  local wanted=$1 previous='' word
  shift
  for word in "$@"; do
    case $previous in
      -o | --output | --proof | --checkpoint | --resume | --data | --figures | --export | --into)
        word=${word#../ground/}
        [[ ${word%%/*} != "$wanted" ]] || return 0
        ;;
    esac
    previous=$word
  done
  return 1
}

attack() { # the verb and its words
  local name text changed=no now
  attacks=$((attacks + 1))
  if [[ $1 != serve && ("$* " == *" --time 100ms "* || " $* " != *' --time '*) ]]; then
    run 30 "$CHANGEOVER" "$@"
  else # A server never ends, others may have been given much time: they are asked to stop.
    { timeout --preserve-status -s INT -k $((8 * slower)) 2 "$CHANGEOVER" "$@" >"$out" 2>"$err" \
      </dev/null; } 2>/dev/null
    code=$?
    heard
    # On a busy machine the signal may come before the program waits for it.
    [[ $1 != serve || $code != 130 || -n $said || -s $out ]] || code=0
  fi
  judge_ending
  if [[ -z $defect && -s $out ]]; then
    IFS= read -r -d '' -n 20000 text <"$out"
    ! unclean "$text" || printf -v defect 'raw bytes on standard output: %q' "${text:0:200}"
  fi
  [[ -z $defect ]] || fault "changeover $(quoted "$@"): $defect"
  now=$(names_here)
  if [[ $now != "$before" ]]; then
    while IFS= read -r name; do
      [[ $'\n'$before$'\n' != *$'\n'"$name"$'\n'* ]] || continue
      changed=yes
      # A result that could not be written where it should be is put here, and said to be.
      [[ -z $name ]] || named "$name" "$@" || [[ "$*" == *$'\n'* || $name == state* ]] ||
        [[ $code == 4 && $said == *"./$name"* ]] ||
        fault "changeover $(quoted "$@"): left $(quoted "$name")"
    done <<<"$now"
    while IFS= read -r name; do
      [[ $'\n'$now$'\n' == *$'\n'"$name"$'\n'* ]] ||
        fault "changeover $(quoted "$@"): removed $(quoted "$name")"
    done <<<"$before"
    changed=yes
  fi
  for name in "${!pristine[@]}"; do
    text=
    IFS= read -r -d '' text <"$name"
    if [[ $text != "${pristine[$name]}" ]]; then
      named "$name" "$@" || fault "changeover $(quoted "$@"): changed $name"
      changed=yes
    fi
  done
  shopt -s nullglob dotglob
  local left=("$TMPDIR"/*)
  shopt -u nullglob dotglob
  if ((${#left[@]} > 0)); then
    fault "changeover $(quoted "$@"): left ${left[*]} in TMPDIR"
    rm -rf "${left[@]}"
  fi
  [[ $changed == no ]] || restore
}

# One in `every`, always beginning elsewhere, so that few rounds meet all options.
turn=$((RANDOM % every))
due() {
  turn=$(((turn + 1) % every))
  ((turn == 0))
}
# The same of so many at once: the places of those that are due.
due_among() { # NUMBER
  local at
  chosen=()
  for ((at = every - 1 - turn; at < $1; at += every)); do chosen+=("$at"); done
  turn=$(((turn + $1) % every))
}

has_option() { # VERB NAME
  [[ ${options[$1]} == *" $2 "* ]]
}

# The description: verb, "argument" or "option", names, kind, words.
declare -A options=() arguments=() kinds=()
verbs=()
while IFS=$'\t' read -r verb what names kind _; do
  [[ -n ${options[$verb]+known} ]] || {
    verbs+=("$verb")
    options[$verb]=' '
    arguments[$verb]=
  }
  if [[ $what == option ]]; then
    for name in ${names//,/ }; do
      [[ $name != --open ]] || continue # No browser is attacked.
      options[$verb]+="$name "
      kinds[$verb $name]=$kind
    done
  elif [[ $what == argument ]]; then
    arguments[$verb]+="${arguments[$verb]:+ }$kind"
  fi
done <"$description"
((${#verbs[@]} >= 16)) || fault "changeover describe: only ${#verbs[@]} verbs"

for verb in "${verbs[@]}"; do
  if [[ -n ${settings[$verb]+known} ]]; then
    IFS='|' read -r -a bases <<<"${settings[$verb]}"
    ((${#bases[@]} > 0)) || bases=('')
  else
    plausible=${arguments[$verb]//number/7}
    bases=("${plausible//file/good.txt}")
  fi
  limits=()
  has_option "$verb" --quiet && limits+=(--quiet)
  for base in "${bases[@]}"; do
    read -r -a words <<<"$base"
    # Each option, with each value; flags without.
    for option in ${options[$verb]}; do
      [[ $option != --help && $option != -h ]] || continue
      brief=("${limits[@]}")
      [[ $option == --time ]] || ! has_option "$verb" --time || [[ $verb == minima ]] ||
        brief+=(--time 100ms)
      if [[ ${kinds[$verb $option]} == flag ]]; then
        ! due || attack "$verb" "${words[@]}" "$option" "${brief[@]}"
        continue
      fi
      due_among ${#values[@]}
      for at in "${chosen[@]}"; do
        attack "$verb" "${words[@]}" "${brief[@]}" "$option" "${values[at]}"
      done
    done
    brief=("${limits[@]}")
    ! has_option "$verb" --time || [[ $verb == minima ]] || brief+=(--time 100ms)
    # Each word of the command line replaced, and one word more.
    for ((i = 0; i <= ${#words[@]}; ++i)); do
      due_among ${#values[@]}
      for at in "${chosen[@]}"; do
        attack "$verb" "${words[@]:0:i}" "${values[at]}" "${words[@]:i+1}" "${brief[@]}"
      done
    done
    # Two options at once, with values of all kinds.
    read -r -a names <<<"${options[$verb]}"
    for ((i = 0; i < 40 && ${#names[@]} > 0; ++i)); do
      due || continue
      pair=()
      for _ in 1 2; do
        option=${names[RANDOM % ${#names[@]}]}
        [[ $option != --help && $option != -h ]] || continue
        pair+=("$option")
        [[ ${kinds[$verb $option]} == flag ]] || pair+=("${values[RANDOM % ${#values[@]}]}")
      done
      attack "$verb" "${words[@]}" "${brief[@]}" "${pair[@]}"
    done
  done
done
# No verb at all, and what is none.
for value in "${values[@]}"; do
  ! due || attack "$value"
done
finish
