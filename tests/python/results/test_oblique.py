"""Oblique impacts: those of the command, over arrays, in SI, with what goes wrong."""

import json

import numpy as np
import pytest
import stoss

BALL = stoss.Sphere(poisson=0.3)
STEEL = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
SHOT = stoss.Sphere(radius=0.01, material=STEEL)


@pytest.fixture(scope="module")
def fan():
    return stoss.oblique(BALL, speed=[[0.01], [0.05]], angle=[-30, 5, 45], friction=0.2)


def test_arrays_broadcast_and_are_the_values_one_by_one(fan):
    assert fan.restitution.shape == fan.friction.shape == (2, 3) and len(fan) == 2
    for i, speed in enumerate((0.01, 0.05)):
        for k, angle in enumerate((-30, 5, 45)):
            one = stoss.oblique(BALL, speed=speed, angle=angle, friction=0.2)
            for name in ("restitution", "sliding_after", "spin_after", "friction_loss_error", "steps"):
                assert getattr(fan, name)[i, k] == getattr(one, name)
    assert fan.angle.ravel() == pytest.approx([-30, 5, 45] * 2)


def test_every_number_of_the_motion_broadcasts():
    result = stoss.oblique(
        BALL, against="same", speed=0.05, tangential=[[0.02], [0.0]], spin=[0.0, 0.01], second_spin=0.01,
        friction=[[[0.1]], [[0.4]]],
    )  # fmt: skip
    assert result.restitution.shape == (2, 2, 2)
    one = stoss.oblique(BALL, against="same", speed=0.05, spin=0.01, second_spin=0.01, friction=0.4)
    assert result[1, 1, 1].sliding_after == one.sliding_after
    assert result[1, 1, 1].friction == 0.4 and result[1, 0, 0].friction == 0.4 and result[0].friction.max() == 0.1


def test_selection_keeps_the_inputs(fan):
    part = fan[1, fan.angle[1] > 0]
    assert part.tangential.shape == (2,) and part.body == BALL and part.speed.tolist() == [0.05, 0.05]
    single = part[0]
    assert isinstance(single.restitution, float) and single.angle == pytest.approx(5)
    with pytest.raises(TypeError):
        len(single)


def test_momentum_is_kept():
    """A ball: Ω′ − Ω = 5/2 (v_t′ − v_t)/R, but for the arms beside the middle."""
    result = stoss.oblique(BALL, speed=1e-3, tangential=[1e-3, 3e-4], spin=[2e-4, -1e-4], friction=0.2)
    turned, slowed = result.spin_after - result.spin, result.tangential_after - result.tangential
    assert turned / (2.5 * slowed) == pytest.approx([1, 1], abs=2e-3)
    assert result.sliding == pytest.approx(result.tangential + result.spin)
    assert result.tangential_restitution == pytest.approx(-result.sliding_after / result.sliding)


def test_a_line_says_the_essential(fan):
    one = stoss.oblique(BALL, speed=0.05, tangential=0.02, spin=0.01, friction=0.3, against="same")
    assert repr(one).startswith(
        "ObliqueRestitution(Sphere(poisson=0.3) against Sphere(poisson=0.3), speed=0.05 c, tangential=0.02 c, "
        "spin=0.01 c/R, friction=0.3: restitution 0.99"
    )
    values = "6 values, Sphere(poisson=0.3), speed=0.01 to 0.05 c, friction=0.2: tangential restitution 0."
    assert repr(fan).startswith(f"ObliqueRestitution({values}")
    assert repr(fan).endswith("all converged)")


def test_tables_have_units_and_errors(fan, tmp_path):
    fan.to_csv(tmp_path / "fan.csv")
    head = next(line for line in (tmp_path / "fan.csv").read_text().splitlines() if not line.startswith("#"))
    names = ["speed[c]", "tangential[c]", "spin[c/R]", "second_spin[c/R]", "friction", "restitution"]
    assert head.split(",")[:6] == names and "sliding_after_error[c]" in head and "spin_after[c/R]" in head
    table = stoss.read_csv(tmp_path / "fan.csv")
    assert table["sliding_after"].tolist() == fan.sliding_after.ravel().tolist()
    frame = fan.to_dataframe()
    assert frame.shape[0] == 6 and frame.attrs["units"]["tangential_after"] == "c"
    assert fan.to_xarray().restitution.shape == (2, 3)
    angles = stoss.oblique(BALL, speed=0.05, tangential=[0.01, 0.02], friction=0.2)
    assert angles.to_xarray().restitution.dims == ("tangential",)
    assert json.loads(json.dumps(fan.to_dict()))["tolerance"] == 0.01


def test_nothing_slides_before():
    result = stoss.oblique(BALL, speed=0.05, tangential=[0.0, 0.01], spin=[0.0, -0.01], friction=0.3)
    assert result.sliding.tolist() == [0, 0] and result.converged.all()
    assert np.isinf(result.tangential_restitution_error).all() and result.sliding_after[0] == 0
    assert result.to_dict()["tangential_restitution_error"] == ["unknown", "unknown"]


def test_what_misses_its_tolerance():
    with pytest.raises(stoss.NotConverged, match="^oblique: the tolerance asks for more points") as missed:
        stoss.oblique(BALL, speed=0.1, tangential=0.02, friction=0.2, tolerance=1e-5)
    assert isinstance(missed.value.best, stoss.ObliqueRestitution) and missed.value.best.sliding_after_error > 0
    assert repr(missed.value.best).endswith("not converged)")
    with pytest.warns(stoss.StossWarning, match="1 of 2 values not as accurate"):
        result = stoss.oblique(BALL, speed=0.1, tangential=[0.02, 0.5], friction=0.2, tolerance=1e-5)
    assert result.converged.tolist() == [False, True] and result.reason[1] == ""


def test_warnings():
    with pytest.warns(stoss.StossWarning, match="linear elasticity"):
        stoss.oblique(BALL, speed=[0.7], tangential=1.0, friction=0.01)
    hard = stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=1e9)
    with pytest.warns(stoss.StossWarning, match="^the ball yields above 0.0339 m/s .*, 30 times that.: the real rebound is much lower; use stoss predict$"):
        result = stoss.oblique(stoss.Sphere(radius=0.01, material=hard), speed=1.0, angle=30, friction=0.1)
    assert result.beyond_yield and result.yield_speed_si == pytest.approx(0.0339, rel=1e-2)


@pytest.mark.parametrize(
    "given, said",
    [
        ({"speed": 2}, "speed: got 2, allowed 1e-8 to 1"),
        ({"tangential": 1.5}, "tangential: got 1.5, allowed -1 to 1"),
        ({"angle": 90}, "angle: got 90, allowed -90 to 90"),
        ({"angle": 3, "tangential": 0.1}, "angle: got tangential and angle, allowed one of them"),
        ({"spin": [0, 2]}, "spin: got 2, allowed -1 to 1"),
        ({"second_spin": 0.1}, "second_spin: got one that is not 0, allowed only 0"),
        ({"friction": -0.1}, "friction: got -0.1, allowed 0 to 5"),
        ({"friction": None}, "friction: got None, allowed a number or an array of numbers"),
        ({"tolerance": 1e-9}, "tolerance: got 1e-09, allowed 1e-6 to 0.5"),
        ({"threads": -1}, "threads: got -1"),
        ({"speed": [0.1, 0.2], "spin": [0, 0, 0]}, "speed, tangential, spin, second_spin, friction: got shapes"),
        ({"body": stoss.Rod()}, "friction: not available for 'rod', but for disks"),
        ({"against": stoss.ExponentialWall()}, "against: got "),
        ({"against": stoss.Disk(poisson=0.3)}, "against: got "),
        ({"body": SHOT, "speed": 1, "tangential": 1e4}, "; with this material c is 5172.19 m/s"),
        ({"body": SHOT, "speed": 1, "spin": 1e9}, "; with this material c/R is 517219 rad/s"),
    ],
)
def test_refused_in_one_line(given, said):
    with pytest.raises(stoss.InvalidInput) as refused:
        stoss.oblique(**{"body": BALL, "speed": 0.1, "friction": 0.1} | given)
    assert said in str(refused.value) and "\n" not in str(refused.value)


def test_no_values():
    empty = stoss.oblique(BALL, speed=[], friction=0.1)
    assert empty.restitution.shape == (0,) and len(empty) == 0


def test_interrupted_keeps_what_is_done(interpreter):
    result = interpreter.run(
        """
import signal, threading, numpy as np, stoss
threading.Timer(0.6, lambda: signal.raise_signal(signal.SIGINT)).start()
try:
    stoss.oblique(stoss.Sphere(poisson=0.3), speed=np.geomspace(1e-3, 0.1, 4000), angle=30, friction=0.1)
except stoss.Interrupted as stopped:
    done = np.isfinite(stopped.best.restitution)
    print(0 < done.sum() < 4000, (stopped.best.reason[~done] == "interrupted").all(), stopped)
"""
    )
    assert result.stdout.startswith("True True oblique: interrupted after "), result.stderr
