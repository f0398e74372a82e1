#!/usr/bin/env bash
# What the installation puts into a prefix, its removal takes away, and nothing else.
#   install.sh BUILD_TREE SCRATCH
set -euo pipefail
scripts=$(realpath "$(dirname "$0")/../scripts")
tree=$1
rm -rf "$2"
mkdir -p "$2"
cd "$2"

fail() { echo "install: $*" >&2; exit 1; }

mkdir -p "my prefix/include/stoss" "my prefix/bin" "my prefix/share/doc"
echo mine | tee "my prefix/include/stoss/mine.hpp" >"my prefix/bin/mine"
find "my prefix" -type f | sort >before
"$scripts/install.sh" "my prefix" "$tree" >log
echo "bin/of-an-earlier-version" >>"my prefix/share/stoss/installed"
touch "my prefix/bin/of-an-earlier-version"
"$scripts/install.sh" "my prefix" "$tree" >log
"my prefix/bin/stoss" --version >log
[ -f "my prefix/include/stoss/impact.hpp" ] || fail "no headers"

"$scripts/uninstall.sh" "my prefix" >log
find "my prefix" -type f | sort | cmp - before || fail "not as before: $(find "my prefix" -type f)"
[ ! -e "my prefix/lib/cmake/stoss" ] && [ ! -e "my prefix/share/stoss" ] || fail "empty folders left"
[ -d "my prefix/share/doc" ] || fail "removed a folder that is not stoss's"
if "$scripts/uninstall.sh" "my prefix" 2>message; then fail "removed twice"; fi
[ "$(wc -l <message)" = 1 ] || fail "no message of one line: $(cat message)"

# Into the root of a package.
DESTDIR=$PWD/package "$scripts/install.sh" /usr "$tree" >log
[ -x package/usr/bin/stoss ] || fail "DESTDIR does not count"
DESTDIR=$PWD/package "$scripts/uninstall.sh" /usr >log
[ -z "$(find package -type f)" ] || fail "left in DESTDIR: $(find package -type f)"
