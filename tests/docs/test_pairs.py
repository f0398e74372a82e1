"""The numbers of docs/understand/findings/pairs.md: those of its CSV file, and those of the command."""

import math
import re

import pytest
from conftest import command, line, page, table, with_error

PAGE, WORDS = page("docs/understand/findings/pairs.md")
SPEEDS = (0.01, 0.1, 0.3)
ROWS = {(row["radius_ratio"], row["speed"]): row for row in table("docs/results/pairs.csv")}
RATIOS = sorted({ratio for ratio, _ in ROWS})
LOSS = {speed: [ROWS[ratio, speed]["lost_fraction"] for ratio in RATIOS] for speed in SPEEDS}
PATH = 4 * math.sqrt(1 - 0.33**2)  # R₂/c: a pressure wave to the far side and back


def of(ratio):
    return [ROWS[ratio, speed] for speed in SPEEDS]


def test_what_the_file_holds():
    assert f"holds {len(RATIOS)} ratios; all values meet a tolerance of 10⁻³" in WORDS
    assert all(row["converged"] == "true" for row in ROWS.values())


@pytest.mark.parametrize("ratio", (1, 1.5, 2, 5, 20))
def test_table_of_restitution(ratio):
    names = ("restitution", "lost_fraction")
    cells = [with_error(row[name], row[f"{name}_error"]) for name in names for row in of(ratio)]
    cells.insert(3, f"{of(ratio)[0]['restitution_of_rods']:.3f}")
    assert line(f"{ratio:g}", *cells) in PAGE


def test_claims_about_the_loss():
    equal, double, twenty = ([row["lost_fraction"] for row in of(ratio)] for ratio in (1, 2, 20))
    least = min(LOSS[0.01])
    assert f"from {equal[0]:.4f} to {least:.4f} at R₂/R₁ = {RATIOS[LOSS[0.01].index(least)]:g}" in WORDS
    by_two, by_twenty = ([a / b for a, b in zip(its, equal)] for its in (double, twenty))
    said = f"At a ratio of radii of 2 the loss is {round(min(by_two))} to {max(by_two):.1f} times that of equal disks"
    assert f"{said}, at 20 it is {round(min(by_twenty))} to {round(max(by_twenty))} times" in WORDS
    shares = [[100 * ROWS[ratio, speed]["lost_to_smaller"] for ratio in RATIOS] for speed in SPEEDS]
    said = [f"{min(its):.1f} to {max(its):.1f} %".replace(".0 %", " %") for its in shares]
    assert f"absorbs {said[0]} of the energy at v = 0.01 c, {said[1]} at 0.1 c and {said[2]} at 0.3 c" in WORDS


def test_where_the_loss_falls_first():
    larger = min((row for (_, speed), row in ROWS.items() if speed == 0.01), key=lambda row: row["lost_to_larger"])
    periods = larger["contact_time"] / larger["radius_ratio"] / 4.368
    said = f"At R₂/R₁ = {larger['radius_ratio']:g}, τ is {periods:.2f} periods of the larger disk"
    assert f"{said}, which then absorbs the least, {100 * larger['lost_to_larger']:.1f} %" in WORDS
    assert f"τ is {ROWS[1, 0.01]['contact_time'] / 4.368:.2f} periods in a pair of equal disks" in WORDS


def test_when_the_far_side_is_too_far():
    assert f"{PATH:.2f} R₂/c" in WORDS
    for speed in SPEEDS:
        first = next(ratio for ratio in RATIOS if PATH * ratio > ROWS[ratio, speed]["contact_time"])
        assert f"{first:g} (v = {speed:g})" in WORDS or f"{first:g} ({speed:g})" in WORDS


def test_the_limit_is_a_half_plane():
    limits = [2 * ROWS[40, speed]["impulse"] - ROWS[20, speed]["impulse"] for speed in SPEEDS]
    known = re.search(r"extrapolate to ([\d.]+)\((\d)\), ([\d.]+)\((\d)\) and ([\d.]+)\((\d)\) m₁v", WORDS).groups()
    for limit, value in zip(limits, known[::2]):
        assert abs(limit - float(value)) <= 0.6e-4
    losses = re.search(r"1 − ε² is ([\d.]+)\((\d)\), ([\d.]+)\((\d)\) and ([\d.]+)\((\d)\) at v", WORDS).groups()
    for limit, value in zip(limits, losses[::2]):
        assert abs(1 - (limit - 1) ** 2 - float(value)) <= 1e-4
    largest = max(abs(ROWS[ratio, speed]["impulse"] / limit - 1)
                  for speed, limit in zip(SPEEDS, limits) for ratio in RATIOS if ratio >= 3)  # fmt: skip
    assert f"within {100 * largest:.1f} % of its limit" in WORDS
    # ε = J/(m₁v) (1 + R₁²/R₂²) − 1, at every ratio
    for (ratio, _), row in ROWS.items():
        assert row["restitution"] == pytest.approx(row["impulse"] * (1 + ratio**-2) - 1, abs=2e-4)


@pytest.mark.parametrize("ratio", (50, 1000))
def test_still_larger_disks(ratio):
    job = f"restitution --body disk --poisson 0.33 --against disk,radius={ratio} --speed {','.join(map(str, SPEEDS))}"
    found = command(f"{job} --tolerance 2.5e-4")
    assert line(ratio, *(with_error(row["lost_fraction"], row["lost_fraction_error"]) for row in found)) in PAGE


def test_beside_finite_elements():
    for radius, speed, tolerance in ((2, 0.2, 1e-4), (10, 0.1, 3e-5)):
        job = f"restitution --body disk --poisson 0.33 --against disk,radius={radius} --speed {speed} --tolerance {tolerance}"
        (row,) = command(job)
        assert with_error(row["lost_fraction"], row["lost_fraction_error"]) in WORDS
