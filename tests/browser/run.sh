#!/usr/bin/env bash
# Runs tests of the pages in Chromium; skipped (77) where Node, its modules or Chromium are
# missing: `./dev test` brings them where it can.
# usage: run.sh WEB COMMAND...
#        run.sh WEB --tests FILE...
set -euo pipefail
cd "$1"
shift
missing() {
  printf 'skipped: %s\n' "$1"
  exit 77
}
command -v node >/dev/null || missing 'Node is not installed'
[[ -d node_modules/playwright-core && -d node_modules/axe-core && -d node_modules/esbuild &&
  -d node_modules/json-schema-to-typescript ]] ||
  missing 'web/node_modules is not there; run ./dev web install'
command -v "${CHROMIUM:-chromium-headless-shell}" >/dev/null ||
  [[ -z ${CHROMIUM:-} && -x /usr/bin/chromium ]] ||
  missing 'Chromium is not installed'
[[ $1 == --tests ]] || exec "$@"
shift

# The files run beside each other, for a browser waits as often as it works. On a loaded machine one
# can miss a limit of time: what fails is tried once more, alone, and that is said.
said=$(mktemp -d)
trap 'rm -rf "$said"' EXIT
declare -A process
again=()
for file in "$@"; do
  node "$file" >"$said/$(basename "$file")" 2>&1 &
  process[$file]=$!
done
code=0
for file in "$@"; do
  failed=0
  wait "${process[$file]}" || failed=1
  printf '%s\n' "$file"
  cat "$said/$(basename "$file")"
  ((failed == 0)) || again+=("$file")
done
for file in "${again[@]}"; do
  printf 'failed; once more: %s\n' "$file"
  node "$file" || code=1
done
exit "$code"
