#!/usr/bin/env bash
# Builds what has changed in the preset dev and runs the tests of a file's room: of the folder in tests/ that has its path,
# or of the next one above.
#   try.sh [--name] FILE [JOBS]    of src/, include/stoss/ or tests/; --name: only says what it would run
set -euo pipefail
only_name=
if [ "$1" = --name ]; then only_name=1 && shift; fi
file=${1#"$PWD"/}
jobs=${2:-2}
case $file in
  src/* | tests/*) room=${file#*/} ;;
  include/stoss/*) room=${file#include/stoss/} ;;
  *) room= ;;
esac
[ -n "$room" ] && [ -e "$file" ] ||
  { echo "try: FILE: got '$file', allowed a file of src/, include/stoss/ or tests/ (make try FILE=src/contact/contact.cpp)" >&2; exit 2; }
case $room in body/*) room=bodies/x ;; esac  # which all bodies share
while room=$(dirname "$room"); ! compgen -G "tests/$room/test_*.cpp" >/dev/null; do :; done
name=try_$(echo "${room#.}" | tr -c '[:alnum:]\n' _)
[ -z "$only_name" ] || { echo "$name"; exit; }
tree=build/dev
mkdir -p $tree
[ -f $tree/build.ninja ] || cmake --preset dev >$tree/configure.log 2>&1 || { cat $tree/configure.log; exit 1; }
cmake --build --preset dev -j "$jobs" --target "$name"
ctest --preset dev -R "^$name[.][0-9]+$" -j "$jobs"
