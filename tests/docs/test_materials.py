"""The table of cylinders in docs/materials.md and what is said of their yielding: the numbers of the command. (Those of
balls and drop tests are in tests/python.)"""

import math

import pytest
from conftest import command, line, page, power, with_error

PAGE, WORDS = page("docs/materials.md")
# E, ν, ρ as the page and stoss.materials have them; speeds in m/s.
CYLINDERS = {
    "steel": (2.1e11, 0.30, 7850, (0.01, 0.1, 1, 10)),
    "glass": (7.0e10, 0.22, 2500, (0.1, 1, 10)),
    "ice": (9.3e9, 0.33, 917, (0.01, 0.1, 1)),
    "rubber": (2e6, 0.49, 1100, (0.1, 1, 10)),
}
MILD, HARDENED = 0.235e9, 1.7e9  # yield strengths, Pa


def impacts(name, speeds=None):
    """Impacts of a cylinder, each with its maximum pressure √F E′ in Pa."""
    young, poisson, density, usual = CYLINDERS[name]
    found = command(f"restitution --poisson {poisson} --young {young} --density {density} --radius 0.01 --plane strain"
                    f" --speed {','.join(map(str, speeds or usual))} --quiet")  # fmt: skip
    return [row | {"pressure": math.sqrt(row["max_force"]) * young / (1 - poisson**2)} for row in found]


def shown(speed):
    return power(speed, 2) if speed < 1e-3 else f"{speed:#.2g}"


def pressure(value):
    """With two digits, in MPa or GPa."""
    unit, scale = ("GPa", 1e9) if value > 1.2e8 else ("MPa", 1e6)
    value /= scale
    return f"{value:.0f} {unit}" if value >= 10 else f"{float(f'{value:.1e}'):#.2g} {unit}"


def duration(seconds):
    return f"{1e3 * seconds:.1f} ms" if seconds > 1e-3 else f"{1e6 * seconds:.1f} µs"


@pytest.mark.parametrize("name", CYLINDERS)
def test_table_of_cylinders(name):
    for row, speed in zip(impacts(name), CYLINDERS[name][3]):
        cells = (f"{speed:g}", shown(row["speed"]), with_error(row["restitution"], row["restitution_error"]),
                 duration(row["contact_time_si"]), pressure(row["pressure"]))  # fmt: skip
        assert line(*cells)[2:] in PAGE, line(*cells)


@pytest.mark.parametrize("strength, said", [(MILD, 0.06), (HARDENED, 2.7)])
def test_where_cylinders_begin_to_flow(strength, said):
    below, above = impacts("steel", (0.95 * said, 1.05 * said))
    assert below["pressure"] < 1.79 * strength < above["pressure"]
    assert f"{said:g} m/s" in WORDS and f"{1.79 * strength / 1e9:.2g} GPa" in WORDS


@pytest.mark.parametrize("strength, said", [(MILD, "0.9 mm/s"), (HARDENED, "0.13 m/s")])
def test_where_balls_begin_to_yield(strength, said):
    density = 7850 if strength == MILD else 7810
    (row,) = command(f"restitution --body sphere --poisson 0.3 --young 2.1e11 --density {density} --radius 0.01"
                     f" --yield {strength} --speed 0.01 --quiet")  # fmt: skip
    begins = row["yield_speed_si"]
    assert said == (f"{1e3 * begins:.1f} mm/s" if begins < 0.01 else f"{begins:.2f} m/s") and f"{said}" in WORDS
    assert f"{strength / 1e9:g} GPa" in WORDS


def test_two_glass_balls_beside_measurements():
    young, poisson, density, _ = CYLINDERS["glass"]
    ball = f"--body sphere --poisson {poisson} --young {young} --density {density} --radius 1.59e-3"
    job = f"restitution {ball} --speed 1"
    (elastic,) = command(f"{job} --against same")
    loss_time = 1 / (1000 * 2 * math.pi * 1e4)
    (lossy,) = command(f"{job} --loss-time {loss_time} --against same")
    said = f"{elastic['restitution']:.5f} elastic and {lossy['restitution']:.3f} with the Q above at 1 m/s"
    assert said in WORDS
    assert round(1000 * (1 - lossy["restitution"]) / (1 - 0.97), -2) == 300 and "a Q of some 300" in WORDS
