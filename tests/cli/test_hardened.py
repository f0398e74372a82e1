"""The command as built for release has what cmake/hardening.cmake asks for. Of what is carried elsewhere see
tests/portable/test_guarded.py, of the shared library tests/packaging."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))

import hardened

COMMAND = Path(os.environ["STOSS"]).resolve()
TREE = COMMAND.parents[1]
pytestmark = pytest.mark.skipif(hardened.reason_to_skip(TREE) != "", reason=hardened.reason_to_skip(TREE))


def test_command_is_guarded():
    assert hardened.guards(COMMAND) == hardened.GUARDED


def test_command_has_no_fixed_address():
    assert hardened.has_no_fixed_address(COMMAND)


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
    subprocess.run([hardened.cached(TREE, "CMAKE_CXX_COMPILER"), *map(str.strip, flags), program, "-o", tmp_path / "overflow"], check=True)
    done = subprocess.run([tmp_path / "overflow"], capture_output=True, text=True)
    assert done.returncode == -6 and "buffer overflow detected" in done.stderr
