"""Numbers at the ends of what a double holds, layers that are as unlike: the rule of the hunt, by processor time."""

import shlex

import pytest
from judged import ANSWER, judge, run

pytestmark = pytest.mark.numbers
BALL = "--body sphere --poisson 0.3 --speed 0.01"
SIZES = [f"1e{sign}{power}" for power in (300, 150, 30) for sign in ("", "-")]
STIFF_BASE = "plate,thickness=6,young=0.0011,density=0.11/thickness=1,young=300,density=0.01"
FIVE = ("plate,thickness=1,young=0.00113/thickness=0.5,young=51.1/thickness=0.3,young=191/thickness=1,young=358"
        "/thickness=0.2,young=87.3")

BODIES = {
    "sphere": {"radius": 0.005, "young": 1e9, "density": 2000, "loss_time": 0},
    "disk": {"radius": 0.005, "young": 1e9, "density": 2000, "loss_time": 0},
    "rod": {"length": 0.1, "area": 1e-4, "young": 1e9, "density": 2000, "loss_time": 0},
    "half-space": {"young": 1e9, "density": 2000, "loss_time": 0},
    "half-plane": {"young": 1e9, "density": 2000, "loss_time": 0},
    "plate": {"thickness": 0.005, "young": 1e9, "density": 2000, "loss_time": 0},
    "strip": {"thickness": 0.005, "young": 1e9, "density": 2000, "loss_time": 0},
}
MEETS = {"sphere": ("wall", "sphere", "half-space", "plate"), "disk": ("wall", "disk", "half-plane", "strip"),
         "rod": ("wall", "rod")}
LAYER = {"thickness": 0.005, "young": 1e9, "density": 2000}


def options(body, numbers):
    return f"--body {body} --poisson 0.3 " + " ".join(f"--{k.replace('_', '-')} {v}" for k, v in numbers.items())


def keys(numbers):
    return "poisson=0.3," + ",".join(f"{k}={v}" for k, v in numbers.items())


def calls():
    """Of each number of each body, what it is about, and the words with it at each size."""
    for body, partners in MEETS.items():
        its = BODIES[body]
        for name in its:
            for other in partners[::2]:
                against = "wall" if other == "wall" else f"{other},{keys(BODIES[other])}"
                yield f"{body} {name} {other}", lambda v, b=body, n=name, i=its, a=against: (
                    f"{options(b, {**i, n: v})} --speed 0.5 --against {a}")
        for other in partners[1:]:
            for name in BODIES[other]:
                yield f"{body} {other} {name}", lambda v, b=body, n=name, i=its, o=other: (
                    f"{options(b, i)} --speed 0.5 --against {o},{keys({**BODIES[o], n: v})}")
            yield f"{body} {other} speed", lambda v, b=body, i=its, o=other: (
                f"{options(b, i)} --speed {v} --against {o},{keys(BODIES[o])}")
    for layer in (0, 1):
        for name in LAYER:
            def stack(v, at=layer, n=name):
                layers = [{**LAYER, **({n: v} if i == at else {})} for i in (0, 1)]
                return f"{options('sphere', BODIES['sphere'])} --speed 0.5 --against plate,{'/'.join(map(keys, layers))}"
            yield f"sphere layer {layer} {name}", stack


CALLS = dict(calls())


def hold(stoss, words, interrupt=None):
    result = run([stoss.path, *shlex.split(words)], interrupt)
    fault = judge(*result)
    assert not fault, f"{fault}\n  stoss {words}"
    return result


@pytest.mark.parametrize("what", CALLS)
def test_rule_holds_for_extreme_sizes(stoss, what):
    for size in ("1e150", "1e-30"):
        hold(stoss, f"restitution {CALLS[what](size)}")


@pytest.mark.long
@pytest.mark.parametrize("command", ["restitution", "impact", "oblique --friction 0.2 --angle 30", "predict"])
@pytest.mark.parametrize("what", CALLS)
def test_rule_holds_for_all_sizes_long(stoss, command, what):
    if (command == "predict" and not what.startswith("sphere")) or (command[0] == "o" and what.startswith("rod")):
        pytest.skip("not of these bodies")
    for size in SIZES:
        hold(stoss, f"{command} {CALLS[what](size)}")


@pytest.mark.parametrize("command", ["restitution", "impact", "oblique --friction 0.2 --tangential 0.01"])
@pytest.mark.parametrize("thickness", ["1e200"])
def test_a_plate_of_any_thickness_is_a_half_space(stoss, command, thickness):
    """What bends as little is none that gives way, however many digits its stiffness would have."""
    for against in (f"plate,thickness={thickness}", f"plate,thickness=1/thickness={thickness}"):
        (row,) = stoss.data(f"{command} {BALL} --against {against}")
        (thick,) = stoss.data(f"{command} {BALL} --against {against.replace(thickness, '1e30')}")
        assert float(row["restitution"]) == pytest.approx(float(thick["restitution"]), abs=1e-6)


@pytest.mark.parametrize("after", [0.5, pytest.param(2, marks=pytest.mark.long)])
@pytest.mark.parametrize(
    "words", [f"impact {BALL} --against {STIFF_BASE}", f"impact {BALL} --loss-time 0.3 --against {FIVE}",
              f"oblique {BALL} --tangential 0.01 --friction 0.2 --against {STIFF_BASE}"]
)
def test_layers_heed_an_interrupt_while_they_are_made(stoss, words, after):
    _, _, answer, _, _ = hold(stoss, words, after)
    assert answer is None or answer < ANSWER


@pytest.mark.parametrize(
    "below, said",
    [("young=1e30", "young ratio: got 1e+30, allowed up to 1e9"), ("density=1e9", "density ratio: got 1000000000"),
     ("young=9e8,density=1.1e-6", "more modes than are computed")],
)  # fmt: skip
def test_layers_with_more_waves_than_are_computed_are_refused_before_they_are_made(stoss, below, said):
    words = f"restitution {BALL} --against plate,thickness=1/thickness=1,{below}"
    code, used, interrupted, _, text = hold(stoss, words)
    assert code != 0 and interrupted is None and said in text
    assert used < 2.0
