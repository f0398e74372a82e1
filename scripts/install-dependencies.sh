#!/usr/bin/env bash
# Installs the Debian packages that stoss needs and that are missing, as root or through sudo: all of them, or with the
# argument `build` only those for the library and the command, with `python` also those for the Python package, with
# `test` also those of `make test`; with `long` besides all of them Yade, a gigabyte, and compilers for other systems, for
# `make test-long`.
# With `modal` those of the package and of `python -m stoss.modal`; with `deb` those of `make deb`.
# Where that is not possible it names what is missing and stops with an error.
set -euo pipefail

what=${1:-all}
# Build and core; the command.
packages=(
  g++ cmake ninja-build make git libeigen3-dev libboost-dev librandom123-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev
)
# The Python package.
if [ "$what" != build ]; then
  packages+=(
    python3-dev pybind11-dev python3-numpy python3-matplotlib
    python3-venv python3-pip python3-setuptools python3-wheel
  )
fi
# Tests and checks; the page.
if [ "$what" = test ] || [ "$what" = all ] || [ "$what" = long ]; then
  packages+=(
    libgtest-dev libgmock-dev pkgconf strace python3-pytest python3-jsonschema python3-hypothesis python3-tqdm mypy
    gfortran chipmunk-dev libbox2d-dev libbullet-dev
    python3-scipy python3-numba lammps liggghts libmujoco-dev
    python3-netcdf4 python3-xarray python3-mpi4py openmpi-bin python3-distributed
    clang libclang-rt-dev clang-format
    emscripten chromium
  )
  # Debian's packages of Node.js and npm do not go together with those of others, which may be there already.
  if ! command -v npm >/dev/null || [ "$(node -p 'parseInt(process.versions.node) >= 18' 2>/dev/null)" != true ]; then
    packages+=(nodejs npm)
  fi
fi

# Benchmarks; static analysis; the documentation site.
if [ "$what" = all ] || [ "$what" = long ]; then
  packages+=(
    libbenchmark-dev clang-tidy
    doxygen python3-sphinx furo python3-myst-parser python3-breathe python3-sphinx-copybutton libjs-katex
  )
fi

[ "$what" != long ] || packages+=(yade)

# Debian packages; before a release they are installed and tested in a fresh Debian.
if [ "$what" = deb ] || [ "$what" = long ]; then
  packages+=(build-essential debhelper dh-python dpkg-dev lintian sphinx-common)
fi
[ "$what" != long ] || packages+=(autopkgtest debootstrap)

# Other systems (scripts/systems.sh).
if [ "$what" = long ]; then
  packages+=(libc++-14-dev libc++abi-14-dev)
  packages+=(g++-i686-linux-gnu g++-s390x-linux-gnu g++-mingw-w64-x86-64-posix qemu-user)
fi

# Body files from finite elements; CalculiX is their second source in tests.
if [ "$what" = modal ] || [ "$what" = test ] || [ "$what" = long ]; then
  packages+=(python3-dolfinx-real python3-petsc4py-real python3-slepc4py-real python3-mpi4py openmpi-bin)
  packages+=(python3-gmsh python3-scipy calculix-ccx)
fi

if ! command -v dpkg-query >/dev/null; then
  echo "install-dependencies: this is not a Debian system; please install the equivalents of: ${packages[*]}" >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "install-dependencies: missing: ${missing[*]} (not root, and no sudo to install them)" >&2
    exit 1
  fi
  as_root=(sudo)
fi
if ! command -v apt-get >/dev/null; then
  echo "install-dependencies: missing: ${missing[*]} (no apt-get to install them)" >&2
  exit 1
fi

echo "install-dependencies: installing ${missing[*]}"
if ! "${as_root[@]}" apt-get update -qq ||
  ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" \
    >/dev/null; then
  echo "install-dependencies: could not install all of: ${missing[*]}" >&2
  exit 1
fi
