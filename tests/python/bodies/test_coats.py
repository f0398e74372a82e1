"""Coats of bodies: alike in units of the body and in SI, in documents and reprs, refused in one line."""

import pytest
import stoss
import stoss.bodies._encounter

SOFT = {"coat": 0.002, "coat_young": 0.01, "coat_poisson": 0.45, "coat_quality": 8}


def lost(body, speed, **more):
    return stoss.restitution(body, speed=speed, **more).lost_fraction


def test_alike_in_si_and_in_units_of_the_body():
    own = lost(stoss.Sphere(poisson=0.25, **SOFT), 0.01)
    material = stoss.Material(young=1e10, poisson=0.25, density=2500)
    si = stoss.Sphere(radius=0.02, material=material, **SOFT | {"coat": 4e-5, "coat_young": 1e8})
    assert lost(si, 0.01 * 2000) == pytest.approx(own, rel=1e-9)
    other = stoss.Sphere(poisson=0.25, radius=3, young=2, density=5, **SOFT | {"coat": 0.006, "coat_young": 0.02})
    assert lost(other, 0.01) == pytest.approx(own, rel=1e-9)


def test_either_face():
    ball, block = stoss.Sphere(poisson=0.3), stoss.HalfSpace(poisson=0.2, young=3)
    one = lost(stoss.Sphere(poisson=0.3, **SOFT), 0.02, against=block)
    assert lost(ball, 0.02, against=stoss.HalfSpace(poisson=0.2, young=3, **SOFT)) == pytest.approx(one, rel=1e-9)
    assert one != lost(ball, 0.02, against=block)


def test_it_is_said():
    assert repr(stoss.Sphere(poisson=0.3, coat=0.1, coat_young=2)) == "Sphere(poisson=0.3, coat=0.1, coat_young=2)"
    assert repr(stoss.Sphere(poisson=0.3)) == "Sphere(poisson=0.3)"


@pytest.mark.parametrize("given, said", [({"coat": 0.1}, "coat_young: missing"), ({"coat_young": 1}, "coat: missing"),
                                         ({"coat": 2, "coat_young": 1}, "coat: got 2"),
                                         ({"coat": 0.1, "coat_young": 1, "coat_poisson": 0.5}, "coat_poisson: got 0.5")])  # fmt: skip
def test_refused_in_one_line(given, said):
    with pytest.raises(stoss.InvalidInput, match=f"^{said}"):
        lost(stoss.Sphere(poisson=0.3, **given), 0.1)


def test_a_body_by_its_modes_is_another_with_another_coat():
    bar = stoss.ModalBody(mass=0.08, curvature=100, young=2e11, poisson=0.3, density=7850, compliance=1e-7,
                          frequency=[5300.0], displacement=[7.1])  # fmt: skip
    thin, thick = (bar.with_face(coat=each, coat_young=1e9) for each in (1e-5, 1e-4))
    assert len({bar, thin, thick}) == 3
    wall = stoss.HalfSpace(material=stoss.Material(young=2e11, poisson=0.3, density=7850))
    assert len({stoss.bodies._encounter.encounter(each, wall) for each in (bar, thin, thick)}) == 3
