#!/usr/bin/env bash
# Programs of users in C and other languages, against the installed library.
#   run.sh TOPIC BUILD_TREE SCRATCH, after run.sh install BUILD_TREE SCRATCH
# CXX and CXXFLAGS are those of the library.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
topic=$1 tree=$2 prefix=$3/prefix
out=$3/$topic

fail() { echo "c_interface.$topic: $*" >&2; exit 1; }
skip() { echo "c_interface.$topic: skipped, $*"; exit 77; }
needed() { command -v "$1" >/dev/null || skip "no $1"; }

if [ "$topic" = install ]; then
  rm -rf "$3"
  cmake --install "$tree" --prefix "$3/first" >/dev/null
  mv "$3/first" "$prefix"  # an installed tree can be moved
  exit
fi

rm -rf "$out" && mkdir -p "$out"
libraries=$(dirname "$(find "$prefix" -name stoss.pc)")
export PKG_CONFIG_LIBDIR=$libraries LD_LIBRARY_PATH=$libraries/..
unset PKG_CONFIG_PATH
# Sanitizers of the library are needed by the programs too.
sanitizers=() strict=(-std=c89 -pedantic -Wall -Wextra -Werror)
for flag in ${CXXFLAGS:-}; do
  case $flag in -fsanitize=* | -fno-sanitize*) sanitizers+=("$flag") ;; esac
done
sanitized() { [ ${#sanitizers[@]} -gt 0 ]; }
if sanitized && [[ $CXX == *clang* ]]; then sanitizers+=(-fsanitize-link-c++-runtime); fi  # for programs in C too

case $topic in
gcc | clang)
  needed "$topic"
  needed pkg-config
  if sanitized && [[ $CXX != *$topic* ]]; then skip "the sanitizers are those of $CXX"; fi
  read -ra flags <<<"$(pkg-config --cflags --libs stoss)"
  read -ra static <<<"$(pkg-config --static --cflags --libs stoss)"
  "$topic" "${strict[@]}" "${sanitizers[@]}" "$here/main.c" "${flags[@]}" -lm -o "$out/main"
  "$out/main"
  "$topic" "${strict[@]}" "${sanitizers[@]}" "$here/main.c" "${static[@]}" -lm -o "$out/by_static"
  ;;
header)  # the header alone, in C++ of any age and in C after C89
  read -ra flags <<<"$(pkg-config --cflags stoss)"
  printf '#include <stoss/stoss.h>\n#include <stoss/stoss.h>\nint main() { return stoss_version() == 0; }\n' >"$out/main.cpp"
  for standard in c++98 c++11 c++20; do
    "$CXX" "-std=$standard" "${strict[@]:1}" -fsyntax-only "${flags[@]}" "$out/main.cpp"
  done
  "$CXX" -std=c++20 "${sanitizers[@]}" "$out/main.cpp" "${flags[@]}" $(pkg-config --libs stoss) -o "$out/main"
  "$out/main"
  ;;
page)  # the program of docs/reference/c.md says what it says that it says
  needed cc
  sanitized && skip "the same as without sanitizers"
  sed -n '/^```c$/,/^```$/p' "$here/../../docs/reference/c.md" | sed '/^```/d' >"$out/main.c"
  cc "${strict[@]}" "$out/main.c" $(pkg-config --cflags --libs stoss) -o "$out/main"
  got=$("$out/main")
  said=$(sed -n 's|.*/\* \(0\.[0-9]* +- [0-9.]*\) \*/$|\1|p' "$out/main.c")
  [ -n "$said" ] && awk -v got="$got" -v said="$said" 'BEGIN { split(got, g, " "); split(said, s, " ");
    d = g[1] - s[1]; exit !(g[2] == "+-" && d * d <= g[3] * g[3]) }' || fail "got '$got', the page says '$said'"
  ;;
table)  # the header of a table and the library, in one program
  needed gcc
  sanitized && skip "the same as without sanitizers"
  [ -x "$prefix/bin/stoss" ] || skip "no command"
  "$prefix/bin/stoss" table --body disk --poisson 0.33 --speed 0.01:0.2 --format c -o "$out/restitution.h"
  gcc "${strict[@]}" -I "$out" "$here/table.c" $(pkg-config --cflags --libs stoss) -lm -o "$out/main"
  "$out/main"
  ;;
fortran)
  needed gfortran
  sanitized && skip "gfortran links no sanitizers of $CXX"
  read -ra libs <<<"$(pkg-config --libs stoss)"
  gfortran -std=f2008 -Wall -Wextra -Wno-c-binding-type -Wno-compare-reals -Werror -J "$out" "$prefix/include/stoss/stoss.f90" \
    "$here/main.f90" "${libs[@]}" -o "$out/main"
  "$out/main"
  ;;
shared)  # what loads libraries at run time: Python's ctypes, as Julia's ccall
  sanitized && skip "a library with sanitizers cannot be loaded at run time"
  needed python3
  library=$(find "$prefix" -name 'libstoss.so' | head -n 1)
  if [ -z "$library" ]; then
    library=$out/libstoss.so
    "$CXX" -shared -Wl,--whole-archive "$(find "$prefix" -name libstoss.a)" -Wl,--no-whole-archive -pthread -o "$library"
  fi
  python3 "$here/main.py" "$library" "$prefix/include/stoss/stoss.h"
  ;;
cmake)  # a project in C that finds the package
  sanitized && skip "the same as without sanitizers"
  needed cc
  cmake -S "$here/project" -B "$out" "-DCMAKE_PREFIX_PATH=$prefix" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF >/dev/null
  cmake --build "$out" >/dev/null
  "$out/main"
  ;;
*) fail "no such topic" ;;
esac
