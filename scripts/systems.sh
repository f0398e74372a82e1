#!/usr/bin/env bash
# Builds the library and the command for another system, and compares what they compute there with what they compute
# here, by the command in STOSS (default: that of build/release).
#   systems.sh [SYSTEM [JOBS]]
# SYSTEM is the name of a file of cmake/toolchains; without one it names them. Exit code 77: what that needs is not
# there.
set -euo pipefail
cd "$(dirname "$0")/.."
toolchains=cmake/toolchains
if [ $# = 0 ]; then
  basename -s .cmake -a $(ls $toolchains/*.cmake | grep -v headers.cmake)
  exit
fi
system=$1
jobs=${2:-1}
toolchain=$toolchains/$system.cmake
fail() { echo "systems: $system: $*" >&2; exit 1; }
skip() { echo "systems: $system: skipped, $* (scripts/install-dependencies.sh long)"; exit 77; }
[ "$system" != headers ] && [ -f "$toolchain" ] ||
  { echo "systems: got $system, allowed $("$0" | paste -sd' ')" >&2; exit 1; }
native=${STOSS:-build/release/cli/stoss}
[ -x "$native" ] || fail "no command of this machine to compare with: got $native (make build, or set STOSS)"

set_to() { sed -n "s/^set($1 \"\?\([^\")]*\)\"\?)$/\1/p" "$toolchain"; }
read -ra cxx <<<"$(set_to CMAKE_CXX_COMPILER) $(set_to CMAKE_CXX_FLAGS_INIT)"
read -ra c <<<"$(set_to CMAKE_C_COMPILER) $(set_to CMAKE_C_FLAGS_INIT)"
read -ra link <<<"$(set_to CMAKE_EXE_LINKER_FLAGS_INIT)"
command -v "${cxx[0]}" >/dev/null || skip "no ${cxx[0]}"
echo '#include <version>' | "${cxx[@]}" -std=c++20 -fsyntax-only -x c++ - 2>/dev/null ||
  skip "no C++ library for ${cxx[*]}"

# Optimised for the compiler's time: what is looked for here is not speed.
build=build/systems/$system
mkdir -p "$build"
build() {
  cmake --preset release -B "$build" --toolchain "$toolchain" "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG" &&
    cmake --build "$build" -j "$jobs" --target stoss stoss_command
}
build >"$build/log" 2>&1 || { cat "$build/log" >&2; exit 1; }

emulator=()
if grep -q STOSS_EMULATOR "$toolchain"; then
  emulator=("$(sed -n 's/^STOSS_EMULATOR:FILEPATH=//p' "$build/CMakeCache.txt")")
  if [ ! -x "${emulator[0]}" ]; then
    echo "systems: $system: built; not run, no $(sed -n 's/^find_program(STOSS_EMULATOR \(.*\))$/\1/p' "$toolchain")"
    exit 77
  fi
  export WINEPREFIX=$PWD/build/systems/wine WINEDEBUG=-all
fi

# A user's program in C, with documents of encounters among the rest.
"${c[@]}" -std=c89 -pedantic -Wall -Wextra -Werror -Iinclude -c tests/c_interface/main.c -o "$build/main.o"
"${cxx[@]}" "${link[@]}" "$build/main.o" "$build"/libstoss.a -pthread -o "$build/main.exe"
status=0
"${emulator[@]}" "$build/main.exe" 2>"$build/errors" || status=$?
if [ $status = 126 ]; then  # as of 32 bits, where the kernel is built without them
  echo "systems: $system: built; not run, this machine does not execute its programs"
  exit 77
fi
[ $status = 0 ] || { cat "$build/errors" >&2; exit $status; }

command=$build/cli/stoss
[ -e "$command" ] || command=$command.exe
python3 tests/systems/compare.py "$native" "${emulator[@]}" "$command"
