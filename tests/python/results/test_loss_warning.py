"""All that computes with the loss of a named material says where it is far from that of one Q, and of what is not sound."""

import pytest

import stoss

BALL = stoss.Sphere(radius=1.0, material=stoss.materials["granite"])
MODES = {"cutoff": 12}
CALLS = {
    "restitution": lambda: stoss.restitution(BALL, against="same", speed=[0.01, 0.1], tolerance=0.1),
    "oblique": lambda: stoss.oblique(BALL, against="same", speed=0.1, angle=30, friction=0.1, tolerance=0.3),
    "impact": lambda: stoss.impact(BALL, against="same", speed=0.1, **MODES),
    "oblique_impact": lambda: stoss.oblique_impact(BALL, against="same", speed=0.1, angle=30, friction=0.1, **MODES),
    "bounce": lambda: stoss.bounce(BALL, speed=0.1, count=2, gravity=9.81, **MODES),
    "distribution": lambda: stoss.restitution_distribution(BALL, speed=0.1, temperature=0.01, samples=2),
    "function": lambda: stoss.restitution_function(BALL, against="same", speed=(0.05, 0.1), error=0.05),
    "rule": lambda: stoss.collision_rule(BALL, speed=(0.05, 0.1), error=0.05, tolerance=0.3),
    "fit": lambda: stoss.fit(BALL, against="same", law="linear", speed=(0.05, 0.1)),
}
SOUND = "granite is taken as sound, smooth, dry and uncracked: measured losses are often ten times as large and more"


@pytest.mark.parametrize("name", CALLS)
def test_says_by_how_much_and_what_is_taken_as_sound(name):
    with pytest.warns(stoss.StossWarning) as caught:
        CALLS[name]()
    loss, sound = [str(each.message) for each in caught]
    assert loss.startswith("the loss of granite is ") and " times too small at 0." in loss, loss
    assert sound == SOUND
    assert all(each.filename == __file__ for each in caught)


def test_elastic_estimates_say_what_is_taken_as_sound_only():
    with pytest.warns(stoss.StossWarning) as caught:
        stoss.quasistatic.slow_impact(BALL, speed=0.1)
    assert [str(each.message) for each in caught] == [SOUND]


def test_a_sweep_says_it_once_for_each_case(tmp_path):
    against = ["wall", {"kind": "sphere", "radius": 1.0, "material": "granite"}]
    grid = stoss.Grid(bodies=[BALL], against=against, speed=[0.1], tolerance=0.3)
    with pytest.warns(stoss.StossWarning) as caught:
        stoss.sweep(grid, store=tmp_path / "store")
    said = [str(each.message) for each in caught]
    assert sum(each.startswith("the loss of granite is ") for each in said) == 2 and said.count(SOUND) == 1, said


@pytest.mark.parametrize("loss_time", [0, 2.4e-5])
def test_of_a_loss_time_of_ones_own_nothing_is_said(loss_time, recwarn):
    ball = stoss.Sphere(radius=1.0, material=stoss.materials["granite"], loss_time=loss_time)
    stoss.impact(ball, against="same", speed=0.1, **MODES)
    assert not list(recwarn)
