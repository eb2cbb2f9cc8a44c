#!/usr/bin/env bash
# The server against clients that mean no good and days that go wrong: bytes that are no HTTP,
# connections that stay half open, a port that is taken, kill -9 while a design is kept, a disk that
# is full while files are exported. It answers afterwards, no file is half written, and what stops
# it is one line with the documented exit code.
# shellcheck source=support/attack.sh
source "$(dirname "$0")/support/attack.sh"
CHANGEOVER=$(program CHANGEOVER) || exit
export CHANGEOVER_CATALOG=$scratch/ground/mine.db

# start ARGUMENT...: a server in the background; sets process, port, token.
start() {
  local line tries
  rm -f "$out"
  env --default-signal=INT "$CHANGEOVER" serve "$@" >"$out" 2>"$err" </dev/null &
  process=$!
  for ((tries = 0; tries < 600; ++tries)); do
    [[ ! -s $out ]] || break
    kill -0 "$process" 2>/dev/null || break
    sleep 0.1
  done
  read -r line <"$out" ||
    { fault "serve $(quoted "$@"): no address; $(head -c 300 "$err")"; return 1; }
  port=${line#http://127.0.0.1:}
  token=${line##*token=}
  port=${port%%/*}
}

# ask METHOD TARGET [BODY [HEADER]...]: sets status and answer.
ask() {
  local method=$1 target=$2 body=${3:-} header
  shift 2
  shift $(($# > 0 ? 1 : 0))
  status=none answer=
  exec {server}<>"/dev/tcp/127.0.0.1/$port" || return 1
  {
    printf '%s %s HTTP/1.1\r\nHost: 127.0.0.1:%s\r\nConnection: close\r\n' "$method" "$target" \
      "$port"
    for header in "$@"; do printf '%s\r\n' "$header"; done
    [[ $method == GET ]] || printf 'Content-Length: %s\r\n' "${#body}"
    printf '\r\n%s' "$body"
  } 1>&"$server"
  answer=$(timeout 120 cat <&"$server" | tr -d '\0')
  exec {server}>&-
  status=${answer#HTTP/1.1 }
  status=${status%% *}
}

alive() { # after what
  attacks=$((attacks + 1))
  kill -0 "$process" 2>/dev/null ||
    { fault "$1: the server is gone; $(head -c 300 "$err")"; return 1; }
  ask GET '/api/bounds?v=20&k=5&kind=linear'
  [[ $status == 200 ]] || fault "$1: the server answers $status afterwards"
}

stop() { # signal, after what
  local code
  kill -s "$1" "$process"
  wait "$process"
  code=$?
  [[ $code == 0 ]] || fault "SIG$1 after $2: exit code $code; $(head -c 300 "$err")"
}

# Sockets that close say so, and kill who writes to them; faults go to standard output.
exec 2>/dev/null
trap '' PIPE
shopt -s execfail

start --port 0 || finish
for ((round = 0; round < (rounds > 1 ? 30 * rounds : 12); ++round)); do
  # Bytes that are no HTTP, and HTTP with some of its bytes changed.
  request="GET /api/cell?v=20&k=5&kind=linear HTTP/1.1\r\nHost: 127.0.0.1:$port\r\nContent-Length: 10\r\n\r\n0 1 2 3 4 "
  exec {socket}<>"/dev/tcp/127.0.0.1/$port" || { fault 'no connection'; break; }
  if ((round % 3 == 0)); then
    head -c $((RANDOM % 3000)) /dev/urandom >&"$socket"
  else
    place=$((RANDOM % 120))
    printf '%b' "${request:0:place}\\x$(printf '%02x' $((RANDOM % 256)))${request:place}" \
      >&"$socket"
  fi
  exec {socket}>&-
done
alive 'garbage'

# Connections that stay open and say nothing, or half of something.
held=()
for ((i = 0; i < 100; ++i)); do
  exec {socket}<>"/dev/tcp/127.0.0.1/$port" || break
  held+=("$socket")
  ((i % 2 == 0)) ||
    printf 'POST /api/verify HTTP/1.1\r\nHost: 127.0.0.1:%s\r\nContent-Length: 99\r\n\r\n0 1' \
    "$port" >&"$socket"
done
alive '100 connections that stay open'
for socket in "${held[@]}"; do exec {socket}>&-; done

# More than the server takes from one address: they only hold connections, and make room.
if ulimit -n 2048 2>/dev/null; then
  held=()
  for ((i = 0; i < 600; ++i)); do
    exec {socket}<>"/dev/tcp/127.0.0.1/$port" || break
    held+=("$socket")
    ((i % 2 == 0)) ||
      printf 'POST /api/verify HTTP/1.1\r\nHost: 127.0.0.1:%s\r\nContent-Length: 60000000\r\n\r\n0 1' "$port" >&"$socket"
  done
  for ((tries = 0; tries < 100; ++tries)); do
    ask GET '/api/bounds?v=20&k=5&kind=linear'
    [[ $status != 200 ]] || break
    sleep 0.1
  done
  alive '600 connections that stay open'
  for socket in "${held[@]}"; do exec {socket}>&-; done
fi

# Bodies of every kind of wrong.
for body in '' '[' "$(printf '[%.0s' {1..5000})" '{"parts":1e999}' $'\x01\x02' '{"a":"\ud800"}' \
  '<!DOCTYPE x [<!ENTITY a "b">]>'; do
  for target in /api/verify /api/plan /api/loadorder /api/draw '/api/verify?v=99999999999'; do
    ask POST "$target" "$body" 'Content-Type: application/json'
    [[ $status == 4?? ]] || fault "POST $target with $(quoted "$body"): $status"
  done
done
alive 'wrong bodies'

# No client without the token; none from another origin.
ask POST /api/search '{"v":9,"k":4}' 'Content-Type: application/json'
[[ $status == 401 ]] || fault "a search without the token: $status"
ask POST /api/verify '0 1 2' 'Origin: http://evil.example'
[[ $status == 403 ]] || fault "a foreign origin: $status"

# Names of a catalog are paths: what SQLite would take for something else ends no server.
stop TERM 'posts'
mkfifo fifo
for name in 'file:zz.db?mode=memory' ':memory:' fifo /dev/null; do
  start --port 0 --catalog "$name" || continue
  ask POST '/api/catalog/add?kind=linear' $'0 1 2\n0 1 3\n0 2 3\n1 2 3\n' \
    "X-Changeover-Token: $token" 'Content-Type: text/plain'
  if [[ -p $name || -c $name ]]; then
    [[ $status == 5?? || $status == 4?? ]] ||
      fault "serve --catalog $name: a design is kept: $status"
  else
    [[ $status == 200 && -f $name ]] || fault "serve --catalog $name: a design is not kept: $status"
  fi
  alive "serve --catalog $name"
  stop INT "serve --catalog $name"
done
start --port 0 || finish

# A second server on the same port.
run 60 "$CHANGEOVER" serve --port "$port"
attacks=$((attacks + 1))
[[ $code == 4 && $said == *'another program listens there'* ]] ||
  fault "a port that is taken: exit code $code $said"
alive 'a second server'
stop INT 'all that'

# Killed while a design is being kept: the catalog is whole, and the next server keeps it.
for ((round = 0; round < (rounds > 1 ? 3 * rounds : 2); ++round)); do
  rm -f mine.db*
  start || break
  (
    for ((i = 0; i < 20; ++i)); do
      ask POST '/api/catalog/add?kind=circular' $'0 1 2 3\n4 5 2 3\n4 5 0 1\n' \
        "X-Changeover-Token: $token" \
        'Content-Type: text/plain'
    done
  ) &
  client=$!
  sleep "0.$((RANDOM % 4))$((RANDOM % 10))"
  kill -KILL "$process"
  wait "$process" "$client"
  attacks=$((attacks + 1))
  run 60 "$CHANGEOVER" catalog list --users
  [[ $code == 0 ]] || fault "the catalog after kill -9: exit code $code $said"
  start || break
  ask POST '/api/catalog/add?kind=circular' $'0 1 2 3\n4 5 2 3\n4 5 0 1\n' \
    "X-Changeover-Token: $token" 'Content-Type: text/plain'
  [[ $status == 200 && $answer == *6.4.2.circular.3.* ]] || fault "keeping after kill -9: $status"
  stop TERM 'kill -9'
done

# Files for any web server: whole, or not there.
mkdir pages && printf '<!doctype html><html><head><title>x</title></head></html>' >pages/index.html
small=(serve --assets pages --k 3 --v 5..7 --change 2 --export)
run 120 "$CHANGEOVER" "${small[@]}" site
[[ $code == 0 && -s site/index.html && -s site/data/config.json ]] ||
  fault "export: exit code $code $said"
mkdir full && printf 'mine' >full/mine
run 60 "$CHANGEOVER" "${small[@]}" full
attacks=$((attacks + 1))
[[ $code == 4 && $(cat full/mine) == mine && $(ls -A full) == mine ]] ||
  fault "export into a folder with other things: exit code $code"
# Over an earlier export: what is not as that wrote it is refused at every depth, and stays.
listing() { (cd site && find . -printf '%p %y %s %l\n' | sort &&
  find . -type f -exec sha256sum {} + | sort); }
first_cell=$(find site/data/cell -type f | head -n 1)
for put in 'mkdir -p site/data/cell/mine; echo a >site/data/cell/mine/a' \
  'echo mine >site/data/mine.json' 'mkdir site/data/empty' \
  'mkfifo site/data/pipe' 'ln -s /etc/passwd site/data/link' 'ln -s cell site/data/cells' \
  'rm site/index.html; mkdir site/index.html' \
  'echo more >>site/index.html' "rm '$first_cell'; ln -s /etc/passwd '$first_cell'" \
  "rm '$first_cell'; mkfifo '$first_cell'" \
  'echo mine >site/.changeover-unfinished' 'echo ../site/index.html >site/.changeover-unfinished' \
  'echo "changeover 0.1.0" >site/.changeover-explorer' 'rm site/.changeover-explorer' \
  'rm site/.changeover-explorer; ln -s /etc/passwd site/.changeover-explorer'; do
  cp -a site good-site
  eval "$put"
  kept=$(listing)
  run 120 "$CHANGEOVER" "${small[@]}" site
  attacks=$((attacks + 1))
  [[ $code == 4 && $said == *'--export site: '* ]] ||
    fault "export over what is not its own ($put): exit code $code $said"
  [[ $(listing) == "$kept" ]] || fault "export over what is not its own changed it: $put"
  rm -rf site && mv good-site site
done
# A list that no export wrote says nothing about files, and is found out in a moment.
list=site/.changeover-explorer
for put in 'printf "%064d  /etc/passwd\n" 0 >>site/.changeover-explorer' \
  'printf "%064d  ../mine\n" 0 >>site/.changeover-explorer' \
  'printf "%064d  data//x\n" 0 >>site/.changeover-explorer' \
  'printf "%064d  data/own/\n" 0 >>site/.changeover-explorer; mkdir site/data/own' \
  'tail -n 1 good-site/.changeover-explorer >>site/.changeover-explorer' \
  'head -c 700 good-site/.changeover-explorer >site/.changeover-explorer' \
  'head -c 300000 /dev/urandom >site/.changeover-explorer' \
  'truncate -s 20G site/.changeover-explorer'; do
  cp -a site good-site
  eval "$put"
  kept=$(find site -printf '%p %y %s\n' | sort)
  run 60 "$CHANGEOVER" "${small[@]}" site
  attacks=$((attacks + 1))
  [[ $code == 4 && $said == *"$list"*'no export wrote'* ]] ||
    fault "export over a list that no export wrote ($put): exit code $code $said"
  [[ $(find site -printf '%p %y %s\n' | sort) == "$kept" ]] ||
    fault "export over a list that no export wrote changed the site: $put"
  rm -rf site && mv good-site site
done
ln -s nowhere away
run 60 "$CHANGEOVER" "${small[@]}" away
attacks=$((attacks + 1))
[[ $code == 4 && $said == *'leads nowhere'* ]] ||
  fault "export to a link that leads nowhere: exit code $code $said"
# A file that a user puts there during the export stays.
"$CHANGEOVER" serve --assets pages --k 3..5 --v 5..40 --export site >"$out" 2>"$err" </dev/null &
process=$!
for ((tries = 0; tries < 600; ++tries)); do
  [[ -z $(find . -maxdepth 1 -name 'site.new-*') ]] || break
  sleep 0.01
done
echo mine >site/data/mine
wait "$process"
code=$?
heard
attacks=$((attacks + 1))
[[ $code == 4 && $(cat site/data/mine) == mine && -z $(find . -maxdepth 1 -name 'site.new-*') ]] ||
  fault "export over what came while it worked: exit code $code $said"
rm -f site/data/mine
# A user who may not read the earlier site may not read the next one.
chmod 700 site
run 120 "$CHANGEOVER" "${small[@]}" site
attacks=$((attacks + 1))
[[ $code == 0 && $(stat -c %a site) == 700 ]] ||
  fault "export over a private site: exit code $code, mode $(stat -c %a site)"
(umask 027; run 120 "$CHANGEOVER" "${small[@]}" masked)
[[ $(stat -c %a masked) == 750 ]] || fault 'export: the umask is ignored'
# Killed between any two steps of putting it there: the next export clears what was left.
if command -v strace >/dev/null && strace -o /dev/null true; then
  steps=(unlink:1)
  ((rounds == 1)) || steps=(renameat2:1 syncfs:1 unlink:1 unlink:2 unlink:9 rmdir:1 rmdir:3)
  for step in "${steps[@]}"; do
    strace -f --seccomp-bpf -o /dev/null -e trace="${step%:*}" -e \
      inject="${step%:*}:signal=KILL:when=${step#*:}" "$CHANGEOVER" "${small[@]}" site >"$out" \
      2>"$err"
    run 120 "$CHANGEOVER" "${small[@]}" site
    attacks=$((attacks + 1))
    [[ $code == 0 && -z $(find . -maxdepth 1 -name 'site.new-*') ]] ||
      fault "export after a kill at $step: exit code $code $said"
  done
fi
# A file that is gone is no loss, and what is named like a site that was left belongs to a user.
rm "$first_cell"
cp -a site site.new-abcdef
echo mine >site.new-abcdef/mine
kept=$(find site.new-abcdef -type f -exec sha256sum {} + | sort)
run 120 "$CHANGEOVER" "${small[@]}" site
attacks=$((attacks + 1))
[[ $code == 0 && -s $first_cell ]] || fault "export over an earlier one: exit code $code $said"
[[ $(find site.new-abcdef -type f -exec sha256sum {} + | sort) == "$kept" ]] ||
  fault 'export took a folder that is not its own'
rm -rf site.new-abcdef
before=$(cat site/data/config.json site/index.html)
for ((round = 0; round < (rounds > 1 ? 3 * rounds : 2); ++round)); do
  env --default-signal=INT "$CHANGEOVER" serve --assets pages --k 3..8 --v 5..60 --export site \
    >"$out" 2>"$err" </dev/null &
  process=$!
  sleep "0.$((RANDOM % 10))"
  if ((round % 2 == 0)); then kill -KILL $process; else kill -INT $process; fi
  wait $process
  code=$?
  if ((round % 2 == 0)); then
    # What it left is cleared by the next one.
    run 120 "$CHANGEOVER" "${small[@]}" site
    [[ $code == 0 && -z $(find . -maxdepth 1 -name 'site.new-*') ]] ||
      fault "export after kill -9: exit code $code, or a folder is left"
  fi
  attacks=$((attacks + 1))
  [[ $(cat site/data/config.json site/index.html) == "$before" ]] ||
    fault 'export, stopped: the old site is another'
  if ((round % 2 == 1)); then
    [[ $code == 30 || $code == 130 ]] ||
      fault "export, interrupted: exit code $code $(head -c 300 "$err")"
    [[ -z $(find . -maxdepth 1 -name 'site.new-*') || $code == 130 ]] ||
      fault 'export, interrupted: a folder is left'
  fi
  rm -rf site.new-*
done
if mkdir disk && mount -t tmpfs -o size=64k none disk; then
  at_exit+=("umount '$PWD/disk'")
  run 120 "$CHANGEOVER" "${small[@]}" disk/site
  attacks=$((attacks + 1))
  [[ $code == 4 ]] || fault "export to a full disk: exit code $code $said"
  [[ -z $(ls -A disk) ]] || fault "export to a full disk: left $(ls -A disk)"
fi

finish
