"""Bodies that vibrate before the impact: time reversed, conserved, repeated, and refused."""

import copy
import json
import pickle

import numpy as np
import pytest

import stoss

BALL = stoss.Sphere(poisson=0.3)
RINGING = stoss.Oscillation(order=2, index=0, energy=0.1, phase=2.0)


@pytest.fixture(scope="module")
def ringing():
    """An impact of a ball that vibrates, at little cost."""
    return stoss.impact(BALL, speed=0.01, cutoff=15, state=RINGING)


@pytest.mark.parametrize(
    "body, against, speed",
    [
        (stoss.Disk(poisson=0.33), stoss.HardWall(), 0.1),
        (stoss.Sphere(poisson=0.3), stoss.HardWall(), 0.05),
        (stoss.Disk(poisson=0.33), stoss.ExponentialWall(hardness=300), 0.1),
    ],
)
def test_an_impact_without_radiation_runs_backwards(body, against, speed):
    there = stoss.impact(body, against=against, speed=speed, cutoff=12, tail="static")
    back = np.array(there.state_after(flight=0.0))
    back["phase"] *= -1.0
    again = stoss.impact(body, against=against, speed=there.restitution * speed, cutoff=12, tail="static", state=back)
    assert 1 - there.restitution > 1e-3
    assert again.restitution * there.restitution == pytest.approx(1.0, abs=2e-5)
    assert again.restitution > 1 and again.lost_fraction < 0


def test_free_flight_turns_phases_only(hit):
    start, later = (hit.state_after(flight=flight) for flight in (0.0, 7.5))
    assert np.array_equal(start["energy"], later["energy"]) or later["energy"] == pytest.approx(start["energy"])
    omega = {(m["order"], m["index"]): m["omega"] for m in hit.mode_energies}
    turned = [omega[(m["order"], m["index"])] * 7.5 for m in start]
    off = np.remainder(later["phase"] - start["phase"] - turned + np.pi, 2 * np.pi) - np.pi
    assert np.abs(off).max() < 1e-9
    assert start["energy"].sum() == pytest.approx(hit.vibration / hit.translation, rel=1e-12)


def test_lossy_bodies_come_to_rest():
    lossy = stoss.impact(stoss.Sphere(poisson=0.3, loss_time=0.1), speed=0.05, cutoff=12)
    energy = [lossy.state_after(flight=flight)["energy"].sum() for flight in (0.0, 20.0, 1e3)]
    assert energy[0] > energy[1] > energy[2] and energy[2] < 1e-6 * energy[0]


def test_waves_of_a_half_space_run_away():
    met = stoss.HalfSpace(poisson=0.3, young=4.0)
    hit = stoss.impact(BALL, against=met, speed=0.01, cutoff=12, state=RINGING)
    assert set(hit.state_after(flight=10)["body"]) == {0}
    wave = hit.wave(time=3.0, distance=[0.0, 0.5], depth=[0.0, 0.5])
    still = stoss.impact(BALL, against=met, speed=0.01, cutoff=12).wave(time=3.0, distance=[0.0, 0.5], depth=[0.0, 0.5])
    assert np.abs(wave.normal - still.normal).max() > 1e-4 * np.abs(still.normal).max()


def test_each_of_two_bodies_may_vibrate():
    two = stoss.Sphere(poisson=0.2, radius=1.5)
    modes = [stoss.Oscillation(2, 0, 0.05, 1.0), stoss.Oscillation(3, 0, 0.1, -1.0, of=1)]
    pair = stoss.impact(BALL, against=two, speed=0.02, cutoff=12, state=modes)
    held = pair.mode_energies[pair.mode_energies["before"] > 0]
    assert held[["body", "order", "index"]].tolist() == [(0, 2, 0), (1, 3, 0)]
    assert held["before"] == pytest.approx(np.array([0.05, 0.1]) / 1.15, rel=1e-9)
    assert pair.translation + pair.vibration + pair.unresolved == pytest.approx(1.0, abs=1e-3)
    assert pair.restitution**2 == pytest.approx(pair.translation * 1.15, rel=1e-9)


def test_the_ledger_starts_with_what_is_given(ringing):
    path = ringing.trajectory()
    assert path.vibration[0] == pytest.approx(0.1 / 1.1, rel=1e-9)
    assert path.velocity[-1] == -ringing.restitution * ringing.speed
    assert ringing.energies_at(time=0)["energy"] == pytest.approx(ringing.mode_energies["before"], abs=1e-14)
    assert ringing.state.tolist() == [(0, 2, 0, 0.1, 2.0)]
    field = ringing.field(time=0.0, radius=[0.5, 1.0])
    assert field.x.shape[0] == 2


def test_a_state_is_given_in_several_ways(ringing):
    for state in ([RINGING], (RINGING,), ringing.state, np.array(ringing.state), stoss.Oscillation(2, 0, 0.1, phase=2)):
        again = stoss.impact(BALL, speed=0.01, cutoff=15, state=state)
        assert again.restitution == ringing.restitution
    at_rest = stoss.impact(BALL, speed=0.01, cutoff=15)
    for state in ([], None, np.zeros(0, ringing.state.dtype)):
        empty = stoss.impact(BALL, speed=0.01, cutoff=15, state=state)
        assert empty.restitution == at_rest.restitution and empty.state is None


def test_copies_are_the_same_bit_by_bit(ringing):
    for again in (pickle.loads(pickle.dumps(ringing)), copy.deepcopy(ringing)):
        assert np.array_equal(again.mode_energies, ringing.mode_energies)
        assert again.state.tolist() == ringing.state.tolist() and not again.state.flags.writeable


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


def test_restitution_is_that_of_impacts():
    phases = np.linspace(0, 2 * np.pi, 5)[:-1]
    for phase in phases:
        state = stoss.Oscillation(2, 0, 0.1, phase)
        value = stoss.restitution(BALL, speed=0.01, state=state)
        fine = stoss.impact(BALL, speed=0.01, cutoff=100, state=state)
        assert value.converged and value.lost_fraction == pytest.approx(
            fine.lost_fraction, abs=2 * value.lost_fraction_error + 1e-5
        )


def test_restitution_at_any_number_of_threads():
    one, many = (
        stoss.restitution(BALL, speed=[0.01, 0.02, 0.1], state=RINGING, threads=threads) for threads in (1, 3)
    )
    assert np.array_equal(one.restitution, many.restitution) and one.restitution[0] > 1


@pytest.mark.parametrize(
    "state, message",
    [
        (stoss.Oscillation(2, 0, np.nan), "energy: got nan, allowed 0 to 1e12"),
        (stoss.Oscillation(2, 0, -0.1), "energy: got -0.1, allowed 0 to 1e12"),
        (stoss.Oscillation(2, 0, np.inf), "energy: got inf"),
        (stoss.Oscillation(2, 0, 0.1, np.nan), "phase: got nan"),
        (stoss.Oscillation(2, 400, 0.1), r"vibration: got (a )?mode"),
        (stoss.Oscillation(-1, 0, 0.1), r"vibration: got (a )?mode"),
        ([RINGING, RINGING], "twice, allowed once"),
        (stoss.Oscillation(2, 0, 0.1, of=1), r"mode of body 1, allowed 0 \(a wall has no modes\)"),
        (0.1, r"state: got 0.1, allowed a stoss.Oscillation, a sequence of them, or an array with the fields body"),
        ([RINGING, None], "state: got None"),
        ("ringing", "state: got 'ringing'"),
    ],
)
@pytest.mark.parametrize("compute", [stoss.impact, stoss.restitution])
def test_refusals(compute, state, message):
    with pytest.raises(stoss.InvalidInput, match=message) as caught:
        compute(BALL, speed=0.01, state=state)
    assert "\n" not in str(caught.value)


def test_waves_cannot_be_there_before():
    with pytest.raises(stoss.InvalidInput, match="allowed modes of bodies that are there as a whole"):
        stoss.impact(BALL, against=stoss.HalfSpace(), speed=0.01, cutoff=12, state=stoss.Oscillation(0, 0, 0.1, of=1))


@pytest.mark.parametrize("given, name", [(("2", 0, 0.1), "order"), ((2, 0.5, 0.1), "index"), ((2, 0, "x"), "energy")])
def test_oscillations_are_numbers(given, name):
    with pytest.raises(stoss.InvalidInput, match=f"^{name}: got"):
        stoss.Oscillation(*given)


@pytest.mark.parametrize("flight", [-1.0, np.nan, np.inf, "soon"])
def test_flights_are_times(hit, flight):
    with pytest.raises(stoss.InvalidInput, match="^flight: got"):
        hit.state_after(flight=flight)


def test_picture_of_what_was_given_and_taken(ringing, closed):
    ax = stoss.plot.ledger(ringing)
    assert "before" in [text.get_text() for text in ax.get_legend().get_texts()]
    (lines,) = ax.collections
    (line,) = lines.get_segments()
    assert line[:, 1] == pytest.approx(0.1 / 1.1, rel=1e-9)
    assert line[:, 0].mean() == pytest.approx(2 - 1.5 * 0.84 / 4)
    assert not stoss.plot.ledger(ringing, when="average").collections
