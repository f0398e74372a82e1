#!/usr/bin/env bash
# Builds the page into build/web: the package of the core (scripts/npm.sh), the rest with Vite; or, native, into
# build/native/web for tests. Exit code 77: what that needs is not there.
#   web.sh [JOBS [build|native]]
set -euo pipefail
what=${2:-build}
scripts/npm.sh "${1:-2}" "$what"
out=build/web
[ "$what" = build ] || out=build/native/web
web/build.sh $out
