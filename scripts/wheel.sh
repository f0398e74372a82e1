#!/usr/bin/env bash
# Builds the Python package for other machines into build/dist: its sources (sdist), and of these alone, without
# network, a wheel, which is checked and named by the systems that it runs on (scripts/check_wheel.py).
# Another interpreter than Debian's: PYTHON=/path/to/python3, as scripts/python.sh has it.
set -euo pipefail
python=${PYTHON:-/usr/bin/python3}
dist=build/dist
[ -x "$python" ] || { echo "wheel: got $python, allowed a Python 3.10 or newer (set PYTHON)" >&2; exit 1; }

# Runs a step, and shows what it said if it fails.
quietly() { "$@" >build/wheel.log 2>&1 || { cat build/wheel.log >&2; exit 1; }; }

mkdir -p "$dist"
rm -rf "$dist"/*.whl "$dist"/*.tar.gz build/wheel
rm -rf python/stoss.egg-info  # setuptools would add the files of its old list
quietly "$python" -c "from setuptools import build_meta; build_meta.build_sdist('$dist')"
quietly "$python" -m pip wheel --no-build-isolation --no-index --no-deps --disable-pip-version-check \
  --wheel-dir build/wheel "$dist"/stoss-*.tar.gz
"$python" scripts/check_wheel.py build/wheel/stoss-*.whl --into "$dist"
rm -rf build/wheel
(cd "$dist" && ls -l ./*.tar.gz ./*.whl)
