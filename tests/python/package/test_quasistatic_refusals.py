"""stoss.quasistatic: what is refused, and how; nothing that is passed gives anything but a result or a refusal."""

import inspect
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from test_fuzz import FUZZ, boxed, boxes, called, harmless, shaped

import stoss
from stoss import quasistatic

nan, inf = math.nan, math.inf
USUAL = {
    "poisson": 0.33, "speed": 0.01, "force": 0.01, "compression": 0.01, "depth": 0.1, "x": 1.0, "y": 0.1, "cutoff": 6,
    "psi1": 2.0, "chi": 1.4, "displacement": 0.2, "tangential": 0.3, "distance": 0.5,
}  # fmt: skip
BALL = stoss.Sphere(poisson=0.3)
HARD = stoss.Sphere(radius=0.01, material=stoss.Material(young=2e11, poisson=0.3, density=8e3, yield_strength=1e9))
FUNCTIONS = [getattr(quasistatic, name) for name in quasistatic.__all__ if name[0].islower()]
BAD = {
    "poisson": [-1, 1, nan, inf, "0.3", True, [0.3, nan], 1j],
    "speed": [0, -0.1, 1e-101, 0.3, nan, inf, "x", [0.01, 0.3], {}],
    "force": [-1e-9, 2, nan, inf, "x", [0.01, -1]],
    "compression": [-0.6, 0.7, nan, inf, "x", b"1"],
    "depth": [-1e-9, nan, inf, "x"],
    "y": [nan, inf, "x", np.True_],
    "x": [-0.01, 2.1, nan, "x"],
    "psi1": [2e6, nan, inf, "x"],
    "chi": [0, -1, 1001, nan, "x", [1, 0]],
    "tolerance": [0, 1e-9, 0.2, nan, "x", [1e-3]],
    "displacement": [nan, inf, "x"],
    "tangential": [-1.1, 1.1, nan, "x"],
    "distance": [-0.1, nan, inf, "x"],
    "cutoff": [0, -1, 1001, nan, "x", [6, 7]],
    "nodes": [0, 15, 5000, 16.0, "16", True],
    "law": ["", "Center", 1, ["center"]],
    "contact": ["", "Hertz", 1, None],
    "against": [stoss.HardWall(), "soft", None],
}


def usual(function):
    """The names of the arguments, and arguments with which the function works."""
    parameters = inspect.signature(function).parameters
    arguments = {name: USUAL[name] for name in parameters if name in USUAL}
    if "body" in parameters and parameters["body"].default is inspect.Parameter.empty:
        arguments["body"] = HARD
    return list(parameters), arguments


def of_a_sphere(function):
    """The same, of a sphere in its units."""
    names, arguments = usual(function)
    given = {name: value for name, value in arguments.items() if name != "poisson"}
    return names, {**given, "body": HARD if function is quasistatic.yield_speed else BALL}


@pytest.mark.parametrize("usually", [usual, of_a_sphere])
@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda each: each.__name__)
def test_refusals(function, usually):
    names, arguments = usually(function)
    if usually is of_a_sphere and "body" not in names:
        return  # of disks alone
    assert function(**arguments) is not None
    with pytest.raises(TypeError, match="positional"):
        function(0.3, 0.3)
    bodies = [stoss.Rod(), "disk", 0.3, [BALL]] if "body" in names else []
    for name in set(names) & set(BAD) | {"body"} & set(names):
        for value in bodies if name == "body" else BAD[name]:
            if value == inspect.signature(function).parameters[name].default:
                continue
            with pytest.raises(stoss.InvalidInput, match=r"^[\w ]+: got .+, allowed .+") as caught:
                function(**{**arguments, name: value})
            assert str(caught.value).isprintable() and len(str(caught.value)) < 300


def test_refusals_of_combinations(steel):
    with pytest.raises(stoss.InvalidInput, match="^law: got 'diameter', allowed 'center' or 'hertz'$"):
        quasistatic.slow_impact(BALL, speed=0.01, law="diameter")
    with pytest.raises(stoss.InvalidInput, match="^law: got 'hertz', allowed 'center' or 'diameter'$"):
        quasistatic.compression(poisson=0.3, force=0.01, law="hertz")
    with pytest.raises(stoss.InvalidInput, match="^distance: got -0.1, allowed"):
        quasistatic.hertz_pressure(BALL, force=0.01, y=-0.1)
    for pair in ({"body": BALL}, {"body": HARD, "against": BALL}):
        with pytest.raises(stoss.InvalidInput, match=r"^(body|against): got Sphere\(.*\), allowed a stoss.Sphere"):
            quasistatic.yield_speed(**pair)
    for function in (quasistatic.slow_impact, quasistatic.rayleigh):
        for given_ in ({}, {"poisson": 0.3, "body": steel}, {"body": "steel"}, {"body": stoss.Rod()}):
            with pytest.raises(stoss.InvalidInput, match="^body: got "):
                function(speed=0.01, **given_)
    with pytest.raises(stoss.InvalidInput, match=r"^poisson, speed: got shapes \(2,\) and \(3,\), allowed shapes that"):
        quasistatic.slow_impact(poisson=[0.1, 0.2], speed=[0.1, 0.1, 0.1])
    with pytest.raises(stoss.InvalidInput, match=r"^force, depth, y: got shapes \(2,\) and \(\) and \(3,\), allowed"):
        quasistatic.hertz_stress(force=[0.1, 0.2], depth=0, y=[0.1, 0.1, 0.1])
    core, two, three = stoss._core, np.full(2, 0.1), np.full(3, 0.1)
    for call in (lambda: core.compression("center", two, three), lambda: core.slow_impact("law", two, two)):
        with pytest.raises(ValueError):
            call()


@pytest.mark.parametrize("usually", [usual, of_a_sphere])
@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda each: each.__name__)
@given(data=st.data())
@FUZZ
def test_fuzz(function, usually, data):
    names, arguments = usually(function)
    if usually is of_a_sphere and "body" not in names:
        return  # of disks alone
    for name in data.draw(st.lists(st.sampled_from(names), min_size=1, max_size=2, unique=True)):
        box = data.draw(boxes.filter(lambda box, name=name: harmless(name, box.content)), name)
        arguments[name] = box.content
    called(function, arguments)


@given(poisson=boxed(shaped), speed=boxed(shaped))
@FUZZ
def test_fuzz_of_arrays(poisson, speed):
    result = called(quasistatic.slow_impact, {"poisson": poisson.content, "speed": speed.content})
    if result is not None:
        assert np.shape(result.contact_time) == np.shape(result.speed) == np.shape(result.poisson)
        assert np.all((np.asarray(result.contact_time) > 3) & (np.asarray(result.max_force) < 1))
