"""All that computes elastic values in SI says how far beyond the speed of yielding they are, once, to who asked."""

import re

import pytest

import stoss

BALL = stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"], loss_time=0)
BLOCK = stoss.HalfSpace(material=stoss.materials["glass"], loss_time=0)
MODES = {"cutoff": 12}
CALLS = {
    "restitution": lambda: stoss.restitution(BALL, against=BLOCK, speed=[0.001, 1.0], tolerance=0.1),
    "oblique": lambda: stoss.oblique(BALL, against=BLOCK, speed=1.0, angle=30, friction=0.1, tolerance=0.3),
    "impact": lambda: stoss.impact(BALL, against=BLOCK, speed=1.0, **MODES),
    "oblique_impact": lambda: stoss.oblique_impact(BALL, against=BLOCK, speed=1.0, angle=30, friction=0.1, **MODES),
    "bounce": lambda: stoss.bounce(BALL, speed=1.0, count=2, gravity=9.81, **MODES),
    "distribution": lambda: stoss.restitution_distribution(BALL, speed=1.0, temperature=0.01, samples=2),
    "function": lambda: stoss.restitution_function(BALL, against=BLOCK, speed=(0.5, 1.0), error=0.05),
    "pair_table": lambda: stoss.pair_table(BALL, speed=(0.5, 1.0), ratio=(1.0, 1.2), error=0.05),
    "rule": lambda: stoss.collision_rule(BALL, speed=(0.5, 1.0), error=0.05, tolerance=0.3),
    "atlas": lambda: stoss.atlas(BALL, speed=[1.0]),
    "fit": lambda: stoss.fit(BALL, against="same", law="linear", speed=(0.5, 1.0)),
    "slow_impact": lambda: stoss.quasistatic.slow_impact(BALL, speed=1.0),
    "rayleigh": lambda: stoss.quasistatic.rayleigh(BALL, speed=1.0, cutoff=9),
}
SAID = r"^the ball yields above 0\.0\d+ m/s \(you asked for 1 m/s, \d+ times that\): the real rebound is much lower; use stoss predict$"


def warnings_of(call):
    with pytest.warns(stoss.StossWarning) as caught:
        call()
    return [each for each in caught if "yields above" in str(each.message)]


@pytest.mark.parametrize("name", CALLS)
def test_says_how_far_beyond(name):
    (one,) = warnings_of(CALLS[name])
    assert re.search(SAID, str(one.message)), one.message
    assert one.filename == __file__


def test_a_sweep_says_it_of_the_worst_case(tmp_path):
    bodies = [BALL, stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"], loss_time=0)]
    grid = stoss.Grid(bodies=bodies, against=["wall", {"kind": "half-space", "material": "glass"}], speed=[0.1], tolerance=0.3)
    (one,) = warnings_of(lambda: stoss.sweep(grid, store=tmp_path / "store"))
    assert str(one.message).startswith("2 of 4 cases beyond yielding; in the worst the ball yields above 0.0009")
    assert one.filename == __file__


def test_nothing_is_said_below(recwarn):
    stoss.impact(BALL, against=BLOCK, speed=0.015, **MODES)
    stoss.impact(stoss.Sphere(radius=5e-3, material=stoss.materials["glass"], loss_time=0), speed=1.0, **MODES)
    assert not list(recwarn)
