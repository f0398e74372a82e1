#!/usr/bin/env bash
# Builds the page into build/web: the package of the core (scripts/npm.sh), the rest with Vite. Exit code 77: what that
# needs is not there.
set -euo pipefail
scripts/npm.sh "${1:-2}" build
cd web
npx vite build --logLevel warn
