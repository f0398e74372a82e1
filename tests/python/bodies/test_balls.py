"""The table of examples/07_balls.py is what the package computes, and agrees with Hertz."""

import csv

import numpy as np
import pytest

import stoss


def test_balls_of_the_example_are_those_of_the_package(example_folder):
    table = example_folder("07_balls") / "out/balls.csv"
    rows = list(csv.DictReader(table.read_text(encoding="utf-8").splitlines()))
    assert len(rows) == 14  # steel up to its yield speed, 0.13 m/s
    for row in rows:
        speed = row["speed_m_s"]
        ball = stoss.Sphere(radius=0.01, material=stoss.materials[row["material"]], loss_time=0)
        direct = stoss.restitution(ball, speed=float(speed))
        assert direct.lost_fraction == pytest.approx(float(row["lost_fraction"]), rel=1e-8)
        # Hertz: the pressure that goes with a force and the energy that made it.
        stiff = ball.young / (1 - ball.poisson**2)
        hertz = stiff * 2 / np.pi * (15 / 16 * 4 * np.pi / 3 * ball.density * float(speed) ** 2 / stiff) ** 0.2
        if direct.speed < 5e-4:  # a faster ball presses deeper, where a whole ball is stiffer than Hertz's
            assert float(row["pressure_Pa"]) == pytest.approx(hertz, rel=0.01)
