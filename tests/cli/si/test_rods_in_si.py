"""Rods with a material: --young, --density, --length and --area with --body rod."""

import json
import math

import pytest
from conftest import number, rows

YOUNG, DENSITY, LENGTH, AREA = 2.1e11, 7850, 0.5, 1e-4
STEEL = f"--body rod --young {YOUNG} --density {DENSITY} --length {LENGTH} --area {AREA}"
C = math.sqrt(YOUNG / DENSITY)
ALUMINIUM = {"young": 7e10, "density": 2700, "length": 1.0}


def second(**keys):
    return "rod," + ",".join(f"{key}={value!r}" for key, value in keys.items())


def transit_and_impedance(young, density, length, area):
    return length / math.sqrt(young / density), area * math.sqrt(young * density)


def exact(second_area):
    """Restitution and contact time in s, by the method of characteristics (docs/theory/pairs.md, Rods)."""
    first_time, first = transit_and_impedance(YOUNG, DENSITY, LENGTH, AREA)
    second_time, other = transit_and_impedance(**ALUMINIUM, area=second_area)
    if first <= other:
        return (other - first + 2 * first * first_time / second_time) / (first + other), 2 * first_time
    whole, part = divmod(second_time / first_time, 1)
    r = (first - other) / (first + other)
    masses = first * first_time / (other * second_time)
    return (1 + masses) * (1 - r**whole * (1 - part * (1 - r))) - 1, 2 * second_time


@pytest.mark.parametrize("area", [2e-4, 4e-4], ids=["softer", "harder"])
def test_two_metals_meet_as_the_method_of_characteristics_says(stoss, area):
    restitution, contact_time = exact(area)
    against = second(**ALUMINIUM, area=area)
    (row,) = stoss.data(f"restitution {STEEL} --speed 1 --tolerance 1e-2 --against {against}")
    assert abs(number(row, "restitution") - restitution) <= number(row, "restitution_error")
    assert abs(float(row["contact_time_si[s]"]) - contact_time) <= float(row["contact_time_si_error[s]"])
    errors = []
    for cutoff in (100, 400, 1600):
        (hit,) = stoss.data(f"impact {STEEL} --speed 1 --cutoff {cutoff} --against {against}")
        errors.append(abs(number(hit, "restitution") - restitution))
    assert errors[2] < errors[0] / 8 and errors[2] < 1e-3


def test_force_is_that_of_two_plane_waves(stoss, tmp_path):
    path = tmp_path / "t.csv"
    stoss.data(f"impact {STEEL} --speed 1 --cutoff 400 --trajectory {path} --against", second(**ALUMINIUM, area=4e-4))
    instants = [row for row in rows(path.read_text()) if 0.1 < number(row, "time") < 1.9]
    mean = sum(number(row, "force") for row in instants) / len(instants)
    _, first = transit_and_impedance(YOUNG, DENSITY, LENGTH, AREA)
    _, other = transit_and_impedance(**ALUMINIUM, area=4e-4)
    assert mean * YOUNG * AREA == pytest.approx(first * other / (first + other), rel=1e-3)


def test_si_values_are_those_of_the_ratios(stoss):
    (si,) = stoss.data(f"restitution {STEEL} --speed 1 --tolerance 1e-2 --against", second(**ALUMINIUM, area=2e-4))
    ratios = {"length": 1 / LENGTH, "young": 7e10 / YOUNG, "density": 2700 / DENSITY, "area": 2e-4 / AREA}
    (own,) = stoss.data(f"restitution --body rod --speed {1 / C!r} --tolerance 1e-2 --against", second(**ratios))
    assert float(si["speed_si[m/s]"]) == pytest.approx(1, rel=1e-14)
    scales = {"contact_time[L/c]": LENGTH / C, "max_compression[L]": LENGTH, "max_force[EA]": YOUNG * AREA}
    units = {"contact_time[L/c]": "s", "max_compression[L]": "m", "max_force[EA]": "N"}
    for column, scale in scales.items():
        name, _, unit = column.partition("[")
        assert float(si[column]) == pytest.approx(float(own[column]), rel=1e-10)
        assert float(si[f"{name}_si[{units[column]}]"]) == pytest.approx(float(own[column]) * scale, rel=1e-10)
        assert float(si[f"{name}_si_error[{units[column]}]"]) == pytest.approx(
            float(own[f"{name}_error[{unit}"]) * scale, rel=1e-6
        )
    assert number(si, "restitution") == pytest.approx(number(own, "restitution"), abs=1e-11)


def test_same_is_the_wall_at_half_the_speed(stoss):
    (pair,) = stoss.data(f"impact {STEEL} --speed 2 --cutoff 200 --against same")
    (wall,) = stoss.data(f"impact {STEEL} --speed 1 --cutoff 200")
    assert number(pair, "restitution") == pytest.approx(number(wall, "restitution"), abs=1e-12)
    assert float(pair["contact_time_si[s]"]) == pytest.approx(float(wall["contact_time_si[s]"]), rel=1e-12)


def test_inputs_and_trajectory(stoss, tmp_path):
    path = tmp_path / "t.csv"
    against = second(**ALUMINIUM, area=2e-4)
    result = stoss.run(f"impact {STEEL} --speed 1 --cutoff 100 --format json --trajectory {path} --against", against)
    document = json.loads(result.stdout)
    inputs = document["inputs"]
    rod = inputs["first"]
    assert (rod["length"], rod["area"], rod["material"]["young"]) == (LENGTH, AREA, YOUNG)
    assert (inputs["against"]["length"], inputs["against"]["material"]["density"]) == (1, 2700)
    assert (document["units"]["max_force_si"], document["units"]["max_force"]) == ("N", "EA")
    assert {"time[L/c]", "center[L]", "force[EA]"} <= set(rows(path.read_text())[0])


SOLID = "--young 1e9 --density 1e3"
WHOLE = f"{SOLID} --length 1 --area 1"


@pytest.mark.parametrize(
    "arguments, name, said",
    [
        ("--body rod --young 1e9", "material", "rod without density, allowed young, density and sizes"),
        (f"--body rod {SOLID} --length 1", "area", "missing (a material needs it too, in m^2)"),
        ("--body rod --length 1 --area 1", "material", "rod without young"),
        (f"--body rod {SOLID} --length 0 --area 1", "length", "0"),
        (f"--body rod {SOLID} --length 1 --area -1", "area", "-1"),
        (f"--body rod {WHOLE} --radius 1", "radius", "--body rod"),
        (f"--body rod {WHOLE} --against rod,length=2", "against", "without young"),
        (f"--body rod {WHOLE} --against rod,length=2,young=1e9,density=1e3", "against area", "missing"),
        (f"--body rod {WHOLE} --against rod,length=1,area=1,young=-1,density=1", "against young", "-1"),
        (f"--body rod {WHOLE} --against rod,length=1e6,area=1,young=1e9,density=1e3", "length ratio", "1e+06"),
        (f"--body rod {WHOLE} --against disk", "against", "a disk meets disks"),
        ("--poisson 0.3 --length 1", "length", "--body sphere, allowed only with --body rod"),
        (f"--poisson 0.3 {SOLID} --radius 1 --area 1", "area", "--body sphere, allowed only with --body rod"),
    ],
)
def test_refusals(stoss, arguments, name, said):
    for command in ("restitution", "impact"):
        result = stoss.run(f"{command} --speed 0.1", arguments)
        assert (result.returncode, result.stdout) == (3, "")
        (line,) = result.stderr.splitlines()
        assert line.startswith(f"stoss: error: {name}: ") and said in line


@pytest.mark.parametrize("command", ["restitution", "impact"])
def test_help_names_them(stoss, command):
    text = stoss.run(command, "--help").stdout
    assert "--length M " in text and "--area M^2" in text
