"""ε(v) as a function: units, shapes, range, errors against direct values, pickles."""

import pickle
import threading

import numpy as np
import pytest

import stoss

BALL = stoss.Sphere(poisson=0.3)
RUBBER = stoss.Disk(radius=0.01, material=stoss.materials["rubber"], loss_time=0)


@pytest.fixture(scope="module")
def epsilon():
    return stoss.restitution_function(BALL, speed=(1e-3, 0.3))


@pytest.fixture(scope="module")
def in_si():
    return stoss.restitution_function(RUBBER, against="same", speed=(0.002, 30.0), error=1e-4, beyond="law")


def test_values_are_within_their_error_of_direct_ones(in_si):
    speed = np.exp(np.random.default_rng(20).uniform(np.log(0.002), np.log(30.0), 60))
    direct = stoss.restitution(RUBBER, speed=speed / 2, tolerance=1e-15, absolute=1e-5)
    missed = np.abs(in_si(speed) - direct.restitution)
    error = in_si.error(speed) + direct.restitution_error
    assert np.all(missed <= 3 * error) and np.mean(missed <= error) >= 0.95
    assert np.max(in_si.error(speed)) <= in_si.greatest_error <= 1e-4


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


@pytest.mark.parametrize("bad", [0.0, 1e-4, 0.31, 1e300, np.nan, np.inf, -np.inf])
def test_nothing_is_extrapolated_silently(epsilon, bad):
    for call in (epsilon, epsilon.error):
        for given in (bad, [0.1, bad]):
            with pytest.raises(stoss.InvalidInput, match="speed: got"):
                call(given)


def test_refusals_in_si_say_what_c_is(in_si):
    with pytest.raises(stoss.InvalidInput, match="with this material c is"):
        in_si(31.0)


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


STEEL, GLASS = stoss.materials["structural steel"], stoss.materials["glass"]


@pytest.mark.parametrize(
    "body, against, speed",
    [
        (stoss.Disk(poisson=0.33), None, (1e-3, 0.01)),
        (stoss.Disk(poisson=0.33, loss_time=0.1), "same", (1e-3, 0.01)),
        (stoss.Sphere(poisson=0.3, loss_time=0.1, radius=2), None, (1e-3, 0.01)),
        (BALL, stoss.HalfSpace(young=2), (1e-3, 0.01)),
        (stoss.Sphere(poisson=0.3, rigid=True), stoss.HalfSpace(poisson=0.2), (1e-3, 0.01)),
        (stoss.Sphere(radius=5e-3, material=STEEL, loss_time=0), stoss.HalfSpace(material=GLASS, loss_time=0), (1, 9)),
    ],
)
def test_laws_hold(body, against, speed):
    function = stoss.restitution_function(body, against=against, speed=speed, error=1e-2, beyond="law")
    slow = speed[0] / 10
    direct = stoss.restitution(body, against=against, speed=slow)
    assert abs(function(slow) - direct.restitution) <= function.error(slow) + direct.restitution_error


@pytest.mark.parametrize(
    "body, against",
    [
        (stoss.Rod(), None), (BALL, stoss.Sphere(poisson=0.3, radius=2)), (stoss.Disk(poisson=0.3), stoss.HalfPlane()),
        (stoss.Sphere(poisson=0.3, loss_time=1), stoss.HalfSpace()),
        (stoss.Sphere(poisson=0.3, rigid=True), BALL),
    ],
)  # fmt: skip
def test_a_law_that_there_is_not_is_refused_at_once(body, against):
    with pytest.raises(stoss.InvalidInput, match="law") as refusal:
        stoss.restitution_function(body, against=against, speed=(1e-8, 0.5), error=1e-7, beyond="law")
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    "arguments, what",
    [
        ({"speed": 0.1}, "speed"), ({"speed": (0.1, 0.2, 0.3)}, "speed"), ({"speed": (0.2, 0.1)}, "range"),
        ({"speed": (0.0, 0.1)}, "speed"), ({"speed": (0.1, np.nan)}, "speed"), ({"speed": "fast"}, "speed"),
        ({"error": 0}, "error"), ({"error": np.nan}, "error"), ({"error": 1}, "error"),
        ({"beyond": "guess"}, "beyond"), ({"beyond": 3}, "beyond"), ({"threads": -1}, "threads"),
        ({"against": "wall"}, "against"), ({"poisson": 0.3}, "body"),
    ],
)  # fmt: skip
def test_refusals(arguments, what):
    with pytest.raises(stoss.InvalidInput, match=f"^{what}: got"):
        stoss.restitution_function(BALL, **({"speed": (0.01, 0.1)} | arguments))


def test_pickles_and_copies_are_the_same_function(epsilon, in_si):
    for function in (epsilon, in_si):
        again = pickle.loads(pickle.dumps(function))
        speeds = np.geomspace(*function.range, 50)[1:-1]
        assert np.array_equal(again(speeds), function(speeds))
        assert np.array_equal(again.error(speeds), function.error(speeds))
        assert repr(again) == repr(function)
    slow = 0.5 * in_si.range[0]
    assert pickle.loads(pickle.dumps(in_si))(slow) == in_si(slow)


def test_threads_do_not_change_it(epsilon):
    one = stoss.restitution_function(BALL, speed=(1e-3, 0.3), threads=1)
    assert np.array_equal(one.restitution, epsilon.restitution) and np.array_equal(one.speed, epsilon.speed)
    found = []
    several = [threading.Thread(target=lambda: found.append(epsilon([0.1, 0.2]))) for _ in range(4)]
    for each in several:
        each.start()
    for each in several:
        each.join()
    assert all(np.array_equal(each, epsilon([0.1, 0.2])) for each in found)


def test_a_curve_becomes_a_function():
    curve = stoss.restitution(BALL, speed=np.geomspace(0.3, 1e-3, 40))
    function = curve.function()
    direct = stoss.restitution(BALL, speed=[0.0123, 0.0456, 0.234], absolute=1e-6, tolerance=1e-15)
    missed = np.abs(function(direct.speed) - direct.restitution)
    assert np.all(missed <= function.error(direct.speed) + direct.restitution_error)
    assert function(0.3) == curve.restitution[0] and function.range == (curve.speed[-1], curve.speed[0])
    assert curve.function(beyond="clamp")(1e-8) == curve.restitution[-1]
    assert curve.function(beyond="law")(0) == 1
    both = stoss.restitution(poisson=[[0.2], [0.33]], speed=np.geomspace(1e-2, 0.3, 20))
    with pytest.raises(stoss.InvalidInput, match="2 bodies.*allowed one"):
        both.function()
    assert both[1].function()(0.1) == pytest.approx(0.94706, abs=2e-3)


def test_only_whole_curves_become_functions():
    with pytest.raises(stoss.InvalidInput, match="knots: got 1"):
        stoss.restitution(BALL, speed=0.1).function()
    with pytest.raises(stoss.InvalidInput, match="rise"):
        stoss.restitution(BALL, speed=[0.1, 0.1, 0.2, 0.3, 0.4]).function()
    with pytest.warns(stoss.StossWarning):
        curve = stoss.restitution(BALL, speed=[0.001, 0.01, 0.02, 0.05, 0.1, 0.4], tolerance=1e-15, absolute=1e-6)
    with pytest.raises(stoss.InvalidInput, match="have not converged"):
        curve.function()
    kept = curve[curve.converged]
    assert 0 < len(kept) < 6


def test_vibration_goes_with_the_function():
    ringing = stoss.Oscillation(order=2, index=0, energy=0.05, phase=2.0)
    curve = stoss.restitution(BALL, speed=np.geomspace(0.01, 0.02, 12), state=ringing)
    function = curve.function()
    assert function.state is curve.state and "state" in function._inputs()
    with pytest.raises(stoss.InvalidInput, match="beyond"):
        curve.function(beyond="law")


def test_ctrl_c(interpreter):
    code = (
        "import _thread, threading, time, stoss\n"
        "threading.Timer(0.3, _thread.interrupt_main).start()\n"
        "begin = time.time()\n"
        "try: stoss.restitution_function(poisson=0.33, speed=(1e-7, 0.6), error=2e-6)\n"
        "except KeyboardInterrupt: print('stopped', time.time() - begin < 20)\n"
    )
    done = interpreter.run(code)
    assert done.stdout.strip() == "stopped True", done.stdout + done.stderr


def test_picture(epsilon, in_si):
    plt = pytest.importorskip("matplotlib.pyplot")
    ax = epsilon.plot()
    assert ax.get_xlabel() == "speed of approach v / c" and len(ax.collections) >= 1
    (curve, *_), (bars,) = ax.lines, ax.containers
    assert curve.get_xdata()[0] == 1e-3 and curve.get_xdata()[-1] == 0.3
    assert np.array_equal(bars.lines[0].get_ydata(), epsilon.restitution)
    assert stoss.plot.function(in_si, ax, label="rubber") is ax and ax.get_xlabel() == "speed of approach v / (m/s)"
    plt.close("all")


def test_csv(epsilon, in_si, tmp_path):
    for function in (epsilon, in_si):
        function.to_csv(tmp_path / "function.csv")
        table = stoss.read_csv(tmp_path / "function.csv")
        assert table.kind == "function" and table.units["speed"] == "c" and table.inputs["beyond"] == function.beyond
        assert np.array_equal(table["restitution"], function.restitution)
        assert np.array_equal(table["interpolation_error"][:-1], function.interpolation_error)
