"""The table of balls in docs/materials.md is what examples/07_balls.py computes, and that agrees with Hertz."""

import csv
from pathlib import Path

import numpy as np
import pytest

import stoss

ROOT = Path(__file__).parents[3]


def written(text):
    """A number of a page, as 1.4(2)·10⁻⁷, and one unit of its last digit."""
    shown, _, power = text.partition("·10")
    mantissa = shown.partition("(")[0]
    scale = 10.0 ** int(power.translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")) or 0)
    return float(mantissa) * scale, scale * 10.0 ** -len(mantissa.partition(".")[2])


def test_balls_are_those_of_the_page_on_materials(example_folder):
    table = example_folder("07_balls") / "out/balls.csv"
    rows = list(csv.DictReader(table.read_text(encoding="utf-8").splitlines()))
    page = (ROOT / "docs/materials.md").read_text(encoding="utf-8").partition("## Balls")[2].partition("## Drop tests")[0]
    lines = [[cell.strip() for cell in line.split("|")[1:-1]] for line in page.splitlines() if line.startswith("|")]
    assert len(lines) - 2 == len(rows) == 16
    units = {"µs": 1e-6, "ms": 1e-3, "GPa": 1e9, "MPa": 1e6}
    for row, (material, speed, ratio, loss, epsilon, time, pressure) in zip(rows, lines[2:]):
        assert material in ("", row["material"]) and float(speed) == float(row["speed_m_s"])
        (loss, digit), error = written(loss), float(row["lost_fraction_error"])
        assert abs(loss - float(row["lost_fraction"])) <= 0.51 * digit + 0.1 * error
        assert float(epsilon) == pytest.approx((1 - float(row["lost_fraction"])) ** 0.5, abs=error)
        value, digit = written(ratio)
        assert abs(value - float(row["speed_c"])) <= 0.51 * digit
        for shown, name in ((time, "contact_time_s"), (pressure, "pressure_Pa")):
            number, unit = shown.split()
            assert float(number) * units[unit] == pytest.approx(float(row[name]), rel=0.06)
        ball = stoss.Sphere(radius=0.01, material=stoss.materials[row["material"]], loss_time=0)
        direct = stoss.restitution(ball, speed=float(speed))
        assert direct.lost_fraction == pytest.approx(float(row["lost_fraction"]), rel=1e-8)
        # Hertz: the pressure that goes with a force and the energy that made it.
        stiff = ball.young / (1 - ball.poisson**2)
        hertz = stiff * 2 / np.pi * (15 / 16 * 4 * np.pi / 3 * ball.density * float(speed) ** 2 / stiff) ** 0.2
        if direct.speed < 1e-3:
            assert float(row["pressure_Pa"]) == pytest.approx(hertz, rel=0.01)
