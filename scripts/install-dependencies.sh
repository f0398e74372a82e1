#!/usr/bin/env bash
# Installs the Debian packages that stoss needs and that are missing, as root or through sudo: those of the groups that
# are named, or all that a developer uses; STOSS_LIST=1 prints their names instead. Groups:
#   build                                          library and command (in every group)
#   python                                         also the Python package
#   test                                           also what `make test` needs
#   engines, particles, elements, cluster, page    programs of others, for tests/friends/groups.toml
#   long                                           for `make test-long`: all of them, Yade, compilers for other systems
#   modal, deb                                     `python -m stoss.modal`; `make deb`
# Where that is not possible it names what is missing and stops with an error.
set -euo pipefail

packages=(
  g++ cmake ninja-build make git libeigen3-dev libboost-dev librandom123-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev
)
# Debian's packages of Node.js and npm do not go together with those of others, which may be there already.
node=()
if ! command -v npm >/dev/null || [ "$(node -p 'parseInt(process.versions.node) >= 18' 2>/dev/null)" != true ]; then
  node=(nodejs npm)
fi

add() {
  case $1 in
  build) ;;
  python)
    packages+=(
      python3-dev pybind11-dev python3-numpy python3-matplotlib
      python3-venv python3-pip python3-setuptools python3-wheel
    ) ;;
  test)
    add python
    packages+=(
      libgtest-dev libgmock-dev pkgconf strace python3-pytest python3-jsonschema python3-hypothesis python3-tqdm mypy
      gfortran python3-scipy python3-numba python3-netcdf4 python3-xarray
      clang libclang-rt-dev clang-format lld chromium "${node[@]}"
    ) ;;
  engines) packages+=(chipmunk-dev libbox2d-dev libbullet-dev libode-dev "${node[@]}") ;;
  particles) packages+=(lammps liggghts libmujoco-dev libsimbody-dev python3-scipy) ;;
  modal)
    add python
    packages+=(
      python3-dolfinx-real python3-petsc4py-real python3-slepc4py-real python3-mpi4py openmpi-bin
      python3-gmsh python3-scipy
    ) ;;
  elements) add modal && packages+=(calculix-ccx) ;;
  cluster) packages+=(python3-mpi4py openmpi-bin python3-distributed python3-netcdf4) ;;
  page) packages+=(emscripten chromium "${node[@]}") ;;
  develop)  # benchmarks, static analysis, the documentation site
    packages+=(
      libbenchmark-dev clang-tidy
      doxygen python3-sphinx furo python3-myst-parser python3-breathe python3-sphinx-copybutton libjs-katex
    ) ;;
  deb) add python && packages+=(build-essential debhelper dh-python dpkg-dev lintian sphinx-common) ;;
  long)
    for each in test engines particles elements cluster page develop deb; do add $each; done
    # A fresh Debian, in which the packages are installed and tested; other systems (scripts/systems.sh).
    packages+=(yade autopkgtest debootstrap libc++-14-dev libc++abi-14-dev)
    packages+=(g++-i686-linux-gnu g++-s390x-linux-gnu g++-mingw-w64-x86-64-posix qemu-user) ;;
  *)
    echo "install-dependencies: group: got $1, allowed those that the head of this file lists" >&2
    exit 2 ;;
  esac
}
[ $# -gt 0 ] || set -- test page develop
for group in "$@"; do add "$group"; done
if [ -n "${STOSS_LIST:-}" ]; then
  printf '%s\n' "${packages[@]}"
  exit
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
