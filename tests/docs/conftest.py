"""What tests of the numbers of pages have in common: tables, pages, and numbers as pages write them."""

import csv
import math
import os
import shlex
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def page(name):
    """The text of a page, and the same without its line breaks and without `**`."""
    text = (ROOT / name).read_text(encoding="utf-8")
    return text, " ".join(text.replace("**", "").split())


def rows(lines):
    """The rows of a CSV file, with numbers where there are numbers, by names without units."""

    def number(text):
        try:
            return float(text)
        except ValueError:
            return text

    found = csv.DictReader(line for line in lines if not line.startswith("#"))
    return [{key.partition("[")[0]: number(text) for key, text in row.items()} for row in found]


def table(name):
    return rows((ROOT / name).read_text(encoding="utf-8").splitlines())


def command(arguments):
    """The rows that a command prints: the arguments of the program that the environment variable STOSS names."""
    words = [os.environ["STOSS"], *shlex.split(arguments), "--format", "csv"]
    found = subprocess.run(words, capture_output=True, text=True, timeout=120)
    assert found.returncode in (0, 1), found.stderr  # 1: a value misses its tolerance
    return rows(found.stdout.splitlines())


def sampled(values, every=3):
    """Values of a parameter of which one of so many is tested at every commit, all before a release."""
    return [value if k % every == 0 else pytest.param(value, marks=pytest.mark.long) for k, value in enumerate(values)]


def line(*cells):
    """A line of a table."""
    return f"| {' | '.join(map(str, cells))} |"


def with_error(value, error):
    """0.9720953(68): the error in units of the last digits."""
    places = 1 - math.floor(math.log10(error))
    return f"{value:.{places}f}({error * 10**places:.0f})"


def power(value, digits):
    """2.3·10⁻⁴, with so many digits."""
    mantissa, _, exponent = f"{value:.{digits - 1}e}".partition("e")
    return f"{mantissa}·10{str(int(exponent)).translate(SUPERSCRIPTS)}"
