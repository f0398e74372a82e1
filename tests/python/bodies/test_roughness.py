"""Rough faces in Python: of bodies, blocks, plates and walls, in any units; both refusals and values."""

import copy
import pickle

import numpy as np
import pytest
import stoss

BALL = stoss.Sphere(poisson=0.3)


def lost(body, **given):
    return stoss.restitution(body, **{"speed": 0.1, **given}).lost_fraction


def test_all_ways_to_give_it_are_one():
    own = lost(stoss.Sphere(poisson=0.3, u0=0.02))
    assert own == pytest.approx(0.0043804, abs=5e-6) and own < 0.3 * lost(BALL)
    for against in (stoss.HardWall(u0=0.02), stoss.HardWall(roughness=0.02 / 0.45), stoss.ExponentialWall(hardness=50)):
        assert lost(BALL, against=against) == pytest.approx(own, rel=1e-6)
    steel = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
    ball = stoss.Sphere(radius=5e-3, material=steel)
    v = 0.1 * ball.scales.speed
    for body, against in ((ball, stoss.HardWall(u0=1e-4)), (stoss.Sphere(radius=5e-3, material=steel, u0=1e-4), "wall")):
        assert lost(body, against=against, speed=v) == pytest.approx(own, rel=1e-6)
    scaled = stoss.Sphere(poisson=0.3, radius=2, u0=0.04)
    assert lost(scaled) == pytest.approx(own, rel=1e-6)


def test_both_faces_count():
    block = stoss.HalfSpace(u0=0.004)
    both = lost(stoss.Sphere(poisson=0.3, u0=0.003), against=block, speed=0.05)
    assert both == pytest.approx(lost(BALL, against=stoss.HalfSpace(u0=0.005), speed=0.05), rel=1e-9)
    same = stoss.Sphere(poisson=0.3, u0=0.003)
    assert lost(same, against="same", speed=0.05) == pytest.approx(lost(same, against=same, speed=0.05), rel=1e-9)


@pytest.mark.parametrize(
    "one",
    [stoss.Sphere(poisson=0.3, u0=0.02), stoss.HalfSpace(roughness=0.1), stoss.HardWall(roughness=0.01),
     stoss.Plate(layers=[stoss.Layer(thickness=0.1), stoss.Layer()], u0=0.01), stoss.Rod(roughness=0.1),
     stoss.Sphere(radius=5e-3, material=stoss.materials["glass"], roughness=134e-9)],
    ids=repr,
)  # fmt: skip
def test_rough_things_are_values(one):
    assert eval(repr(one), vars(stoss)) == one == copy.deepcopy(one) == pickle.loads(pickle.dumps(one))
    assert "u0=" in repr(one) or "roughness=" in repr(one)


@pytest.mark.parametrize("make", [lambda **its: stoss.Sphere(poisson=0.3, **its), stoss.HalfSpace, stoss.HardWall, stoss.Rod])
def test_refusals(make):
    with pytest.raises(stoss.InvalidInput, match="^roughness: given beside u0"):
        make(roughness=0.1, u0=0.1)
    for name in ("roughness", "u0"):
        for value in (-1, np.nan, np.inf):
            with pytest.raises(stoss.InvalidInput, match=f"^{name}: got"):
                make(**{name: value})
    with pytest.raises(stoss.InvalidInput, match="u0: got 1.5, allowed 0 to 1 "):
        its = make(u0=1.5)
        lost(its) if isinstance(its, (stoss.Sphere, stoss.Rod)) else lost(BALL, against=its)


def test_modal_bodies_are_rough_too():
    modes = {"mass": 0.0785, "curvature": 100.0, "young": 2.1e11, "poisson": 0.3, "density": 7850, "compliance": 5e-8,
             "frequency": [5319], "displacement": [7.14], "complete_to": 5319}  # fmt: skip
    smooth, rough = stoss.ModalBody(**modes), stoss.ModalBody(**modes, roughness=1e-6)
    assert rough != smooth and rough.roughness == 1e-6 and pickle.loads(pickle.dumps(rough)) == rough
    assert smooth.to_dict() == rough.to_dict()  # a face is not of the file


def test_a_collision_with_friction_and_an_impact_without_a_tail():
    hit = stoss.oblique(BALL, speed=0.05, angle=30, friction=0.3, against=stoss.ExponentialWall(hardness=200))
    assert 0.99 < hit.restitution < 1
    kept = stoss.impact(BALL, speed=0.1, cutoff=15, against=stoss.HardWall(u0=0.01), tail="none")
    assert kept.tail == "none" and kept.unresolved == 0
    with pytest.raises(stoss.InvalidInput, match="^tail: got none at smooth faces"):
        stoss.impact(BALL, speed=0.1, cutoff=15, tail="none")


def test_grids_have_them(tmp_path):
    grid = stoss.Grid(bodies={"kind": "sphere", "poisson": 0.3, "u0": [0.01, 0.02]}, speed=[0.1],
                      against=[{"kind": "wall", "u0": [0, 0.02]}, {"kind": "exponential", "hardness": 100}, "same"])
    assert len(grid.cases()) == 8 and stoss.Grid.from_dict(grid.to_dict()).to_dict() == grid.to_dict()
    values = stoss.sweep(grid, store=tmp_path / "s")
    own = lost(stoss.Sphere(poisson=0.3, u0=0.02))
    assert np.min(np.abs(np.ravel(values.lost_fraction) / own - 1)) < 1e-3


def test_the_atlas_is_of_smooth_faces():
    for call in (lambda: stoss.atlas(stoss.Sphere(poisson=0.3, u0=0.01), speed=0.1),
                 lambda: stoss.atlas(BALL, against=stoss.HardWall(u0=0.01), speed=0.1),
                 lambda: stoss.atlas(BALL, against=stoss.HalfSpace(u0=0.01), speed=0.1)):  # fmt: skip
        with pytest.raises(stoss.InvalidInput, match="smooth"):
            call()


def test_prediction_says_when_faces_count_as_smooth():
    ball = stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"])
    with pytest.warns(stoss.StossWarning, match="faces are taken as smooth"):
        slow = stoss.predict(ball, speed=1e-3)
    assert 0.02 < slow.rough_speed < 0.2
