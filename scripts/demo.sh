#!/usr/bin/env bash
# The main job: restitution against speed for two Poisson's ratios, as tables here, and as CSV and picture in out/; and a
# collision in motion.
set -euo pipefail
stoss=$1
python=$2
mkdir -p out
speeds=log:0.005:0.3:24
for poisson in 0.33 0.9; do
  file=out/restitution_poisson_$poisson.csv
  echo
  echo "Restitution of an elastic disk against a hard wall, Poisson's ratio $poisson (speeds in c, times in R/c)"
  echo
  "$stoss" restitution --body disk --poisson "$poisson" --speed "$speeds"
  "$stoss" restitution --body disk --poisson "$poisson" --speed "$speeds" --format csv -o "$file"
  echo
  echo "Written with all digits to $file"
done

echo
MPLBACKEND=Agg "$python" scripts/demo.py out
