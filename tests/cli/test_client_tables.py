"""The tables of tests/data/clients, which clients in engines are tested with, are what the command makes of the line that
each names."""

import re
import shlex
from pathlib import Path

import pytest

pytestmark = pytest.mark.numbers
FOLDER = Path(__file__).resolve().parents[1] / "data/clients"
TABLES = sorted(FOLDER.glob("*/*.*"))
NUMBER = re.compile(r"(?<![\w.])-?\d+\.?\d*(?:e[-+]?\d+)?(?![\w.])")


def told(text):
    """The command that a table names, without its program."""
    return re.search(r"^(?: \*|//) command: stoss (.*)$", text, re.M)[1]


def parts(text):
    """Its words, however lines are broken, without the version and its numbers."""
    text = re.sub(r"stoss \d+\.\d+\.\d+\S*: table", "", text)
    return NUMBER.sub(" ", text).split(), [float(number) for number in NUMBER.findall(text)]


def test_there_are_tables():
    assert len(TABLES) == 8


SLOW = ("ice/rule.h", "ice/restitution.h")  # which take seconds each


def marked(table):
    return pytest.param(table, marks=pytest.mark.long) if f"{table.parent.name}/{table.name}" in SLOW else table


@pytest.mark.parametrize("table", map(marked, TABLES), ids=lambda path: f"{path.parent.name}/{path.name}")
def test_the_command_makes_them(stoss, tmp_path, table):
    expected = table.read_text(encoding="utf-8")
    arguments = told(expected)
    assert shlex.split(arguments)[-2:] == ["-o", table.name]
    done = stoss.run(arguments, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    words, numbers = parts((tmp_path / table.name).read_text(encoding="utf-8"))
    expected_words, expected_numbers = parts(expected)
    assert words == expected_words, f"in {table.parent}: stoss {arguments}"
    # Functions of the C library differ in the last place between processors.
    assert numbers == pytest.approx(expected_numbers, rel=1e-6, abs=1e-12)
