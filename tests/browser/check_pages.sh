#!/usr/bin/env bash
# Are the pages in web/dist those that web/src makes? Told by the checksums that the build wrote,
# without Node: each source listed has its checksum, and no source is missing from the list.
# usage: check_pages.sh WEB
set -euo pipefail
cd "$1"
fail() {
  printf 'web/dist is not of these sources: %s; run ./dev web build and commit web/dist\n' "$1" >&2
  exit 1
}
sha256sum --check --quiet --strict dist/sources.sha256 >/dev/null 2>&1 ||
  fail "$(sha256sum --check --quiet dist/sources.sha256 2>/dev/null | sed -n 's/: FAILED.*//p' |
  head -1) has changed"
listed=$(cut -c 67- dist/sources.sha256 | sort)
there=$({
  find src -type f
  printf '%s\n' answers.d.ts build.mjs package.json package-lock.json references.json tsconfig.json \
    types.mjs
} | sort)
[[ $listed == "$there" ]] || {
  other=$(comm -3 <(printf '%s\n' "$listed") <(printf '%s\n' "$there") | tr -d '\t' | sed -n 1p)
  fail "$other is new or gone"
}
for page in index.html assets/app.js; do
  [[ -s dist/$page ]] || fail "dist/$page is missing"
done
