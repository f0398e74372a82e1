"""Ensembles of bodies that vibrate: statistics, repetition, files, pictures, refusals."""

import copy
import json
import pickle
import signal
import subprocess
import sys

import numpy as np
import pytest

import stoss

BALL = stoss.Sphere(poisson=0.3)


def warm(**changes):
    asked = {"speed": 0.01, "temperature": 0.01, "samples": 40, "seed": 7} | changes
    return stoss.restitution_distribution(BALL, **asked)


@pytest.fixture(scope="module")
def ensemble():
    return warm()


def test_statistics(ensemble):
    values = ensemble.restitution
    assert len(ensemble) == 40 and ensemble.sample.tolist() == list(range(40)) and ensemble.converged.all()
    assert ensemble.mean == pytest.approx(values.mean(), rel=1e-14)
    assert ensemble.spread == pytest.approx(values.std(ddof=1), rel=1e-10)
    assert ensemble.mean_error == pytest.approx(values.std(ddof=1) / np.sqrt(40), rel=1e-10)
    assert ensemble.numerical_error == pytest.approx(ensemble.restitution_error.mean(), rel=1e-10)
    assert ensemble.above_one == np.mean(values > 1) > 0
    count, edges = ensemble.histogram(bins=6)
    assert count.sum() == 40 and edges[0] == values.min() and edges[-1] == values.max()


def test_energies_are_those_of_the_spectrum():
    many = warm(samples=400, error=0.5)
    mean, modes = many.vibration.mean(), len(many.spectrum)
    # The sum of n exponential energies has the mean n T and the variance n T².
    assert abs(mean - 0.01 * modes) < 4 * 0.01 * np.sqrt(modes / 400)
    assert many.vibration.var() == pytest.approx(modes * 1e-4, rel=0.3)


@pytest.mark.parametrize("threads", [1, 3])
def test_threads_change_nothing(ensemble, threads):
    again = warm(threads=threads)
    assert np.array_equal(again.restitution, ensemble.restitution) and again.mean == ensemble.mean


def test_samples_depend_on_seed_and_number_only(ensemble):
    assert np.array_equal(warm(samples=10).restitution, ensemble.restitution[:10])
    assert not np.any(warm(samples=10, seed=8).restitution == ensemble.restitution[:10])


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


def test_files_and_copies(ensemble, tmp_path):
    ensemble.to_csv(tmp_path / "it.csv")
    lines = (tmp_path / "it.csv").read_text().splitlines()
    assert "# temperature: 0.01" in lines and "# seed: 7" in lines
    assert sum(not line.startswith("#") for line in lines) == 41
    values = json.loads(json.dumps(ensemble.to_dict()))
    assert values["mean"] == ensemble.mean and len(values["restitution"]) == 40
    for again in (pickle.loads(pickle.dumps(ensemble)), copy.deepcopy(ensemble)):
        assert np.array_equal(again.restitution, ensemble.restitution) and again.mean == ensemble.mean
    with pytest.raises(ValueError, match="read-only"):
        ensemble.restitution[0] = 1.0


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


CHILD = """
import signal, stoss
signal.signal(signal.SIGINT, signal.default_int_handler)
print("ready", flush=True)
try:
    stoss.restitution_distribution(
        stoss.Sphere(poisson=0.3), speed=0.01, temperature=0.01, samples=100000, seed=7, error=1e-5, progress=True)
except stoss.Interrupted as caught:
    best = caught.best
    print(len(best), repr(float(best.restitution[0])), caught)
"""


def test_interrupt_keeps_what_is_done(interpreter):
    child = interpreter.start(CHILD, stderr=subprocess.PIPE)
    try:
        assert child.stdout.readline() == "ready\n"
        seen = ""
        while " 3/100000" not in seen and "3/100000 " not in seen:  # the bar
            seen += child.stderr.read(1)
        child.send_signal(signal.SIGINT)
        count, first, text = child.communicate(timeout=10)[0].split(maxsplit=2)
    finally:
        child.kill()
        child.wait()
    assert int(count) >= 3 and f"interrupted after {count} of 100000 samples (they are in .best)" in text
    assert float(first) == warm(samples=1, error=1e-5).restitution[0]


@pytest.mark.skipif(sys.platform == "win32", reason="no stderr to look at")
def test_progress(interpreter):
    result = interpreter.run(
        "import stoss; stoss.restitution_distribution(poisson=0.33, speed=0.1, temperature=0.1, samples=3, "
        "progress=True)"
    )
    assert "3/3" in result.stderr and not result.stdout


@pytest.mark.parametrize(
    "changes, message",
    [
        ({"temperature": None}, "temperature: got neither, allowed one of temperature and spectrum"),
        ({"spectrum": [stoss.Oscillation(2, 0, 1.0)]}, "temperature: got temperature and spectrum"),
        ({"temperature": -1.0}, "temperature: got -1, allowed 0 to 1e6"),
        ({"temperature": np.nan}, "temperature: got nan"),
        ({"temperature": np.inf}, "temperature: got inf"),
        ({"temperature": "warm"}, "temperature: got 'warm'"),
        ({"highest": 0.5}, "highest: got 0.5, allowed from 1.64"),
        ({"highest": 1e4}, "highest: got 10000, allowed above 0 to 128"),
        ({"highest": np.nan}, "highest: got nan"),
        ({"temperature": None, "spectrum": lambda omega: np.nan}, "energy: got nan, allowed 0 to 1e6"),
        ({"temperature": None, "spectrum": lambda omega: "x"}, "spectrum: got 'x'"),
        ({"temperature": None, "spectrum": 3.0}, "spectrum: got 3.0, allowed a stoss.Oscillation"),
        ({"temperature": None, "spectrum": [stoss.Oscillation(2, 0, 1.0)] * 2}, "twice, allowed once"),
        ({"temperature": None, "spectrum": stoss.Oscillation(2, 0, 1.0, of=1)}, "a wall has no modes"),
        ({"samples": 0}, "samples: got 0, allowed 1 to 1000000"),
        ({"samples": 1.5}, "samples: got 1.5, allowed an integer"),
        ({"seed": -1}, "seed: got -1, allowed 0 to 2147483647"),
        ({"error": 0.0}, "error: got 0, allowed 1e-9 to 0.5"),
        ({"threads": -1}, "threads: got -1"),
        ({"speed": 2.0}, "speed: got 2"),
        ({"speed": [0.1, 0.2]}, r"speed: got \[0.1, 0.2\], allowed one number"),
        ({"against": stoss.ExponentialWall()}, "against: got ExponentialWa"),
        ({"progress": 1}, "progress: got 1, allowed True or False"),
    ],
)
def test_refusals(changes, message):
    with pytest.raises(stoss.InvalidInput, match=message) as caught:
        warm(**changes)
    assert "\n" not in str(caught.value)


def test_picture(ensemble, closed):
    ax = ensemble.plot()
    mean, at_rest = (line.get_xdata()[0] for line in ax.lines)
    assert mean == ensemble.mean
    assert at_rest == pytest.approx(stoss.restitution(BALL, speed=0.01).restitution, abs=1e-3)
    assert [text.get_text()[:4] for text in ax.get_legend().get_texts()] == ["mean", "at r"]
    (steps,) = ax.patches
    assert steps.get_data().values.sum() == 40
    assert stoss.plot.distribution(ensemble, ax, bins=3) is ax
    with pytest.raises(stoss.InvalidInput, match="result: got"):
        stoss.plot.distribution(stoss.restitution(BALL, speed=0.01))
