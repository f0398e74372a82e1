"""The classes of bodies, blocks and walls are those of the core's table of kinds: names, order, defaults, ranges; they,
walls and materials are values."""

import copy
import dataclasses
import json
import math
import pickle

import numpy as np
import pytest
import stoss
import stoss.bodies._encounter
import stoss._core
from wrong_values import NUMBERS as NO_NUMBERS
from wrong_values import SEVERAL

CLASSES = {"disk": stoss.Disk, "sphere": stoss.Sphere, "hollow-sphere": stoss.HollowSphere,
           "rod": stoss.Rod, "half-space": stoss.HalfSpace,
           "half-plane": stoss.HalfPlane, "plate": stoss.Plate, "strip": stoss.Strip,
           "exponential": stoss.ExponentialWall}  # fmt: skip
PLATES = ("plate", "strip")
WALLS = {"wall": stoss.HardWall}
WORDS = {"same"}  # which have no numbers
OF_WALL = ("roughness", "u0")
COAT = ("coat", "coat_young", "coat_poisson", "coat_quality", "yield_strength", "yield_hardening", "yield_rate")  # which go together
FACE = (*OF_WALL, *COAT)  # whose lengths are limited by the first body
FILES = {"modal": stoss.ModalBody}  # which are given by documents of their own (test_modal.py)
KINDS = {
    name: {"wall": wall, "bounded": bounded, "rigid": rigid, "plane": plane, "file": file, "numbers": numbers}
    for name, wall, bounded, rigid, plane, file, numbers in stoss._core.kinds()
}
NUMBERS = [(kind, *number) for kind in CLASSES for number in KINDS[kind]["numbers"] if number[0] not in COAT]
EACH = pytest.mark.parametrize("kind", CLASSES)


def made(kind, **given):
    """One of that kind, with the numbers that it must have."""
    needed = {"poisson": 0.3} if kind in ("disk", "sphere", "hollow-sphere") else {}
    needed |= {"thickness": 2.0} if kind in PLATES else {"inner": 0.9} if kind == "hollow-sphere" else {}
    return CLASSES[kind](**{**needed, **given})


def test_there_is_a_class_for_every_kind():
    assert set(KINDS) == set(CLASSES) | set(WALLS) | WORDS | set(FILES)
    assert all(not KINDS[word]["numbers"] for word in WORDS)
    for kind, numbers in {**dict.fromkeys(WALLS, OF_WALL), **dict.fromkeys(FILES, FACE)}.items():
        assert tuple(name for name, *_ in KINDS[kind]["numbers"]) == numbers
    assert {name for name, its in KINDS.items() if its["file"]} == set(FILES)
    assert all(made._kind == name for name, made in FILES.items())


@EACH
def test_fields_are_the_parameters_of_the_core(kind):
    fields = [field.name for field in dataclasses.fields(CLASSES[kind])]
    numbers = [name for name, *_ in KINDS[kind]["numbers"]]
    flags = [name for name in ("plane", "rigid") if KINDS[kind][name]] + ["layers"] * (kind == "plate")
    assert fields == numbers + ([] if KINDS[kind]["wall"] else ["relaxation", "material"]) + flags


@EACH
def test_what_is_left_out_is_what_the_core_takes(kind):
    one = made(kind)
    for name, _, otherwise, *_, of_material in KINDS[kind]["numbers"]:
        if otherwise is not None:
            assert getattr(one, name) == otherwise
        elif KINDS[kind]["bounded"] or not of_material:
            with pytest.raises(stoss.InvalidInput, match=f"^{name}: missing"):
                CLASSES[kind](**{each: 0.3 for each, _, usual, *_ in KINDS[kind]["numbers"] if usual is None and each != name})
        else:
            assert getattr(one, name) is None  # that of the first body


@EACH
def test_a_material_makes_what_the_core_says(kind):
    if KINDS[kind]["wall"]:
        return
    steel, sizes = stoss.materials["structural steel"], {"radius", "length", "area", "thickness", "inner"}
    own = [name for name, *_, of_material in KINDS[kind]["numbers"] if not of_material and name in sizes]
    one = CLASSES[kind](material=steel, **dict.fromkeys(own, 0.01))
    of_balls = {"sphere": ["radius"], "hollow-sphere": ["radius", "inner"]}
    assert own == {"rod": ["length", "area"], "disk": ["radius"], **of_balls}.get(
        kind, ["thickness"] if kind in PLATES else []
    )
    for name, *_, of_material in KINDS[kind]["numbers"]:
        if of_material:
            assert getattr(one, name) == getattr(steel, name)
            with pytest.raises(stoss.InvalidInput, match=f"^{name}: got .*, allowed none with a material"):
                CLASSES[kind](material=steel, **dict.fromkeys(own, 0.01), **{name: 0.1})


@pytest.mark.parametrize("kind, name, unit, otherwise, low, high, low_included, of_material", NUMBERS)
def test_ranges_are_those_of_the_core(kind, name, unit, otherwise, low, high, low_included, of_material):
    high = math.inf if name in FACE else high
    below = math.nextafter(low, -math.inf) if low_included else low
    for value in (below, math.nan, *((math.nextafter(high, math.inf),) if math.isfinite(high) else (math.inf,))):
        with pytest.raises(stoss.InvalidInput, match=f"^{name}: got "):
            made(kind, **{name: value})
    for value in [*NO_NUMBERS, *SEVERAL]:
        if value is not None:
            with pytest.raises(stoss.InvalidInput, match=f"^{name}: got .+, allowed .+$"):
                made(kind, **{name: value})
    for value in ((low,) if low_included else ()) + ((high,) if math.isfinite(high) else ()):
        assert getattr(made(kind, **{name: value}), name) == value


@EACH
def test_an_encounter_is_the_document_of_the_core(kind):
    if not KINDS[kind]["bounded"]:
        return
    body = made(kind, young=2.5, density=1.5)
    document = json.loads(stoss.bodies._encounter.encounter(body, body).to_json())
    numbers = {name: getattr(body, name) for name, *_ in KINDS[kind]["numbers"] if name not in (*FACE, "extra_mass")}
    assert document.pop("format").startswith("stoss encounter ")
    assert document == {"first": {"kind": kind, **numbers}, "against": {"kind": kind, **numbers}}


RUBBER = stoss.Material(young=2e6, poisson=0.49, density=1100, loss_time=1 / (10 * 2 * np.pi * 500))
GLASS, PVB = stoss.materials["glass"], stoss.materials["PVB"]
PANE, FILM = stoss.Layer(thickness=4e-3, material=GLASS), stoss.Layer(thickness=0.8e-3, material=PVB)
LAMINATED = stoss.Plate(layers=[PANE, FILM, PANE], loss_time=0)
COATED = stoss.Plate(layers=[stoss.Layer(thickness=0.1, young=4), stoss.Layer(poisson=0.2)])
IN_SI = [stoss.Sphere(radius=5e-3, material=RUBBER), stoss.Disk(radius=5e-3, material=RUBBER, plane="strain"),
         stoss.Rod(length=5e-3, area=1e-4, material=RUBBER), stoss.HalfSpace(material=RUBBER), stoss.HalfPlane(material=RUBBER),
         stoss.Strip(thickness=0.01, material=RUBBER)]  # fmt: skip
VALUES = [
    *(made(kind) for kind in CLASSES), *(made(kind, **{KINDS[kind]["numbers"][0][0]: 0.4}) for kind in ("disk", "sphere", "plate")),
    stoss.HardWall(), stoss.HardWall(u0=0.1), stoss.HalfSpace(roughness=0.1), stoss.ExponentialWall(hardness=9), stoss.Rod(area=2, loss_time=2), stoss.HalfSpace(young=2, loss_time=0.1),
    stoss.Disk(poisson=0.3, rigid=True), stoss.Sphere(radius=5e-3, material=RUBBER, rigid=True), RUBBER, GLASS, PANE, LAMINATED, COATED,
    *IN_SI,
]  # fmt: skip


@pytest.mark.parametrize("one", VALUES, ids=repr)
def test_they_are_values(one):
    for twin in (copy.deepcopy(one), pickle.loads(pickle.dumps(one)), dataclasses.replace(one), eval(repr(one), vars(stoss))):
        assert one == twin and hash(one) == hash(twin) and repr(one) == repr(twin)
    assert [one == other for other in VALUES].count(True) == 1 and len({*VALUES}) == len(VALUES)
    for field in dataclasses.fields(one):
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(one, field.name, getattr(one, field.name))


@pytest.mark.parametrize("lossy", IN_SI, ids=repr)
def test_bodies_have_the_loss_time_of_their_material(lossy):
    elastic = dataclasses.replace(lossy, loss_time=0)
    assert lossy.loss_time == RUBBER.loss_time and elastic.loss_time == 0
    assert dataclasses.replace(lossy, loss_time=RUBBER.loss_time) == lossy != elastic
    assert "loss_time" not in repr(lossy).partition("material=")[0] and "loss_time=0" in repr(elastic)


def test_a_material_keeps_its_loss_time_and_a_rigid_body_loses_nothing():
    assert dataclasses.replace(RUBBER, young=1e6).loss_time == RUBBER.loss_time
    assert stoss.Sphere(radius=5e-3, material=RUBBER, rigid=True).loss_time == 0


def test_a_wall_has_a_name_as_in_the_command():
    ball = stoss.Sphere(poisson=0.3)
    steel = stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"], loss_time=0)
    calls = {
        "restitution": lambda against: stoss.restitution(ball, against=against, speed=0.01),
        "impact": lambda against: stoss.impact(ball, against=against, speed=0.01, cutoff=5),
        "oblique": lambda against: stoss.oblique(ball, against=against, speed=0.01, angle=10, friction=0.1),
        "predict": lambda against: stoss.predict(steel, against=against, speed=0.1),
    }
    for name, call in calls.items():
        assert call("wall").restitution == call(stoss.HardWall()).restitution, name
    assert stoss.quasistatic.yield_speed(steel, against="wall") == stoss.quasistatic.yield_speed(steel)
    with pytest.raises(stoss.InvalidInput, match="'wall', 'same'"):
        stoss.restitution(ball, against="floor", speed=0.01)
    with pytest.raises(stoss.InvalidInput, match="got 'wall', allowed None, 'same'"):
        stoss.pair_table(ball, against="wall", ratio=(1, 2), speed=(0.01, 0.1))
