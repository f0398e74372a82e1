"""docs/reference/materials.md and docs/understand/measured.md: the numbers of the command."""

import json
import os
import re
import subprocess
import sys

import pytest
from conftest import ROOT, command, page, power, sampled

PAGE, WORDS = page("docs/reference/materials.md")
PAIRS = [row.group(1).split(" on ") for row in re.finditer(r"^\| ([a-z ]+ on [a-z ]+) \| [0-9]", PAGE, re.M)]


def predicted(ball, block, speeds):
    words = [os.environ["STOSS"], "predict", "--body", "sphere", "--material", ball, "--radius", "0.005"]
    words += ["--against", f"half-space,material={block}", "--speed", ",".join(speeds), "--format", "json", "--quiet"]
    return json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)["records"]


def share(value):
    """As the table has it: 0.088, or with a power of ten."""
    if abs(value) < 1e-12:
        return "0"
    return f"{value:.2g}" if abs(value) >= 0.00995 else power(value, 2)




@pytest.mark.parametrize("which", sampled(PAIRS), ids=str)
def test_channels_of_drop_tests(which):
    ball, block = which
    lines = PAGE.splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith(f"| {ball} on {block} |"))
    cells = [cell.strip() for cell in lines[start].strip("|").split("|")][1:]
    (row,) = predicted(ball, block, cells[:1])
    said = [f"{row['restitution']:.4f}", power(row["restitution_error"], 1)]
    said += [share(row["by_models"]), share(row["by_constants"])]
    said += [share(row[name]) for name in ("radiation", "material", "yield", "adhesion")]
    assert cells[1:] == said, which


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


@pytest.mark.long  # what is predicted for ten experiments
def test_table_of_measurements():
    table, _ = page("docs/understand/measured.md")
    made = subprocess.run([sys.executable, ROOT / "studies/measured/compare.py", os.environ["STOSS"]],
                          check=True, capture_output=True, text=True).stdout  # fmt: skip
    assert made.count("\n") == 15
    for line in made.splitlines():
        assert line in table


def test_loss_of_measured_balls_in_terms_of_their_speed():
    _, words = page("docs/understand/measured.md")
    for speed, said in (("1e-3", "0.12 v/c"), ("1e-2", "0.14 v/c")):
        (row,) = command(f"restitution --body sphere --poisson 0.3 --speed {speed} --quiet")
        assert f"{(1 - row['restitution']) / float(speed):.2f} v/c" == said and said in words


def test_factors_by_which_constants_vary():
    _, words = page("docs/reference/materials.md")
    made = subprocess.run([os.environ["STOSS"], "materials", "--format", "json"], check=True, capture_output=True).stdout
    varied = {each["name"]: each["uncertainties"] for each in json.loads(made)["records"]}

    def span(name, of=None):
        known = [its[name] for each, its in varied.items() if its.get(name) and (of is None or each in of)]
        return f"{1 + min(known):g} to {1 + max(known):g}"

    some = ("PMMA", "PE", "PA", "POM", "phenolic resin", "PVB", "granite")
    rubbers = [each for each in varied if each.endswith("rubber")]
    hard = [each for each in varied if each not in (*some, *rubbers)]
    assert f"factors are {span('young', hard)} for E of metals" in words
    assert f"{span('young', some)} for E of plastics and granite, {span('young', rubbers)} for E of rubbers" in words
    for name, letter in (("poisson", "ν"), ("density", "ρ"), ("yield_strength", "Y"), ("surface_energy", "γ")):
        assert f"{span(name)} for {letter}" in words
    assert {its.get("loss", 0.0) for its in varied.values()} <= {0.0, 2.0} and "3 for every Q" in words


def test_ratios_of_the_losses_of_ice_are_those_of_the_table():
    table, words = page("docs/understand/measured.md")
    lines = [line for line in table.splitlines() if "ice, Ø" in line or line.startswith("| the same, compacted")]
    lines = [line for line in lines if line.count("|") == 10]
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in lines]
    slow, fast = ([float(row[-1]) for row in rows if (row[1] == "1 mm/s") == is_slow] for is_slow in (True, False))
    assert len(rows) == 7 and f"by a factor of {min(fast):g} to {max(fast):g} in the loss" in words
    assert f"the factor is {min(slow):g} to {max(slow):g}" in words
    paper = " ".join((ROOT / "docs/paper/paper.md").read_text(encoding="utf-8").split())
    assert f"loses {min(fast):g} to {max(fast):g} times as much as predicted" in paper
