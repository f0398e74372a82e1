#!/usr/bin/env bash
# Builds the page, and the cradle beside it, into a folder, with options of Vite.
#   build.sh FOLDER [OPTION …]
set -euo pipefail
folder=$(realpath -m "$1")
cd "$(dirname "$0")"
npx vite build --logLevel warn --outDir "$folder" --emptyOutDir "${@:2}"
npx vite build --logLevel warn --outDir "$folder" --mode cradle "${@:2}"
