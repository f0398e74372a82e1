"""What an example printed and wrote."""

import csv
import re

import numpy as np
import pytest

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
