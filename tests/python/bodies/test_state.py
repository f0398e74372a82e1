"""Bodies that vibrate before the impact, impacts with some of the modes only, and the energy of each mode in time."""

import json

import numpy as np
import pytest

import stoss

BALL = stoss.Sphere(poisson=0.3)
RINGING = stoss.Oscillation(order=2, index=0, energy=0.1, phase=2.0)


@pytest.fixture(scope="module")
def ringing():
    """An impact of a ball that vibrates, at little cost."""
    return stoss.impact(BALL, speed=0.01, cutoff=15, state=RINGING)


def test_free_flight_turns_phases_only(hit):
    start, later = (hit.state_after(flight=flight) for flight in (0.0, 7.5))
    assert np.array_equal(start["energy"], later["energy"]) or later["energy"] == pytest.approx(start["energy"])
    omega = {(m["order"], m["index"]): m["omega"] for m in hit.mode_energies}
    turned = [omega[(m["order"], m["index"])] * 7.5 for m in start]
    off = np.remainder(later["phase"] - start["phase"] - turned + np.pi, 2 * np.pi) - np.pi
    assert np.abs(off).max() < 1e-9
    assert start["energy"].sum() == pytest.approx(hit.vibration / hit.translation, rel=1e-12)


def test_waves_of_a_half_space_run_away():
    met = stoss.HalfSpace(poisson=0.3, young=4.0)
    hit = stoss.impact(BALL, against=met, speed=0.01, cutoff=12, state=RINGING)
    assert set(hit.state_after(flight=10)["body"]) == {0}
    wave = hit.wave(time=3.0, distance=[0.0, 0.5], depth=[0.0, 0.5])
    still = stoss.impact(BALL, against=met, speed=0.01, cutoff=12).wave(time=3.0, distance=[0.0, 0.5], depth=[0.0, 0.5])
    assert np.abs(wave.normal - still.normal).max() > 1e-4 * np.abs(still.normal).max()


def test_a_state_is_given_in_several_ways(ringing):
    for state in ([RINGING], (RINGING,), ringing.state, np.array(ringing.state), stoss.Oscillation(2, 0, 0.1, phase=2)):
        again = stoss.impact(BALL, speed=0.01, cutoff=15, state=state)
        assert again.restitution == ringing.restitution
    at_rest = stoss.impact(BALL, speed=0.01, cutoff=15)
    for state in ([], None, np.zeros(0, ringing.state.dtype)):
        empty = stoss.impact(BALL, speed=0.01, cutoff=15, state=state)
        assert empty.restitution == at_rest.restitution and empty.state is None


def test_files_say_how_the_bodies_vibrated(ringing, tmp_path):
    curve = stoss.restitution(BALL, speed=[0.01, 0.1], state=RINGING)
    for result in (ringing, curve):
        result.to_csv(tmp_path / "it.csv")
        head = "# state: mode (2, 0) of the first body with energy 0.1 and phase 2.0"
        assert head in (tmp_path / "it.csv").read_text().splitlines()
        values = json.loads(json.dumps(result.to_dict()))
        assert values["state"] == [{"body": 0, "order": 2, "index": 0, "energy": 0.1, "phase": 2.0}]
    many = stoss.impact(BALL, speed=0.01, cutoff=15, state=ringing.state_after(flight=1.0))
    many.to_csv(tmp_path / "many.csv")
    assert "modes with energy" in (tmp_path / "many.csv").read_text()


def test_picture_of_what_was_given_and_taken(ringing, closed):
    ax = stoss.plot.ledger(ringing)
    assert "before" in [text.get_text() for text in ax.get_legend().get_texts()]
    (lines,) = ax.collections
    (line,) = lines.get_segments()
    assert line[:, 1] == pytest.approx(0.1 / 1.1, rel=1e-9)
    assert line[:, 0].mean() == pytest.approx(2 - 1.5 * 0.84 / 4)
    assert not stoss.plot.ledger(ringing, when="average").collections


SOFT = stoss.ExponentialWall(hardness=100)
COMMON = {"poisson": 0.33, "speed": 0.1, "cutoff": 12, "against": SOFT, "tail": "none"}


@pytest.fixture(scope="module")
def whole():
    return stoss.impact(**COMMON)


@pytest.fixture(scope="module")
def keep(whole):
    """The forty most energetic."""
    average = whole.mode_energies["average"]
    return average >= np.sort(average)[-40]


@pytest.fixture(scope="module")
def some(keep):
    return stoss.impact(**COMMON, keep=keep)


def test_only_the_chosen_modes_have_energies(whole, some, keep):
    assert some.modes == len(some.mode_energies) == 40 and some.cutoff == whole.cutoff
    for name in ("order", "index", "omega"):
        assert np.array_equal(some.mode_energies[name], whole.mode_energies[name][keep])
    assert some.restitution != whole.restitution
    assert some.mode_energies["after"].sum() == pytest.approx(some.vibration, rel=1e-12)


def test_the_selection_goes_with_the_result(some, keep):
    assert np.array_equal(some.keep, keep) and not some.keep.flags.writeable
    keep_again = keep.copy()
    given = stoss.impact(**COMMON, keep=keep_again)
    keep_again[:] = False
    assert np.array_equal(given.keep, keep)
    path = some.trajectory()
    assert -path.velocity[-1] / path.velocity[0] == pytest.approx(some.restitution, rel=1e-12)
    assert np.isfinite(some.field(time=2.0, radius=[0.5, 1.0], angle=[0.0]).x).all()


def test_it_is_told(some, whole, keep, tmp_path):
    assert some.to_dict()["keep"] == keep.tolist() and "keep" not in whole.to_dict()
    some.to_csv(tmp_path / "some.csv")
    assert f"# keep: 40 of {keep.size} modes" in (tmp_path / "some.csv").read_text(encoding="utf-8").splitlines()


def test_energies_in_time_are_those_of_the_trajectory(some):
    path = some.trajectory(every=50)
    energies = some.energies_at(time=path.time)
    assert energies.shape == (len(path), some.modes) and not energies.flags.writeable
    assert energies.dtype.names == ("body", "order", "index", "omega", "energy")
    assert energies["energy"].sum(axis=1) == pytest.approx(path.vibration, abs=1e-12)
    for name in ("order", "index", "omega"):
        assert np.array_equal(energies[name][0], some.mode_energies[name])
    # Before the impact nothing vibrates, after it the energies stay.
    assert energies["energy"][0].max() < 1e-10
    late = some.energies_at(time=[path.time[-1], path.time[-1] + 100])
    assert late["energy"] == pytest.approx(np.tile(some.mode_energies["after"], (2, 1)), abs=1e-12)


def test_energies_take_times_of_any_shape_and_order(whole):
    times = np.array([[3.0, 1.0], [2.0, 3.0]])
    energies = whole.energies_at(time=times)
    assert energies.shape == (2, 2, whole.modes)
    for at in np.ndindex(2, 2):
        one = whole.energies_at(time=times[at])
        assert one.shape == (whole.modes,) and np.array_equal(one, energies[at])
    assert np.array_equal(energies[0, 0], energies[1, 1])
    assert whole.energies_at(time=[]).shape == (0, whole.modes)
