"""What the tests of the Python package share. The command to compare with is in the environment variable STOSS."""

import csv
import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import stoss

sys.path.insert(0, str(Path(__file__).parents[2] / "scripts"))
from run_examples import run  # noqa: E402

os.environ.setdefault("MPLBACKEND", "Agg")
DATA = Path(__file__).parents[1] / "data"


class Interpreter:
    """Python in a process of its own, that sees the same package."""

    def __init__(self):
        folders = [str(Path(stoss.__file__).parents[1]), os.environ.get("PYTHONPATH", "")]
        self.environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, folders))}

    def run(self, code, **options):
        """Runs `code` to its end; returns the completed process."""
        return subprocess.run(
            [sys.executable, "-c", code], env=self.environment, capture_output=True, text=True, timeout=60, **options
        )

    def start(self, code, **options):
        """Starts `code`; returns the process, whose output is a pipe."""
        return subprocess.Popen(
            [sys.executable, "-c", code], env=self.environment, stdout=subprocess.PIPE, text=True, **options
        )


@pytest.fixture(scope="session")
def interpreter():
    return Interpreter()


@pytest.fixture(scope="session")
def example_folder():
    """The folder of an example that has run: output.txt, and out/."""
    return run


@pytest.fixture(scope="session")
def command():
    """Runs the stoss command; returns its JSON."""

    def run(arguments):
        words = [os.environ["STOSS"], *shlex.split(arguments), "--format", "json", "--quiet"]
        result = subprocess.run(words, capture_output=True, text=True, timeout=120, check=True)
        return json.loads(result.stdout)

    return run


@pytest.fixture(scope="session")
def references():
    """Rows of a file in tests/data, as dictionaries of numbers; what is empty there is left out."""

    def read(name):
        with open(DATA / name, encoding="utf-8") as stream:
            rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
        assert rows
        return [{key: float(text) for key, text in row.items() if text} for row in rows]

    return read


@pytest.fixture(scope="session")
def steel():
    """A disk in SI."""
    return stoss.Disk(radius=0.01, material=stoss.Material(young=2.1e11, poisson=0.3, density=7850))


@pytest.fixture(scope="session")
def hit():
    """An impact that costs little."""
    return stoss.impact(poisson=0.33, speed=0.1, cutoff=12)


@pytest.fixture
def closed():
    """Pictures are closed after the test, which has left matplotlib's settings as they were."""
    matplotlib = pytest.importorskip("matplotlib")
    from matplotlib import pyplot

    settings = dict(matplotlib.rcParams)
    yield
    pyplot.close("all")
    assert dict(matplotlib.rcParams) == settings


NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.])")


class Run:
    """What an example printed, and the folder that it filled."""

    def __init__(self, folder):
        self.folder = folder / "out"
        self.text = (folder / "output.txt").read_text(encoding="utf-8")

    def numbers(self, start):
        """All numbers of the lines that start so, a list for each line."""
        lines = [line.strip() for line in self.text.splitlines() if line.strip().startswith(start)]
        assert lines, f"no line starts with {start!r} in\n{self.text}"
        return [[float(number) for number in NUMBER.findall(line)] for line in lines]

    def table(self, columns):
        """The rows that hold that many numbers and no words."""
        lines = [line for line in self.text.splitlines() if not re.search(r"[a-zA-Zε]", NUMBER.sub("", line))]
        rows = [[float(number) for number in NUMBER.findall(line)] for line in lines]
        return np.array([row for row in rows if len(row) == columns])

    def csv(self, name):
        lines = (self.folder / name).read_text(encoding="utf-8").splitlines()
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


@pytest.fixture
def example(example_folder):
    return lambda name: Run(example_folder(name))
