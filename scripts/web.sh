#!/usr/bin/env bash
# Builds the page into build/web: the core as WebAssembly with Emscripten, the rest with Vite. Exit code 77: what that
# needs is not there.
set -euo pipefail
jobs=${1:-2}
lack() { echo "web: $1 is missing (make setup installs what it takes)" >&2; exit 77; }
command -v emcmake >/dev/null || lack "Emscripten (emcmake)"
command -v npm >/dev/null || lack "npm"
[ "$(node -p 'parseInt(process.versions.node) >= 18' 2>/dev/null)" = true ] || lack "Node.js 18 or newer"

# Debian's Emscripten looks for its modules of Node.js there, and for the Python that it was made for.
export NODE_PATH=${NODE_PATH:-/usr/share/nodejs} EMSDK_PYTHON=${EMSDK_PYTHON:-/usr/bin/python3}
wasm=build/wasm
mkdir -p "$wasm"
{ emcmake cmake -G Ninja -S web/core -B "$wasm" -DCMAKE_BUILD_TYPE=Release -DSTOSS_WERROR=ON &&
  cmake --build "$wasm" -j "$jobs" --target stoss_web; } >"$wasm/log" 2>&1 || { cat "$wasm/log" >&2; exit 1; }

cd web
node plugins/kinds.mjs  # the core's table of kinds, for the types of the page
if ! cmp -s package-lock.json node_modules/.installed; then
  npm ci --no-progress >"../$wasm/npm.log" 2>&1 || { cat "../$wasm/npm.log" >&2; exit 1; }
  cp package-lock.json node_modules/.installed
fi
npx vite build --logLevel warn
