#!/usr/bin/env bash
# Builds the library and the command for gcov, runs the fast tests, and prints the share of lines of each folder that
# they ran.
set -euo pipefail
jobs=${1:-2}
tree=build/coverage
mkdir -p $tree
cmake --preset coverage >$tree/configure.log 2>&1 || { cat $tree/configure.log; exit 1; }
cmake --build --preset coverage -j "$jobs"
find $tree -name '*.gcda' -delete
# What gcov has to say is not to stand in what tests read.
GCOV_ERROR_FILE=$PWD/$tree/gcov_errors.log ctest --preset coverage -j "$jobs"
find $tree -name '*.gcda' | xargs -n 50 gcov --json-format --stdout 2>$tree/gcov.log >$tree/lines.json
/usr/bin/python3 scripts/coverage.py $tree/lines.json
