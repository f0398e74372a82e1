"""Builds stoss._core with CMake, in the folder that the Makefile uses too; the rest is in pyproject.toml."""

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).parent.resolve()
BUILD = ROOT / "build" / "release"


class BuildWithCMake(build_ext):
    def build_extension(self, ext: Extension) -> None:
        # In a virtual environment sys.executable is a link; the module belongs to the interpreter behind it.
        python = os.path.realpath(sys.executable)
        print(f"stoss: the Python module is built for {python} (Python {sys.version.split()[0]})", flush=True)
        cmake = ["cmake", "--preset", "release", "-DSTOSS_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={python}"]
        subprocess.run(cmake, cwd=ROOT, check=True)
        build = ["cmake", "--build", str(BUILD), "--target", "stoss_python", "--parallel", str(os.cpu_count() or 1)]
        subprocess.run(build, check=True)
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent.parent
        install = ["cmake", "--install", str(BUILD), "--component", "python", "--prefix", str(package)]
        subprocess.run(install, check=True)


version = re.search(r"project\(stoss VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))
assert version, "CMakeLists.txt names no version"
setup(
    version=version.group(1),
    ext_modules=[Extension("stoss._core", sources=[])],
    cmdclass={"build_ext": BuildWithCMake},
)
