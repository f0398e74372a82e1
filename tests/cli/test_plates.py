"""Plates and strips as --against: numbers, SI, layers, what the result says of them, refusals."""

import json

import pytest

BALL = "restitution --body sphere --poisson 0.3 --speed 0.1 --tolerance 0.05"
STEEL = "restitution --body sphere --material 'structural steel' --radius 0.005 --speed 1 --tolerance 0.05"
GLASS = "thickness=4e-3,material=glass"
LAMINATED = f"plate,loss_time=0,{GLASS}/thickness=0.8e-3,material=PVB/{GLASS}"


def inputs(stoss, *arguments):
    result = stoss.run(*arguments, "--format json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)["inputs"]


def test_what_is_met_is_said(stoss):
    said = inputs(stoss, BALL, "--against plate,thickness=2,young=0.5")["against"]
    assert said == {"kind": "plate", "thickness": 2, "young": 0.5}
    said = inputs(stoss, BALL, "--against plate,thickness=0.1,young=4/density=2")["against"]
    assert said["layers"] == [{"thickness": 0.1, "young": 4}, {"density": 2}]


def test_a_laminate_is_said_layer_by_layer(stoss):
    said = inputs(stoss, STEEL, f"--against {LAMINATED}")["against"]
    glass = {"thickness": 4e-3, "material": "glass"}
    assert said == {"kind": "plate", "layers": [glass, {"thickness": 0.8e-3, "material": "PVB"}, glass], "loss_time": 0}


def test_si_is_a_matter_of_units(stoss):
    numbers = "young={},density={},poisson=0.22"
    ball = "restitution --body sphere --tolerance 1e-3 --loss-time 0"
    (si,) = stoss.data(ball, "--poisson 0.3 --young 2.1e11 --density 7850 --radius 0.005 --speed 1",
                       f"--against plate,thickness=0.01,{numbers.format(7e10, 2500)}")  # fmt: skip
    speed = float(si["speed[c]"])
    (ratios,) = stoss.data(ball, f"--poisson 0.3 --speed {speed!r}",
                           f"--against plate,thickness=2,{numbers.format(7e10 / 2.1e11, 2500 / 7850)}")  # fmt: skip
    assert float(si["restitution"]) == pytest.approx(float(ratios["restitution"]), rel=1e-12)


def test_a_strip_in_plane_strain(stoss):
    said = inputs(stoss, "restitution --body disk --material 'structural steel' --radius 0.01 --plane strain --speed 10 --tolerance 0.05",
                  "--against strip,thickness=0.1,material=glass")  # fmt: skip
    assert said["first"]["plane"] == "strain" and said["against"]["kind"] == "strip"
    assert said["against"]["thickness"] == 0.1 and said["against"]["material"] == "glass"


@pytest.mark.parametrize(
    "against, name, said",
    [
        ("plate", "against thickness", "missing"),
        ("plate,thickness=0", "against thickness", "0"),
        ("plate,thickness=-1", "against thickness", "-1"),
        ("plate,thickness=nan", "against thickness", "'nan'"),
        ("plate,thickness=inf", "against thickness", "'inf'"),
        ("plate,thickness=1,radius=2", "against", "allowed thickness, poisson, young, density, loss_time, yield, material"),
        ("plate,thickness=1,material=glass", "against: has a material", "first body is dimensionless"),
        ("plate,thickness=1/thickness=0", "against", "0"),
        ("plate,thickness=1//thickness=1", "against", "''"),
        ("plate,thickness=1/", "against", "''"),
        ("plate,thickness=1/young=2/young=3", "against layer 2 thickness", "missing"),
        ("plate,thickness=1/thickness=1,loss_time=0", "against", "allowed thickness, poisson, young, density, material"),
        ("plate" + "/thickness=1" * 20, "against layers", "21"),
        ("half-space/young=2", "against layers", "2, allowed 1 of a half-space"),
        ("strip,thickness=1", "against", "strip for a sphere"),
    ],
)
def test_refusals(stoss, against, name, said):
    result = stoss.run(BALL, "--against", against)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}") and f": got {said}" in line or said in line
    assert "allowed" in line or said in line


@pytest.mark.parametrize(
    "against, said",
    [
        ("plate,material=glass", "against thickness: missing (a material needs it too, in m)"),
        (f"plate,{GLASS}/thickness=1e-3,material=tin", "material: got 'tin', allowed structural steel"),
        (f"plate,{GLASS}/thickness=1e-3", "against: got plate without young"),
        (LAMINATED.replace("loss_time=0,", ""), "against loss_time: the layers' materials have 1.59"),
    ],
)
def test_refusals_in_si(stoss, against, said):
    result = stoss.run(STEEL, "--against", against)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {said}")


def test_help_says_how_layers_are_given(stoss):
    said = " ".join(stoss.run("restitution --help").stdout.split())
    assert "keys thickness, poisson, young, density, loss_time, yield, material and" in said
    assert "and layers below, as /KEY=NUMBER,...; the last may be a block" in said
