#!/usr/bin/env bash
# Runs a test of the pages in Chromium; skipped (77) where Node, its modules or Chromium are
# missing: `./dev test` brings them where it can.
# usage: run.sh WEB COMMAND...
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
# On a loaded machine a browser can miss a limit of time: what fails is tried once more, and that is
# said.
if [[ "$*" == *' --test '* ]]; then
  "$@" && exit
  printf 'failed; once more:\n'
fi
exec "$@"
