#!/usr/bin/env bash
# Builds the documentation site in build/docs, from the package in build/venv and the command of build/release. What
# has not changed is not made again: the programs of the gallery run only if they or the package have changed.
set -euo pipefail
jobs=${1:-2}
sources=build/docs-source
pages=build/docs-doctrees
mkdir -p build/docs-doxygen
# Sphinx begins anew if the headers or its settings have changed: it misses changed styles, and among old names of C++
# it is slow.
state=$(cat $(git ls-files docs/site include) | sha256sum)
if [ "$state" != "$(cat build/docs-doxygen/state 2>/dev/null)" ]; then
  rm -rf build/docs "$pages" build/docs-doxygen/xml
  doxygen docs/site/Doxyfile
  echo "$state" >build/docs-doxygen/state
fi
# The page, with links to this site, where `make web` has built its core.
if [ -f build/wasm/stoss.mjs ] && [ -d web/node_modules ]; then
  STOSS_DOCUMENTATION=../ web/build.sh build/docs-page
fi
build/venv/bin/python docs/site/generate "$sources" build/release/cli/stoss
# After a warning all pages are read again next time: only then it is said again.
build/venv/bin/python -m sphinx -W --keep-going -q -j "$jobs" -c docs/site -d "$pages" "$sources" build/docs ||
  { rm -rf "$pages"; exit 1; }
echo "built: build/docs/index.html"
