"""Chains of rods: the numbers are those of the core, pictures are drawn, and what cannot be is
refused."""

import csv
import json

import numpy as np
import pytest

import stoss

RODS = [stoss.Rod(length=length) for length in (1.0, 1.2, 0.9, 1.1)]


def chain(**changed):
    given = {"circumference": 40.0, "temperature": 1.0, "seed": 3, "collisions": 100} | changed
    return stoss.rod_chain(RODS, **given)


def test_ledger_closes():
    for method in ("modes", "characteristics"):
        gas = chain(method=method, modes=10, decay_time=30)
        total = gas.translation + gas.vibration + gas.dissipated + gas.unresolved
        assert total == pytest.approx(np.full(total.size, total[0]), rel=1e-12)
        assert gas.collisions[-1] == len(gas) == 100
        assert gas.time[-1] == gas.impacts["time"][-1]
        kinetic = sum(0.5 * rod.length * speed**2 for rod, speed in zip(RODS, gas.velocity))
        assert gas.translation[-1] == pytest.approx(kinetic, rel=1e-12)


def test_velocities_are_drawn_or_given():
    drawn = chain()
    given = chain(temperature=None, velocities=drawn.velocities)
    assert np.array_equal(given.impacts, drawn.impacts)
    assert not np.array_equal(chain(seed=4).velocities, drawn.velocities)


def test_damped_rods_meet_as_two_by_themselves():
    gas = chain(decay_time=0, method="characteristics")
    # Of equal material and section ε is the ratio of the lengths (docs/theory/pairs.md).
    lengths = np.array([rod.length for rod in RODS])
    ratio = np.minimum(lengths, np.roll(lengths, -1)) / np.maximum(lengths, np.roll(lengths, -1))
    assert gas.restitution == pytest.approx(ratio[gas.pair], rel=1e-12)
    assert chain(decay_time=0).restitution == pytest.approx(chain(decay_time=0).restitution, rel=0)


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


@pytest.mark.parametrize(
    "changed",
    [
        {"circumference": 4.0},
        {"circumference": np.nan},
        {"temperature": None},
        {"velocities": [1, 2, 3, 4]},
        {"temperature": None, "velocities": [1, 2]},
        {"temperature": -1.0},
        {"seed": -1},
        {"collisions": None},
        {"collisions": -1},
        {"time": -1.0},
        {"decay_time": -1.0},
        {"method": "springs"},
        {"modes": 0},
        {"pieces": 1},
        {"tail": "soft"},
    ],
)
def test_refusals(changed):
    with pytest.raises(stoss.InvalidInput) as caught:
        chain(**changed)
    assert "\n" not in str(caught.value)
    assert "allowed" in str(caught.value)


@pytest.mark.parametrize("rods", [stoss.Rod(), [], [stoss.Rod()], [stoss.Disk(poisson=0.3)] * 3, "rods"])
def test_refused_rods(rods):
    with pytest.raises(stoss.InvalidInput, match="rods"):
        stoss.rod_chain(rods, circumference=100, temperature=1, collisions=1)


def test_lossy_rods_are_refused():
    with pytest.raises(stoss.InvalidInput, match="decay_time"):
        stoss.rod_chain([stoss.Rod(loss_time=0.1)] * 2, circumference=10, temperature=1, collisions=1)


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
