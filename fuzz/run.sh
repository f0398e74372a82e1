#!/usr/bin/env bash
# Runs a fuzzer over its corpus and on: a fixed number of runs, always the same, or for some time, after which what
# covers more is in the corpus. It ends at what it finds, which then is in build/fuzz.
#   run.sh test PROGRAM | run.sh long PROGRAM [SECONDS]
set -euo pipefail
what=$1
program=$(realpath "$2")
name=$(basename "$program")
name=${name#stoss_fuzz_}
cd "$(dirname "$0")/.."
corpus=fuzz/corpus/$name
mkdir -p build/fuzz
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/new" "$scratch/least"
export TMPDIR=$scratch
# At most a minute and 1 GB for what is at most 4 KB; 128 MB at once are too much.
limits=(-timeout=60 -rss_limit_mb=1024 -malloc_limit_mb=128 -max_len=4096 -artifact_prefix="build/fuzz/$name-")
words=()
[ ! -f "fuzz/$name.dict" ] || words=(-dict="fuzz/$name.dict")
# Those of the command make all its options, or a file, anew each time.
runs=20000
case $name in arguments | resume) runs=2000 ;; esac
case $what in
  test)
    "$program" "${limits[@]}" "${words[@]}" -seed=1 -runs=$runs -verbosity=0 "$scratch/new" "$corpus" ;;
  long)
    "$program" "${limits[@]}" "${words[@]}" -max_total_time="${3:-600}" -print_final_stats=1 "$scratch/new" "$corpus"
    # Few files with all that is reached, however often.
    "$program" "${limits[@]}" -set_cover_merge=1 -use_counters=0 "$scratch/least" "$corpus" "$scratch/new"
    rm -rf "$corpus"
    mv "$scratch/least" "$corpus" ;;
esac
