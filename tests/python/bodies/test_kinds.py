"""The classes of bodies, blocks and walls are those of the core's table of kinds: names, order, defaults, ranges."""

import dataclasses
import json
import math

import pytest
import stoss

CLASSES = {"disk": stoss.Disk, "sphere": stoss.Sphere, "rod": stoss.Rod, "half-space": stoss.HalfSpace,
           "half-plane": stoss.HalfPlane, "plate": stoss.Plate, "strip": stoss.Strip,
           "exponential": stoss.ExponentialWall}  # fmt: skip
PLATES = ("plate", "strip")
WORDS = {"wall", "same"}  # which have no numbers
FILES = {"modal": stoss.ModalBody}  # which are given by documents of their own (test_modal.py)
KINDS = {
    name: {"wall": wall, "bounded": bounded, "rigid": rigid, "plane": plane, "file": file, "numbers": numbers}
    for name, wall, bounded, rigid, plane, file, numbers in stoss._core.kinds()
}
NUMBERS = [(kind, *number) for kind in CLASSES for number in KINDS[kind]["numbers"]]
EACH = pytest.mark.parametrize("kind", CLASSES)


def made(kind, **given):
    """One of that kind, with the numbers that it must have."""
    needed = {"poisson": 0.3} if kind in ("disk", "sphere") else {"thickness": 2.0} if kind in PLATES else {}
    return CLASSES[kind](**{**needed, **given})


def test_there_is_a_class_for_every_kind():
    assert set(KINDS) == set(CLASSES) | WORDS | set(FILES)
    assert all(not KINDS[word]["numbers"] for word in WORDS | set(FILES))
    assert {name for name, its in KINDS.items() if its["file"]} == set(FILES)
    assert all(made._kind == name for name, made in FILES.items())


@EACH
def test_fields_are_the_parameters_of_the_core(kind):
    fields = [field.name for field in dataclasses.fields(CLASSES[kind])]
    numbers = [name for name, *_ in KINDS[kind]["numbers"]]
    flags = [name for name in ("plane", "rigid") if KINDS[kind][name]] + ["layers"] * (kind == "plate")
    assert fields == numbers + ([] if KINDS[kind]["wall"] else ["material"]) + flags


@EACH
def test_what_is_left_out_is_what_the_core_takes(kind):
    one = made(kind)
    for name, _, otherwise, *_, of_material in KINDS[kind]["numbers"]:
        if otherwise is not None:
            assert getattr(one, name) == otherwise
        elif KINDS[kind]["bounded"] or not of_material:
            with pytest.raises(stoss.InvalidInput, match=f"^{name}: missing"):
                CLASSES[kind]()
        else:
            assert getattr(one, name) is None  # that of the first body


@EACH
def test_a_material_makes_what_the_core_says(kind):
    if KINDS[kind]["wall"]:
        return
    steel, sizes = stoss.materials["structural steel"], {"radius", "length", "area", "thickness"}
    own = [name for name, *_, of_material in KINDS[kind]["numbers"] if not of_material and name in sizes]
    one = CLASSES[kind](material=steel, **dict.fromkeys(own, 0.01))
    assert own == {"rod": ["length", "area"], "disk": ["radius"], "sphere": ["radius"]}.get(
        kind, ["thickness"] if kind in PLATES else []
    )
    for name, *_, of_material in KINDS[kind]["numbers"]:
        if of_material:
            assert getattr(one, name) == getattr(steel, name)
            with pytest.raises(stoss.InvalidInput, match=f"^{name}: got .*, allowed none with a material"):
                CLASSES[kind](material=steel, **dict.fromkeys(own, 0.01), **{name: 0.1})


@pytest.mark.parametrize("kind, name, unit, otherwise, low, high, low_included, of_material", NUMBERS)
def test_ranges_are_those_of_the_core(kind, name, unit, otherwise, low, high, low_included, of_material):
    below = math.nextafter(low, -math.inf) if low_included else low
    for value in (below, math.nan, *((math.nextafter(high, math.inf),) if math.isfinite(high) else (math.inf,))):
        with pytest.raises(stoss.InvalidInput, match=f"^{name}: got "):
            made(kind, **{name: value})
    for value in ((low,) if low_included else ()) + ((high,) if math.isfinite(high) else ()):
        assert getattr(made(kind, **{name: value}), name) == value


@EACH
def test_an_encounter_is_the_document_of_the_core(kind):
    if not KINDS[kind]["bounded"]:
        return
    body = made(kind, young=2.5, density=1.5)
    document = json.loads(stoss.bodies._encounter.encounter(body, body).to_json())
    numbers = {name: getattr(body, name) for name, *_ in KINDS[kind]["numbers"]}
    assert document.pop("format").startswith("stoss encounter ")
    assert document == {"first": {"kind": kind, **numbers}, "against": {"kind": kind, **numbers}}
