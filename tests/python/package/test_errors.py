"""What stoss refuses, and how it says so: one line, the name, what was got, what is allowed."""

import re

import numpy as np
import pytest

import stoss
from stoss import quasistatic

nan, inf = float("nan"), float("inf")
DISK = {"poisson": 0.33, "speed": 0.1}
METAL = {"young": 2e11, "poisson": 0.3, "density": 7850}


class Broken:
    """Everything that can be asked of it raises."""

    def _raise(self, *_):
        raise ZeroDivisionError("broken")

    __array__ = __float__ = __index__ = __len__ = __getitem__ = __iter__ = __repr__ = __str__ = __eq__ = _raise
    __hash__ = None


class array:  # reprlib knows how to show the real one
    pass


def restitution(**changed):
    return stoss.restitution(**{**DISK, "tolerance": 0.1, **changed})


def impact(**changed):
    return stoss.impact(**{**DISK, "cutoff": 6, **changed})


def material(**changed):
    return stoss.Material(**{**METAL, **changed})


def in_si(**changed):
    return stoss.Disk(**{"radius": 0.01, "material": material(), **changed})


def rod(**changed):
    return stoss.Rod(**changed)


def modes(**changed):
    return stoss.modes(**{"poisson": 0.33, "cutoff": 6, **changed})


def field(**changed):
    return impact().field(**{"time": 1, "radius": 1, "angle": 0, **changed})


def trajectory(**changed):
    return impact().trajectory(**changed)


def displacement(**changed):
    return modes().displacement(**{"order": 2, "index": 0, "radius": 1, **changed})


def disk(**changed):
    return stoss.Disk(**{"poisson": 0.3, **changed})


def soft(**changed):
    return stoss.ExponentialWall(**changed)


RANGES = [
    (disk, "poisson", [-1, -0.9501, 0.996, 1, nan, inf]),
    (restitution, "poisson", [-1, 1, nan, inf, [0.3, 1], [nan, 0.3]]),
    (restitution, "speed", [0, -0.1, 9e-9, 1.01, nan, inf, -inf, 1e300, [0.1, nan], [[0.1, 2]]]),
    (restitution, "tolerance", [0, -1, 1e-16, 0.6, nan, inf]),
    (restitution, "absolute", [-1e-9, 0.6, nan, inf]),
    (restitution, "threads", [-1, 1025, 2**31 - 1]),
    (impact, "poisson", [1, nan]),
    (impact, "speed", [0, 1.01, nan]),
    (impact, "cutoff", [0, -1, 1001, nan, inf]),
    (impact, "step", [0, -1, 4e-6, 1, nan, inf]),
    (impact, "nodes", [0, -1, 15, 4097]),
    (impact, "half_width", [0, -1, 3.2, nan, inf]),
    (modes, "poisson", [1, nan]),
    (modes, "cutoff", [-1, 1001, nan]),
    (soft, "hardness", [0.9, 1.1e6, nan, inf]),
    (soft, "strength", [0, -1, nan, inf]),
    (material, "young", [0, -1, nan, inf]),
    (material, "poisson", [-1, 0.5, nan, inf]),
    (material, "density", [0, -1, nan]),
    *((disk, name, [0, -1, nan, inf]) for name in ("radius", "young", "density")),
    *((rod, name, [0, -1, nan, inf]) for name in ("length", "young", "density", "area")),
    (in_si, "radius", [0, -1, nan]),
    (in_si, "young", [1, nan]),
    (in_si, "poisson", [0.2, nan]),
    (trajectory, "every", [0, -1]),
    (field, "time", [nan, inf, 1.1e4, [1, -inf]]),
    (field, "radius", [-0.1, 1.1, nan, []]),
    (field, "angle", [nan, inf, []]),
    (displacement, "radius", [-0.1, 1.1, nan]),
]
NUMBERS = [  # of what no number can be made; None is left out where it means something
    "0.1", "", b"1", True, np.True_, [True], 1j, [0.1, "x"], [[0.1], [0.1, 0.2]], {}, {1: 2}, {0.1}, object(),
    Broken(), [Broken()], array(), 10**5000, [10**400], np.array([0.1], dtype=object), np.ma.array([0.1], mask=[True]),
    slice(3), np.datetime64("2020"), np.zeros(2, dtype="f8,i4"), float, Ellipsis, lambda: 0.1, iter(()), None,
]  # fmt: skip
INTEGERS = [0.5, 16.0, nan, "16", True, [16], 10**10, -(10**5000), Broken(), np.array([16, 17]), object()]
WRONG = {
    **{(make, name): NUMBERS for make, name, _ in RANGES if name not in ("threads", "nodes", "every")},
    (restitution, "threads"): [*INTEGERS, None],
    (impact, "nodes"): INTEGERS,
    (trajectory, "every"): [*INTEGERS, None],
    (displacement, "order"): [*INTEGERS, None],
    (displacement, "index"): [*INTEGERS, None],
    (restitution, "progress"): [1, 0, None, "yes", [], Broken()],
    (impact, "against"): ["hard", stoss.HardWall, Broken(), stoss.Rod(), in_si(), 0.3],
    (restitution, "against"): ["hard", stoss.HardWall, Broken(), stoss.Rod(), in_si(), soft()],
    (impact, "body"): [stoss.Disk, 0.3, "disk", Broken(), stoss.HardWall()],
    (in_si, "material"): [{}, "steel", METAL, Broken()],
    (field, "of"): [1, 2, -1, *INTEGERS, None],
    (impact, "tail"): ["", "Static", None, 1, ["static"], Broken()],
    (in_si, "plane"): ["", "Strain", 1, Broken()],
    (disk, "plane"): ["stress", 1, Broken()],
}
MAY_BE_NONE = [(impact, "cutoff"), (impact, "step"), (impact, "half_width"), (impact, "poisson"), (modes, "poisson"),
               (restitution, "poisson"), (field, "radius"), (field, "angle"), (disk, "radius"), (disk, "young"),
               (disk, "density"), (in_si, "young"), (in_si, "poisson"), (rod, "length"), (rod, "young"),
               (rod, "density"), (rod, "area")]  # fmt: skip
ONE = ("cutoff", "tolerance", "absolute", "step", "half_width", "young", "strength")
SCALARS = [(make, name) for make, name, _ in RANGES if name in ONE]


def refused(make, name, value):
    """The message, which must have its form."""
    with pytest.raises(stoss.InvalidInput) as caught:
        make(**{name: value})
    message = str(caught.value)
    assert message.isprintable() and len(message) < 300, message  # one line
    stem = re.escape(name.removesuffix("es").removesuffix("s"))
    assert re.match(rf"(number of )?{stem}\w*( count)?: (got .+, allowed .+|missing.+)", message), message
    assert isinstance(caught.value, ValueError) and caught.value.__cause__ is None
    return message


@pytest.mark.parametrize("make, name, value", [(m, n, v) for m, n, all_ in RANGES for v in all_])
def test_out_of_range(make, name, value):
    refused(make, name, value)


@pytest.mark.parametrize("make, name", WRONG)
def test_wrong_kind(make, name):
    for value in WRONG[make, name]:
        if value is None and (make, name) in MAY_BE_NONE:
            continue
        refused(make, name, value)


@pytest.mark.parametrize("make, name", SCALARS)
def test_one_number_only(make, name):
    for value in ([1.0], [], np.ones((1, 1))):
        assert "one number" in refused(make, name, value)


def test_messages_tell_what_was_got():
    assert refused(restitution, "speed", [0.1, -0.25]).startswith("speed: got -0.25, allowed 1e-8 to 1")
    assert refused(disk, "poisson", 1.5).startswith("poisson: got 1.5, allowed -0.95 to 0.995")
    assert refused(restitution, "speed", "fast").startswith("speed: got 'fast', allowed a number")
    assert len(refused(restitution, "speed", [["x" * 99] * 99] * 99)) < 200


def test_shapes_that_do_not_fit():
    with pytest.raises(stoss.InvalidInput, match=r"^poisson, speed: got shapes \(2,\) and \(3,\), allowed shapes that"):
        stoss.restitution(poisson=[0.1, 0.2], speed=[0.1, 0.2, 0.3])


def test_one_body_only(steel):
    for given in ({}, {"poisson": 0.3, "body": steel}, {"poisson": 0.3, "body": stoss.Rod()}):
        for call in (stoss.restitution, stoss.impact):
            with pytest.raises(stoss.InvalidInput, match="^body: got .*, allowed one of body and poisson$"):
                call(speed=0.1, **given)
    for call in (stoss.restitution, stoss.impact):
        with pytest.raises(stoss.InvalidInput, match="^body: got 'steel', allowed a stoss"):
            call("steel", speed=0.1)
    for call in (stoss.modes, quasistatic.slow_impact, quasistatic.rayleigh):
        with pytest.raises(stoss.InvalidInput, match="^body: got Rod.., allowed a stoss.Disk"):
            call(stoss.Rod(), **({"cutoff": 6} if call is stoss.modes else {"speed": 1e-3}))
    with pytest.raises(stoss.InvalidInput, match="^radius: missing .a material needs it too, in SI"):
        stoss.Disk(material=steel.material)
    with pytest.raises(AttributeError, match="^scales: Disk.poisson=0.3. has no material"):
        _ = stoss.Disk(poisson=0.3).scales
    with pytest.raises(stoss.InvalidInput, match="^body: got Rod.., allowed a stoss.Disk"):
        stoss.impact(stoss.Rod(), speed=0.1, cutoff=20).field(time=1)
    with pytest.raises(stoss.InvalidInput, match=r"^mode: got \(n, l\) = \(2, 99\), allowed"):
        modes().find(2, 99)
    with pytest.raises(AttributeError, match="^speed_si: this result has no material"):
        _ = impact().speed_si


def test_materials_are_refused_by_the_core():
    both = "'structural steel' (yields at 235 MPa) or 'bearing steel' (at 1.7 GPa)"
    with pytest.raises(stoss.InvalidInput) as old:
        _ = stoss.materials["steel"]
    assert str(old.value).startswith(f"material: got 'steel', allowed {both}") and "\n" not in str(old.value)
    with pytest.raises(stoss.InvalidInput, match="^material: got 'steal', allowed structural steel, glass, "):
        _ = stoss.materials["steal"]
    assert "steel" not in stoss.materials and stoss.materials.get("steel") is None
    bodies = {"kind": "sphere", "radius": 1.0, "material": "steel"}
    with pytest.raises(stoss.InvalidInput) as in_a_grid:
        stoss.Grid(bodies=bodies, against=["wall"], speed=[1.0])
    assert str(in_a_grid.value) == f"bodies: {old.value}"


@pytest.mark.parametrize("call", [stoss.restitution, stoss.impact])
def test_speed_of_a_material_is_in_si(call, steel):
    with pytest.raises(stoss.InvalidInput) as caught:
        call(steel, speed=6000)
    assert str(caught.value).startswith("speed: got ") and "5172" in str(caught.value) and "m/s" in str(caught.value)
    with pytest.raises(stoss.InvalidInput, match="^speed: got"):
        call(steel, speed=1e308)


def test_a_hard_wall_says_where_its_tail_went():
    with pytest.raises(TypeError, match=r"^HardWall: got tail, .*stoss\.impact\(\.\.\., tail='static'\)$"):
        stoss.HardWall(tail="static")


def test_signatures():
    for call in (stoss.restitution, stoss.impact, stoss.modes):
        with pytest.raises(TypeError, match="positional"):
            call(disk(), 0.1)
    calls = [stoss.Disk, stoss.Material]
    calls += [stoss.HardWall, stoss.ExponentialWall, stoss.Rod]
    calls += [impact().trajectory, impact().field, modes().displacement]
    for call in calls:
        with pytest.raises(TypeError, match="positional"):
            call(0.3)
        with pytest.raises(TypeError, match="unexpected keyword"):
            call(poison=0.3)
    for call in (stoss.restitution, stoss.impact, stoss.modes):
        with pytest.raises(TypeError, match="missing"):
            call()
