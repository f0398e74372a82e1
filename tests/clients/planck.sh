#!/usr/bin/env bash
# The clients for planck, installed by its lock file. They are skipped where the registry cannot be reached.
#   planck.sh EXAMPLES SCRATCH TABLE RULE
set -euo pipefail
skip() { echo "skipped: $*"; exit 77; }
for program in node npm; do command -v "$program" >/dev/null || skip "no $program"; done

mkdir -p "$2"
cp "$1"/* "$2"
cd "$2"
if ! cmp -s package-lock.json node_modules/installed-lock.json; then
  status=0
  timeout 200 npm ci --omit=peer --no-audit --no-fund --fetch-retries=1 >install.log 2>&1 || status=$?
  if [ $status = 124 ] || grep -Eq 'ENOTFOUND|ECONN|EAI_AGAIN|ETIMEDOUT|ENETUNREACH|EHOSTUNREACH' install.log; then
    skip "the registry of npm cannot be reached"
  fi
  [ $status = 0 ] || { cat install.log >&2; exit 1; }
  cp package-lock.json node_modules/installed-lock.json
fi
node main.js "$3"
exec node spin.js "$4"
