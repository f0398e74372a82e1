"""stoss table: what it refuses, what it warns of, and what becomes of its file."""

import os
import resource
import signal
import stat
import subprocess
import time

import pytest

DISK = "table --body disk --poisson 0.33 --speed 1e-4:0.3"
# Many seconds of work.
LONG = "table --body sphere --poisson 0.3 --speed 1e-4:0.5 --error 1e-7"


@pytest.mark.parametrize("more, words", [
    ("--speed 0.1", ["speed", "'0.1'", "LOW:HIGH"]),
    ("--speed 0.1:0.2:0.3", ["speed", "'0.1:0.2:0.3'"]),
    ("--speed 0.1:", ["speed", "got ''", "missing"]),
    ("--speed 0.2:0.1", ["speed", "'0.2:0.1'", "below the higher"]),
    ("--speed 0.1:0.1", ["speed", "below the higher"]),
    ("--speed 0:0.1", ["speed", "got 0,"]),
    ("--speed -0.1:0.1", ["speed", "-0.1"]),
    ("--speed nan:0.1", ["speed", "nan"]),
    ("--speed 0.1:2", ["speed", "got 2,"]),
    ("--speed 0.01:0.1 --error 0", ["error", "got 0,"]),
    ("--speed 0.01:0.1 --error 0.2", ["error", "0.2"]),
    ("--speed 0.01:0.1 --error nan", ["error", "nan"]),
    ("--speed 0.01:0.1 --name 2x", ["name", "'2x'"]),
    ("--speed 0.01:0.1 --name=", ["name", "''"]),
    ("--speed 0.01:0.1 --name x --format json", ["name", "json"]),
    ("--speed 0.01:0.1 --beyond error --format two-column", ["beyond", "two-column"]),
    ("--speed 0.01:0.1 --against exponential", ["against", "exponential"]),
    ("--speed 0.01:0.1 --against sphere", ["against", "sphere"]),
    ("--speed 0.01:0.1 --threads -1", ["threads", "-1"]),
    ("--speed 0.01:0.1 --format csv", ["--format", "csv"]),
    ("--speed 0.01:0.1 --beyond law", ["--beyond", "law"]),
    ("", ["--speed"]),
])  # fmt: skip
def test_bad_input(stoss, tmp_path, more, words):
    path = tmp_path / "table.h"
    result = stoss.run("table --body disk --poisson 0.33", more, f"-o {path}")
    assert result.returncode in (2, 3) and result.stdout == "" and not path.exists()
    (line,) = result.stderr.splitlines()
    assert all(word in line for word in words), line


def test_unwritable_places(stoss, tmp_path):
    for place in (tmp_path / "no" / "table.h", tmp_path):
        result = stoss.run(DISK, f"-o {place}")
        assert result.returncode == 4 and "cannot write" in result.stderr and str(place) in result.stderr


@pytest.mark.parametrize("form", ["c", "two-column", "json"])
def test_full_disk(stoss, form):
    words = [stoss.path, *DISK.split(), "--format", form]
    with open("/dev/full", "w") as full:
        result = subprocess.run(words, stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
    assert result.returncode == 4 and "No space left" in result.stderr


def test_a_file_that_cannot_grow_stays_as_it_was(stoss, tmp_path):
    path = tmp_path / "table.h"
    path.write_text("old\n")

    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))

    result = stoss.run(DISK, f"-o {path}", preexec_fn=small_files)
    assert result.returncode == 4 and "File too large" in result.stderr
    assert path.read_text() == "old\n" and os.listdir(tmp_path) == ["table.h"]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_tables_leave_nothing(stoss, tmp_path, number):
    path = tmp_path / "table.h"
    path.write_text("old\n")
    process = stoss.start(f"{LONG} -o {path}", stderr=subprocess.PIPE)
    time.sleep(0.4)
    assert process.poll() is None
    process.send_signal(number)
    _, error = process.communicate(timeout=60)
    assert process.returncode == 128 + number and "interrupted" in error
    assert path.read_text() == "old\n" and os.listdir(tmp_path) == ["table.h"]


def test_a_file_keeps_its_place_and_its_rights(stoss, tmp_path):
    path = tmp_path / "table.h"
    path.write_text("old\n")
    path.chmod(0o640)
    link = tmp_path / "link.h"
    link.symlink_to(path)
    assert stoss.run(DISK, f"-o {link}").returncode == 0
    assert link.is_symlink() and path.read_text().startswith("/* Coefficient")
    assert stat.S_IMODE(path.stat().st_mode) == 0o640
    assert sorted(os.listdir(tmp_path)) == ["link.h", "table.h"]


def test_long_names(stoss, tmp_path):
    path = tmp_path / ("n" * 253 + ".h")
    assert stoss.run(DISK, f"-o {path}").returncode == 0 and path.exists()


def test_warnings(stoss):
    fast = stoss.run("table --body disk --poisson 0.33 --speed 0.1:0.7", strain=True)
    assert fast.returncode == 0 and "above 0.1: linear elasticity" in fast.stderr and fast.stdout.startswith("/*")
    assert not stoss.run("table --body disk --poisson 0.33 --speed 0.1:0.7 --quiet").stderr
    yields = stoss.run(
        "table --body sphere --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.005 --speed 0.01:10 --error 0.1",
        "--yield 1e9",
    )
    assert yields.returncode == 0 and "yield" in yields.stderr
