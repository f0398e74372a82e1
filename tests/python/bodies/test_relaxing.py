"""Bodies and materials that relax: the same in Python as in documents, in SI as in units of the first body."""

import json
import math

import pytest

import stoss

TERMS = [(0.5, 1.0), (0.2, 10.0)]
RUBBER = {"young": 2e6, "poisson": 0.3, "density": 1100.0}
C = math.sqrt(2e6 / 1100.0)


def bounce(body, speed=0.1, **more):
    return stoss.impact(body, speed=speed, cutoff=20, **more).restitution


def test_a_body_relaxes_in_units_of_its_own_and_in_si():
    own = bounce(stoss.Sphere(poisson=0.3, relaxation=TERMS))
    assert own < 0.9
    times = [(share, time * 0.01 / C) for share, time in TERMS]
    ball = stoss.Sphere(radius=0.01, material=stoss.Material(**RUBBER, relaxation=times))
    assert ball.relaxation == ball.material.relaxation
    assert bounce(ball, 0.1 * C) == pytest.approx(own, rel=1e-9)
    plain = stoss.Sphere(radius=0.01, material=stoss.Material(**RUBBER), relaxation=times)
    assert bounce(plain, 0.1 * C) == pytest.approx(own, rel=1e-9)
    assert bounce(stoss.Sphere(radius=0.01, material=ball.material, loss_time=0), 0.1 * C) > 0.99
    relaxed = stoss.Material(**{**RUBBER, "young": 6e5}, relaxation=times, young_is="relaxed")
    assert relaxed.young == pytest.approx(2e6)


def test_a_pair_and_a_block_relax():
    pair = bounce(stoss.Sphere(poisson=0.3, relaxation=TERMS), against="same")
    two = bounce(stoss.Sphere(poisson=0.3, relaxation=TERMS), against=stoss.Sphere(poisson=0.3, relaxation=TERMS))
    assert pair == pytest.approx(two, rel=1e-12)
    soft = stoss.Material(**RUBBER, relaxation=[(0.5, 1e-4)])
    ball = stoss.Sphere(radius=0.01, material=stoss.Material(**RUBBER))
    lossy, elastic = (bounce(ball, 2.0, against=stoss.HalfSpace(material=each))
                      for each in (soft, stoss.Material(**RUBBER)))
    assert lossy < elastic - 0.01


def test_a_quality_holds_the_modulus_at_its_frequency():
    rubber = stoss.Material(**RUBBER, quality=(10, 3000.0))
    assert (rubber.quality, rubber.frequency) == (10.0, 3000.0)
    ball = stoss.Sphere(radius=0.01, material=rubber)
    assert ball.scales.speed > 1.05 * C
    own = bounce(stoss.Sphere(poisson=0.3, quality=10))
    assert bounce(ball, 0.1 * ball.scales.speed) == pytest.approx(own, rel=1e-9)
    pair = bounce(ball, 0.1 * ball.scales.speed, against=stoss.Sphere(radius=0.01, material=rubber))
    assert pair == pytest.approx(bounce(stoss.Sphere(poisson=0.3, quality=10), against="same"), rel=1e-9)
    block = bounce(ball, 0.1 * ball.scales.speed, against=stoss.HalfSpace(material=rubber))
    assert block < 1.0


def test_representations_make_them_again():
    for body in (
        stoss.Sphere(poisson=0.3, relaxation=TERMS),
        stoss.Sphere(poisson=0.3, quality=10),
        stoss.Plate(layers=[stoss.Layer(thickness=1), stoss.Layer(thickness=2)], relaxation=TERMS),
    ):
        assert eval(repr(body), {**vars(stoss)}) == body


@pytest.mark.parametrize(
    "make, said",
    [
        (lambda: stoss.Sphere(poisson=0.3, relaxation=[(0.75, 1), (0.5, 1)]), "relaxation: got shares of 1.25 in sum"),
        (lambda: stoss.Sphere(poisson=0.3, relaxation=[(0.5, 0)]), "relaxation: got 0, allowed times above 0"),
        (lambda: stoss.Sphere(poisson=0.3, relaxation=[0.5, 1]), "relaxation: .*allowed pairs"),
        (lambda: stoss.Sphere(poisson=0.3, relaxation=TERMS, loss_time=1), "relaxation: got a relaxation beside a loss"),
        (lambda: stoss.Sphere(poisson=0.3, relaxation=TERMS, rigid=True), "relaxation: .*none of a rigid body"),
        (lambda: stoss.Sphere(poisson=0.3, quality=1), "quality: got 1, allowed 3 to 1e9"),
        (lambda: stoss.Material(**RUBBER, quality=(10, 1, 2)), "quality: .*allowed Q, or"),
        (lambda: stoss.Material(**RUBBER, young_is="relaxed"), "young_is: there is no relaxation"),
        (lambda: stoss.Material(**RUBBER, relaxation=TERMS, quality=10), "relaxation: got a relaxation beside a quality"),
        (lambda: stoss.rod_chain([stoss.Rod(quality=10)] * 2, circumference=9, temperature=1, collisions=3, decay_time=0),
         "rods: "),
        (lambda: stoss.atlas(stoss.Sphere(poisson=0.3, quality=10), speed=0.1), "body: "),
    ],
)
def test_refusals(make, said):
    with pytest.raises(stoss.InvalidInput, match=f"^{said}"):
        make()


def test_a_grid_takes_documents_that_relax():
    grid = stoss.Grid(bodies={"kind": "sphere", "poisson": 0.3, "relaxation": TERMS}, speed=[0.1])
    assert grid.bodies[0].relaxation == tuple(TERMS)
    assert stoss.Grid.from_dict(json.loads(json.dumps(grid.to_dict()))).bodies == grid.bodies


def test_materials_are_found_in_upper_and_lower_case():
    assert stoss.materials["Glass"] is stoss.materials["glass"]
    with pytest.raises(stoss.InvalidInput, match="did you mean rubber"):
        stoss.materials["ruber"]
    assert stoss.materials["damped rubber"].relaxation
