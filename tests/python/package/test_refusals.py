"""What is out of range or of a wrong type is refused, of every argument of every function, in one line that begins with
its name. Ranges are those of the core's table of inputs; those that the table does not have are here."""

import inspect
import math
import re

import numpy as np
import pytest
import stoss
import stoss._core
from stoss import quasistatic
from wrong_values import BODIES, FLAGS, INTEGERS, NUMBERS, SEVERAL, WORDS, inf, nan

BALL, RODS = stoss.Sphere(poisson=0.3), [stoss.Rod(), stoss.Rod(length=2)]
DROP = stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"])
GLASS = stoss.Sphere(radius=0.05, material=stoss.Material(young=7e10, poisson=0.22, density=2500))
HIT = stoss.impact(poisson=0.33, speed=0.1, cutoff=6)
HEARD = stoss.impact(GLASS, speed=1.0, cutoff=4)
WAVES = stoss.impact(BALL, against=stoss.HalfSpace(), speed=0.1, cutoff=4)
SLIP = stoss.oblique_impact(BALL, speed=0.1, angle=20, friction=0.3, cutoff=6)
STRUCK = stoss.pulse(BALL, against=stoss.HalfSpace(), speed=0.1)
MODES = stoss.modes(poisson=0.33, cutoff=6)
FUNCTION = stoss.restitution_function(BALL, speed=(0.05, 0.1), error=0.05)
PAIRS = stoss.pair_table(poisson=0.33, speed=(0.05, 0.1), ratio=(1, 1.2), error=0.05)
METAL = {"young": 2e11, "poisson": 0.3, "density": 7850}

GLASS = stoss.Material(young=7e10, poisson=0.22, density=2500, quality=50)
BALL_OF_GLASS = stoss.Sphere(radius=0.01, material=GLASS)
DATA = {"speed": [1.0], "restitution": [0.97], "restitution_uncertainty": [0.01]}

# Each function and arguments with which it works; those of the table of inputs by the name of the question.
ONE, ENDS = {"speed": 0.1}, {"speed": (0.01, 0.1)}
CALLS = {
    "restitution": (stoss.restitution, {"body": BALL, **ONE}),
    "oblique": (stoss.oblique, {"body": BALL, **ONE, "friction": 0.1}),
    "distribution": (stoss.restitution_distribution, {"body": BALL, **ONE, "temperature": 0.01, "samples": 2}),
    "predict": (stoss.predict, {"body": DROP, **ONE}),
    "impact": (stoss.impact, {"body": BALL, **ONE, "cutoff": 6}),
    "bounce": (stoss.bounce, {"body": BALL, **ONE, "count": 2, "flight_time": 30}),
    "calibrate": (stoss.calibrate, {"data": DATA, "body": BALL_OF_GLASS, "unknown": "quality"}),
    "fit": (stoss.fit, {"body": BALL, "law": "linear", **ENDS}),
    "function": (stoss.restitution_function, {"body": BALL, **ENDS, "error": 0.05}),
    "pair table": (stoss.pair_table, {"body": BALL, **ENDS, "ratio": (1, 1.2), "error": 0.05}),
    "rule": (stoss.collision_rule, {"body": BALL, **ENDS, "error": 0.05, "tolerance": 0.1}),
    "oblique impact": (stoss.oblique_impact, {"body": BALL, **ONE, "friction": 0.1, "cutoff": 6}),
    "modes": (stoss.modes, {"poisson": 0.33, "cutoff": 6}),
    "atlas": (stoss.atlas, {"body": BALL, **ONE}),
    "chain": (stoss.rod_chain, {"rods": RODS, "circumference": 9, "temperature": 1, "collisions": 9}),
    "row": (stoss.row, {"bodies": [BALL] * 2, **ONE, "tolerance": 0.1}),
    "row impact": (stoss.row_impact, {"bodies": [BALL] * 2, **ONE, "cutoff": 6}),
    "pulse": (stoss.pulse, {"body": BALL, **ONE}),
    "seismogram": (STRUCK.at, {"distance": 5, "points": 9}),
    "trajectory": (HIT.trajectory, {}),
    "oblique trajectory": (SLIP.trajectory, {}),
    "field": (HIT.field, {"time": 1, "radius": [0.5, 1], "angle": [0, 1]}),
    "energies": (HIT.energies_at, {"time": 1}),
    "state after": (HIT.state_after, {"flight": 1}),
    "sound": (HEARD.sound, {"slower": 1000}),
    "wave": (WAVES.wave, {"time": 1, "distance": [0, 1], "depth": [0, 1]}),
    "displacement": (MODES.displacement, {"order": 2, "index": 0, "radius": 1}),
    "value": (FUNCTION, {"speed": 0.07}),
    "value of pairs": (PAIRS, {"speed": 0.07, "ratio": 1.1}),
    "wall": (stoss.ExponentialWall, {}),
    "material": (stoss.Material, METAL),
    "measurement": (stoss.relaxation_of_measurement,
                    {"frequency": [1, 10, 99], "storage": [1, 2, 3], "loss": [0.1, 0.2, 0.1]}),
    "shift": (stoss.shifted, {"relaxation": [(0.5, 1)], "c1": 17, "c2": 51, "reference": 20, "temperature": 30}),
    "oscillation": (stoss.Oscillation, {"order": 2, "index": 0, "energy": 0.1}),
}
USUAL = {"poisson": 0.33, "speed": 0.01, "force": 0.01, "compression": 0.01, "depth": 0.1, "y": 0.1, "cutoff": 6,
 "psi1": 2.0,
         "chi": 1.4, "displacement": 0.2, "tangential": 0.3, "distance": 0.5}  # fmt: skip
HARD = stoss.Sphere(radius=0.01, material=stoss.Material(young=2e11, poisson=0.3, density=8e3, yield_strength=1e9))
for name in quasistatic.__all__:
    if name[0].islower():
        function = getattr(quasistatic, name)
        parameters = inspect.signature(function).parameters
        usual = {each: USUAL[each] for each in parameters if each in USUAL}
        needs = "body" in parameters and parameters["body"].default is inspect.Parameter.empty
        CALLS[name] = (function, {**usual, **({"body": HARD} if needs else {})})
        if "body" in parameters and not needs:
            CALLS[f"{name} of a ball"] = (function, {"body": BALL,
             **{each: usual[each] for each in usual if each != "poisson"}})

# Out of the ranges that no table has, by the name of the argument, and of the call where it means something else.
RANGES = {
    "poisson": [-1, 1, [0.3, nan]], "cutoff": [0, -1, 1001], "threads": [-1, 1025, 2**31 - 1], "step": [0, -1, 1],
    "nodes": [0, -1, 15, 5000], "half_width": [0, -1, 3.2], "hardness": [0.9, 1.1e8], "strength": [0, -1],
    "young": [0, -1], "density": [0, -1], "yield_strength": [-1], "loss_time": [-1], "surface_energy": [-0.1, 2e6],
    "quality": [1, -10, (0, 1), (10, nan)], "relaxation": [[(0.7, 1), (0.6, 1)], [0.5], 1, [(0.5, -1)]], "every": [0, -1], ("field", "time"): [1.1e4, [1, -inf]], "time": [1.1e4],
    ("measurement", "frequency"): [[1, 1, 2], [-1, 1, 2]], ("material", "frequency"): [0, -1],
    "data": [0.1, None, {}, {"speed": [1.0]}], "unknown": ["hardness", [], 0.1],
    "storage": [[0, 1, 2]], "loss": [[1, -1, 2]], "c1": [-1], "c2": [0], "reference": [1e7],
    ("shift", "temperature"): [-40],
    "radius": [-0.1, 1.1, []], "distance": [-0.1], "flight": [-1], "duration": [0], "rate": [10], "slower": [-1],
    ("sound", "quality"): [0.1], "of": [7, -1], "circumference": [4.0 - 2], "velocities": [[1, 2, 3]],
     "collisions": [-1],
    ("chain", "time"): [-1], "decay_time": [-1], ("chain", "modes"): [0], "pieces": [1], "seed": [-1],
     "temperature": [-1],
    "error": [0, 1], "tolerance": [0, 1], "ratio": [2.0, (2, 1), (1, nan)], "speed": [0, 2, [0.1, nan]],
    "force": [-1e-9, 2, [0.01, -1]], "compression": [-0.6, 0.7], "depth": [-1e-9], "psi1": [2e6], "chi": [0, -1, [1,
     0]],
    ("tangential traction", "tangential"): [1.1], "uncertainties": [{"yong": 0.1}, {"young": 11}, 0.1],
    "rods": [stoss.Rod(), [], [stoss.Rod()], [BALL] * 3], "friction": [-1, 6], "spin": [2], "second_spin": [0.1],
    "angle": [90], ("value", "speed"): [0.0, 0.31], ("value of pairs", "speed"): [0.3], ("value of pairs",
     "ratio"): [2.5, -1],
    "until": [0, -1], "gaps": [-1, 1001, [0, 0], [[0]]], "before": ["same", BALL],
    "bodies": [[], BALL, [BALL], [BALL, 1]],
    "keep": [True, [], [0, 1], "all", [[True]]], ("field", "angle"): [[]], ("predict", "speed"): [0, 1e9],
     ("displacement", "radius"): [-0.1, 1.1], ("oscillation", "of"): [],
    ("wave", "depth"): [[], -1.0], "spectrum": [3.0, lambda _: nan, lambda _: "x"],
}  # fmt: skip
SPEED_OF_PULSES = [0, -0.1, 1e-101, 0.3, [0.01, 0.3]]
WHOLE = {"threads", "nodes", "every", "order", "index", "of", "samples", "seed", "count", "collisions", "pieces",
 "rate"}
SINGLE = {"cutoff", "tolerance", "absolute", "step", "half_width", "error", "strength", "hardness", "temperature",
 "flight_time",
          "gravity", "adhesion", "highest", "circumference", "flight", "until"}  # fmt: skip
CHOICES = {"young_is", "tail", "beyond", "law", "program", "method", "contact"}
NOT_NUMBERS = {"air": FLAGS, "body": BODIES, "against": [*BODIES, stoss.Rod, HIT], "progress": FLAGS, "state": [0.1, "ringing",
 [None]]}
OTHERS = {"data", "unknown", "keep", "rods", "uncertainties", "spectrum", "quality"}  # of which only RANGES says what is wrong
AS_WRITTEN = {"spectrum": "(spectrum|energy)", "quality": "(quality|frequency)", "of": "(of|body)", "rods": "rods?",
 "keep": "keep",
              "state": "(state|energy|vibration)", "y": "(y|distance)", "speed": "(speed|range)"}  # fmt: skip
IN_PLACE_OF = {"poisson": "body", "body": "poisson", "height": "speed", "gravity": "flight_time",
 "spectrum": "temperature",
               "velocities": "temperature", "angle": "tangential"}  # fmt: skip
LIMITS = {(question, name): limits for question, name, *limits in stoss._core.inputs()}
QUESTIONS = {"oblique impact": ("oblique", "impact"), "function": ("table",), "pair table": ("table",),
 "rule": ("table",), "row impact": ("row",), "seismogram": ("pulse",)}


def beyond(name, low, high, low_included, high_included):
    """The nearest numbers that are not allowed."""
    if name in WHOLE:
        return [int(low) - 1, int(high) + 1]
    wrong = [math.nextafter(low, -inf) if low_included else low] if math.isfinite(low) else []
    return wrong + ([math.nextafter(high, inf) if high_included else high] if math.isfinite(high) else [])


def out_of_range(call, name):
    limits = [LIMITS[each, name] for each in QUESTIONS.get(call, (call,)) if (each, name) in LIMITS]
    ends = name in ("speed", "ratio") and QUESTIONS.get(call, (call,))[0] in ("table", "fit")
    if limits and not ends and (call, name) not in RANGES:
        return beyond(name, *limits[0])
    if ends:
        return [(wrong, 0.1) for wrong in beyond(name, *limits[0])] + [0.1, (0.1, 0.2, 0.3), (0.2, 0.1), (0.1, nan)]
    if name == "speed" and CALLS[call][0] in (quasistatic.slow_impact, quasistatic.rayleigh):
        return SPEED_OF_PULSES
    return RANGES.get((call, name), RANGES.get(name, []))


def wrong_of(call, name):
    """All that this argument of the call must not be."""
    if name in OTHERS and (call, name) not in RANGES:
        return RANGES[name]
    if name in NOT_NUMBERS:
        return NOT_NUMBERS[name]
    if name in CHOICES:
        return WORDS
    if name in WHOLE:
        return [*out_of_range(call, name), *INTEGERS]
    several = SEVERAL if name in SINGLE else []
    no_numbers = [] if call == "oscillation" else [nan] if (call, name) == ("chain", "time") else [nan, inf]
    return [*no_numbers, *out_of_range(call, name), *NUMBERS, *several]


ARGUMENTS = [(call, name) for call, (function, _) in CALLS.items() for name in inspect.signature(function).parameters]


def test_every_function_is_here():
    public = [getattr(module, name) for module in (stoss, quasistatic) for name in module.__all__]
    files = {stoss.animate, stoss.merge, stoss.open_sweep, stoss.read_csv, stoss.sweep, stoss.with_error}
    assert {each for each in public if inspect.isfunction(each)} - files <= {function for function, _ in CALLS.values()}


@pytest.mark.parametrize("call, name", ARGUMENTS)
@pytest.mark.filterwarnings("ignore::stoss.StossWarning")
def test_refusals(call, name):
    function, usual = CALLS[call]
    default = inspect.signature(function).parameters[name].default
    for value in wrong_of(call, name):
        if value is None and default is None or isinstance(value, str) and value == default:
            continue
        given = {each: arguments for each, arguments in usual.items() if each != IN_PLACE_OF.get(name)}
        with pytest.raises(stoss.InvalidInput) as caught:
            function(**{**given, name: value})
            pytest.fail(f"{name}={value!r} is taken")
        message = str(caught.value)
        assert message.isprintable() and len(message) < 300, message  # one line
        stem = AS_WRITTEN.get(name, re.escape(name.removesuffix("es").removesuffix("s")) + r"\w*")
        assert re.match(rf"(number of )?{stem}[^:]*: (got .+, allowed .+|missing.+|.+)", message), (value, message)
        assert isinstance(caught.value, ValueError) and caught.value.__cause__ is None


@pytest.mark.parametrize("call", CALLS)
def test_signatures(call):
    function, usual = CALLS[call]
    with pytest.raises(TypeError, match="positional|unexpected keyword"):
        function(*[0.3] * 20)
    with pytest.raises(TypeError, match="unexpected keyword"):
        function(**usual, poison=0.3)
    if usual and not isinstance(function, (stoss.RestitutionFunction, stoss.PairTable)):
        needed = [name for name, each in inspect.signature(function).parameters.items() if each.default is each.empty]
        if needed:
            with pytest.raises(TypeError, match="missing"):
                function()


def test_messages_tell_what_was_got():
    for changed, said in (
        ({"speed": [0.1, -0.25]}, "speed: got -0.25, allowed 1e-8 to 1"), ({"poisson": 1.5},
         "poisson: got 1.5, allowed -0.95 to 0.995"),
        ({"speed": "fast"}, "speed: got 'fast', allowed a number"), ({"speed": [["x" * 99] * 99] * 99},
         "speed: got [['xxx"),
    ):  # fmt: skip
        with pytest.raises(stoss.InvalidInput) as caught:
            stoss.restitution(**{"poisson": 0.33, "speed": 0.1, **changed})
        assert str(caught.value).startswith(said) and len(str(caught.value)) < 200


def test_shapes_that_do_not_fit():
    for call, names in (
        (lambda: stoss.restitution(poisson=[0.1, 0.2], speed=[0.1, 0.2, 0.3]), "poisson, speed"),
        (lambda: quasistatic.slow_impact(poisson=[0.1, 0.2], speed=[0.1, 0.1, 0.1]), "poisson, speed"),
        (lambda: quasistatic.maw(psi1=[1, 2], chi=[1, 2, 3]), "psi1, chi"),
        (lambda: stoss.oblique(BALL, speed=[0.1, 0.2], spin=[0, 0, 0], friction=0.1),
         "speed, spin, second_spin, friction"),
    ):  # fmt: skip
        with pytest.raises(stoss.InvalidInput,
         match=rf"^{names}: got shapes \(2,\) and .*\(3,\).*, allowed shapes that"):
            call()
    with pytest.raises(ValueError):
        stoss._core.compression("center", np.full(2, 0.1), np.full(3, 0.1))
