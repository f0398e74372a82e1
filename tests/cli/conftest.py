"""Black-box tests of the stoss command. The program under test is in the environment variable STOSS."""

import csv
import io
import os
import re
import shlex
import signal
import subprocess
import time
from pathlib import Path

import pytest


# A job of four rows, for what may happen to its file.
SMALL = "restitution --body disk --poisson 0.33,-0.2 --speed 0.1,0.2"


class Command:
    def __init__(self, path):
        self.path = path

    def run(self, *arguments, strain=False, **options):
        """Runs the command with `arguments` split as a shell does; returns the completed process. Fast impacts are
        cheap, so most tests have some, and the warning of their strain is left out unless `strain`."""
        words = [word for argument in arguments for word in shlex.split(argument)]
        done = subprocess.run(
            [self.path, *words], capture_output=True, text=True, timeout=600, stdin=subprocess.DEVNULL, **options
        )
        if not strain:
            done.stderr = re.sub(r"^stoss: warning: strain of some .*\n", "", done.stderr, flags=re.MULTILINE)
        return done

    def start(self, arguments, **options):
        """Starts the command; returns the process."""

        # The shell of the tests may ignore signals; the command must see the defaults.
        def defaults():
            signal.signal(signal.SIGINT, signal.SIG_DFL)
            signal.signal(signal.SIGPIPE, signal.SIG_DFL)

        return subprocess.Popen([self.path, *shlex.split(arguments)], preexec_fn=defaults, text=True, **options)

    def data(self, *arguments):
        """Rows of the CSV output, as dictionaries; the command must succeed."""
        result = self.run(*arguments, "--format csv")
        assert result.returncode == 0, result.stderr
        return rows(result.stdout)


def wait_for_rows(process, path, count):
    """Returns when `count` rows are in the CSV file at `path`; the process must still be at work."""
    while not path.exists() or sum(not line.startswith("#") for line in path.open(errors="replace")) <= count:
        assert process.poll() is None
        time.sleep(0.02)


def wait_until_caught(process, number):
    """Returns when the process handles a signal, which sanitizers make late."""
    status = Path(f"/proc/{process.pid}/status")
    caught = 0
    while not caught >> (number - 1) & 1:
        assert process.poll() is None
        time.sleep(0.02)
        caught = int(re.search("SigCgt:(.*)", status.read_text())[1], 16)


def rows(text):
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    found = list(csv.DictReader(io.StringIO("\n".join(lines))))
    for row in found:  # of files that a run may continue
        row.pop("checksum", None)
    return found


def number(row, name):
    """The value of a column, whatever its unit."""
    return float(row[next(key for key in row if key.partition("[")[0] == name)])


@pytest.fixture(scope="session")
def stoss():
    return Command(os.environ["STOSS"])


@pytest.fixture(scope="session")
def usual_build(stoss):
    """The command where it is built without sanitizers, which take processor time."""
    with open(stoss.path, "rb") as program:
        if b"__asan_init" in program.read():
            pytest.skip("sanitizers take processor time")
    return stoss


@pytest.fixture(scope="session")
def small(stoss):
    """The whole CSV text of the job SMALL."""
    return stoss.run(SMALL, "--format csv").stdout


def resume(stoss, path, job=SMALL, **options):
    return stoss.run(job, "--resume", str(path), **options)
