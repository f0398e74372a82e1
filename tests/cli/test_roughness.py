"""Rough faces: options and keys, what they are refused for, and extremes that must end as they should."""

import json
import math
import signal
import subprocess

import pytest

from conftest import wait_until_caught

BALL = "--body sphere --poisson 0.3"
STEEL = "--body sphere --material 'structural steel' --radius 0.005"


def row(stoss, arguments):
    return stoss.data(arguments)[0]


def lost(stoss, arguments, **_):
    return float(row(stoss, f"restitution {arguments}")["lost_fraction"])


def test_a_wall_a_partner_and_a_body_are_rough_alike(stoss):
    """Of one length, wherever it is given and in whatever units."""
    own = lost(stoss, f"{BALL} --speed 0.1 --u0 0.02")
    assert own == pytest.approx(0.0043804, abs=5e-6)
    for other in (
        f"{BALL} --speed 0.1 --against wall,u0=0.02",
        f"{BALL} --speed 0.1 --against exponential,hardness=50",
        f"{BALL} --speed 0.1 --against exponential,hardness=50,strength=3",
        f"{BALL} --speed 0.1 --roughness {0.02 / 0.45!r}",
        f"{BALL} --speed 0.1 --u0 0.012 --against wall,u0=0.016",
    ):
        assert lost(stoss, other) == pytest.approx(own, rel=1e-6), other
    c = math.sqrt(7e10 / 2500)
    in_si = f"--body sphere --young 7e10 --poisson 0.3 --density 2500 --radius 0.01 --speed {0.1 * c!r}"
    assert lost(stoss, f"{in_si} --u0 2e-4") == pytest.approx(own, rel=1e-6)
    assert lost(stoss, f"{in_si} --against wall,roughness={2e-4 / 0.45!r}") == pytest.approx(own, rel=1e-6)


def test_the_default_is_smooth(stoss):
    smooth = lost(stoss, f"{BALL} --speed 0.1")
    assert lost(stoss, f"{BALL} --speed 0.1 --roughness 0 --against wall,u0=0") == smooth


@pytest.mark.parametrize(
    "arguments",
    [
        "curve --body disk --poisson 0.33 --speed log:0.01:0.1:3 --against exponential,hardness=200",
        f"oblique {BALL} --speed 0.05 --angle 20,40 --friction 0.3 --u0 0.005",
        f"oblique {BALL} --speed 0.05 --angle 20 --friction 0.3 --against exponential,hardness=200",
        f"table {BALL} --speed 0.01:0.1 --error 1e-2 --beyond clamp --roughness 0.01",
        f"restitution {BALL} --speed 0.05 --against half-space,u0=0.01",
        f"restitution {BALL} --speed 0.05 --against plate,thickness=1,roughness=0.01",
        f"restitution {BALL} --speed 0.05 --rigid-body --against sphere,u0=0.01",
        f"impact {BALL} --speed 0.05 --u0 0.01 --tail none --cutoff 15",
        f"impact {BALL} --speed 0.05 --u0 0.01 --tail static --cutoff 15",
        f"bounce {BALL} --speed 0.05 --count 3 --flight-time 10 --u0 0.01 --cutoff 10",
        "restitution --body rod --speed 0.1 --u0 0.02 --tolerance 0.5 --absolute 0.01",
    ],
)
def test_commands_take_rough_faces(stoss, arguments):
    if arguments.startswith("curve"):
        arguments = arguments.replace("curve", "restitution", 1)
    assert stoss.run(arguments).returncode == 0


def test_documents_and_provenance_say_the_roughness(stoss):
    made = json.loads(stoss.run(f"restitution {BALL} --speed 0.1 --u0 0.02 --against wall,roughness=0.01 --format json").stdout)
    assert made["inputs"]["first"]["u0"] == 0.02
    assert made["inputs"]["against"] == {"kind": "wall", "roughness": 0.01}
    impact = json.loads(stoss.run(f"impact {BALL} --speed 0.1 --u0 0.02 --cutoff 10 --tail none --format json").stdout)
    assert impact["inputs"]["tail"] == "none"


@pytest.mark.parametrize(
    "options, line",
    [
        ("--roughness -1", "roughness: got -1, allowed 0 or more"),
        ("--u0 nan", "u0"),
        ("--u0 inf", "u0"),
        ("--u0 1.1", "u0: got 1.1, allowed 0 to 1"),
        ("--roughness 1e308", "roughness: got 1e+308, allowed 0 to 2.22222"),
        ("--u0 0.1 --roughness 0.1", "roughness: given beside u0, which is 0.45 of it (give one of both)"),
        ("--against wall,u0=0.1,roughness=0.1", "against roughness: given beside u0"),
        ("--against wall,u0=-1", "against u0: got -1, allowed 0 or more"),
        ("--against sphere,u0=2", "against u0: got 2, allowed 0 to 1"),
        ("--against same,u0=0.1", "against: got 'u0', allowed none with same"),
        ("--against plate,thickness=1/thickness=1,u0=0.1", "against: got 'u0', allowed thickness"),
        ("--against exponential,hardness=0.5", "against hardness: got 0.5, allowed 1 to 1e8"),
    ],
)
def test_refusals_are_one_line(stoss, options, line):
    answer = stoss.run(f"restitution {BALL} --speed 0.1 {options}")
    assert answer.returncode == 3 and answer.stderr.count("\n") == 1
    assert line in answer.stderr


@pytest.mark.parametrize("u0", ["1e-8", "1e-6", "1e-4", "1e-2", "0.1", "1"])
@pytest.mark.parametrize("speed", [pytest.param("1e-4", marks=pytest.mark.long), "1e-2", "0.1"])
def test_any_length_ends_with_a_value_or_says_why_not(stoss, u0, speed):
    answer = stoss.run(f"restitution {BALL} --speed {speed} --u0 {u0} --tolerance 0.05 --format json")
    made = json.loads(answer.stdout)["records"][0]
    assert answer.returncode in (0, 1) and (made["converged"] or "not as accurate" in answer.stderr)
    if made["lost_fraction"] is not None:
        assert -1e-6 < made["lost_fraction"] < 0.02


@pytest.mark.parametrize("u0", ["1e-8", "1e-3", "1"])
def test_the_slowest_impact_ends(stoss, u0):
    answer = stoss.run(f"impact {BALL} --speed 1e-8 --u0 {u0} --cutoff 6 --format json")
    assert answer.returncode == 0 or "stoss: error: " in answer.stderr
    if answer.returncode == 0:
        assert abs(json.loads(answer.stdout)["records"][0]["energy_error"]) < 1e-3


def test_results_do_not_depend_on_threads(stoss):
    both = f"{BALL} --speed log:0.01:0.1:6 --u0 0.003 --against half-space,u0=0.004"
    one, two = (stoss.run(f"restitution {both} --threads {n} --format csv").stdout for n in (1, 2))
    data = [[line for line in text.splitlines() if not line.startswith("#")] for text in (one, two)]
    assert data[0] == data[1] and len(data[0]) == 7


def test_all_at_once(stoss):
    """Both faces rough, a loss, friction, a block."""
    made = row(stoss, f"oblique {BALL} --speed 0.02 --angle 30 --friction 0.3 --loss-time 0.1 --roughness 0.01 "
                      "--against half-space,u0=0.003,loss_time=0.05 --tolerance 0.1")
    assert 0.0 < float(made["restitution"]) < 1.0 and -1.0 < float(made["tangential_restitution"]) < 1.0


def test_prediction_says_when_faces_count_as_smooth(stoss):
    smooth = stoss.run(f"predict {STEEL} --speed 0.001")
    assert "faces are taken as smooth: below " in smooth.stderr
    rough = stoss.run(f"predict {STEEL} --speed 0.001 --roughness 24e-9")
    assert "asperities: waves take " in rough.stderr and "taken as smooth" not in rough.stderr


def test_an_interrupt_ends_it_at_once(stoss):
    process = stoss.start(f"restitution {BALL} --speed 1e-4 --u0 1", stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    wait_until_caught(process, signal.SIGINT)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == -signal.SIGINT or process.returncode == 130
    assert "interrupted" in errors
