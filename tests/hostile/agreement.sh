#!/usr/bin/env bash
# Three judges of the same lists: verify, checkdesign, and the definition itself in awk, below.
# Random lists, walks that keep to the change number, and designs with small damages: strength 1 to
# 4 where all know it, changes of 0 to more than k, blocks of one element, one block, elements in
# every block. They agree on the verdict, on exit codes, and on all that is counted.
#
# A round is a hundred lists.
# shellcheck source=support/attack.sh
source "$(dirname "$0")/support/attack.sh"
CHANGEOVER=$(program CHANGEOVER) || exit
CHECKDESIGN=$(program CHECKDESIGN) || exit
seed=$((${HOSTILE_SEED:-1} * 1000))

# Lists at random: FOLDER/0, … COUNT of them.
cat >"$scratch/tools/lists.awk" <<'AWK'
function below(n) { return int(rand() * n) }
# A k-subset of 0 … v−1 into `block`.
function draw(v, k,   i, j, t) {
  for (i = 0; i < v; ++i) block[i] = i
  for (i = 0; i < k; ++i) { j = i + below(v - i); t = block[i]; block[i] = block[j]; block[j] = t }
}
# m members of the block for m of those outside it, which stand behind the first k.
function step(v, k, m,   i, j, t) {
  for (i = 0; i < k; ++i) { j = i + below(k - i); t = block[i]; block[i] = block[j]; block[j] = t }
  for (i = k; i < v; ++i) { j = i + below(v - i); t = block[i]; block[i] = block[j]; block[j] = t }
  for (i = 0; i < m && i < k && k + i < v; ++i) { t = block[i]; block[i] = block[k + i]; block[k + i] = t }
}
BEGIN {
  srand(seed)
  for (n = 0; n < count; ++n) {
    t = 2 + below(3); k = 1 + below(6); if (k < t && below(6)) k = t + below(3)
    v = k + below(5); m = 1 + below(k); if (!below(15)) m = k + 1; b = 1 + below(14)
    if (below(8) == 0) b = 1 + below(2)
    kind = below(2) ? "circular" : "linear"
    file = folder "/" n
    printf "# changeover design v=%d k=%d change=%d kind=%s strength=%d\n", v, k, m, kind, t > file
    draw(v, k)
    honest = below(3)
    for (i = 0; i < b; ++i) {
      line = block[0]
      for (j = 1; j < k; ++j) line = line " " block[j]
      print line > file
      if (honest && below(10)) step(v, k, m); else draw(v, k)
    }
    close(file)
  }
}
AWK

# Damages each list of the files given once, in a way that a reader still accepts.
cat >"$scratch/tools/damage.awk" <<'AWK'
function below(n) { return int(rand() * n) }
function finish_file(   i, line, a, c, e) {
  if (!lines) return
  out = folder "/" (files++)
  what = below(6); i = 1 + below(lines); e = 1 + below(lines)
  if (what == 0 && lines > 1) { for (a = i; a < lines; ++a) text[a] = text[a + 1]; --lines }
  else if (what == 1) { line = text[i]; text[i] = text[e]; text[e] = line }
  else if (what == 2) { text[++lines] = text[i] }
  else if (what == 3) {
    n = split(text[i], word, " "); c = 1 + below(n)
    do { e = below(v); used = 0; for (a = 1; a <= n; ++a) if (word[a] == e "") used = 1 } while (used && n < v)
    if (n < v) word[c] = e
    line = word[1]; for (a = 2; a <= n; ++a) line = line " " word[a]
    text[i] = line
  } else if (what == 4) sub(/kind=[a-z]*/, below(2) ? "kind=linear" : "kind=circular", header)
  else sub(/change=[0-9]*/, "change=" (1 + below(4)), header)
  print header > out
  for (a = 1; a <= lines; ++a) print text[a] > out
  close(out); lines = 0
}
BEGIN { srand(seed) }
FNR == 1 { finish_file() }
/^# changeover design/ { header = $0; v = $0; sub(/.* v=/, "", v); sub(/ .*/, "", v); v += 0; next }
/^#/ || NF == 0 { next }
{ text[++lines] = $0 }
END { finish_file() }
AWK

# The definition: FILE valid uncovered bad-steps excess never-newly-covered fixed, one line per file.
cat >"$scratch/tools/judge.awk" <<'AWK'
function parameter(name, otherwise,   at) {
  at = $0
  if (!sub(".* " name "=", "", at)) return otherwise
  sub(/ .*/, "", at)
  return at
}
# Is the subset s[1 … t] in block i?
function holds(i,   j) {
  for (j = 1; j <= t; ++j) if (!((i, s[j]) in has)) return 0
  return 1
}
function judge_subset(   i, before, occurs, times) {
  occurs = times = 0
  for (i = 1; i <= b; ++i) if (holds(i)) {
    occurs = 1
    before = i > 1 ? i - 1 : wraps ? b : 0
    if (!before || !holds(before)) ++times
  }
  if (!occurs) ++uncovered
  if (occurs && !times) ++never
  if (times > 1) excess += times - 1
}
function subsets(depth, from,   x) {
  if (depth > t) { judge_subset(); return }
  for (x = from; x < v; ++x) { s[depth] = x; subsets(depth + 1, x + 1) }
}
function finish_file(   i, j, next_one, kept, x, everywhere) {
  if (!b) return
  wraps = kind == "circular" && b > 1
  uncovered = bad = excess = never = fixed = 0
  for (i = 1; i <= b; ++i) {
    if (i == b && !wraps) break
    next_one = i < b ? i + 1 : 1
    kept = 0
    for (x = 0; x < v; ++x) if (((i, x) in has) && ((next_one, x) in has)) ++kept
    if (k - kept != m) ++bad
  }
  for (x = 0; x < v; ++x) {
    everywhere = 1
    for (i = 1; i <= b; ++i) if (!((i, x) in has)) everywhere = 0
    fixed += everywhere
  }
  subsets(1, 0)
  print name, (bad || uncovered ? "false" : "true"), uncovered, bad, excess, never, fixed
  b = 0; split("", has)
}
FNR == 1 { finish_file(); name = FILENAME; sub(/.*\//, "", name); kind = "linear"; m = 2; t = 2 }
/^# changeover design/ {
  v = parameter("v", 0) + 0; k = parameter("k", 0) + 0; m = parameter("change", 2) + 0
  kind = parameter("kind", "linear"); t = parameter("strength", 2) + 0
  next
}
/^#/ || NF == 0 { next }
{ ++b; for (j = 1; j <= NF; ++j) has[b, $j + 0] = 1 }
END { finish_file() }
AWK

field() { # NAME: of the JSON report, from its details on
  local rest=${report#*\"details\":}
  rest=${rest#*\""$1"\":}
  printf '%s' "${rest%%[,\}]*}"
}

both_refuse=0
compare() { # FOLDER
  local name valid uncovered bad excess never fixed report code other expected word number file
  while read -r name valid uncovered bad excess never fixed; do
    file=$1/$name
    attacks=$((attacks + 1))
    "$CHANGEOVER" verify "$file" --json >"$out" 2>"$err"
    code=$?
    IFS= read -r -d '' report <"$out"
    "$CHECKDESIGN" "$file" >"$out" 2>"$scratch/said/other"
    other=$?
    if [[ $code != "$other" ]]; then
      fault "list ${name} of seed $seed: verify ends with $code, checkdesign with $other: $(tr \
        '\n' '/' <"$file")"
      continue
    fi
    if ((code > 1)); then # Parameters that both refuse, such as a change of more than k.
      both_refuse=$((both_refuse + 1))
      ((code == 3)) || fault "list $name of seed $seed: both end with $code: $(tr '\n' '/' <"$file")"
      continue
    fi
    expected=$([[ $valid == true ]]; echo $?)
    ((code == expected)) ||
      fault "list $name of seed $seed: exit code $code, but by the definition $expected: $(tr '\n' '/' <"$file")"
    [[ $(field valid) == "$valid" && $(field uncovered) == "$uncovered" &&
      $(field bad_steps) == "$bad" && $(field excess) == "$excess" &&
      $(field never_newly_covered) == "$never" ]] ||
      fault "list $name of seed $seed: verify counts otherwise than the definition ($valid $uncovered $bad $excess $never): $(tr '\n' '/' <"$file")"
    while read -r word number _; do
      case $word in
        uncovered) expected=$uncovered ;;
        bad-steps) expected=$bad ;;
        excess) expected=$excess ;;
        never-newly-covered) expected=$never ;;
        fixed) expected=$fixed ;;
        *) continue ;;
      esac
      [[ $number == "$expected" ]] ||
        fault "list $name of seed $seed: checkdesign counts $word $number, by the definition $expected: $(tr '\n' '/' <"$file")"
    done <"$out"
  done < <(awk -f "$scratch/tools/judge.awk" "$1"/*)
}

mkdir designs
n=0
for parameters in '6 4 --circular' '9 4' '7 3 --circular' '10 5' '9 5 -m 1' '11 4 -m 1 --circular' '12 6 --linear' \
  '13 4 --circular' '8 3 -m 1 --linear' '10 6 -m 3'; do
  # shellcheck disable=SC2086
  "$CHANGEOVER" design $parameters --format text >designs/$n 2>/dev/null && n=$((n + 1))
done
((n >= 6)) || fault "only $n designs to damage"
rm -f designs/$n

for ((round = 0; round < rounds; ++round)); do
  seed=$((seed + 1))
  rm -rf lists damaged
  mkdir lists damaged
  awk -v seed=$seed -v count=70 -v folder=lists -f "$scratch/tools/lists.awk"
  awk -v seed=$seed -v folder=damaged -f "$scratch/tools/damage.awk" designs/* designs/* designs/*
  compare lists
  compare damaged
done
compare designs
printf '%d lists were refused by both\n' "$both_refuse"
((both_refuse * 3 < attacks)) || fault "too many lists were refused for this to mean much"
finish
