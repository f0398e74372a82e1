#!/usr/bin/env bash
# Everything that must hold at every commit. What did not change is neither built nor, under the slow sanitizers, run again.
set -euo pipefail
jobs=${1:-2}

step() { printf '\n== %s\n' "$*"; }

build() {
  mkdir -p "build/$1"
  cmake --preset "$1" "${@:2}" >"build/$1/configure.log" 2>&1 || { cat "build/$1/configure.log"; exit 1; }
  cmake --build --preset "$1" -j "$jobs"
}

step "format"
git ls-files '*.cpp' '*.hpp' '*.c' '*.h' | xargs clang-format --dry-run --Werror

step "build: g++, warnings are errors"
build release -DSTOSS_BUILD_TESTS=ON -DSTOSS_BUILD_PYTHON=ON
step "build: clang++ with AddressSanitizer and UndefinedBehaviorSanitizer"
build asan

step "tests"
ctest --preset release -j "$jobs"

step "tests under sanitizers"
passed=build/asan/passed
state=$(cat build/asan/tests/stoss_tests build/asan/cli/stoss $(git ls-files tests) | sha256sum)
if [ "$state" = "$(cat "$passed" 2>/dev/null)" ]; then
  echo "passed before, and neither the programs nor the tests have changed since"
else
  ctest --preset asan -j "$jobs"
  echo "$state" >"$passed"
fi
