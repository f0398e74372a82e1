"""Spheres with a material: SI values, two materials, and where yielding begins (--yield)."""

import json
import math

import pytest
from conftest import number

YOUNG, POISSON, DENSITY, RADIUS = 2.1e11, 0.3, 7850, 0.01
STEEL = f"--body sphere --poisson {POISSON} --young {YOUNG} --density {DENSITY} --radius {RADIUS}"
GLASS = "sphere,poisson=0.22,young=7e10,density=2500,radius=0.02"
C = math.sqrt(YOUNG / DENSITY)
FORCE = 4 * math.pi / 3 * RADIUS**2 * YOUNG  # m c^2/R


def yield_speed(strength, spheres):
    """In m/s, by Johnson's section 11.5(a): the energy at which Hertz' maximum pressure is 1.6 Y."""
    compliance = sum((1 - nu**2) / young for young, nu, _, _ in spheres)
    curvature = sum(1 / radius for _, _, _, radius in spheres)
    inverse_mass = sum(1 / (4 / 3 * math.pi * density * radius**3) for _, _, density, radius in spheres)
    pressure, modulus, radius = 1.6 * strength, 1 / compliance, 1 / curvature
    contact = math.pi * pressure * radius / (2 * modulus)
    energy = 8 / 15 * modulus * math.sqrt(radius) * (contact**2 / radius) ** 2.5
    return math.sqrt(2 * energy * inverse_mass)


def test_si_values_are_those_of_the_units(stoss):
    (si,) = stoss.data(f"restitution {STEEL} --speed 50")
    (own,) = stoss.data(f"restitution --body sphere --poisson {POISSON} --speed {50 / C!r}")
    assert float(si["speed_si[m/s]"]) == pytest.approx(50, rel=1e-14)
    scales = {"contact_time_si[s]": RADIUS / C, "max_compression_si[m]": RADIUS, "max_force_si[N]": FORCE}
    for name, scale in scales.items():
        assert float(si[name]) == pytest.approx(number(own, name.partition("_si")[0]) * scale, rel=1e-10)
    assert number(si, "restitution") == pytest.approx(number(own, "restitution"), abs=1e-12)
    assert "beyond_yield" not in si


# Hertz' impact (Johnson, eq. 11.24): the maximum force from the energy, the time 2.94 delta/v.
def test_a_slow_ball_of_steel_is_hertzian(stoss):
    (row,) = stoss.data(f"impact {STEEL} --speed 0.01 --cutoff 25")
    modulus, mass = YOUNG / (1 - POISSON**2), 4 / 3 * math.pi * DENSITY * RADIUS**3
    delta = (15 * mass * 0.01**2 / (16 * modulus * math.sqrt(RADIUS))) ** 0.4
    assert float(row["max_compression_si[m]"]) == pytest.approx(delta, rel=0.01)
    assert float(row["max_force_si[N]"]) == pytest.approx(
        4 / 3 * modulus * math.sqrt(RADIUS) * delta**1.5, rel=0.01
    )
    assert float(row["contact_time_si[s]"]) == pytest.approx(2.9432 * delta / 0.01, rel=0.01)


def test_two_materials_are_their_ratios(stoss):
    (si,) = stoss.data(f"restitution {STEEL} --speed 100 --against {GLASS}")
    against = f"sphere,poisson=0.22,radius=2,young={7e10 / YOUNG!r},density={2500 / DENSITY!r}"
    (own,) = stoss.data(f"restitution --body sphere --poisson 0.3 --speed {100 / C!r} --against {against}")
    assert number(si, "restitution") == pytest.approx(number(own, "restitution"), abs=1e-11)
    assert number(si, "lost_to_second") == pytest.approx(number(own, "lost_to_second"), abs=1e-11)


def test_modes_in_hertz(stoss):
    (row, *_) = stoss.data(f"modes {STEEL} --cutoff 4")
    assert float(row["frequency[Hz]"]) == pytest.approx(number(row, "omega") * C / RADIUS / (2 * math.pi), rel=1e-12)
    refused = stoss.run(f"modes {STEEL} --plane strain")
    assert refused.returncode == 3 and "plane: got --plane with --body sphere" in refused.stderr


@pytest.mark.parametrize(
    "against, strengths, expected",
    [
        ("wall", "", yield_speed(1e9, [(YOUNG, POISSON, DENSITY, RADIUS)])),
        ("same", "", yield_speed(1e9, [(YOUNG, POISSON, DENSITY, RADIUS)] * 2)),
        (GLASS, "", yield_speed(1e9, [(YOUNG, POISSON, DENSITY, RADIUS), (7e10, 0.22, 2500, 0.02)])),
        (GLASS, ",yield=4e8", yield_speed(4e8, [(YOUNG, POISSON, DENSITY, RADIUS), (7e10, 0.22, 2500, 0.02)])),
        (GLASS, ",yield=9e9", yield_speed(1e9, [(YOUNG, POISSON, DENSITY, RADIUS), (7e10, 0.22, 2500, 0.02)])),
    ],
)
def test_record_says_where_yielding_begins(stoss, against, strengths, expected):
    slower, faster = 0.99 * expected, 1.01 * expected
    command = f"restitution {STEEL} --yield 1e9 --speed {slower!r},{faster!r} --against {against}{strengths}"
    result = stoss.run(command, "--format json --tolerance 0.1")
    document = json.loads(result.stdout)
    first, second = document["records"]
    assert first["yield_speed_si"] == pytest.approx(expected, rel=1e-12)
    assert first["yield_speed"] == pytest.approx(expected / C, rel=1e-12)
    assert (first["beyond_yield"], second["beyond_yield"]) == (False, True)
    assert document["inputs"]["first"]["material"]["yield_strength"] == 1e9
    assert document["units"]["yield_speed_si"] == "m/s"
    (line,) = result.stderr.splitlines()
    asked = f"you asked for {faster:.4g} m/s, 1.01 times that"
    assert line.endswith(f" yields above {expected:.3g} m/s ({asked}): the real rebound is lower; use stoss predict")
    assert line.startswith("stoss: warning: the ball " if strengths != ",yield=4e8" else "stoss: warning: the other ball ")


def test_a_strength_of_the_second_alone(stoss):
    (row,) = stoss.data(f"impact {STEEL} --speed 1 --cutoff 25 --against {GLASS},yield=4e8")
    spheres = [(YOUNG, POISSON, DENSITY, RADIUS), (7e10, 0.22, 2500, 0.02)]
    assert float(row["yield_speed_si[m/s]"]) == pytest.approx(yield_speed(4e8, spheres), rel=1e-12)
    assert row["beyond_yield"] == "true"


# Johnson: 0.14 m/s for a hard steel sphere (Y = 1000 N/mm^2) that strikes steel, which has E* of half the modulus at a
# rigid wall.
def test_hard_steel_yields_where_johnson_says(stoss):
    half = STEEL.replace(str(YOUNG), str(YOUNG / 2))
    (row,) = stoss.data(f"impact {half} --yield 1e9 --speed 0.1 --cutoff 25")
    assert float(row["yield_speed_si[m/s]"]) == pytest.approx(0.14, abs=0.005)
    assert row["beyond_yield"] == "false"


def test_inputs_describe_both(stoss):
    words = f"impact {STEEL} --yield 1e9 --speed 1 --cutoff 25 --against {GLASS},yield=4e8 --format json --quiet"
    inputs = json.loads(stoss.run(words).stdout)["inputs"]
    steel = {"young": YOUNG, "poisson": POISSON, "density": DENSITY, "yield_strength": 1e9}
    glass = {"young": 7e10, "poisson": 0.22, "density": 2500, "yield_strength": 4e8}
    assert inputs["first"] == {"kind": "sphere", "radius": RADIUS, "material": steel}
    assert inputs["against"] == {"kind": "sphere", "radius": 0.02, "material": glass}


@pytest.mark.parametrize(
    "arguments, name, said",
    [
        ("--young 1e9", "material", "sphere without density, allowed young, density and sizes"),
        ("--young 1e9 --density 1e3 --radius 0", "radius", "0"),
        ("--young -1 --density 1e3 --radius 1", "young", "-1"),
        ("--young 1e9 --density 1e3 --radius 1 --yield 0", "yield_strength", "0"),
        ("--young 1e9 --density 1e3 --radius 1 --plane stress", "plane", "--body sphere"),
        ("--young 1e9 --density 1e3 --radius 1 --against sphere,radius=2", "against", "without young"),
        (
            "--young 1e9 --density 1e3 --radius 1 --against sphere,young=1e9,density=1e3,radius=1,yield=-1",
            "against yield_strength",
            "-1",
        ),
    ],
)
@pytest.mark.parametrize("command", ["restitution", "impact"])
def test_refusals(stoss, command, arguments, name, said):
    result = stoss.run(f"{command} --body sphere --poisson 0.3 --speed 1", arguments)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: got ") and said in line and "allowed" in line
