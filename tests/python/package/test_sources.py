"""Files import each other in one direction only, for types too: results know nothing of pictures. `pip install .` needs no
more than it names, and builds with what is there."""

import ast
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import stoss

PACKAGE = Path(stoss.__file__).parent
STUDIES = Path(__file__).parents[3] / "studies"


def imported(path, package):
    """Names of the modules that a file imports, at any place of it."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (each.name for each in node.names)
        if isinstance(node, ast.ImportFrom):
            above = package[: len(package) + 1 - node.level] if node.level else []
            module = ".".join([*above, *filter(None, [node.module])])
            yield from (module, *(f"{module}.{each.name}" for each in node.names))


@pytest.mark.parametrize("root, name, some", [(PACKAGE, "stoss", 80), (STUDIES, "", 30)])
def test_no_circles(root, name, some):
    paths = [path for path in root.rglob("*.py") if path.name != "__main__.py"]
    parts = {path: [*filter(None, [name]), *path.relative_to(root).with_suffix("").parts] for path in paths}
    files = {".".join(own).removesuffix(".__init__"): path for path, own in parts.items()}
    needs = {each: {*imported(path, parts[path][:-1])} & {*files} - {each, name} for each, path in files.items()}
    # The packages themselves collect their modules, which do not need what they collect.
    needs = {each: own - {"stoss.plot"} if each.startswith("stoss.plot.") else own for each, own in needs.items()}
    assert len(needs) > some
    while free := [each for each, own in needs.items() if not own]:
        needs = {each: own - {*free} for each, own in needs.items() if each not in free}
    assert not needs


ROOT = Path(__file__).parents[3]

# Configures as CMake does, but neither builds nor installs.
CONFIGURE_ONLY = """#!/bin/sh
case "$1" in --build | --install) exit 0 ;; esac
exec {cmake} "$@"
"""


def configured(folder, *missing, **variables):
    """The cache of the tree that setup.py configures where all is installed but these tools."""
    cmake = shutil.which("cmake")
    assert cmake
    binaries = folder / "bin"
    binaries.mkdir()
    (binaries / "cmake").write_text(CONFIGURE_ONLY.format(cmake=cmake))
    (binaries / "cmake").chmod(0o755)
    for tool in Path("/usr/bin").iterdir():
        if tool.name not in ("cmake", *missing):
            (binaries / tool.name).symlink_to(tool)
    build = [sys.executable, "setup.py", "build_ext"]
    build += ["--build-temp", folder / "temp", "--build-lib", folder / "lib"]
    environment = {"PATH": str(binaries), "HOME": str(folder), **variables}
    process = subprocess.run(build, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=300)
    assert process.returncode == 0, process.stdout + process.stderr
    (cache,) = folder.glob("temp/**/CMakeCache.txt")
    lines = cache.read_text().splitlines()
    return {line.partition(":")[0]: line.partition("=")[2] for line in lines if "=" in line}


@pytest.mark.parametrize("missing, generator", [("make", "Ninja"), ("ninja", "Unix Makefiles")])
def test_build_takes_the_tool_that_is_there(tmp_path, missing, generator):
    cache = configured(tmp_path, missing)
    assert cache["CMAKE_GENERATOR"] == generator
    # The settings of a user, not those of the presets.
    assert (cache["CMAKE_BUILD_TYPE"], cache["STOSS_WERROR"]) == ("Release", "OFF")
    parts = {name: cache[f"STOSS_BUILD_{name}"] for name in ("CLI", "PYTHON", "TESTS")}
    assert parts == {"CLI": "OFF", "PYTHON": "ON", "TESTS": "OFF"}
    assert os.path.realpath(cache["Python_EXECUTABLE"]) == os.path.realpath(sys.executable)


def test_generator_of_the_user_counts(tmp_path):
    cache = configured(tmp_path, CMAKE_GENERATOR="Unix Makefiles")
    assert cache["CMAKE_GENERATOR"] == "Unix Makefiles"


def test_build_names_what_it_imports():
    tomllib = pytest.importorskip("tomllib")
    build = tomllib.loads((ROOT / "pyproject.toml").read_text())["build-system"]
    names = {requirement.partition(">=")[0] for requirement in build["requires"]}
    # setuptools makes a wheel with `wheel`, unless it is newer than 70.
    assert names == {"setuptools", "wheel", "pybind11", "numpy"}
