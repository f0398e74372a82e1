"""All that computes says, once and to who asked, how far beyond yielding it is, where a named loss is far from that of one
Q, what is taken as sound, and what has not converged or is beyond small strain."""

import re
import warnings

import numpy as np
import pytest
import stoss

BALL = stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"], loss_time=0)
ROCK = stoss.Sphere(radius=1.0, material=stoss.materials["granite"])
BLOCK = stoss.HalfSpace(material=stoss.materials["glass"], loss_time=0)
MODES = {"cutoff": 12}
CALLS = {
    "restitution": lambda ball, v: stoss.restitution(ball, speed=[0.001, v], tolerance=0.1),
    "oblique": lambda ball, v: stoss.oblique(ball, speed=v, angle=30, friction=0.1, tolerance=0.3),
    "impact": lambda ball, v: stoss.impact(ball, speed=v, **MODES),
    "oblique_impact": lambda ball, v: stoss.oblique_impact(ball, speed=v, angle=30, friction=0.1, **MODES),
    "bounce": lambda ball, v: stoss.bounce(ball, speed=v, count=2, gravity=9.81, **MODES),
    "distribution": lambda ball, v: stoss.restitution_distribution(ball, speed=v, temperature=0.01, samples=2),
    "function": lambda ball, v: stoss.restitution_function(ball, speed=(v / 2, v), error=0.05),
    "rule": lambda ball, v: stoss.collision_rule(ball, speed=(v / 2, v), error=0.05, tolerance=0.3),
    "fit": lambda ball, v: stoss.fit(ball, against="same", law="linear", speed=(v / 2, v)),
}
ELASTIC = {
    "pair_table": lambda ball, v: stoss.pair_table(ball, speed=(v / 2, v), ratio=(1.0, 1.2), error=0.05),
    "atlas": lambda ball, v: stoss.atlas(ball, speed=[v]),
    "slow_impact": lambda ball, v: stoss.quasistatic.slow_impact(ball, speed=v),
    "rayleigh": lambda ball, v: stoss.quasistatic.rayleigh(ball, speed=v, cutoff=9),
}
YIELDS = (
    r"^the ball yields above 0\.0\d+ m/s \(you asked for 1 m/s, \d+ times that\): the real rebound is much lower; "
    "give a yield_strength, or use stoss predict$"
)
SOUND = "granite is taken as sound, smooth, dry and uncracked: measured losses are often ten times as large and more"


def said(call):
    """All that is warned of by a call, which must be told to this file."""
    with pytest.warns(stoss.StossWarning) as caught:
        call()
    assert all(each.filename == __file__ for each in caught)
    return [str(each.message) for each in caught]


@pytest.mark.parametrize("name", [*CALLS, *ELASTIC])
def test_says_how_far_beyond_yielding(name):
    (one,) = [each for each in said(lambda: {**CALLS, **ELASTIC}[name](BALL, 1.0)) if "yields above" in each]
    assert re.search(YIELDS, one), one


@pytest.mark.parametrize("name", CALLS)
def test_says_what_is_taken_as_sound(name):
    assert said(lambda: CALLS[name](ROCK, 0.1)) == [SOUND]


def test_elastic_estimates_say_what_is_taken_as_sound_only():
    assert said(lambda: stoss.quasistatic.slow_impact(ROCK, speed=0.1)) == [SOUND]


def test_a_sweep_says_it_of_the_worst_case_and_of_each(tmp_path):
    bodies = [BALL, stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"], loss_time=0)]
    against = ["wall", {"kind": "half-space", "material": "glass"}]
    grid = stoss.Grid(bodies=bodies, against=against, speed=[0.1], tolerance=0.3)
    (one,) = [each for each in said(lambda: stoss.sweep(grid, store=tmp_path / "store")) if "yields above" in each]
    assert one.startswith("2 of 4 cases beyond yielding; in the worst the ball yields above 0.0009")
    rocks = ["wall", {"kind": "sphere", "radius": 1.0, "material": "granite"}]
    grid = stoss.Grid(bodies=[ROCK], against=rocks, speed=[0.1], tolerance=0.3)
    of_rocks = said(lambda: stoss.sweep(grid, store=tmp_path / "rocks"))
    assert of_rocks == [SOUND]


def test_nothing_is_said_below_or_of_a_loss_time_of_ones_own(recwarn):
    stoss.impact(BALL, against=BLOCK, speed=0.015, **MODES)
    stoss.impact(stoss.Sphere(radius=5e-3, material=stoss.materials["glass"], loss_time=0), speed=1.0, **MODES)
    for loss_time in (0, 2.4e-5):
        ball = stoss.Sphere(radius=1.0, material=stoss.materials["granite"], loss_time=loss_time)
        stoss.impact(ball, against="same", speed=0.1, **MODES)
    assert not list(recwarn)


def test_not_converged_carries_the_best_value():
    with pytest.raises(stoss.NotConverged) as caught:
        stoss.restitution(stoss.Rod(), speed=0.1)
    best = caught.value.best
    assert isinstance(caught.value, RuntimeError) and str(caught.value).startswith("restitution: ")
    assert isinstance(best, stoss.Restitution) and not best.converged and best.reason in str(caught.value)
    assert best.restitution == pytest.approx(1, abs=1e-2) and "not converged" in repr(best) and len(repr(best)) <= 160
    with pytest.raises(stoss.NotConverged, match="impact: would take more than") as caught:
        stoss.impact(poisson=0.33, speed=0.1, cutoff=6, against=stoss.ExponentialWall(hardness=1e6), tail="none")
    assert caught.value.best is None


def test_arrays_mark_what_is_not_converged():
    with pytest.warns(stoss.StossWarning, match="^2 of 2 values not as accurate as asked for") as caught:
        result = stoss.restitution(stoss.Rod(), speed=[0.1, 0.2])
    assert caught[0].filename == __file__
    assert result.converged.tolist() == [False, False] and all(result.reason) and "2 not converged" in repr(result)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fine = stoss.restitution(poisson=0.33, speed=[0.05, 0.08], tolerance=0.1)
    assert fine.reason.tolist() == ["", ""]


def test_large_strain_is_warned_of():
    for speed in (0.9, [0.1, 0.9]):
        with pytest.warns(stoss.StossWarning, match="^strain of some 0.[0-9]+, above 0.1") as caught:
            result = stoss.restitution(poisson=0.33, speed=speed, tolerance=0.1)
        assert caught[0].filename == __file__ and np.any(result.beyond_small_strain)
    assert stoss.impact(poisson=0.33, speed=0.9, cutoff=6).beyond_small_strain
    assert not stoss.impact(poisson=0.33, speed=0.1, cutoff=6).beyond_small_strain
