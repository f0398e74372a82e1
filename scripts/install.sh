#!/usr/bin/env bash
# Installs build/release, or another build tree, into a prefix, and lists there what scripts/uninstall.sh removes.
set -euo pipefail
prefix=$(realpath -m "$1")
tree=${2:-build/release}
cmake --install "$tree" --prefix "$prefix"
list=${DESTDIR:-}$prefix/share/stoss/installed
mkdir -p "${list%/*}"
# What an earlier version has put there stays on the list.
{ cat "$list" 2>/dev/null || true; sed "s|^$prefix/||" "$tree/install_manifest.txt"; echo; } |
  grep . | sort -u >"$list.new"
mv "$list.new" "$list"
