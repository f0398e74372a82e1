"""Bodies of files with a tangent, with friction: against the exact sphere, exact laws, and in sweeps."""

from pathlib import Path

import numpy as np
import pytest
import stoss

FILES = Path(__file__).parents[3] / "examples" / "any_body"
STEEL = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
SPHERE = stoss.Sphere(radius=0.01, material=STEEL)
OF_MESH = 5e-5
"""By what the mesh, which lies inside the sphere, has less mass, inertia and arm."""


@pytest.fixture(scope="module")
def ball():
    return stoss.ModalBody.read(FILES / "sphere.json")


@pytest.mark.parametrize("against", ["wall", "same", stoss.HalfSpace(material=STEEL), stoss.Plate(thickness=0.02, material=STEEL)])
def test_sphere_of_a_mesh_rubs_as_the_sphere(ball, against):
    motion = {
        "speed": np.array([0.05, 5.0])[:, None, None], "angle": np.array([2.0, 20.0, 60.0, 85.0])[None, :, None],
        "friction": np.array([1e-9, 0.1, 1.0]), "spin": np.array([0.0, 30.0, -30.0]),
    }  # fmt: skip
    found, exact = (stoss.oblique(each, against=against, **motion) for each in (ball, SPHERE))
    assert found.restitution.shape == (2, 4, 3)
    size = np.maximum(np.abs(exact.sliding), exact.friction * exact.speed)
    scales = {"restitution": 0.0, "friction_loss": 1.0, "sliding_after": size, "tangential_after": size, "spin_after": size}
    for name, scale in scales.items():
        allowed = getattr(found, f"{name}_error") + getattr(exact, f"{name}_error") + OF_MESH * scale
        assert np.all(np.abs(getattr(found, name) - getattr(exact, name)) <= allowed), name
    assert np.all(found.sliding_after_error < 0.03 * size)


def test_one_impact_keeps_momenta_and_energy_and_obeys_coulomb(ball):
    beam = stoss.ModalBody.read(FILES / "beam_0.json")
    small = stoss.Sphere(radius=0.005, material=STEEL)
    for first, against in ((ball, None), (ball, "same"), (small, beam), (beam, small)):
        for friction in (1e-9, 0.05, 1.0):
            for angle in (5.0, 70.0):
                hit = stoss.oblique_impact(first, against=against, speed=0.5, angle=angle, friction=friction)
                # All that slides less took friction, of both masses and of turning: at most 3.5 μ (1 + ε) v of a ball.
                assert abs(hit.sliding_after - hit.sliding) <= 3.5 * friction * (1 + hit.restitution) * hit.speed * (1 + 1e-4)
                assert abs(hit.energy_error) < 1e-3
                assert abs(hit.sliding_after) <= abs(hit.sliding)


def test_the_order_of_both_bodies_does_not_matter():
    beam = stoss.ModalBody.read(FILES / "beam_0.json")
    small = stoss.Sphere(radius=0.005, material=STEEL)
    motion = {"speed": 0.5, "angle": [5.0, 20.0, 60.0], "friction": 0.2}
    one, other = stoss.oblique(small, against=beam, **motion), stoss.oblique(beam, against=small, **motion)
    for name in ("restitution", "tangential_restitution"):
        errors = getattr(one, f"{name}_error") + getattr(other, f"{name}_error")
        assert np.all(np.abs(getattr(one, name) - getattr(other, name)) <= errors), name


def test_a_body_without_a_tangent_is_refused_in_one_line(ball):
    bell = stoss.ModalBody.read(FILES / "bell.json")
    for first, against in ((bell, SPHERE), (ball, bell), (SPHERE, bell)):
        for ask in (stoss.oblique, stoss.oblique_impact):
            with pytest.raises(stoss.InvalidInput) as refused:
                ask(first, against=against, speed=0.5, angle=10, friction=0.1)
            assert str(refused.value).startswith("friction: got 'bell' without tangential data, allowed ")
            assert "\n" not in str(refused.value)
        smooth = stoss.oblique(first, against=against, speed=0.5, angle=10, friction=0)
        assert smooth.sliding_after == smooth.sliding


def test_sweeps_take_files_with_friction(tmp_path):
    known = {"kind": "modal", "file": str(FILES / "sphere.json")}
    grid = {"speed": [0.1, 1.0], "friction": [0.1, 0.4], "angle": [10, 60]}
    itself = {"kind": "sphere", "radius": 0.01, "material": {"young": 2.1e11, "poisson": 0.3, "density": 7850}}
    made = stoss.sweep(stoss.Grid(bodies=[known, itself], against=["wall", "same"], **grid), store=tmp_path / "store")
    off = np.abs(made.tangential_restitution[0] - made.tangential_restitution[1])
    assert off.shape == (2, 2, 2, 2)
    assert np.all(off <= made.tangential_restitution_error.sum(axis=0))
    bell = {"kind": "modal", "file": str(FILES / "bell.json")}
    with pytest.raises(stoss.InvalidInput, match="friction: got 'bell' without tangential data"):
        stoss.sweep(stoss.Grid(bodies=[itself], against=[bell], **grid), store=tmp_path / "refused")
