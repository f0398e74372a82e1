#!/usr/bin/env bash
# clang-tidy (.clang-tidy) over the library and the command as build/lint compiles them, a folder as one file: headers
# are read once a folder.
#   tidy.sh [JOBS]
set -euo pipefail
cd "$(dirname "$0")/.."
/usr/bin/python3 -c '
import json, re
of_ours = re.compile(r"/stoss(_options|_command|_documents)?\.dir/|^(src|cli)/")
for each in json.load(open("build/lint/compile_commands.json")):
    if of_ours.search(each["file"].removeprefix(each["directory"].removesuffix("build/lint"))):
        print(each["file"], end="\0")' |
  xargs -0 -P "${1:-2}" -n 1 clang-tidy --quiet -p build/lint
