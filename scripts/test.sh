#!/usr/bin/env bash
# Everything that must hold at every commit. Nothing is built twice; what did not change is not built again.
set -euo pipefail
jobs=${1:-2}

step() { printf '\n== %s\n' "$*"; }

step "format"
git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror

build() {
  mkdir -p "build/$1"
  cmake --preset "$1" >"build/$1/configure.log" 2>&1 || { cat "build/$1/configure.log"; exit 1; }
  cmake --build --preset "$1" -j "$jobs"
}

step "build: g++, warnings are errors"
build release
step "build: clang++"
build clang
step "build: AddressSanitizer and UndefinedBehaviorSanitizer"
build asan

step "tests"
ctest --preset release -j "$jobs"
step "tests under sanitizers"
ctest --preset asan -j "$jobs"
