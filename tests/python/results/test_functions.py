"""ε(v) as a function: units, shapes, range, pickles, a header in C and two columns; ε of two bodies against the ratio of radii."""

import numpy as np
import pytest
import stoss
from matplotlib import pyplot as plt

BALL = stoss.Sphere(poisson=0.3)
RUBBER = stoss.Disk(radius=0.01, material=stoss.materials["rubber"], loss_time=0)


@pytest.fixture(scope="module")
def epsilon():
    return stoss.restitution_function(BALL, speed=(1e-3, 0.3), error=1e-2)


@pytest.fixture(scope="module")
def in_si():
    return stoss.restitution_function(RUBBER, against="same", speed=(0.002, 30.0), error=1e-2, beyond="law")


def test_numbers_give_floats_and_arrays_their_shape(epsilon):
    assert type(epsilon(0.1)) is float and type(epsilon.error(0.1)) is float
    assert type(epsilon(np.float64(0.1))) is float
    speeds = np.array([[0.1, -0.2, 0.3], [0.001, 0.01, 0.02]])
    values, errors = epsilon(speeds), epsilon.error(speeds)
    assert values.shape == errors.shape == speeds.shape
    for place in np.ndindex(speeds.shape):
        assert values[place] == epsilon(abs(speeds[place])) and errors[place] == epsilon.error(speeds[place])
    assert epsilon([]).shape == (0,) and epsilon([0.1]).shape == (1,)


def test_range_and_knots_are_in_the_unit_of_the_call(epsilon, in_si):
    assert epsilon.range == (1e-3, 0.3) and in_si.range == pytest.approx((0.002, 30.0), rel=1e-15)
    assert in_si(0.002) == in_si.restitution[0] and in_si(30.0) == in_si.restitution[-1]
    for function in (epsilon, in_si):
        knots = function.knots
        assert len(knots) == len(function) == function.speed.size
        np.testing.assert_allclose(function(np.clip(knots["speed"], *function.range)), knots["restitution"], atol=1e-12)
    np.testing.assert_allclose(in_si.speed_si, in_si.knots["speed"])
    with pytest.raises(AttributeError, match="no material"):
        _ = epsilon.speed_si
    assert f"{len(in_si)} speeds computed" in repr(in_si) and "0.002 to 30 m/s" in repr(in_si)
    assert "0.001 to 0.3 c" in repr(epsilon) and "\n" not in repr(in_si)


@pytest.mark.parametrize("bad", [0.0, 1e-4, 0.31, np.nan, -np.inf])
def test_nothing_is_extrapolated_silently(epsilon, bad):
    for call in (epsilon, epsilon.error):
        for given in (bad, [0.1, bad]):
            with pytest.raises(stoss.InvalidInput, match="speed: got"):
                call(given)


def test_beyond_its_range_it_does_what_was_chosen():
    clamped = stoss.restitution_function(BALL, speed=(0.01, 0.1), error=1e-2, beyond="clamp")
    assert clamped([0.0, 1e-5, -1e-9]).tolist() == [clamped.restitution[0]] * 3
    assert clamped(1e9) == clamped.restitution[-1] and clamped.error(1e9) == np.inf
    with pytest.raises(stoss.InvalidInput):
        clamped(np.nan)
    lawful = stoss.restitution_function(BALL, speed=(0.01, 0.1), error=1e-2, beyond="law")
    slow = np.geomspace(1e-6, 9e-3, 12)
    direct = stoss.restitution(BALL, speed=slow)
    assert np.all(np.abs(lawful(slow) - direct.restitution) <= lawful.error(slow) + direct.restitution_error)
    assert lawful(0) == 1 and lawful.error(0) == 0
    with pytest.raises(stoss.InvalidInput, match="range"):
        lawful(0.2)


def test_a_curve_becomes_a_function():
    curve = stoss.restitution(BALL, speed=np.geomspace(0.3, 1e-3, 24), tolerance=0.01)
    function = curve.function()
    direct = stoss.restitution(BALL, speed=[0.0123, 0.0456, 0.234])
    missed = np.abs(function(direct.speed) - direct.restitution)
    assert np.all(missed <= function.error(direct.speed) + direct.restitution_error)
    assert function(0.3) == curve.restitution[0] and function.range == (curve.speed[-1], curve.speed[0])
    assert curve.function(beyond="clamp")(1e-8) == curve.restitution[-1]
    assert curve.function(beyond="law")(0) == 1
    both = stoss.restitution(poisson=[[0.2], [0.33]], speed=np.geomspace(1e-2, 0.3, 12), tolerance=0.05)
    with pytest.raises(stoss.InvalidInput, match="2 bodies.*allowed one"):
        both.function()
    assert both[1].function()(0.1) == pytest.approx(0.94706, abs=5e-3)


def test_only_whole_curves_become_functions():
    with pytest.raises(stoss.InvalidInput, match="speeds: got 1"):
        stoss.restitution(BALL, speed=0.1).function()
    with pytest.raises(stoss.InvalidInput, match="rise"):
        stoss.restitution(BALL, speed=[0.1, 0.1, 0.2, 0.3, 0.4]).function()
    with pytest.warns(stoss.StossWarning):
        curve = stoss.restitution(stoss.Rod(), speed=np.geomspace(0.01, 0.1, 6))
    with pytest.raises(stoss.InvalidInput, match="have not converged"):
        curve.function()
    assert len(curve[curve.converged]) < 6


def test_vibration_goes_with_the_function():
    ringing = stoss.Oscillation(order=2, index=0, energy=0.05, phase=2.0)
    curve = stoss.restitution(BALL, speed=np.geomspace(0.01, 0.02, 12), state=ringing)
    function = curve.function()
    assert function.state is curve.state and "state" in function._inputs()
    with pytest.raises(stoss.InvalidInput, match="beyond"):
        curve.function(beyond="law")


def test_picture(epsilon, in_si):
    plt = pytest.importorskip("matplotlib.pyplot")
    ax = epsilon.plot()
    assert ax.get_xlabel() == "speed of approach v / c" and len(ax.collections) >= 1
    (curve, *_), (bars,) = ax.lines, ax.containers
    assert curve.get_xdata()[0] == 1e-3 and curve.get_xdata()[-1] == 0.3
    assert np.array_equal(bars.lines[0].get_ydata(), epsilon.restitution)
    assert stoss.plot.function(in_si, ax, label="rubber") is ax and ax.get_xlabel() == "speed of approach v / (m/s)"
    plt.close("all")


@pytest.fixture(scope="module")
def steel():
    ball = stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"])
    return stoss.restitution_function(ball, against="same", speed=(0.01, 0.5), error=2e-3)


def test_header_has_the_unit_of_the_function(steel, tmp_path):
    """It is that of the core, which the tests of the command compile."""
    steel.to_c(str(tmp_path / "ball.h"), name="ball")
    text = (tmp_path / "ball.h").read_text()
    assert "ball_restitution(" in text and "ball_restitution_error(" in text and "radius=0.005" in text
    assert "in m/s; its sign" in text and f"stoss {stoss.__version__}: function" in text
    for name in ("1x", ""):
        with pytest.raises(stoss.InvalidInput, match=f"name: got '{name}', allowed"):
            steel.to_c(tmp_path / "x.h", name=name)
    with pytest.raises(OSError):
        steel.to_c(tmp_path / "no" / "x.h")
    assert [path.name for path in tmp_path.iterdir()] == ["ball.h"]


def test_modules_are_those_of_the_command(steel, tmp_path):
    steel.to_rust(tmp_path / "ball.rs", name="ball")
    steel.to_js(tmp_path / "ball.mjs", name="ball")
    assert "pub fn ball_restitution(speed: f64) -> f64 {" in (tmp_path / "ball.rs").read_text()
    text = (tmp_path / "ball.mjs").read_text()
    assert "export function ball_restitution(speed) {" in text and "in m/s; its sign" in text
    with pytest.raises(stoss.InvalidInput, match="name: got 1, allowed a str"):
        steel.to_js(tmp_path / "x.mjs", name=1)


def test_columns_are_as_accurate_as_asked_for(steel, tmp_path):
    for error in (None, 1e-2):
        steel.to_two_column(tmp_path / "ball.txt", error=error)
        speed, restitution = np.loadtxt(tmp_path / "ball.txt").T
        at = np.geomspace(0.0101, 0.499, 500)
        distance = np.abs(np.interp(at, speed, restitution) - steel(at))
        assert np.all(distance + steel.error(at) <= (error or 2 * steel.greatest_error))
    with pytest.raises(stoss.InvalidInput, match="error: got 1e-09, allowed"):
        steel.to_two_column(tmp_path / "x.txt", error=1e-9)


@pytest.fixture(scope="module")
def disks():
    return stoss.pair_table(poisson=0.33, speed=(0.02, 0.2), ratio=(1, 2), error=2e-2)


def test_arrays_broadcast_and_inverses_are_the_same(disks):
    speed, ratio = np.array([[0.03], [-0.1]]), np.array([1.0, 1.5, 1.9])
    values = disks(speed, ratio)
    assert values.shape == (2, 3) == disks.error(speed, ratio).shape
    np.testing.assert_allclose(disks(speed, 1 / ratio), values, rtol=1e-13)
    assert isinstance(disks(0.1, 1.5), float) and disks(0.1, 1.5) == values[1, 1]


def test_two_materials_in_si():
    steel = stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"], loss_time=0)
    glass = stoss.Sphere(radius=5e-3, material=stoss.materials["glass"], loss_time=0)
    table = stoss.pair_table(steel, against=glass, speed=(10, 100), ratio=(0.9, 1.1), error=1e-2, beyond="clamp")
    assert not table.alike and "m/s" in repr(table)
    direct = stoss.restitution(steel, against=glass, speed=40.0)
    assert abs(table(40.0, 1.0) - direct.restitution) < table.error(40.0, 1.0) + direct.restitution_error
    assert table(0.0, 1.0) == table(1.0, 1.0) == table(10.0, 1.0) and table.error(0.0, 1.0) == np.inf
    with pytest.raises(stoss.InvalidInput, match="speed: got nan"):
        table(np.nan, 1.0)
    assert table.error(200.0, 1.0) == np.inf and table(200.0, 1.0) == pytest.approx(table(100.0, 1.0), abs=1e-9)


def test_the_picture_of_pairs_has_a_curve_for_each_ratio(disks):
    axes = disks.plot()
    assert len(axes.lines) == 5 and "v / c" in axes.get_xlabel()
    plt.close(axes.figure)


def test_pairs_beyond_the_range_are_refused(disks):
    for speed, ratio in ((0.3, 1.0), (0.1, 2.5), (0.1, 0.4), (0.0, 1.0), (0.1, -1.0), (np.nan, 1.0)):
        with pytest.raises(stoss.InvalidInput):
            disks(speed, ratio)
