"""Refusals and notes name what was given, and ways out that there are."""

import json
from pathlib import Path

import pytest

BALL = f"--body @{Path(__file__).resolve().parents[2] / 'examples/any_body/sphere.json'}"
FOAM = "young=1e4,poisson=0.3,density=100"
OF_FOAM = "--body sphere --radius 0.005 --young 1e4 --poisson 0.3 --density 100 --speed 0.1"
STEEL = "--body sphere --radius 0.005 --material 'bearing steel' --speed 0.1"
EXTREME = "--body sphere --young 1e300 --density 1e-300 --radius 1e-300 --poisson 0.3 --speed 1"


@pytest.mark.parametrize(
    "words, way, taken",
    [
        (f"{STEEL} --against half-space,{FOAM}", "let the first be rigid (--rigid-body)", "--rigid-body"),
        (f"{STEEL} --against sphere,radius=0.005,{FOAM}", "let the first be rigid (--rigid-body)", "--rigid-body"),
        (f"{STEEL} --against plate,thickness=0.01,{FOAM}", "let the first be rigid (--rigid-body)", "--rigid-body"),
        (f"{OF_FOAM} --against sphere,radius=0.005,material='bearing steel'",
         "let the second be rigid (--against ...,rigid=1)", ",rigid=1"),
    ],
)  # fmt: skip
def test_the_way_out_of_hard_on_soft_can_be_gone(stoss, words, way, taken):
    refused = stoss.run("restitution", words)
    assert refused.returncode == 3 and refused.stderr.endswith(f"; beyond, the stiffer one is rigid: {way})\n")
    joined = words + taken if taken.startswith(",") else f"{words} {taken}"
    assert stoss.run("restitution", joined).returncode == 0
    assert stoss.run("impact", joined).returncode == 0


def test_a_body_of_a_file_is_not_told_to_be_rigid(stoss):
    for against in (f"half-space,{FOAM}", f"plate,thickness=0.01,{FOAM}"):
        refused = stoss.run(f"restitution {BALL} --speed 0.1 --against {against}").stderr
        assert "take a rigid sphere of its radius in its place)" in refused


def test_the_second_may_be_rigid_as_in_a_document(stoss):
    words = "restitution --body sphere --poisson 0.3 --speed 0.01 --format json --against"
    one = json.loads(stoss.run(words, "sphere,radius=2,rigid=1").stdout)
    other = json.loads(stoss.run(words, "sphere,radius=2").stdout)
    assert one["inputs"]["against"]["rigid"] is True and "rigid" not in other["inputs"]["against"]
    assert one["records"][0]["restitution"] != other["records"][0]["restitution"]
    assert stoss.run(words, "sphere,radius=2,rigid=0").returncode == 0
    for wrong, said in (("sphere,rigid=2", "against rigid: got 2, allowed 0 or 1"), ("half-space,rigid=1", "against: got 'rigid'"),
                        ("rod,rigid=1", "rigid")):  # fmt: skip
        refused = stoss.run(words, wrong)
        assert refused.returncode == 3 and said in refused.stderr


@pytest.mark.parametrize(
    "words, said, never",
    [
        *((f"{command} {EXTREME}", "young: got 1e+300, allowed above 0, 1e-30 to 1e30", "loss_time")
          for command in ("restitution", "impact", "distribution --temperature 0.1", "predict", "quasistatic", "table")),
        ("restitution --body sphere --material glass --radius 1e-300 --speed 1",
         "radius: got 1e-300, allowed 1e-30 to 1e30 (in m)", "loss_time"),
        ("restitution --body sphere --poisson 0.3 --speed 0.1 --against sphere,young=1e300,density=1e-300,radius=1e-300",
         "radius ratio: got 1e-300", "loss_time"),
        (f"distribution {BALL} --temperature 0.1 --speed 0.1", "known at a point only", "a mode above"),
        ("predict --body sphere --radius 1e-9 --material glass --speed 1 "
         "--against plate,thickness=0.01,young=1e9,poisson=0.4,density=1000,loss_time=3e-5",
         "against loss_time: got 3e-05, allowed 0 to 9.9999e-08", "got 3e+"),
        ("restitution --body rod --speed 0.01 --tolerance 1e-6", "c/L", "c/R"),
        ("restitution --body sphere --poisson 0.3 --speed 1e-5 --against plate,thickness=0.15",
         "the body stays: the plate is infinite", "(stays)"),
        ("restitution --body sphere --radius 0.01 --speed 1 --material steal", "did you mean structural steel or bearing steel?", "ruby"),
        ("tabel", "did you mean table?", "allowed"),
        ("steal", "allowed modes, impact, ", "did you mean"),
    ],
)  # fmt: skip
def test_messages_are_of_what_was_given(stoss, words, said, never):
    result = stoss.run(words)
    assert said in result.stderr and never not in result.stderr, result.stderr
    assert "nan" not in result.stderr
