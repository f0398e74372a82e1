"""Errors of a body file against the truth: a sphere of a mesh beside its modes in closed form."""

from pathlib import Path

import numpy as np
import pytest
import stoss

FILE = Path(__file__).parents[3] / "examples" / "any_body" / "sphere.json"
STEEL = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
COMPLIANCE = -0.505882  # c₀ in 1/(ER), from the sum over the degrees (docs/developer/derivations/any_body.md)
GAPS = (2.8, 3.45, 4.59)  # in c/R, between frequencies of modes that move the point


@pytest.fixture(scope="module")
def of_mesh():
    return stoss.ModalBody.read(FILE)


@pytest.fixture(scope="module")
def exact(of_mesh):
    """The same body by its modes in closed form: near the pole U + χθ² of U cos θ P_n − V sin θ dP_n/dθ."""
    sphere = stoss.Sphere(radius=1 / np.mean(of_mesh.curvature), material=STEEL)
    modes = stoss.modes(sphere, cutoff=max(GAPS))
    rising = np.argsort(modes.omega)
    order, radial, tangential = modes.order[rising], modes.radial[rising], modes.tangential[rising]
    turns = 0.5 * order * (order + 1)
    bend = tangential * turns - 0.5 * radial * (1 + turns)
    return stoss.ModalBody(
        mass=of_mesh.mass, curvature=1 / sphere.radius, young=STEEL.young, poisson=STEEL.poisson, density=STEEL.density,
        compliance=COMPLIANCE / (STEEL.young * sphere.radius), frequency=modes.omega[rising] * sphere.scales.frequency / (2 * np.pi),
        displacement=radial / np.sqrt(of_mesh.mass), displacement_curvature=bend / np.sqrt(of_mesh.mass) / sphere.radius**2,
        complete_to=max(GAPS) * sphere.scales.frequency / (2 * np.pi),
    )  # fmt: skip


def main_modes(of_mesh, exact):
    """Those of the mesh that are the exact ones, by their place among those that move the point most nearby."""
    found = np.abs(of_mesh.displacement)
    wanted = np.abs(exact.displacement)
    near = np.abs(of_mesh.frequency[None, :] / exact.frequency[:, None] - 1) < 0.02
    return np.argmin(np.where(near, np.abs(found[None, :] - wanted[:, None]), np.inf), axis=1)


def test_displacements_of_a_mesh_err_to_one_side(of_mesh, exact):
    """Finite elements move the point too far: so a file is off by all errors of displacements at once."""
    places = main_modes(of_mesh, exact)
    assert np.unique(places).size == places.size
    off = of_mesh.frequency[places] - exact.frequency
    assert np.all(np.abs(off) < of_mesh.frequency_error[places])
    farther = np.abs(of_mesh.displacement[places]) - np.abs(exact.displacement)
    by_weight = np.abs(exact.displacement) * farther
    assert by_weight[farther > 0].sum() > 0.95 * np.abs(by_weight).sum()


@pytest.mark.parametrize("against", [None, "same", stoss.HalfSpace(material=STEEL)])
def test_the_true_change_is_within_those_of_all_errors(of_mesh, exact, against):
    """Over speeds and cutoffs, as what few modes lose swings with both."""
    true, stated = [], []
    for share in (1e-4, 1e-3, 1e-2):
        for cutoff in GAPS:
            asked = {"against": against, "speed": share * of_mesh.scales.speed, "cutoff": cutoff}
            here, right, *others = (stoss.impact(each, **asked).lost_fraction for each in (of_mesh, exact, *of_mesh.off_by_errors()))
            true.append((here - right) / right)
            stated.append([(other - here) / right for other in others])
    assert np.linalg.norm(true) < np.linalg.norm(stated)
    assert np.median(np.abs(true) / np.linalg.norm(stated, axis=1)) > 0.05  # nor are they far too large
