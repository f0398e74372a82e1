#!/usr/bin/env bash
# Builds the documentation site in build/docs, from the package in build/venv and the command of build/release. What
# has not changed is not made again: the programs of the gallery run only if they or the package have changed.
set -euo pipefail
jobs=${1:-2}
mkdir -p build/docs-doxygen
state=$(cat docs/site/Doxyfile $(git ls-files include) | sha256sum)
if [ "$state" != "$(cat build/docs-doxygen/state 2>/dev/null)" ]; then
  doxygen docs/site/Doxyfile
  echo "$state" >build/docs-doxygen/state
fi
build/venv/bin/python docs/site/generate build/docs-source build/release/cli/stoss
build/venv/bin/python -m sphinx -W --keep-going -q -j "$jobs" -c docs/site -d build/docs-doctrees build/docs-source build/docs
echo "built: build/docs/index.html"
