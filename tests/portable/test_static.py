"""The static command runs where there is nothing else, and says the same as the other one, bit by bit."""

import os
import re
import shlex
import shutil
import subprocess

import pytest

from conftest import COMMAND, TREE, run

STATIC = TREE / "static/stoss"
pytestmark = pytest.mark.skipif(not STATIC.exists(), reason="no static command in this build tree")

# Values, tables and text of every kind, on both threads where there are some; and what is refused.
LINES = [
    "--version",
    "--help",
    "restitution --body disk --poisson 0.33 --speed log:1e-3:0.1:4 --threads 2 --format csv",
    "restitution --body sphere --poisson 0.3 --speed 0.01 --against half-space --format json",
    "restitution --body rod --speed 0.1 --tolerance 0.1 --format table",
    "impact --body sphere --radius 0.005 --material 'structural steel' --speed 1 --format json",
    "oblique --body sphere --poisson 0.3 --speed 0.01 --friction 0.3 --angle 30 --format csv",
    "distribution --body disk --poisson 0.33 --speed 0.1 --samples 4 --temperature 0.01 --seed 7 --threads 2 --format csv",
    "modes --body disk --poisson 0.33 --cutoff 12 --format csv",
    "table --body disk --poisson 0.33 --speed 1e-2:0.1 --error 0.01 --format c",
    "schema",
    "restitution --body disk --poisson 7 --speed 0.1",
    "fit --help",
]


@pytest.fixture(scope="module")
def empty_root(tmp_path_factory):
    """A root directory with nothing in it but the command."""
    if os.geteuid() != 0:
        pytest.skip("only root can change its root directory")
    root = tmp_path_factory.mktemp("root")
    shutil.copy(STATIC, root / "stoss")
    if subprocess.run(["chroot", root, "/stoss", "--version"], capture_output=True).returncode == 125:
        pytest.skip("not even root may change its root directory here")
    return root


def said(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, timeout=120, stdin=subprocess.DEVNULL)
    return done.returncode, done.stdout, done.stderr


def test_it_needs_no_other_file():
    headers = run("readelf", "--wide", "--program-headers", "--dynamic", STATIC).stdout
    assert "NEEDED" not in headers and "INTERP" not in headers and "RPATH" not in headers


@pytest.mark.parametrize("line", LINES)
def test_in_an_empty_root_it_says_the_same(empty_root, line):
    words = shlex.split(line)
    theirs = said(COMMAND, *words)
    assert said("chroot", empty_root, "/stoss", *words) == theirs
    assert theirs[0] in (0, 1, 3), theirs  # the line itself is one


def test_it_writes_its_file_there(empty_root):
    line = "restitution --body disk --poisson 0.33 --speed 0.1 --format csv --output /rows.csv"
    assert said("chroot", empty_root, "/stoss", *shlex.split(line))[0] == 0
    assert b"restitution" in (empty_root / "rows.csv").read_bytes()
    assert sorted(path.name for path in empty_root.iterdir()) == ["rows.csv", "stoss"]


def test_without_python_it_says_so_in_one_line(empty_root):
    line = "fit --law hunt-crossley --body sphere --material 'structural steel' --radius 0.005 --speed 0.1:1"
    status, _, message = said("chroot", empty_root, "/stoss", *shlex.split(line))
    assert (status, message.count(b"\n")) == (4, 1)
    assert re.search(rb"cannot run python3", message)


def test_it_is_small_and_starts_at_once():
    def start(program):
        """Processor time in ms, which other programs hardly change: the least of many."""
        times = []
        for _ in range(20):
            process = subprocess.Popen([program, "--version"], stdout=subprocess.DEVNULL)
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            times.append(1e3 * (used.ru_utime + used.ru_stime))
        return min(times)

    size, static, shared = STATIC.stat().st_size / 1e6, start(STATIC), start(COMMAND)
    print(f"{size:.1f} MB; starts in {static:.1f} ms of processor time, the other in {shared:.1f} ms")
    assert size < 12
    assert static <= shared  # it looks up no libraries
