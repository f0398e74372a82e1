"""What is built for release has what cmake/hardening.cmake asks for."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

TREE = Path(os.environ["STOSS"]).resolve().parents[1]
BUILT = [Path(os.environ["STOSS"]), *sorted((TREE / "python" / "stoss").glob("_core*.so")), *sorted(TREE.glob("libstoss.so"))]


def cached(name):
    """A variable of the build tree; "" where the command is not in one."""
    cache = TREE / "CMakeCache.txt"
    found = re.search(rf"^{name}:[A-Z]+=(.*)$", cache.read_text() if cache.exists() else "", re.MULTILINE)
    return found[1] if found else ""


pytestmark = [
    pytest.mark.skipif(cached("CMAKE_BUILD_TYPE") != "Release", reason="not built for release"),
    pytest.mark.skipif(shutil.which("readelf") is None, reason="readelf is missing"),
]


def readelf(option, path):
    return subprocess.run(["readelf", option, path], capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize("path", BUILT, ids=lambda path: path.name)
def test_memory_is_not_data_and_code_at_once(path):
    segments = re.findall(r"^ +(\w+)(?: +0x\w+){5} ([R ][W ][E ])", readelf("-lW", path), re.MULTILINE)
    flags = dict(segments)
    assert flags["GNU_STACK"] == "RW "
    assert flags["GNU_RELRO"] == "R  "
    assert [each for name, each in segments if name == "LOAD"] and not any("WE" in each for _, each in segments)


@pytest.mark.parametrize("path", BUILT, ids=lambda path: path.name)
def test_functions_of_other_libraries_are_bound_before_anything_runs(path):
    dynamic = readelf("-dW", path)
    assert re.search(r"\(FLAGS\) +BIND_NOW", dynamic) or re.search(r"\(FLAGS_1\) .*\bNOW\b", dynamic)
    assert "TEXTREL" not in dynamic


def test_command_has_no_fixed_address():
    assert re.search(r"Type: +DYN", readelf("-hW", BUILT[0]))
    assert re.search(r"\(FLAGS_1\) .*\bPIE\b", readelf("-dW", BUILT[0]))


def test_all_is_compiled_with_checked_buffers():
    """Each command of the tree, but for those whose own flags come from elsewhere."""
    text = subprocess.run(["ninja", "-C", TREE, "-t", "commands", "stoss_command"], capture_output=True, text=True, check=True)
    compiled = [line for line in text.stdout.splitlines() if " -c " in line]
    assert len(compiled) > 20
    for line in compiled:
        assert re.findall(r"-[DU]_FORTIFY_SOURCE(?:=\d)?", line)[-1] == "-D_FORTIFY_SOURCE=3" and re.search(r" -O[123] ", line), line


def test_buffers_are_checked(tmp_path):
    """The same flags make a program end that writes beyond an allocation."""
    program = tmp_path / "overflow.cpp"
    program.write_text("""#include <cstdlib>
#include <cstring>
int main(int count, char** words) {
  char* place = static_cast<char*>(std::malloc(static_cast<std::size_t>(count)));
  std::memset(place, words[0][0], static_cast<std::size_t>(count) + 1);
  return place[0] == 1;
}
""")
    text = subprocess.run(["ninja", "-C", TREE, "-t", "commands", "stoss_command"], capture_output=True, text=True, check=True)
    line = next(line for line in text.stdout.splitlines() if " -c " in line)
    flags = re.findall(r"-[DU]_FORTIFY_SOURCE(?:=\d)?| -O[123](?= )", line)
    subprocess.run([cached("CMAKE_CXX_COMPILER"), *map(str.strip, flags), program, "-o", tmp_path / "overflow"], check=True)
    done = subprocess.run([tmp_path / "overflow"], capture_output=True, text=True)
    assert done.returncode == -6 and "buffer overflow detected" in done.stderr
