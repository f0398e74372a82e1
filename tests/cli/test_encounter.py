"""Who meets whom: named materials, the JSON Schema of encounters, and what --body and --against refuse."""

import json
import subprocess

import jsonschema
import pytest
from conftest import rows

BALL = {"kind": "sphere", "poisson": 0.3}
STEEL = {"kind": "sphere", "radius": 0.005, "material": "structural steel"}
NUMBERS = {"young": 7e10, "poisson": 0.22, "density": 2500}


@pytest.fixture(scope="module")
def schema(stoss):
    document = json.loads(stoss.run("schema").stdout)
    jsonschema.Draft202012Validator.check_schema(document)
    return jsonschema.Draft202012Validator(document)


@pytest.mark.parametrize(
    "encounter",
    [
        {"first": BALL},
        {"first": BALL, "against": "wall"},
        {"first": BALL, "against": {"kind": "exponential", "hardness": 300}},
        {"first": BALL, "against": {"kind": "sphere", "radius": 2, "rigid": True}},
        {"first": STEEL, "against": {"kind": "half-space", "material": NUMBERS}},
        {"first": {"kind": "disk", "radius": 1, "material": "glass", "plane": "strain"}, "against": "same"},
        {"first": {"kind": "rod"}, "against": {"kind": "rod", "length": 2, "area": 0.5}},
        {"first": BALL, "vibration": [{"order": 2, "index": 0, "energy": 0.1, "body": "first"}]},
        {"first": BALL, "against": {"kind": "plate", "thickness": 2, "young": 3}},
        {"first": BALL, "against": {"kind": "plate", "layers": [{"thickness": 2}, {"young": 3}], "loss_time": 0}},
        {"first": STEEL, "against": {"kind": "plate", "layers": [{"thickness": 0.004, "material": "PVB"}]}},
    ],
)
def test_schema_takes(schema, encounter):
    schema.validate(encounter)


@pytest.mark.parametrize(
    "encounter",
    [
        {},
        {"first": "wall"},
        {"first": {"kind": "sphere"}},
        {"first": {"kind": "sphere", "poisson": 0.5}},
        {"first": {"kind": "half-space", "poisson": 0.3}},
        {"first": {**BALL, "area": 1}},
        {"first": BALL, "against": "cube"},
        {"first": BALL, "against": {"kind": "sphere", "young": 0}},
        {"first": {"kind": "sphere", "radius": 1, "material": "steal"}},
        {"first": {"kind": "sphere", "radius": 1, "material": {"young": 1e9}}},
        {"first": BALL, "vibration": [{"order": 2, "index": 0}]},
        {"first": BALL, "friction": 5.1},
        {"first": BALL, "against": {"kind": "plate"}},
        {"first": BALL, "against": {"kind": "plate", "thickness": 0}},
        {"first": BALL, "against": {"kind": "plate", "thickness": 1, "layers": [{"thickness": 1}]}},
        {"first": BALL, "against": {"kind": "plate", "layers": []}},
        {"first": BALL, "against": {"kind": "plate", "layers": [{"thickness": 1, "loss_time": 0}]}},
        {"first": BALL, "against": {"kind": "strip"}},
        {"first": BALL, "speed": 1},
    ],
)
def test_schema_refuses(schema, encounter):
    with pytest.raises(jsonschema.ValidationError):
        schema.validate(encounter)


def test_a_named_material_is_its_numbers(stoss):
    listed = {row["name"]: row for row in json.loads(stoss.run("materials --format json").stdout)["records"]}
    steel, glass = listed["brass"], listed["glass"]

    def numbers(of):
        return f"young={of['young']},density={of['density']},poisson={of['poisson']},quality={of['quality']}"

    speed = "restitution --body sphere --radius 0.005 --speed 0.1,1"
    constants = f"--young {steel['young']} --density {steel['density']} --poisson {steel['poisson']}"
    typed = f"{constants} --quality {steel['quality']}"
    named = stoss.data(speed, "--material brass", "--against half-space,material=glass")
    yields = ("yield_speed[c]", "yield_speed_si[m/s]", "beyond_yield")
    assert all(float(row["yield_speed_si[m/s]"]) > 0 for row in named)
    without = [{name: value for name, value in row.items() if name not in yields} for row in named]
    assert without == stoss.data(speed, typed, f"--against half-space,{numbers(glass)}")


def test_one_material_is_shown_with_all_that_is_known_of_it(stoss):
    (row,) = json.loads(stoss.run("materials PVB --format json").stdout)["records"]
    shown = stoss.run("materials PVB").stdout
    assert f"relaxation from E(0) = {row['young']:.4g} Pa: {row['relaxation']}\n" in shown
    assert "at 10000 Hz: E' = 5.68e+08 Pa" in shown and f"source: {row['source']}\n" in shown
    assert "known within a factor of: young 1.3 poisson 1.05 density 1.01\n" in shown
    steel = stoss.run("materials 'bearing steel'").stdout
    assert "frequency of the modulus: 10000 Hz\n" in steel and "loss 3 yield_strength 1.2\n" in steel
    unknown = stoss.run("materials stone")
    assert unknown.returncode == 3 and unknown.stderr.startswith("stoss: error: material: got 'stone', allowed ")


DISK = "restitution --body disk --poisson 0.33 --speed 0.2 --tolerance 0.1"
SOLID = "--body disk --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01"
GLASS = "thickness=4e-3,material=glass"


def test_inputs_are_the_document_of_the_encounter(stoss):
    def inputs(*words):
        return json.loads(stoss.run(*words, "--format json").stdout)["inputs"]

    ball = "restitution --body sphere --poisson 0.3 --speed 0.1 --tolerance 0.1 --against"
    steel = "restitution --body sphere --material 'structural steel' --radius 0.005 --speed 1 --tolerance 0.1 --against"
    pair = inputs(DISK, "--against disk,radius=0.5,density=3")
    assert pair["first"]["kind"] == "disk" and pair["against"] == {"kind": "disk", "radius": 0.5, "density": 3}
    solid = inputs(f"restitution {SOLID} --tolerance 0.1 --speed 20 --against disk,young=7e10,density=2500,radius=0.02,poisson=0.22")
    assert solid["against"]["radius"] == 0.02 and solid["against"]["material"]["young"] == 7e10
    assert solid["speed[m/s]"] == 20
    soft = inputs("impact --body disk --poisson 0.3 --speed 0.1 --cutoff 12.5 --against exponential,hardness=300")
    assert soft["against"] == {"kind": "exponential", "hardness": 300}
    assert (soft["speed"], soft["cutoff"]) == (0.1, 12.5)
    assert inputs(ball, "half-space --rigid-body")["first"]["rigid"] is True
    plate = inputs(ball, "plate,thickness=0.1,young=4/density=2")["against"]
    assert plate["layers"] == [{"thickness": 0.1, "young": 4}, {"density": 2}]
    laminate = inputs(steel, f"plate,loss_time=0,{GLASS}/thickness=0.8e-3,material=PVB/{GLASS}")["against"]
    glass = {"thickness": 4e-3, "material": "glass"}
    assert laminate == {"kind": "plate", "layers": [glass, {"thickness": 0.8e-3, "material": "PVB"}, glass], "loss_time": 0}
    strip = inputs(f"restitution {SOLID} --tolerance 0.1 --speed 10 --plane strain --against strip,thickness=0.1,material=glass")
    assert strip["first"]["plane"] == "strain" and strip["against"] == {"kind": "strip", "thickness": 0.1, "material": "glass", "plane": "strain"}


def test_what_is_left_out_is_that_of_the_first(stoss):
    table = stoss.data("restitution --body disk --poisson 0.2,0.33 --speed 0.2 --tolerance 0.1 --against disk,radius=2")
    (alone,) = stoss.data("restitution --body disk --poisson 0.2 --speed 0.2 --tolerance 0.1 --against disk,radius=2,poisson=0.2")
    assert table[0] == alone and float(table[1]["restitution"]) < float(table[0]["restitution"])
    for body, against in (("sphere --poisson 0.3", "half-space"), ("disk --poisson 0.3", "half-plane")):
        job = f"restitution --body {body} --speed 0.1 --tolerance 0.1 --against {against}"
        assert stoss.run(job).stdout == stoss.run(f"{job},poisson=0.3,young=1,density=1").stdout


def test_spaces_around_keys_and_numbers_do_not_count(stoss):
    command = [stoss.path, *DISK.split(), "--against", " disk , radius = 2 ", "--format", "csv"]
    text = subprocess.run(command, capture_output=True, text=True).stdout
    assert rows(text) == stoss.data(DISK, "--against disk,radius=2")


def test_help_says_how_layers_are_given(stoss):
    said = " ".join(stoss.run("restitution --help").stdout.split())
    assert "keys thickness, poisson, young, density, loss_time, quality, roughness, u0, coat, coat_young, coat_poisson, coat_quality, yield_strength, yield_hardening, yield_rate, relaxation, young_is, material, c_p, c_s and" in said
    assert "and layers below, as /KEY=NUMBER,... (the last may be a block)" in said


def test_records_say_where_yielding_begins(stoss):
    bodies = "--body sphere --material 'bearing steel' --radius 0.01 --tolerance 0.1 --against sphere,radius=0.02,material="
    for other, who in (("'bearing steel'", "the ball "), ("'structural steel'", "the other ball ")):
        job = f"restitution {bodies}{other} --format json --speed"
        (record,) = json.loads(stoss.run(job, "0.001").stdout)["records"]
        speed = record["yield_speed_si"]
        result = stoss.run(job, f"{0.99 * speed!r},{1.01 * speed!r}")
        assert [row["beyond_yield"] for row in json.loads(result.stdout)["records"]] == [False, True]
        (line,) = result.stderr.splitlines()
        asked = f"you asked for {1.01 * speed:.4g} m/s, 1.01 times that"
        assert line.startswith(f"stoss: warning: {who}")
        hint = "the real rebound is lower; give a yield_strength, or use stoss predict"
        assert line.endswith(f" yields above {speed:.3g} m/s ({asked}): {hint}")


def test_a_strength_makes_a_body_yield_and_says_no_more(stoss):
    ball = "restitution --body sphere --material 'bearing steel' --radius 0.01 --against half-space,material=glass --speed 5"
    elastic, yields = stoss.run(ball, "--format json"), stoss.run(ball, "--yield-strength 1.7e9 --format json")
    (one,), (other,) = (json.loads(each.stdout)["records"] for each in (elastic, yields))
    assert "yields above" in elastic.stderr and "yields above" not in yields.stderr
    assert other["restitution"] < one["restitution"] and other["yielded"] > 0.05 and other["dent"] > 0
    assert one["yielded"] == one["dent"] == 0


WAVES = "--c-p 5900 --c-s 3200 --density 7800"


def test_speeds_of_waves_make_a_material(stoss):
    ratio = (5900 / 3200) ** 2
    poisson = (ratio - 2) / (2 * ratio - 2)
    young = 2 * 7800 * 3200**2 * (1 + poisson)
    ball = "restitution --body sphere --radius 0.01 --speed 1 --format csv"
    (waves,) = rows(stoss.run(f"{ball} {WAVES} --against half-space,c_p=5000,c_s=3000,density=2500").stdout)
    usual = f"--young {young!r} --poisson {poisson!r} --density 7800"
    (moduli,) = rows(stoss.run(f"{ball} {usual} --against half-space,c_p=5000,c_s=3000,density=2500").stdout)
    for name in ("poisson", "restitution", "contact_time_si[s]"):
        assert float(waves[name]) == pytest.approx(float(moduli[name]), rel=1e-9)


@pytest.mark.parametrize(
    "given, said",
    [
        ("--c-p 5900 --density 7800", "c_s: "),
        ("--c-p 5900 --c-s 3200", "density: "),
        (f"{WAVES} --young 2e11", "young: c_p and c_s give it"),
        (f"{WAVES} --poisson 0.3", "poisson: c_p and c_s give it"),
        ("--c-p 3200 --c-s 3200 --density 7800", "c_p: got 3200, allowed above sqrt(4/3) c_s"),
    ],
)
def test_what_makes_no_material_of_waves(stoss, given, said):
    run = stoss.run(f"restitution --body sphere --radius 0.01 --speed 1 {given}")
    assert run.returncode == 3 and said in run.stderr and run.stderr.count("\n") == 1
