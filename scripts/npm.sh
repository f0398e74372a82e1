#!/usr/bin/env bash
# Builds the npm package of the core into build/npm, compiled to WebAssembly with Emscripten, and packs it into
# build/dist unless told not to; or, native, for tests without Emscripten into build/native/npm, where the core that is
# compiled for this machine answers (tests/page_core). Exit code 77: what that needs is not there.
#   npm.sh [JOBS [pack|build|native]]
set -euo pipefail
jobs=${1:-2}
what=${2:-pack}
lack() { echo "npm: $1 is missing (make setup installs what it takes)" >&2; exit 77; }
command -v npm >/dev/null || lack "npm"
[ "$(node -p 'parseInt(process.versions.node) >= 18' 2>/dev/null)" = true ] || lack "Node.js 18 or newer"

if [ "$what" = native ]; then
  core=build/native/core npm=build/native/npm
  mkdir -p $core
  cp tests/page_core/stoss.mjs $core
  printf '\0asm\1\0\0\0' | tee $core/{first,page}.wasm >$core/stoss.wasm  # empty modules
else
  core=build/wasm npm=build/npm
  mkdir -p $core
  command -v emcmake >/dev/null || lack "Emscripten (emcmake)"
  # Debian's Emscripten looks for its modules of Node.js there, and for the Python that it was made for.
  export NODE_PATH=${NODE_PATH:-/usr/share/nodejs} EMSDK_PYTHON=${EMSDK_PYTHON:-/usr/bin/python3}
  { emcmake cmake -G Ninja -S web/core -B $core -DCMAKE_BUILD_TYPE=Release -DSTOSS_WERROR=ON &&
    cmake --build $core -j "$jobs" --target stoss_web stoss_page stoss_first; } >$core/log 2>&1 || { cat $core/log >&2; exit 1; }
fi

(cd web
 if ! cmp -s package-lock.json node_modules/.installed; then
   npm ci --no-progress >"../$core/npm.log" 2>&1 || { cat "../$core/npm.log" >&2; exit 1; }
   cp package-lock.json node_modules/.installed
 fi
 node plugins/kinds.mjs ../$core  # what the core knows of bodies, for types and texts
 rm -rf ../$npm
 npx tsc -p package --outDir ../$npm)
cp "$core/stoss.mjs" "$core"/{first,page,stoss}.wasm web/package/README.md LICENSE $npm/
# The version is that of CMakeLists.txt.
version=$(sed -n 's/^project(stoss VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
node -e '
  const { readFileSync, writeFileSync } = require("node:fs");
  const { name, ...rest } = JSON.parse(readFileSync("web/package/package.json", "utf8"));
  writeFileSync(process.argv[2], JSON.stringify({ name, version: process.argv[1], ...rest }, null, 2) + "\n");
' "$version" $npm/package.json
# For who imports it as any other package: the page.
ln -sfn ../../$npm web/node_modules/stoss

[ "$what" = pack ] || exit 0
mkdir -p build/dist
rm -f build/dist/*.tgz
(cd build/npm && npm pack --silent --pack-destination ../dist >/dev/null)
ls -l build/dist/*.tgz
