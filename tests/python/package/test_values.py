"""The package gives the core's numbers: those of the command bit for bit."""

import dataclasses

import numpy as np
import pytest

import stoss

ERRORS = ("lost_fraction", "contact_time", "max_compression", "max_force")
ARRAYS = [field.name for field in dataclasses.fields(stoss.Restitution) if field.name.endswith("_error")]
STEEL = "--poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01"


def same(result, record, names):
    """Bit for bit."""
    for name in names:
        assert getattr(result, name) == record[name], name


def test_restitution_is_that_of_the_command(command):
    records = command("restitution --poisson 0.33,-0.5 --speed 0.1,0.01,1e-6 --tolerance 1e-3")["records"]
    result = stoss.restitution(poisson=[[0.33], [-0.5]], speed=[0.1, 0.01, 1e-6])
    for i, record in enumerate(records):
        record = {**record, "runs": len(record["runs"])}
        for name in [*ARRAYS, "poisson", "speed", "restitution", *ERRORS, "cutoff", "energy_error", "modes", "runs",
                     "steps", "converged", "strain", "beyond_small_strain"]:  # fmt: skip
            assert getattr(result, name).ravel()[i] == record[name], name


@pytest.mark.parametrize("plane", ["stress", "strain"])
def test_si_is_that_of_the_command(command, plane):
    disk = stoss.Disk(radius=0.01, material=stoss.materials["structural steel"], loss_time=0, plane=plane)
    names = ("speed", "contact_time_si", "max_force_si", "max_compression_si", "restitution", "poisson")
    records = command(f"restitution {STEEL} --plane {plane} --speed 5,50")["records"]
    for speed, record in zip((5, 50), records):
        result = stoss.restitution(disk, speed=speed)
        same(result, record, names)
        assert result.speed_si == pytest.approx(record["speed_si"], rel=1e-15)
    (record,) = command(f"impact {STEEL} --plane {plane} --speed 5 --cutoff 12")["records"]
    same(stoss.impact(disk, speed=5, cutoff=12), record, names[:-1])
    modes = stoss.modes(disk, cutoff=9)
    assert modes.omega.tolist() == [m["omega"] for m in command(f"modes {STEEL} --plane {plane} --cutoff 9")["records"]]
    bar_speed = disk.scales.speed
    assert bar_speed == pytest.approx((2.1e11 / 7850 / (1 if plane == "stress" else 1 - 0.3**2)) ** 0.5, rel=1e-14)
    assert disk.scales.time == pytest.approx(0.01 / bar_speed)
    assert disk.scales.force == pytest.approx(np.pi * 0.01 * 7850 * bar_speed**2, rel=1e-14)


@pytest.mark.parametrize(
    "options, arguments",
    [
        ({}, ""),
        ({"tail": "static"}, "--tail static"),
        ({"against": stoss.ExponentialWall(hardness=99, strength=2)}, "--against exponential,hardness=99,strength=2"),
        ({"step": 0.01, "nodes": 100}, "--step 0.01 --nodes 100"),
    ],
)
def test_impact_is_that_of_the_command(command, options, arguments):
    answer = command(f"impact --poisson 0.33 --speed 0.1 --cutoff 15 {arguments}")
    hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=15, **options)
    (record,) = answer["records"]
    assert {"restitution", "vibration", "max_force", "energy_error"} < set(record)
    same(hit, record, [name for name in record if name != "poisson"])
    for name in ("order", "index", "omega", "after", "average"):
        assert hit.mode_energies[name].tolist() == [mode[name] for mode in answer["modes"]]


def test_modes_are_those_of_the_command(command):
    modes = stoss.modes(poisson=0.9, cutoff=20)
    records = command("modes --poisson 0.9 --cutoff 20")["records"]
    for name in ("order", "index", "omega", "radial", "tangential"):
        assert getattr(modes, name).tolist() == [record[name] for record in records]
    assert modes.radial_family.tolist() == [record["family"] == "radial" for record in records]


def test_extrapolation_is_that_of_the_command(command):
    (record,) = command("restitution --method extrapolate --poisson 0.33 --speed 0.3")["records"]
    result = stoss.extrapolated_restitution(poisson=0.33, speed=0.3)
    same(result, record, ("restitution", "restitution_error", "lost_fraction", "lost_fraction_error"))
    assert result.to_dict()["impacts"] == record["impacts"]
    assert result.steps == sum(impact["steps"] for impact in record["impacts"])
    best = stoss.restitution(poisson=0.33, speed=0.3)
    assert abs(best.lost_fraction - result.lost_fraction) < 2 * result.lost_fraction_error
