"""Sequences of impacts of a body that comes back."""

import json
import pickle
import signal
import time

import numpy as np
import pytest

import stoss

BALL = stoss.Sphere(poisson=0.3)


def test_a_first_vibration_is_that_of_the_command(command):
    records = command("bounce --body disk --poisson 0.33 --speed 0.1 --count 3 --flight-time 20 --mode 2,0,energy=0.2,phase=1")
    ringing = stoss.Oscillation(order=2, index=0, energy=0.2, phase=1)
    ours = stoss.bounce(poisson=0.33, speed=0.1, count=3, flight_time=20, state=ringing)
    assert ours.restitution.tolist() == [record["restitution"] for record in records["records"]]
    assert ours.vibration_before[0] == pytest.approx(0.2 / 1.2)
    first = stoss.impact(poisson=0.33, speed=0.1, cutoff=20, state=ringing)
    assert ours.restitution[0] == first.restitution
    second = stoss.impact(
        poisson=0.33, speed=ours.speed[1], cutoff=20, state=first.state_after(flight=20)
    )  # fmt: skip
    assert ours.restitution[1] == pytest.approx(second.restitution, abs=1e-10)


@pytest.mark.parametrize("tail", ["radiating", "static"])
def test_without_memory_every_impact_is_that_of_impact(tail):
    sequence = stoss.bounce(BALL, tail=tail, speed=0.1, count=4, flight_time=30, decay_time=0, cutoff=12)
    single = [stoss.impact(BALL, tail=tail, speed=speed, cutoff=12).restitution for speed in sequence.speed]
    assert sequence.restitution.tolist() == single


def test_a_material_has_si():
    steel = stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=1e9)
    ball = stoss.Sphere(radius=0.01, material=steel)
    with pytest.warns(stoss.StossWarning, match="yields"):
        fall = stoss.bounce(ball, speed=1.0, count=3, gravity=9.81, decay_time=1e-3)
    left = fall.speed_si * fall.restitution
    np.testing.assert_allclose(fall.flight_time_si, 2 * left / 9.81, rtol=1e-12)
    assert fall.beyond_yield.all()
    own = stoss.bounce(
        BALL, speed=fall.speed[0], count=3, gravity=fall.gravity, decay_time=fall.decay_time
    )  # fmt: skip
    np.testing.assert_allclose(own.restitution, fall.restitution, rtol=1e-12)


def test_results_are_frozen_and_can_be_kept(tmp_path):
    sequence = stoss.bounce(BALL, speed=0.05, count=4, flight_time=30, cutoff=12)
    with pytest.raises(ValueError):
        sequence.restitution[0] = 1.0
    with pytest.raises(AttributeError):
        sequence.restitution = 1.0
    again = pickle.loads(pickle.dumps(sequence))
    assert again.restitution.tolist() == sequence.restitution.tolist() and repr(again) == repr(sequence)
    assert json.loads(json.dumps(sequence.to_dict()))["restitution"] == sequence.restitution.tolist()
    sequence.to_csv(tmp_path / "sequence.csv")
    assert len((tmp_path / "sequence.csv").read_text().splitlines()) == 5 + 5


@pytest.mark.parametrize(
    "arguments, said",
    [
        ({}, "neither"),
        ({"flight_time": 1, "gravity": 1}, "exactly one"),
        ({"flight_time": 0}, "above 0"),
        ({"flight_time": np.nan}, "flight_time"),
        ({"gravity": -1}, "gravity"),
        ({"flight_time": 1, "decay_time": -1}, "decay_time"),
        ({"flight_time": 1, "count": 0}, "count"),
        ({"flight_time": 1, "count": 1.5}, "count"),
        ({"flight_time": 1, "against": "same"}, "against"),
        ({"flight_time": 1, "cutoff": -1}, "cutoff"),
        ({"flight_time": "soon"}, "flight_time"),
    ],
)
def test_bad_input_is_one_line(arguments, said):
    with pytest.raises(stoss.InvalidInput) as caught:
        stoss.bounce(BALL, speed=0.1, **arguments)
    assert said in str(caught.value) and "\n" not in str(caught.value)


def test_what_is_done_is_kept_when_the_speed_leaves_its_range():
    with pytest.raises(stoss.NotConverged, match="1e-8 to 1") as caught:
        stoss.bounce(poisson=0.33, speed=1e-8, count=3, flight_time=9)
    assert len(caught.value.best) == 1


def test_ctrl_c_keeps_what_is_done(interpreter):
    child = interpreter.start(
        "import stoss\nprint('ready', flush=True)\ntry:\n"
        "    stoss.bounce(poisson=0.33, speed=0.1, count=10**8, flight_time=30)\n"
        "except stoss.Interrupted as stopped:\n    print(len(stopped.best), stopped.best.number[-1])\n"
    )
    assert child.stdout.readline() == "ready\n"
    time.sleep(0.5)
    child.send_signal(signal.SIGINT)
    done, last = child.communicate(timeout=20)[0].split()
    assert done == last and int(done) > 3


def test_a_short_flight_is_said():
    with pytest.warns(stoss.StossWarning, match="1 flights too short"):
        sequence = stoss.bounce(poisson=0.33, speed=0.1, count=2, flight_time=1e-3, cutoff=12)
    assert sequence.short_flight.tolist() == [False, True]


def test_the_picture_shows_both(closed):
    pytest.importorskip("matplotlib")
    sequence = stoss.bounce(BALL, speed=0.05, count=8, flight_time=30, decay_time=40, cutoff=12)
    upper = sequence.plot()
    rest, points = upper.get_lines()
    assert points.get_ydata().tolist() == sequence.restitution.tolist()
    single = [stoss.impact(BALL, speed=speed, cutoff=12).restitution for speed in sequence.speed]
    np.testing.assert_allclose(rest.get_ydata(), single, rtol=1e-12)
    lower = upper.figure.axes[-1]
    tops = [area.get_paths()[0].vertices[:, 1].max() for area in lower.collections]
    assert tops == pytest.approx([sequence.translation.max(), *tops[1:]], rel=1e-12)
    assert tops[-1] == pytest.approx(1, abs=1e-3)
    labels = [text.get_text() for text in lower.get_legend().get_texts()]
    assert labels == ["translation", "vibration", "dissipated", "above the cutoff"]


def test_the_picture_goes_where_one_wants_it(closed):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    figure, (left, right) = pyplot.subplots(1, 2)
    sequence = stoss.bounce(BALL, speed=0.05, count=80, flight_time=30, cutoff=12)
    assert sequence.plot(right) is right
    assert len(figure.axes) == 3 and not left.has_data()
    free = figure.add_axes((0.1, 0.1, 0.2, 0.2))
    with pytest.raises(stoss.InvalidInput, match="subplots"):
        sequence.plot(free)
