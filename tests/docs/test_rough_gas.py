"""The numbers of docs/understand/findings/gas.md: those of its CSV file."""

import itertools
import math
import re

import pytest
from conftest import ROOT, line, page, power, table

PAGE, WORDS = page("docs/understand/findings/gas.md")
FILE = "docs/results/rough_gas.csv"
ROWS = table(FILE)
BODIES = {"disks": (2, 1), "spheres": (3, 3)}  # degrees of freedom
COUNTS = (5, 10, 20, 40, 60)


def of(body, rule):
    return [row for row in ROWS if (row["body"], row["rule"]) == (body, rule)]


def ratio(body, rule, collisions):
    """The temperature of rotation over that of translation, between rows by a line."""
    for a, b in itertools.pairwise(of(body, rule)):
        if a["collisions"] <= collisions <= b["collisions"]:
            part = (collisions - a["collisions"]) / (b["collisions"] - a["collisions"])
            return (1 - part) * a["rotation"] / a["translation"] + part * b["rotation"] / b["translation"]
    raise AssertionError(collisions)


def when(body, rule, share):
    """Time at which so much of the energy is left: between rows its logarithm is linear in theirs."""
    moves, turns = BODIES[body]
    rows = [(row["time"], moves * row["translation"] + turns * row["rotation"]) for row in of(body, rule)]
    for (early, more), (late, less) in itertools.pairwise(rows):
        if less <= share * rows[0][1]:
            part = math.log(more / (share * rows[0][1])) / math.log(more / less)
            return early ** (1 - part) * late**part
    raise AssertionError(share)


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("rule", ("stoss", "constant", "mean field"))
def test_ratios(body, rule):
    assert line(f"{body}, {rule}", *(f"{ratio(body, rule, each):.3f}" for each in COUNTS)) in PAGE


def test_constants():
    text = (ROOT / FILE).read_text(encoding="utf-8")
    found = re.findall(r"constant restitution ([\d.]+), tangential ([\d.]+)", text)
    (disk, disk_along), (ball, ball_along) = ((f"{float(a):.5f}", f"{float(b):.5f}") for a, b in found)
    assert f"{disk} and {disk_along} for disks, {ball} and {ball_along} for spheres" in WORDS


@pytest.mark.parametrize("body", BODIES)
def test_mean_field_holds_at_first(body):
    said = of(body, "mean field")
    for row, theory in zip(of(body, "constant"), said):
        if row["collisions"] <= 10:
            assert abs(row["rotation"] / row["translation"] - theory["rotation"] / theory["translation"]) < 0.04


def test_times():
    ends = {rule: [power(when(body, rule, 0.01), 2) for body in BODIES] for rule in ("stoss", "constant")}
    disks, spheres = ends["stoss"]
    assert f"after {disks} R/c (disks) and {spheres} R/c (spheres) with stoss" in WORDS
    assert "{} and {} with the constants".format(*ends["constant"]) in WORDS
