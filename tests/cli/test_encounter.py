"""Who meets whom: named materials, the JSON Schema of encounters, and what --body and --against refuse."""

import json

import jsonschema
import pytest

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
        return f"young={of['young']},density={of['density']},poisson={of['poisson']},loss_time={of['loss_time']}"

    speed = "restitution --body sphere --radius 0.005 --speed 0.1,1"
    constants = f"--young {steel['young']} --density {steel['density']} --poisson {steel['poisson']}"
    typed = f"{constants} --yield {steel['yield_strength']} --loss-time {steel['loss_time']}"
    named = stoss.data(speed, "--material brass", "--against half-space,material=glass")
    assert named == stoss.data(speed, typed, f"--against half-space,{numbers(glass)}")
    assert all(float(row["yield_speed_si[m/s]"]) > 0 for row in named)


@pytest.mark.parametrize(
    "arguments, name, said",
    [
        ("--material steal --radius 1", "material", "allowed structural steel, glass"),
        ("--material steel --radius 1", "material", "allowed 'structural steel' (yields at 235 MPa) or 'bearing steel' (at"),
        ("--poisson 0.3 --against half-space,material=steel", "material", "'bearing steel'"),
        ("--material 'structural steel'", "radius", "missing (a material needs it too, in m)"),
        ("--material 'structural steel' --radius 1 --young 1e9", "young", "the material has it already"),
        ("--poisson 0.3 --against half-space,material=glass", "against", "has a material, but the first body is dimensionless"),
        ("--material 'structural steel' --radius 1 --against half-space,material=glass,young=1", "against young", "the material has it already"),
    ],
)
def test_refusals(stoss, arguments, name, said):
    result = stoss.run("restitution --body sphere --speed 0.1", arguments)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: ") and said in line


DISK = "restitution --body disk --poisson 0.33 --speed 0.2"
SOLID = "--body disk --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01"


REFUSED = [
    ("dsk,radius=2", "against", "did you mean disk?"),
    ("wall,radius=2", "against", "none with wall"),
    ("same,radius=2", "against", "none with same"),
    ("disk,raduis=2", "against", "did you mean radius?"),
    ("disk,length=2", "against", "allowed poisson, radius, young, density, loss_time, rigid, material with disk"),
    ("disk,", "against", "''"),
    (",", "against", "''"),
    ("disk,radius", "against", "allowed radius=NUMBER"),
    ("disk,radius=2,radius=2", "against", "twice"),
    ("disk,radius=", "against radius", "''"),
    ("disk,radius=nan", "against radius", "'nan'"),
    ("disk,radius=1e400", "against radius", "1e400"),
    ("disk,radius=2=3", "against radius", "2=3"),
    ("disk,radius=0", "against radius", "0"),
    ("disk,young=-1", "against young", "-1"),
    ("disk,density=-1", "against density", "-1"),
    ("disk,poisson=1", "against poisson", "1"),
    ("disk,radius=1e4", "radius ratio", "10000"),
    ("disk,young=1e4", "young ratio", "10000"),
    ("rod", "against", "a disk meets disks"),
    ("exponential", "against", "exponential"),
]


@pytest.mark.parametrize("against, name, said", REFUSED)
def test_refusals_of_options(stoss, tmp_path, against, name, said):
    path = tmp_path / "x.csv"
    path.write_text("precious")
    result = stoss.run(DISK, f"-o {path} --against", against)
    assert (result.returncode, result.stdout, path.read_text()) == (3, "", "precious")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: got ") and said in line and "allowed" in line
    if against != "exponential":
        other = stoss.run("impact --body disk --poisson 0.33 --speed 0.2 --cutoff 20 --against", against)
        assert other.returncode == 3 and name in other.stderr and said in other.stderr


@pytest.mark.parametrize(
    "arguments, name, said",
    [
        (f"{SOLID} --against disk,radius=2", "against", "without young"),
        (f"{SOLID} --against disk,young=1e9,density=1e3,radius=-1", "against radius", "-1"),
        (f"{SOLID} --against disk,young=1e9,density=1e3,radius=0.01,poisson=0.5", "against poisson", "0.5"),
        ("--body rod --poisson 0.3", "poisson", "--body rod"),
        ("--body rod --plane strain", "plane", "--body rod"),
        ("--body rod --against disk", "against", "a disk meets disks"),
        ("--body rod --against rod,area=0", "against area", "0"),
    ],
)
def test_what_does_not_go_together(stoss, arguments, name, said):
    result = stoss.run("restitution --speed 1", arguments)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: got ") and said in line and "allowed" in line
