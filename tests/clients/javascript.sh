#!/usr/bin/env bash
# A client in JavaScript. Engines are installed by its lock file, and it is skipped where the registry cannot be reached.
#   javascript.sh EXAMPLES SCRATCH CLIENT TABLE    the table is a module that clients import
set -euo pipefail
skip() { echo "skipped: $*"; exit 77; }
for program in node npm flock; do command -v "$program" >/dev/null || skip "no $program"; done

mkdir -p "$2/$3"
cp "$1"/*.js "$4" "$2/$3"
cd "$2"
exec 9>lock
flock 9  # clients run side by side, and one installs for all
if ! cmp -s "$1/package-lock.json" node_modules/installed-lock.json; then
  cp "$1"/package*.json .
  status=0
  timeout 200 npm ci --omit=peer --no-audit --no-fund --fetch-retries=1 >install.log 2>&1 || status=$?
  if [ $status = 124 ] || grep -Eq 'ENOTFOUND|ECONN|EAI_AGAIN|ETIMEDOUT|ENETUNREACH|EHOSTUNREACH' install.log; then
    skip "the registry of npm cannot be reached"
  fi
  [ $status = 0 ] || { cat install.log >&2; exit 1; }
  cp package-lock.json node_modules/installed-lock.json
fi
flock -u 9
exec node "$3/$3.js"
