#!/usr/bin/env bash
# The check of pages can fail: a source changed, added, taken away, a page missing.
# usage: check_pages_test.sh CHECK WEB
set -euo pipefail
check=$1 web=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fresh() {
  rm -rf "$folder/web"
  mkdir "$folder/web"
  (cd "$web" && tar -cf - --exclude node_modules .) | tar -xf - -C "$folder/web"
}
refused() {
  if bash "$check" "$folder/web" 2>"$folder/said"; then
    printf 'not noticed: %s\n' "$1" >&2
    exit 1
  fi
  grep -q 'run ./dev web build' "$folder/said"
}
fresh
bash "$check" "$folder/web"
printf '\n' >>"$folder/web/src/main.ts"
refused 'a source changed'
fresh
printf 'export {};\n' >"$folder/web/src/new.ts"
refused 'a source added'
fresh
rm "$folder/web/src/icon.svg"
refused 'a source taken away'
fresh
rm "$folder/web/dist/assets/app.js"
refused 'a page missing'
