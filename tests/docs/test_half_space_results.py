"""The numbers of docs/understand/findings/half_space.md are those of its table of all speeds."""

import math
import re

import pytest
from conftest import page, table

PAGE, WORDS = page("docs/understand/findings/half_space.md")
POWERS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def rows(ball):
    """The rows of one kind of ball, by speed."""
    its = [row for row in table("docs/results/half_space.csv") if row["ball"] == ball]
    assert all(row["converged"] == "true" for row in its)
    return {row["speed"]: row for row in its}


ELASTIC, RIGID, WALL = rows("elastic"), rows("rigid"), rows("at_wall")


def number(cell):
    """A number as the page writes it, and one unit of its last digit."""
    mantissa, error, power = re.fullmatch(r"(?:([\d.]+?)(\(\d+\))?)??·?(?:10([⁻⁰¹²³⁴-⁹]+))?", cell).groups()
    scale = 10.0 ** int(power.translate(POWERS)) if power else 1.0
    digits = len(mantissa.partition(".")[2]) if mantissa else 0
    return float(mantissa or 1.0) * scale, scale * 10.0**-digits, int(error[1:-1]) if error else None


LINES = re.findall(r"^\| [\d.⁻⁰¹²³⁴-⁹]+ \|.*$", PAGE, re.MULTILINE)
TABLE = [[cell.strip() for cell in line.split("|")[1:-1]] for line in LINES]


@pytest.mark.parametrize("cells", TABLE, ids=lambda cells: cells[0])
def test_table_of_the_half_space(cells):
    assert len(TABLE) == 7
    speed = min(ELASTIC, key=lambda each: abs(each - number(cells[0])[0]))
    elastic, rigid, wall = ELASTIC[speed], RIGID[speed], WALL[speed]
    expected = [
        (elastic, "lost_fraction"), (elastic, "slow_theory"), (elastic, "power_law"), (elastic, "lost_to_ball"),
        (rigid, "lost_fraction"), (rigid, "slow_theory"), (rigid, "power_law"), (wall, "lost_fraction"),
    ]  # fmt: skip
    for cell, (row, name) in zip(cells[1:], expected):
        value, unit, error = number(cell)
        assert abs(value - row[name]) <= 0.6 * unit, cell
        assert error is None or abs(error * unit - row[f"{name}_error"]) <= unit, cell


def on_half_space(speed):
    """1 − ε² of the elastic ball at a speed between those of the table, whose logarithms are joined by lines."""
    above = next(each for each in ELASTIC if each >= speed)
    below = max((each for each in ELASTIC if each < speed), default=above)
    share = math.log(speed / below) / math.log(above / below) if above > below else 0.0
    return ELASTIC[below]["lost_fraction"] ** (1 - share) * ELASTIC[above]["lost_fraction"] ** share


def test_waves_of_the_loss_at_the_wall_are_resolved():
    loss = [row["lost_fraction"] for row in WALL.values()]
    assert all(row["lost_fraction_error"] <= 1.05e-3 * row["lost_fraction"] for row in WALL.values())
    turns = [k for k in range(1, len(loss) - 1) if (loss[k] - loss[k - 1]) * (loss[k + 1] - loss[k]) < 0]
    assert (turns[-1] - turns[0]) / (len(turns) - 1) > 7  # from a minimum to a maximum


def test_claims_about_the_loss():
    ratio = [on_half_space(speed) / row["lost_fraction"] for speed, row in WALL.items() if speed <= 0.1]
    assert f"11 to {round(max(ratio), -2):.0f} times more" in WORDS and round(min(ratio)) == 11
    assert max(row["lost_to_ball"] / row["lost_fraction"] for row in ELASTIC.values()) < 0.04
    for its in (ELASTIC, RIGID):
        lost = [row["lost_fraction"] for row in its.values()]
        assert lost == sorted(lost)
    above = {speed: row["lost_fraction"] / row["power_law"] - 1 for speed, row in ELASTIC.items()}
    assert all(each < 0.01 for speed, each in above.items() if speed < 1.9e-5)
    assert max(above.values()) == pytest.approx(0.117, abs=5e-4) == above[0.0316228]
    below = {speed: 1 - row["lost_fraction"] / row["power_law"] for speed, row in RIGID.items()}
    assert all(0 < each < (0.01 if speed < 1.9e-4 else 1.0) for speed, each in below.items())
    for its, highest, within in ((ELASTIC, 1e-3, 0.005), (RIGID, 0.01, 0.01)):
        assert all(
            abs(row["slow_theory"] / row["lost_fraction"] - 1) < within for speed, row in its.items() if speed <= highest
        )
    assert RIGID[1e-6]["lost_fraction"] / ELASTIC[1e-6]["lost_fraction"] == pytest.approx(2.3, abs=0.05)


def test_numbers_of_speeds():
    assert f"{len(ELASTIC)} speeds on the half-space for each ball and {len(WALL)} at a rigid wall" in WORDS
    assert len(RIGID) == len(ELASTIC)


def test_numbers_of_the_waves():
    poisson, shear = 0.3, 1 / math.sqrt(2 * 1.3)
    pressure = shear * math.sqrt((2 - 2 * poisson) / (1 - 2 * poisson))
    assert f"$c_p = {pressure:.3f}$" in PAGE and f"$c_s = {shear:.3f}$" in PAGE
    assert f"= {math.degrees(math.asin(shear / pressure)):.0f}°" in PAGE
    low, high = 0.5 * shear, shear  # of Rayleigh's equation
    while high - low > 1e-9:
        middle = 0.5 * (low + high)
        p, s = (math.sqrt(1 - (middle / speed) ** 2) for speed in (pressure, shear))
        low, high = (middle, high) if 4 * p * s > (1 + s**2) ** 2 else (low, middle)
    assert f"$c_R = {low:.3f}$" in PAGE
    assert f"contact lasts {ELASTIC[0.1]['contact_time']:.2f} R/c" in WORDS
