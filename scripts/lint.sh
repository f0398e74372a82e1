#!/usr/bin/env bash
# Lints Python with ruff (rules: pyproject.toml) and the page with Biome (web/biome.jsonc): all tracked files, or those
# named. Exit code 77: the packages of web/ are not installed (make web).
#   lint.sh [FILE …]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
modules=$root/web/node_modules
[ -x "$modules/.bin/biome" ] && [ -d "$modules/@astral-sh/ruff-wasm-nodejs" ] ||
  { echo "lint: skipped: ruff and Biome are not installed (make web)"; exit 77; }

python=() page=()
for file in "$@"; do
  file=$(realpath "$file")
  case $file in *.py) python+=("$file") ;; *) page+=("$file") ;; esac
done
if [ $# = 0 ]; then
  mapfile -t python < <(cd "$root" && git ls-files '*.py')
  page=(.)
fi

status=0
if [ ${#python[@]} -gt 0 ]; then
  cd "$root"
  settings=$(/usr/bin/python3 -c '
import json, tomllib
print(json.dumps(tomllib.load(open("pyproject.toml", "rb"))["tool"]["ruff"]))')
  node scripts/ruff.mjs "$settings" "${python[@]}" || status=1
fi
if [ ${#page[@]} -gt 0 ]; then
  cd "$root/web"
  node_modules/.bin/biome lint --config-path=. --error-on-warnings --max-diagnostics=none "${page[@]}" || status=1
fi
exit $status
