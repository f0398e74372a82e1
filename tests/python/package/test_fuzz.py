"""Nothing that is passed to the package gives anything but a result, InvalidInput, NotConverged or a TypeError of the
signature; the private module stoss._core refuses too, without a crash."""

import inspect
import math
import os
import warnings

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import stoss
import stoss._core
from test_refusals import CALLS

# An example that takes longer than five seconds is a defect too.
# All of them in make test-long.
EXAMPLES = int(os.environ.get("STOSS_EXAMPLES", "100"))
FUZZ = settings(derandomize=True, database=None, deadline=5000, max_examples=EXAMPLES,
                suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large])  # fmt: skip
CHEAP = {"cutoff": 6.0, "tolerance": 0.1, "speed": 0.1, "poisson": 0.33}


def raising(name, error):
    """An object that raises when it is asked for a number in one way or another."""

    def method(self, *_, **__):
        raise error

    return type("Raising", (), {name: method, "__hash__": object.__hash__})()


METHODS = ["__array__", "__float__", "__index__", "__len__", "__getitem__", "__iter__", "__repr__", "__str__", "__eq__",
           "__bool__", "__format__", "__array_interface__", "__array_struct__", "__class_getitem__"]  # fmt: skip
ERRORS = [ZeroDivisionError("x"), TypeError("a\nb"), ValueError(), RecursionError(), AttributeError("y"), OSError(5)]
broken = st.builds(raising, st.sampled_from(METHODS), st.sampled_from(ERRORS))


class Lazy:
    """Numbers only through __array__, as some libraries have them."""

    def __init__(self, value):
        self.value = value

    def __array__(self, dtype=None, copy=None):
        return self.value


named = st.sampled_from(["array", "set", "dict", "list", "int", "str", "a\nb"]).map(lambda name: type(name, (), {})())
edges = st.sampled_from([0.0, -0.0, 1.0, -1.0, 0.5, 5e-324, 1e-308, 1e-8, 0.995, -0.95, 1e308, -1e308, math.inf,
                         math.nan, math.nextafter(0.995, 1), math.pi, 1e-100, 2**53 + 1, 2**64])  # fmt: skip
scalars = st.one_of(
    edges, st.floats(), st.floats(0.01, 1), st.integers(), st.integers(-3, 40), st.booleans(), st.none(), st.text(),
    st.binary(), st.complex_numbers(), st.decimals(), st.fractions(), st.integers(300, 5000).map(lambda n: (-10) ** n),
    st.floats(width=16).map(np.float16), st.floats().map(np.longdouble),
    st.floats(0.01, 1).map(type("Odd", (float,), {"__repr__": lambda _: 1 / 0})),
    st.sampled_from([np.datetime64("NaT"), np.timedelta64(1), Ellipsis, NotImplemented, float, print, slice(1)]),
)  # fmt: skip
small = arrays.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=3)
dtypes = st.one_of(arrays.scalar_dtypes(), arrays.array_dtypes(max_size=2))
valid = arrays.arrays(np.float64, small, elements=st.floats(0.05, 0.4))
some_arrays = st.one_of(arrays.arrays(dtypes, small), arrays.arrays(np.float64, small), valid)


def frozen(array):
    array = array.copy()
    array.flags.writeable = False
    return array


shaped = st.one_of(
    some_arrays, some_arrays.map(lambda a: a.astype(object)), valid.map(np.ma.array), valid.map(frozen),
    valid.map(lambda a: a[..., ::-1] if a.ndim else a),
    valid.map(np.asfortranarray), some_arrays.map(Lazy), valid.map(lambda a: a.astype(">f8")), valid.map(memoryview),
    valid.map(np.ndarray.tolist), valid.map(lambda a: np.repeat(a, 3, axis=-1)[..., ::3] if a.ndim else a),
)  # fmt: skip
anything = st.one_of(
    scalars, shaped, broken, named, st.lists(scalars, max_size=4), st.recursive(scalars, st.lists, max_leaves=9),
    st.dictionaries(st.text(), scalars, max_size=2), st.sets(st.integers(), max_size=2), st.builds(object),
    st.builds(lambda: (x for x in (1,))),
    st.builds(stoss.Rod), st.builds(stoss.HardWall), st.just(stoss.Disk(poisson=0.4)), st.just(stoss.Disk),
    st.just(stoss.ExponentialWall(hardness=20)), st.just(stoss.Material(young=1, poisson=0.2, density=1)),
    st.just(stoss.Disk(radius=1, material=stoss.Material(young=1, poisson=0.2, density=1))),
    st.just(stoss.Disk(poisson=0.4, radius=1.5)), st.just(stoss.Rod(length=2)), st.just("same"),
)  # fmt: skip


class Box:
    """Hides what is in it from hypothesis, which wants to print it."""

    def __init__(self, content):
        self.content = content

    def __repr__(self):
        try:
            return repr(self.content)
        except Exception as error:
            return f"<{type(self.content)!r}, whose repr raises {type(error).__name__}>"


@st.composite
def boxed(draw, contents):
    return Box(draw(contents))


boxes = boxed(anything)


def harmless(name, value):
    """Whether the value, if it is a valid one, is also a cheap one."""
    try:
        number = float(value)
    except Exception:
        number = math.nan
    # A grid of very many nodes, a great many steps or modes: allowed, but long.
    dear = {"cutoff": 20 < number <= 10000, "step": 0 < number < 0.01, "nodes": 100 < number <= 4096,
            "half_width": 0 < number < 0.2, "tolerance": 0 < number < 0.01, "progress": bool is type(value),
            "hardness": number > 1e3 or number < 10}  # fmt: skip
    if name in ("cutoffs", "hardnesses"):
        try:
            return bool(np.all(np.nan_to_num(np.asarray(value)) < 100))
        except Exception:
            return True
    return not dear.get(name, False)


def called(function, arguments):
    """Nothing but what is documented comes out."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            result = function(**arguments)
        except (stoss.InvalidInput, stoss.NotConverged) as refusal:
            assert str(refusal).isprintable() and len(str(refusal)) < 400, str(refusal)
            return None
        except MemoryError:
            return None
    assert repr(result) is not None
    return result


hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=6)
slip = stoss.oblique_impact(stoss.Disk(poisson=0.33), speed=0.1, angle=20, friction=0.3, cutoff=6)
modes = stoss.modes(poisson=0.33, cutoff=6)
DISK = stoss._core.encounter('{"first": {"kind": "disk", "poisson": 0.3}}')
RODS = stoss._core.encounter('{"first": {"kind": "rod"}, "against": "same"}')
PUBLIC = {
    "restitution": (stoss.restitution, CHEAP),
    "impact": (stoss.impact, CHEAP),
    "oblique_impact": (stoss.oblique_impact, {"body": stoss.Sphere(poisson=0.3), "friction": 0.3, "speed": 0.1,
                                              "cutoff": 6}),
    "modes": (stoss.modes, CHEAP),
    "Disk": (stoss.Disk, CHEAP),
    "Material": (stoss.Material, {"young": 1, "poisson": 0.3, "density": 1}),
    "Rod": (stoss.Rod, {}),
    "ExponentialWall": (stoss.ExponentialWall, {}),
    "trajectory": (hit.trajectory, {}),
    "oblique trajectory": (slip.trajectory, {}),
    "field": (hit.field, {"time": 1, "radius": 1, "angle": 0}),
    "displacement": (modes.displacement, {"order": 2, "index": 0, "radius": 0.5}),
    "find": (modes.find, {"order": 2, "index": 0}),
}
# One of four of the examples for each, as there are many.
QUASISTATIC = {name: call for name, call in CALLS.items() if call[0].__module__.startswith("stoss.quasistatic")}


def drawn_call(data, function, usual):
    """It is called with one or two arguments that may be anything."""
    parameters = list(inspect.signature(function).parameters)
    changed = data.draw(st.lists(st.sampled_from(parameters), min_size=1, max_size=2, unique=True))
    drawn = {}
    for each in changed:
        drawn[each] = data.draw(boxes.filter(lambda box, each=each: harmless(each, box.content)), each).content
    arguments = {key: value for key, value in usual.items() if key in parameters}
    if any(drawn.get(each) is not None for each in ("body", "material")):
        arguments.pop("poisson", None)  # so that it is looked at
    called(function, {**arguments, **drawn})


@pytest.mark.parametrize("name", PUBLIC)
@given(data=st.data())
@FUZZ
def test_public(name, data):
    drawn_call(data, *PUBLIC[name])


@pytest.mark.parametrize("name", QUASISTATIC)
@given(data=st.data())
@settings(FUZZ, max_examples=max(EXAMPLES // 4, 1))
def test_quasistatic(name, data):
    drawn_call(data, *QUASISTATIC[name])


@given(poisson=boxed(shaped), speed=boxed(shaped))
@FUZZ
def test_arrays(poisson, speed):
    result = called(stoss.restitution, {"poisson": poisson.content, "speed": speed.content, "tolerance": 0.1})
    if result is not None:
        assert np.shape(result.restitution) == np.shape(result.speed) == np.shape(result.poisson)
        assert np.all((0.3 < np.asarray(result.restitution)) & (np.asarray(result.restitution) <= 1))


@given(poisson=boxed(shaped), speed=boxed(shaped))
@FUZZ
def test_arrays_of_slow_impacts(poisson, speed):
    result = called(stoss.quasistatic.slow_impact, {"poisson": poisson.content, "speed": speed.content})
    if result is not None:
        assert np.shape(result.contact_time) == np.shape(result.speed) == np.shape(result.poisson)
        assert np.all((np.asarray(result.contact_time) > 3) & (np.asarray(result.max_force) < 1))


@given(data=st.data())
@FUZZ
def test_private(data):
    """The compiled module alone, with whatever fits its signatures badly. A crash would end the tests."""
    core = stoss._core
    doors = [getattr(core, name) for name in dir(core) if inspect.isbuiltin(getattr(core, name))]
    doors += [hit._handle.trajectory, hit._handle.numbers, hit._handle.modes, core.Encounter, core.Frames.summaries]
    function = data.draw(st.sampled_from(doors))
    usual = [0.3, 0.1, 3, True, np.array([0.1, 0.2]), RODS.contact(9.0, 1.0), DISK, hit._handle, [], len]
    usual += ["sphere", DISK.refinable(), np.zeros(2, core.restitution_row), RODS, DISK.contact(5.0, 1.0)]
    cheap = boxes.filter(lambda box: harmless("tolerance", box.content))
    arguments = data.draw(st.lists(boxed(st.sampled_from(usual)) | cheap, max_size=7))
    try:
        function(*(box.content for box in arguments))
    except (TypeError, ValueError, stoss.NotConverged, MemoryError, RuntimeError):
        pass
