#!/usr/bin/env bash
# ./dev bare-machine --in FOLDER takes a new folder, an empty one or one that it made, and no folder of
# the system or of a user. Nothing is made: the script finds no root user here.
#
# usage: bare_machine_test.sh SCRIPT
set -euo pipefail
script=$1
folder=$(mktemp -d /var/tmp/bare_machine_test.XXXXXX)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin" "$folder/empty" "$folder/full" "$folder/earlier"
printf '#!/bin/sh\necho 1000\n' >"$folder/bin/id"
chmod +x "$folder/bin/id"
touch "$folder/full/mine" "$folder/file" "$folder/earlier/.changeover-bare-machine" \
  "$folder/earlier/log"
ln -s /home "$folder/link"

faults=0
# expect WORDS FOLDER: the script ends with exit code 1 and says them.
expect() {
  local code=0 said
  said=$(PATH="$folder/bin:$PATH" bash "$script" --in "$2" run 2>&1) || code=$?
  [[ $code == 1 && $said == *"$1"* ]] || {
    printf '%s: exit code %s, %s\n' "$2" "$code" "$said" >&2
    faults=1
  }
}

for own in / /home /mnt /media /srv /opt /boot /root /tmp /usr /usr/local/src /usr/local/games \
  /var/local /var/opt /proc "$folder/link"; do
  [[ ! -d $own ]] || expect 'name a new one' "$own"
done
for own in /mnt /media /srv /opt /usr/local/src /var/local /var/opt; do
  [[ ! -d $own || -n $(ls -A "$own") ]] || expect "one of the system's own folders" "$own"
done
expect 'neither empty nor of an earlier run' "$folder/full"
expect 'it is not a folder' "$folder/file"
for good in "$folder/new" "$folder/new/deep" "$folder/empty" "$folder/earlier"; do
  expect 'only root may make a Debian' "$good"
done
said=$(PATH="$folder/bin:$PATH" bash "$script" --debian 11 run 2>&1) || true
[[ $said == *'--debian 11: what is tried is Debian 12 or 13' ]] || {
  printf -- '--debian 11: %s\n' "$said" >&2
  faults=1
}
[[ ! -e $folder/new && -z $(ls -A "$folder/empty") && -e $folder/full/mine ]] || {
  echo 'something was made or lost' >&2
  faults=1
}
exit "$faults"
