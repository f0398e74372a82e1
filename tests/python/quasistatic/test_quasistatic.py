"""stoss.quasistatic: the command's numbers bit for bit, closed forms, and results."""

import copy
import dataclasses
import json
import math
import pickle
import warnings

import numpy as np
import pytest

import stoss
from stoss import quasistatic

LAWS = ("center", "diameter")


@pytest.mark.parametrize("law", LAWS)
def test_compressions_are_those_of_the_command(command, law):
    records = command(f"quasistatic --body disk --poisson 0.33 --compression log:1e-12:0.03:5 --law {law}")["records"]
    at = {"poisson": 0.33, "law": law}
    for record in records:
        force = quasistatic.compression_force(compression=record["compression"], **at)
        assert force == record["force"]
        assert quasistatic.compression_energy(force=force, **at) == record["energy"]
        contact = quasistatic.static_contact(poisson=0.33, compression=record["compression"])
        assert (contact.force, contact.force_error) == (record["static_force"], record["static_force_error"])


@pytest.mark.parametrize("law, s, b", [("center", 1, 0.3), ("diameter", 4, 1)])
def test_laws_are_their_closed_forms(law, s, b):
    at = {"poisson": 0.2, "law": law}
    force = np.geomspace(1e-12, 0.99 * quasistatic.limit_force(**at), 40).reshape(8, 5)
    delta = quasistatic.compression(force=force, **at)
    assert delta == pytest.approx(force * (np.log(s / force) - b), rel=1e-12)
    assert quasistatic.compression_force(compression=delta, **at) == pytest.approx(force, rel=1e-7)
    energy = quasistatic.compression_energy(force=force, **at)
    assert energy == pytest.approx(force**2 * (0.5 * np.log(s / force) - 0.5 * b - 0.25), rel=1e-12)
    assert quasistatic.limit_force(**at) == pytest.approx(s * math.exp(-1 - b), rel=1e-14)
    assert quasistatic.limit_speed(**at) == pytest.approx(s * math.exp(-1 - b) / math.sqrt(2), rel=1e-14)
    slow = quasistatic.slow_impact(speed=[1e-6, 0.1], **at)
    assert quasistatic.compression(force=slow.max_force, **at) == pytest.approx(slow.max_compression, rel=1e-13)
    assert quasistatic.compression_energy(force=slow.max_force, **at) == pytest.approx(slow.speed**2 / 2, rel=1e-12)


def test_hertz():
    force, y = 0.0025, np.linspace(-0.1, 0.1, 201)  # half-width 0.1
    pressure = quasistatic.hertz_pressure(force=force, y=y)
    assert pressure == pytest.approx(0.5 * np.sqrt(np.maximum(0.01 - y**2, 0)), abs=1e-9)
    assert pressure.sum() * (y[1] - y[0]) == pytest.approx(math.pi * force, rel=1e-3)
    surface = quasistatic.hertz_stress(force=force, depth=0.0, y=y)
    assert surface.xx == pytest.approx(-pressure, abs=1e-12) and surface.yy == pytest.approx(-pressure, abs=1e-12)
    depth = np.array([0.05, 0.2])
    below = quasistatic.hertz_stress(force=force, depth=depth, y=0)
    root = np.hypot(0.1, depth)  # K. L. Johnson, Contact Mechanics, eqs. 4.45
    assert below.xx == pytest.approx(-0.5 * 0.01 / root, rel=1e-13)
    assert below.yy == pytest.approx(-0.5 * ((0.01 + 2 * depth**2) / root - 2 * depth), rel=1e-12)
    assert not np.any(below.xy)


def test_static_contact_is_in_balance():
    contact = quasistatic.static_contact(poisson=0.33, compression=0.02, nodes=100)
    assert 2 * contact.spacing * contact.pressure.sum() == pytest.approx(math.pi * contact.force, rel=1e-12)
    assert contact.half_width == pytest.approx(2 * math.sqrt(contact.force), rel=0.01)
    finer = quasistatic.static_contact(poisson=0.33, compression=0.02, nodes=400)
    assert abs(finer.force - contact.force) < contact.force_error + finer.force_error
    pair = [quasistatic.static_contact(poisson=0.33, compression=0.02 + d).energy for d in (-1e-4, 1e-4)]
    assert (pair[1] - pair[0]) / 2e-4 == pytest.approx(finer.force, rel=1e-4)


def results():
    steel = stoss.Disk(radius=0.01, material=stoss.materials["structural steel"])
    yield quasistatic.slow_impact(poisson=0.33, speed=0.01)
    yield quasistatic.slow_impact(steel, speed=[[1e-9, 5]])
    yield quasistatic.slow_impact(poisson=[[0.1], [0.2]], speed=[1e-9, 1e-3])
    yield quasistatic.slow_impact(poisson=0.33, speed=[])
    yield quasistatic.rayleigh(poisson=0.33, speed=0.01, cutoff=8)
    yield quasistatic.rayleigh(steel, speed=[1, 5], cutoff=8)
    yield quasistatic.rayleigh(poisson=[0.1, 0.2], speed=1e-9, cutoff=8)
    yield quasistatic.static_contact(poisson=0.33, compression=0.01, nodes=20)


@pytest.mark.parametrize("result", results(), ids=repr)
def test_results(result, tmp_path):
    for field in dataclasses.fields(result):
        value = getattr(result, field.name)
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(result, field.name, value)
        if isinstance(value, np.ndarray):
            assert not value.flags.writeable
        else:
            assert not isinstance(value, np.generic)
    text = repr(result)
    assert text.startswith(type(result).__name__ + "(") and text.isprintable() and len(text) <= 160
    got = result.to_dict()
    assert json.loads(json.dumps(got)) == got
    for twin in (copy.deepcopy(result), pickle.loads(pickle.dumps(result))):
        assert twin.to_dict() == got
    result.to_csv(tmp_path / "result.csv")
    names = next(line for line in open(tmp_path / "result.csv") if not line.startswith("#")).strip().split(",")
    assert len(names) > 1 and ("contact_time_si[s]" in names) == (getattr(result, "material", None) is not None)


def test_shapes_broadcast():
    nus, speeds = np.array([[0.2], [0.5]]), [1e-3, 1e-9, 1e-6]
    for make in (quasistatic.slow_impact, lambda **at: quasistatic.rayleigh(cutoff=6, **at)):
        many = make(poisson=nus, speed=speeds)
        for i, j in np.ndindex(2, 3):
            alone = make(poisson=nus[i, 0], speed=speeds[j])
            for field in dataclasses.fields(alone):
                value = getattr(alone, field.name)
                if field.name not in ("law", "cutoff", "body", "mode_energies", "max_radius", "mean_lost_fraction"):
                    assert type(value) in (float, int, bool) and getattr(many, field.name)[i, j] == value
    assert type(quasistatic.compression(force=0.01, poisson=0.3)) is float
    assert quasistatic.compression(force=[[0.01]], poisson=[0.3, 0.2]).shape == (1, 2)
    assert quasistatic.hertz_stress(force=[0.01, 0.02], depth=[[0.1]], y=0).xy.shape == (1, 2)
    assert quasistatic.limit_speed(poisson=nus).shape == (2, 1)


def test_values_beyond_perturbation_are_warned_of():
    with pytest.warns(stoss.StossWarning, match="^1 of 2 values beyond perturbation theory") as caught:
        estimate = quasistatic.rayleigh(poisson=0.33, speed=[0.01, 0.1])
    assert caught[0].filename == __file__ and estimate.beyond_perturbation.tolist() == [False, True]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert quasistatic.rayleigh(poisson=0.33, speed=0.02).beyond_perturbation is False
