#!/usr/bin/env bash
# Builds the npm package of the core into build/npm, compiled to WebAssembly with Emscripten, and packs it into
# build/dist unless told not to. Exit code 77: what that needs is not there.
#   npm.sh [JOBS [pack|build]]
set -euo pipefail
jobs=${1:-2}
what=${2:-pack}
lack() { echo "npm: $1 is missing (make setup installs what it takes)" >&2; exit 77; }
command -v emcmake >/dev/null || lack "Emscripten (emcmake)"
command -v npm >/dev/null || lack "npm"
[ "$(node -p 'parseInt(process.versions.node) >= 18' 2>/dev/null)" = true ] || lack "Node.js 18 or newer"

# Debian's Emscripten looks for its modules of Node.js there, and for the Python that it was made for.
export NODE_PATH=${NODE_PATH:-/usr/share/nodejs} EMSDK_PYTHON=${EMSDK_PYTHON:-/usr/bin/python3}
wasm=build/wasm
mkdir -p "$wasm"
{ emcmake cmake -G Ninja -S web/core -B "$wasm" -DCMAKE_BUILD_TYPE=Release -DSTOSS_WERROR=ON &&
  cmake --build "$wasm" -j "$jobs" --target stoss_web; } >"$wasm/log" 2>&1 || { cat "$wasm/log" >&2; exit 1; }

(cd web
 node plugins/kinds.mjs  # what the core knows of bodies, for types and texts
 if ! cmp -s package-lock.json node_modules/.installed; then
   npm ci --no-progress >"../$wasm/npm.log" 2>&1 || { cat "../$wasm/npm.log" >&2; exit 1; }
   cp package-lock.json node_modules/.installed
 fi
 rm -rf ../build/npm
 npx tsc -p package)
cp "$wasm/stoss.mjs" "$wasm/stoss.wasm" web/package/README.md LICENSE build/npm/
# The version is that of CMakeLists.txt.
version=$(sed -n 's/^project(stoss VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
node -e '
  const { readFileSync, writeFileSync } = require("node:fs");
  const { name, ...rest } = JSON.parse(readFileSync("web/package/package.json", "utf8"));
  writeFileSync("build/npm/package.json", JSON.stringify({ name, version: process.argv[1], ...rest }, null, 2) + "\n");
' "$version"
# For who imports it as any other package: the page.
ln -sfn ../../build/npm web/node_modules/stoss

[ "$what" = pack ] || exit 0
mkdir -p build/dist
rm -f build/dist/*.tgz
(cd build/npm && npm pack --silent --pack-destination ../dist >/dev/null)
ls -l build/dist/*.tgz
