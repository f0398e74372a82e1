"""docs/materials.md and docs/measured.md: the numbers of the command."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import command, page

ROOT = Path(__file__).parents[2]
PAGE, WORDS = page("docs/materials.md")
PAIRS = [row.group(1).split(" on ") for row in re.finditer(r"^\| ([a-z ]+ on [a-z ]+) \| [0-9]", PAGE, re.M)]


def predicted(ball, block, speeds):
    words = [os.environ["STOSS"], "predict", "--body", "sphere", "--material", ball, "--radius", "0.005"]
    words += ["--against", f"half-space,material={block}", "--speed", ",".join(speeds), "--format", "json", "--quiet"]
    return json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)["records"]


def share(value):
    """As the table has it: 0.088, or with a power of ten."""
    if abs(value) < 1e-12:
        return "0"
    digits, power = f"{value:.1e}".split("e")
    if int(power) >= -2:
        return f"{value:.2g}"
    return f"{digits}·10⁻{str(abs(int(power))).translate(str.maketrans('0123456789', '⁰¹²³⁴⁵⁶⁷⁸⁹'))}"


def power(value):
    """One digit and a power of ten, as an error has it."""
    digits, exponent = f"{value:.0e}".split("e")
    return f"{digits}·10⁻{str(abs(int(exponent))).translate(str.maketrans('0123456789', '⁰¹²³⁴⁵⁶⁷⁸⁹'))}"


def height(metres):
    return f"{metres * 1e6:.3g} µm" if metres < 1e-3 else f"{metres * 1e3:.3g} mm"


@pytest.mark.parametrize("ball, block", PAIRS)
def test_channels_of_drop_tests(ball, block):
    lines = PAGE.splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith(f"| {ball} on {block} |"))
    table = [[cell.strip() for cell in line.strip("|").split("|")][1:] for line in lines[start : start + 3]]
    for cells, row in zip(table, predicted(ball, block, [cells[0] for cells in table])):
        said = [f"{row['restitution']:.4f}", power(row["restitution_error"])]
        said += [share(row["by_models"]), share(row["by_constants"]), f"{row['restitution_without_models']:.4f}"]
        said += [share(row[name]) for name in ("ringing", "radiation", "material", "yield", "adhesion")]
        assert cells[1:] == [*said, height(row["rebound_height"])], (ball, block, cells[0])


def test_the_pairs_are_those_of_a_drop_test():
    assert len(PAIRS) == 7


def test_materials_are_those_of_the_command():
    words = [os.environ["STOSS"], "materials", "--format", "json"]
    for row in json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)["records"]:
        assert f"\n| {row['name']} |" in PAGE


def test_where_they_begin_to_yield_and_stick():
    for ball, block, speed in (("bearing steel", "glass", "2.2 m/s"), ("bearing steel", "bearing steel", "0.51 m/s")):
        assert speed in WORDS
        slow, fast = predicted(ball, block, [str(factor * float(speed.split()[0])) for factor in (0.97, 1.03)])
        assert slow["yield"] == 0 < fast["yield"]
    (dust,) = command("predict --body sphere --material ice --radius 1e-6 --against same --speed 1.37 --quiet")
    assert dust["restitution"] == 0 and "sticks below 1.4 m/s" in WORDS


def test_table_of_measurements():
    table, words = page("docs/measured.md")
    made = subprocess.run([sys.executable, ROOT / "studies/measured/compare.py", os.environ["STOSS"]],
                          check=True, capture_output=True, text=True).stdout  # fmt: skip
    assert made.count("\n") == 10
    for line in made.splitlines():
        assert line in table
    for speed, said in (("1e-3", "0.12 v/c"), ("1e-2", "0.14 v/c")):
        (row,) = command(f"restitution --body sphere --poisson 0.3 --speed {speed} --quiet")
        assert f"{(1 - row['restitution']) / float(speed):.2f} v/c" == said and said in words
