"""A meshed sphere along its surface: its modes in closed form, its c_t, and how it rubs."""

import json
import math

import numpy as np
import pytest
from conftest import SMALL

import stoss

POISSON = 0.3
COMPLIANCE = -0.19215  # c_t of a sphere of radius and modulus 1 (docs/theory/any_body.md)
MASS = 4 * math.pi / 3
KAPPA = 2.50113263  # (n - 1) j_n(κ) = κ j_{n+1}(κ) of n = 2


@pytest.fixture(scope="module")
def rough_sphere(modal):
    return modal.body(f"{SMALL} --tangent 0,2,0", "rough.json")


def along(body):
    modes = {name: np.array(values) for name, values in body["modes"].items()}
    moves = np.abs(modes["tangential_displacement"]) > 0.05
    return {name: values[moves] for name, values in modes.items()}


def test_lowest_modes(rough_sphere, references):
    found = along(rough_sphere)
    # The toroidal mode of n = 2, which moves the pole by W √(L/2), then the spheroidal one, by V √(L/2).
    wide = 5 / 18 * 2 * KAPPA**2 / (KAPPA**2 - 4)
    rows = [row for row in references("sphere_modes.csv") if row["poisson"] == POISSON]
    lowest = min((row for row in rows if row["degree"] == 2), key=lambda row: row["omega"])
    frequencies = np.array([KAPPA / math.sqrt(2 * (1 + POISSON)), lowest["omega"]]) / (2 * math.pi)
    moved = np.array([math.sqrt(wide), abs(lowest["V"])]) * math.sqrt(3 / MASS)
    assert found["frequency"][:2] == pytest.approx(frequencies, rel=2e-3)
    assert np.abs(found["tangential_displacement"][:2]) == pytest.approx(moved, rel=2e-2)
    assert np.abs(found["displacement"][:2]) == pytest.approx([0, 0], abs=5e-3)
    off = np.abs(np.abs(found["tangential_displacement"][:2]) - moved)
    assert np.all(off < 1.5 * found["tangential_displacement_error"][:2] + 1e-3)


def test_compliance(rough_sphere):
    tangent = rough_sphere["tangent"]
    assert tangent["direction"] == [0.0, 1.0, 0.0]
    assert tangent["compliance"] == pytest.approx(COMPLIANCE, abs=0.06)
    assert abs(tangent["compliance"] - COMPLIANCE) < tangent["compliance_error"] < 0.2


def test_normal_numbers_are_those_without_a_tangent(rough_sphere, small_sphere):
    for name in ("compliance", "compliance_error", "mass", "curvature"):
        assert rough_sphere[name] == small_sphere[name]
    moving = [np.array(body["modes"]["displacement"]) for body in (rough_sphere, small_sphere)]
    assert moving[0] @ moving[0] == pytest.approx(moving[1] @ moving[1], rel=1e-9)


def test_it_rubs_as_the_sphere(rough_sphere, modal):
    body = stoss.ModalBody.read(modal.folder / "rough.json")
    assert body.to_dict()["tangent"] == json.loads(json.dumps(rough_sphere["tangent"]))
    material = stoss.Material(young=1.0, poisson=POISSON, density=1.0)
    sphere = stoss.Sphere(radius=1.0, material=material)
    for sliding in (0.3, 1.0, 3.0):
        case = {"speed": 1e-4, "tangential": 0.3e-4 * sliding, "friction": 0.3}
        found, exact = (stoss.oblique(each, **case) for each in (body, sphere))
        allowed = found.tangential_restitution_error + exact.tangential_restitution_error
        assert abs(found.tangential_restitution - exact.tangential_restitution) <= allowed < 0.1


@pytest.mark.parametrize(
    "tangent, said",
    [("0,0,0", "tangent: got length 0"), ("0.6,0,0.8", "degrees off"), ("1,2", "--tangent")],
)
def test_refusals(modal, tangent, said):
    done = modal.run(f"{SMALL} --tangent {tangent} -o refused.json")
    assert done.returncode == 2 and said in done.stderr and "Traceback" not in done.stderr
