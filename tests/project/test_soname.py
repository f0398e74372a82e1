"""The number of the shared library is one in all that packages it."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
NUMBER = re.search(r"^set\(STOSS_SOVERSION (\d+)\)$", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)[1]
FILES = [path for path in ROOT.glob("debian/**/*") if path.is_file() and path.name not in ("changelog", "copyright")]


@pytest.mark.parametrize("file", [*FILES, ROOT / "tests/packaging/test_debian.py"], ids=lambda file: file.name)
def test_a_file_of_packages_has_the_number_of_the_library(file):
    named = re.findall(r"libstoss(?:\\?\.so\\?\.)?(\d+)", f"{file.name}\n{file.read_text(encoding='utf-8')}")
    assert set(named) <= {NUMBER}
