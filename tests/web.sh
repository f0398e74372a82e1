#!/usr/bin/env bash
# Tests of the page by their topic, in web/. They are skipped where the page is not built.
#   web.sh core|unit|page
set -euo pipefail
[ -d node_modules ] && [ -f ../build/wasm/stoss.mjs ] || { echo "skipped: the page is not built"; exit 77; }
case $1 in
  core) npx vitest run tests/core ;;
  page) npx vitest run tests/page ;;
  unit) npx tsc --noEmit && npx vitest run tests/unit tests/native ;;
esac
