#!/usr/bin/env bash
# Runs tests of the pages in Chromium; skipped (77) where Node, its modules or Chromium are
# missing: `./dev test` brings them where it can.
# usage: run.sh WEB COMMAND...         one that needs no browser
#        run.sh WEB --browser COMMAND...
#        run.sh WEB --pages FILE...    CHANGEOVER_PAGES: words of the names of those to run
#        run.sh WEB --firefox FILE     in Firefox instead, which nothing brings: install it yourself
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
if [[ $1 == --firefox ]]; then
  command -v "${FIREFOX:-firefox-esr}" >/dev/null || [[ -z ${FIREFOX:-} && -x /usr/bin/firefox ]] ||
    missing 'Firefox is not installed'
  exec node --test "$2"
fi
[[ $1 == --browser || $1 == --pages ]] || exec "$@"
command -v "${CHROMIUM:-chromium-headless-shell}" >/dev/null ||
  [[ -z ${CHROMIUM:-} && -x /usr/bin/chromium ]] ||
  missing 'Chromium is not installed'
mode=$1
shift
if [[ $mode == --browser ]]; then
  # On a loaded machine it can miss a limit of time.
  "$@" && exit
  printf 'failed; once more\n'
  exec "$@"
fi
exec node tests/run.mjs --only "${CHANGEOVER_PAGES:-}" "$@"
