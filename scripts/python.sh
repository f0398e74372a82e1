#!/usr/bin/env bash
# Builds the Python module in build/release and installs the package into the virtual environment build/venv, which
# sees the system's packages. Another interpreter than Debian's: PYTHON=/path/to/python3 make python. It must have pip,
# setuptools, wheel, pybind11 and numpy.
set -euo pipefail
python=${PYTHON:-/usr/bin/python3}
venv=build/venv
[ -x "$python" ] || { echo "python: got $python, allowed a Python 3.10 or newer (set PYTHON)" >&2; exit 1; }
echo "Python: $python ($("$python" --version 2>&1))"
# An environment of another interpreter is made anew.
if [ "$(readlink -f "$venv/bin/python" 2>/dev/null)" != "$(readlink -f "$python")" ]; then
  rm -rf "$venv"
  "$python" -m venv --system-site-packages "$venv"
fi
rm -rf build/lib.* build/bdist.*  # what an earlier package left there
module() {
  cmake --preset release -DSTOSS_BUILD_PYTHON=ON "-DPython_EXECUTABLE=$python" &&
    cmake --build --preset release --target stoss_python
}
module >build/python.log 2>&1 || { cat build/python.log >&2; exit 1; }
if ! STOSS_BUILD_TREE=build/release "$venv/bin/python" -m pip install --quiet \
    --no-build-isolation --no-deps --no-index --force-reinstall \
    --disable-pip-version-check --root-user-action=ignore . >build/python.log 2>&1; then
  cat build/python.log >&2
  exit 1
fi
cd build # so that what is imported is what was installed
venv/bin/python -c 'import stoss; print("installed: stoss", stoss.__version__, "in", stoss.__path__[0])'
