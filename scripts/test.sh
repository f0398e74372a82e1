#!/usr/bin/env bash
# The tests of a tier and of those before it: fast (at every commit), whole (what must hold) or long (before a release:
# linters, all tests, those with programs of others, all of them under sanitizers, the documentation site, the
# validation, coverage); or friends, only those with programs of others, of the groups that are named or whose inputs
# have changed.
#   test.sh fast|whole|long [JOBS] | test.sh friends JOBS [--all] [GROUP …]
set -euo pipefail
tier=$1
jobs=${2:-2}

step() {
  step=$*
  printf '\n== %s\n' "$*"
}

# Before a release all is to be known that fails: what takes hours ends at its end only.
failed=()
try() {
  "$@" && return
  [ "$tier" = long ] || exit 1
  failed+=("$step")
}

configure() {
  mkdir -p "build/$1"
  cmake --preset "$1" "${@:2}" >"build/$1/configure.log" 2>&1 || { cat "build/$1/configure.log"; exit 1; }
}

# Runs the tests of a preset, and names those that were skipped inside of their processes, which CTest does not.
run() {
  local status=0 results=$PWD/build/${2:-release}/results.xml  # a test may write CTest's own log anew
  ctest --preset "$1" -j "$jobs" --output-junit "$results" || status=$?
  grep -h '^SKIPPED \[' "$results" | sort -u || true
  return $status
}

friends() { /usr/bin/python3 scripts/friends.py --jobs "$jobs" "$@"; }

if [ "$tier" = long ]; then
  step "lint: ruff, Biome and clang-tidy"
  try make --no-print-directory lint JOBS="$jobs"
fi

# While the library is compiled, what only its tests need is installed.
scripts/install-dependencies.sh build
case $tier in long) packages=long STOSS_EXAMPLES=300 ;; *) packages=test STOSS_EXAMPLES=100 ;; esac
export STOSS_EXAMPLES  # of fuzzed arguments and files of Python
mkdir -p build
scripts/install-dependencies.sh "$packages" >build/packages.log 2>&1 &
installing=$!

step "build: g++, warnings are errors"
configure release
cmake --build --preset release -j "$jobs" --target stoss stoss_command
wait $installing || { cat build/packages.log >&2; exit 1; }
cat build/packages.log

if [ "$tier" = friends ]; then
  configure release -DSTOSS_BUILD_TESTS=ON -DSTOSS_BUILD_PYTHON=ON
  friends "${@:3}"
  exit
fi

step "format"
git ls-files '*.cpp' '*.hpp' '*.c' '*.h' | xargs -P "$jobs" -n 100 clang-format --dry-run --Werror

step "build: tests"
configure release -DSTOSS_BUILD_TESTS=ON -DSTOSS_BUILD_PYTHON=ON
if [ "$tier" = fast ]; then
  cmake --build --preset release -j "$jobs" --target stoss_tests stoss_command_tests
  step "tests: fast"
  run fast
  exit
fi
cmake --build --preset release -j "$jobs"

step "build: clang++ with AddressSanitizer and UndefinedBehaviorSanitizer"
# What handles memory: the C interface, documents, the command; before a release all.
if [ "$tier" = long ]; then
  configure asan -DSTOSS_TEST_ROOMS= -DSTOSS_ARCHIVE= "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1"
  cmake --build --preset asan -j "$jobs" --target stoss_command stoss_tests stoss_command_tests stoss_fuzz
else
  configure asan
  cmake --build --preset asan -j "$jobs"
fi

step "tests: fast and whole"
try run whole

step "tests under sanitizers"
# They are slow: what has passed is not run again.
passed=build/asan/passed
programs=(build/asan/tests/stoss_tests build/asan/cli/stoss build/asan/fuzz/stoss_fuzz_*)
state=$(cat "${programs[@]}" $(git ls-files tests fuzz) | sha256sum)" $tier"
if [ "$state" = "$(cat "$passed" 2>/dev/null)" ]; then
  echo "passed before, and neither the programs nor the tests have changed since"
else
  before=${#failed[@]}
  case $tier in long) try run asan-long asan ;; *) try run asan asan ;; esac
  [ ${#failed[@]} -gt $before ] || echo "$state" >"$passed"
fi

step "tests: programs of others"
case $tier in long) try friends --all ;; *) try friends ;; esac
[ "$tier" = long ] || exit 0

step "tests: long"
try run long

step "validation: the errors of restitution hold, as docs/developer/validation.md says"
configure release -DSTOSS_BUILD_VALIDATE=ON
cmake --build --preset release -j "$jobs" --target stoss_validate
# Its times are those of the machine.
without_times() { sed '/^## Convergence and time/,/^## Errors/d' "$1"; }
as_documented() {
  build/release/validate/stoss_validate --markdown=build/validation.md &&
    diff <(without_times docs/developer/validation.md) <(without_times build/validation.md)
}
try as_documented

step "coverage"
try scripts/coverage.sh "$jobs"

if [ ${#failed[@]} -gt 0 ]; then
  printf 'failed: %s\n' "${failed[@]}" >&2
  exit 1
fi
