"""Builds stoss._core with CMake; the rest is in pyproject.toml.

The environment variable STOSS_BUILD_TREE names a CMake build tree to take the module from
(scripts/python.sh does so); without it the module is built from nothing.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).parent.resolve()


def cmake(*arguments: str) -> None:
    subprocess.run(["cmake", *arguments], check=True)


class BuildWithCMake(build_ext):
    def build_extension(self, ext: Extension) -> None:
        tree = os.environ.get("STOSS_BUILD_TREE") or self.configure()
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(len(os.sched_getaffinity(0)))
        print(f"stoss: compiling the library and the module, {jobs} files at a time", flush=True)
        cmake("--build", tree, "--target", "stoss_python", "--parallel", jobs)
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent.parent
        cmake("--install", tree, "--component", "python", "--prefix", str(package))
        if (package / "stoss/results").is_dir():  # the types of what the module and the core's tables have
            subprocess.run([sys.executable, str(ROOT / "python/stubs.py"), "."], cwd=package, check=True)

    def configure(self) -> str:
        """A tree of its own; with Ninja where that is installed, else with what CMake takes by default (make)."""
        if not shutil.which("cmake"):
            raise SystemExit("stoss: cmake is missing (docs/developer/dependencies.md has all that the build needs)")
        # In a virtual environment sys.executable is a link; the module belongs to the interpreter behind it.
        python = os.path.realpath(sys.executable)
        print(f"stoss: the Python module is built for {python} (Python {sys.version.split()[0]})", flush=True)
        ninja = shutil.which("ninja") and "CMAKE_GENERATOR" not in os.environ
        tree = os.path.abspath(os.path.join(self.build_temp, "ninja" if ninja else "cmake"))
        options = {"BUILD_SHARED_LIBS": "OFF", "CMAKE_BUILD_TYPE": "Release", "Python_EXECUTABLE": python}
        options |= {"STOSS_BUILD_CLI": "OFF", "STOSS_BUILD_PYTHON": "ON", "STOSS_WERROR": "OFF"}
        options |= {"CMAKE_UNITY_BUILD": "ON"}  # half the time
        try:  # the one that pip has installed for this build
            import pybind11

            options["pybind11_DIR"] = pybind11.get_cmake_dir()
        except ImportError:
            pass  # CMake looks for the system's
        generator = ["-G", "Ninja"] if ninja else []
        cmake("-S", str(ROOT), "-B", tree, *generator, *(f"-D{name}={value}" for name, value in options.items()))
        return tree


version = re.search(r"project\(stoss VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))
assert version, "CMakeLists.txt names no version"
setup(
    version=version.group(1),
    ext_modules=[Extension("stoss._core", sources=[])],
    cmdclass={"build_ext": BuildWithCMake},
)
