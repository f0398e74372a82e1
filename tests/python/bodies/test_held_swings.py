"""A ball on what is held softly, which swings back and strikes it again, against two hard masses and a spring."""

from pathlib import Path

import numpy as np
import pytest
import stoss
from scipy.optimize import brentq

FILES = Path(__file__).parents[3] / "examples/any_body"
MASS, FREQUENCY, RADIUS, SPEED = 0.1, 2.0, 0.01, 0.01
STEEL = {"young": 2e11, "poisson": 0.3}


def gap(t, start, speed, ball):
    """Between a mass that swings from `start` on with this speed, and one that goes on from there."""
    return start * np.cos(t) + speed * np.sin(t) - start - ball * t


def billiard(ratio):
    """Speed after over before of such a mass, and how often it hits another on a spring, of mass 1 and ω = 1."""
    x, ball, other, hits = 0.0, 1.0, 0.0, 0
    times = np.linspace(1e-6, 60.0, 60001)
    while True:
        ball, other = (
            ((ratio - 1) * ball + 2 * other) / (ratio + 1),
            ((1 - ratio) * other + 2 * ratio * ball) / (ratio + 1),
        )
        hits += 1
        closed = np.flatnonzero(gap(times, x, other, ball) < 0)
        if not len(closed):
            return -ball, hits
        t = brentq(gap, times[closed[0] - 1], times[closed[0]], args=(x, other, ball))
        x, other = x + ball * t, other * np.cos(t) - x * np.sin(t)


@pytest.mark.parametrize("ratio, hits", [(0.3, 1), (1.5, 2), (2.0, 2), (3.0, 3)])
def test_all_strokes_are_seen(ratio, hits):
    """They take up to 140 ms; of the ball alone a contact lasts 0.2 ms."""
    density = ratio * MASS / (4 / 3 * np.pi * RADIUS**3)
    ball = stoss.Sphere(radius=RADIUS, material=stoss.Material(**STEEL, density=density), loss_time=0)
    body = stoss.ModalBody(
        mass=MASS, held=True, curvature=0, **STEEL, density=7850, complete_to=20000,
        frequency=[FREQUENCY], displacement=[MASS**-0.5], compliance=1 / (MASS * (2 * np.pi * FREQUENCY) ** 2),
    )  # fmt: skip
    hit = stoss.impact(ball, against=body, speed=SPEED)
    expected, strokes = billiard(ratio)
    assert strokes == hit.contacts == hits
    assert hit.restitution == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("name", ["bat_hands_30", "bat_hands_140"])
def test_slow_balls_leave_a_bat_in_hands(name):
    body = stoss.ModalBody.read(FILES / f"{name}.json")
    ball = stoss.Sphere(radius=0.0127, material=stoss.materials["bearing steel"])
    curve = stoss.restitution(ball, against=body, speed=[0.01, 0.1], tolerance=0.2)
    assert np.all(curve.converged) and np.all((curve.restitution > 0.4) & (curve.restitution < 0.8))
