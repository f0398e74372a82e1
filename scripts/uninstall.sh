#!/usr/bin/env bash
# Removes from a prefix the files that scripts/install.sh has put there, and stoss's own folders where nothing is left.
set -euo pipefail
prefix=${DESTDIR:-}$(realpath -m "$1")
list=$prefix/share/stoss/installed
if [ ! -f "$list" ]; then
  echo "uninstall: got $prefix, allowed a PREFIX that \`make install\` has filled: there is no $list" >&2
  exit 1
fi
cd "$prefix"
mapfile -t files <"$list"
mapfile -t folders < <(sed -nE 's|^((.*/)?stoss)/.*|\1|p' "$list" | sort -u)
rm -f -- "${files[@]}" "$list"
find "${folders[@]}" share/stoss -type d -empty -delete
echo "uninstall: removed ${#files[@]} files from $prefix"
