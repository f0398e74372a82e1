"""Sequences of impacts of a body that comes back, ensembles of bodies that vibrate, and chains of rods."""

import csv
import json

import numpy as np
import pytest
import stoss

BALL = stoss.Sphere(poisson=0.3)


def test_what_is_done_is_kept_when_the_speed_leaves_its_range():
    with pytest.raises(stoss.NotConverged, match="1e-8 to 1") as caught:
        stoss.bounce(poisson=0.33, speed=1e-8, count=3, flight_time=9)
    assert len(caught.value.best) == 1


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


def warm(**changes):
    asked = {"speed": 0.01, "temperature": 0.01, "samples": 40, "seed": 7} | changes
    return stoss.restitution_distribution(BALL, **asked)


@pytest.fixture(scope="module")
def ensemble():
    return warm()


def test_spectrum_in_several_ways(ensemble):
    ways = [lambda omega: 0.01, [stoss.Oscillation(m["order"], m["index"], m["energy"]) for m in ensemble.spectrum]]
    for spectrum in ways:
        same = warm(temperature=None, spectrum=spectrum, samples=5)
        assert np.array_equal(same.restitution, ensemble.restitution[:5]) and same.temperature is None
    seen = []
    falling = warm(temperature=None, spectrum=lambda omega: seen.append(omega) or 0.1 * np.exp(-omega), samples=2)
    modes = stoss.modes(BALL, cutoff=10)
    assert seen == pytest.approx(modes.omega.tolist(), rel=1e-12)
    assert falling.spectrum["energy"] == pytest.approx(0.1 * np.exp(-modes.omega), rel=1e-9)


def test_two_bodies_and_half_spaces():
    pair = stoss.restitution_distribution(BALL, against="same", speed=0.02, temperature=0.02, samples=5, highest=5)
    assert set(pair.spectrum["body"]) == {0, 1} and "against Sphere" in repr(pair)
    ground = stoss.restitution_distribution(BALL, against=stoss.HalfSpace(), speed=0.02, temperature=0.02, samples=3)
    assert set(ground.spectrum["body"]) == {0}
    assert ground.restitution.max() < pair.restitution.min()  # waves run away for good


def test_one_sample_has_no_spread():
    one = warm(samples=1)
    assert one.mean == one.restitution[0] and one.spread == np.inf == one.mean_error
    assert one.to_dict()["mean_error"] == "unknown" and "unknown" in repr(one)


def test_what_is_not_as_accurate_is_marked():
    with pytest.warns(stoss.StossWarning, match="3 of 3 samples not as accurate as asked for"):
        rods = stoss.restitution_distribution(
            stoss.Rod(), against=stoss.Rod(length=2.5), speed=0.1, temperature=0.1, samples=3, error=1e-5
        )
    assert not rods.converged.any() and all(rods.reason) and np.isfinite(rods.mean)


def test_picture_of_an_ensemble(ensemble, closed):
    ax = ensemble.plot()
    mean, unexcited = (line.get_xdata()[0] for line in ax.lines)
    assert mean == ensemble.mean
    assert unexcited == pytest.approx(stoss.restitution(BALL, speed=0.01).restitution, abs=1e-3)
    assert [text.get_text()[:4] for text in ax.get_legend().get_texts()] == ["mean", "unex"]
    count, edges = ensemble.histogram(bins=6)
    assert count.sum() == 40 and (edges[0], edges[-1]) == (ensemble.restitution.min(), ensemble.restitution.max())
    assert ensemble.above_one == np.mean(ensemble.restitution > 1) > 0
    (steps,) = ax.patches
    assert steps.get_data().values.sum() == 40
    assert stoss.plot.distribution(ensemble, ax, bins=3) is ax
    with pytest.raises(stoss.InvalidInput, match="result: got"):
        stoss.plot.distribution(stoss.restitution(BALL, speed=0.01))


RODS = [stoss.Rod(length=length) for length in (1.0, 1.2, 0.9, 1.1)]


def chain(**changed):
    given = {"circumference": 40.0, "temperature": 1.0, "seed": 3, "collisions": 100} | changed
    return stoss.rod_chain(RODS, **given)


def test_velocities_are_drawn_or_given():
    drawn = chain()
    given = chain(temperature=None, velocities=drawn.velocities)
    assert np.array_equal(given.impacts, drawn.impacts)
    assert not np.array_equal(chain(seed=4).velocities, drawn.velocities)


def test_time_ends_a_chain():
    gas = chain(collisions=None, time=12.5, method="characteristics")
    assert gas.time[-1] == 12.5
    assert gas.impacts["time"].max() <= 12.5


def test_materials_give_si(tmp_path):
    steel = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
    rods = [stoss.Rod(length=length, area=1e-4, material=steel) for length in (0.1, 0.12)]
    gas = stoss.rod_chain(rods, circumference=2.0, velocities=[0.1, -0.1], collisions=20, method="characteristics")
    masses = 7850 * 1e-4 * np.array([0.1, 0.12])
    drift = 0.1 * (masses[0] - masses[1]) / masses.sum()
    assert gas.translation[0] == pytest.approx(0.5 * (masses * (np.array([0.1, -0.1]) - drift) ** 2).sum())
    gas.to_csv(tmp_path / "gas.csv")
    lines = [line for line in (tmp_path / "gas.csv").read_text().splitlines() if not line.startswith("#")]
    assert lines[0].startswith("time[s],collisions,translation[J]")
    assert len(list(csv.reader(lines))) == gas.time.size + 1
    json.dumps(gas.to_dict())


def test_collapse_keeps_what_is_done():
    rods = [stoss.Rod(length=0.3 if k % 2 else 1.0) for k in range(30)]
    with pytest.raises(stoss.NotConverged, match="inelastic collapse") as caught:
        stoss.rod_chain(rods, circumference=200, temperature=1, collisions=10**6, decay_time=0, method="characteristics")
    assert len(caught.value.best) > 2000
    assert "\n" not in str(caught.value)


def test_pictures():
    pyplot = pytest.importorskip("matplotlib.pyplot")
    damped = chain(decay_time=2, method="characteristics", collisions=1000)
    axes = damped.plot()
    assert [line.get_label() for line in axes.lines] == ["translation", "vibration", "∝ t⁻²"]
    law = axes.lines[2].get_xydata()
    assert np.diff(np.log(law[:, 1])) == pytest.approx(-2 * np.diff(np.log(law[:, 0])), abs=1e-9)
    assert damped.histogram().get_ylabel() == "probability density"
    for empty in (chain(collisions=0), chain(temperature=0)):
        empty.plot()
        empty.histogram()
    pyplot.close("all")
