#!/usr/bin/env bash
# Tests of the page by their topic, in web/: unit and smoke with the core for this machine, core and browser with that in
# WebAssembly. They are skipped where the page is not built.
#   web.sh unit|smoke|core|browser
set -euo pipefail
built=../build/native/web
case $1 in core | browser) built=../build/web ;; esac
[ -d node_modules ] && [ -d $built ] || { echo "skipped: the page is not built"; exit 77; }
case $1 in
  core) npx vitest run tests/core ;;
  smoke) STOSS_PAGE=$PWD/$built npx vitest run tests/smoke ;;
  browser) npx vitest run tests/page ;;
  unit) npx tsc --noEmit && npx vitest run tests/unit tests/native ;;
esac
