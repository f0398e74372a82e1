"""The numbers of docs/understand/findings/rows.md: those of the tables that studies/rows writes, and these against the
command."""

import importlib.util
import math
import os
import sys

import pytest
from conftest import ROOT, page, table

sys.path.append(str(ROOT / "studies/rows"))
SPEC = importlib.util.spec_from_file_location("make_rows", ROOT / "studies/rows/make.py")
make = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(make)

PAGE, WORDS = page("docs/understand/findings/rows.md")
CRADLES, SLOW, WAVES, SPEEDS, DELAYS, DROPS, WALLS, PAIRWISE = (
    table(f"docs/results/rows/{name}.csv")
    for name in ("cradles", "slow", "waves", "speeds", "delays", "drops", "walls", "pairwise")
)
PROGRAM = os.environ["STOSS"]


def having(rows, **values):
    return [row for row in rows if all(row[name] == value for name, value in values.items())]


def listed(rows, places, name="velocity"):
    """As −0.069, 0.075."""
    return ", ".join(f"{row[name]:.{places}f}".replace("-", "−") for row in rows)


def line(*cells):
    return "| " + " | ".join(cells) + " |"


@pytest.mark.parametrize("material", make.MATERIALS)
@pytest.mark.parametrize("speed", [0.1, 1])
def test_cradles(material, speed):
    strengths = (0, make.YIELD) if material == "bearing steel" and speed == 1 else (0,)
    for strength in strengths:
        its = [having(CRADLES, material=material, balls=balls, speed=speed, yield_strength=strength) for balls in (3, 5)]
        name = material + (", yields" if strength else ", elastic" if len(strengths) > 1 else "")
        places = 1 if "rubber" in material else 2
        left = ", ".join(f"{100 * each[0]['translation']:.{places}f} %" for each in its)
        assert line(name, f"{speed:g}", *(listed(each, 3) for each in its), left) in PAGE
    assert all(row["velocity_error"] < 4e-4 and row["converged"] == "true" for row in CRADLES)
    assert {row["material"] for row in CRADLES if row["would_yield"] == "true"} == {"bearing steel"}


def test_slow_rows():
    for shown, speed in (("Hertz", 0), ("10⁻⁷", 1e-7), ("10⁻⁵", 1e-5), ("10⁻³", 1e-3), ("0.01", 0.01), ("0.1", 0.1)):
        cells = [listed(having(SLOW, balls=balls, speed=speed), 4) for balls in (3, 5)]
        assert line(shown, *cells) in PAGE
    first = {row["speed"]: row["velocity"] for row in having(SLOW, balls=3, body=0)}
    off = [f"{100 * (1 - first[speed] / first[0]):.{places}f}" for speed, places in ((1e-7, 1), (1e-5, 1), (1e-3, 0), (0.1, 0))]
    assert "by {} % at 10⁻⁷ c, {} % at 10⁻⁵ c, {} % at 10⁻³ c and {} % at 0.1 c".format(*off) in WORDS


def test_wave():
    (point,) = table("docs/results/rows/point_wave.csv")
    for shown, speed in (("10⁻⁵", 1e-5), ("10⁻³", 1e-3), ("0.01", 0.01), ("0.1", 0.1), ("0.2", 0.2)):
        (its,) = having(SPEEDS, speed=speed)
        cells = f"{its['wave_speed']:#.3g}", f"{its['over_sixth_root']:.3f}", f"{its['width']:.2f}"
        assert line(shown, *cells) in PAGE
    assert f"| {point['over_sixth_root']:.3f} | {point['width']:.2f} |" in PAGE
    fast = {row["contact"]: row["max_force"] for row in having(WAVES, material="elastic", speed=0.1)}
    assert f"falls by {100 * (1 - fast[60] / fast[20]):.2f} % at 0.1 c" in WORDS
    slow = {row["contact"]: row["max_force"] for row in having(WAVES, material="elastic", speed=1e-3)}
    assert abs(slow[60] / slow[20] - 1) < 1e-5
    falls = []
    for speed in (1e-3, 0.1):
        lossy = {row["contact"]: row["max_force"] for row in having(WAVES, material="Q = 100", speed=speed)}
        falls.append((lossy[10] / lossy[26]) ** (1 / 16) - 1)
    assert "falls by {:.2f} % with each ball at 10⁻³ c, and by {:.2f} % at 0.1 c".format(*(100 * each for each in falls)) in WORDS
    assert "over {:.0f} and {:.0f} balls".format(*(math.log(2) / math.log1p(each) for each in falls)) in WORDS


def test_delays():
    for shown, speed in (("10⁻⁵", 1e-5), ("10⁻³", 1e-3), ("0.1", 0.1)):
        added = {row["balls"]: row["added"] for row in having(DELAYS, speed=speed)}
        assert line(shown, *(f"{added[balls]:.3f}" for balls in (3, 4, 5, 10))) in PAGE


def test_drops():
    for shown, ratio in (("1:1", 1), ("1:1.5", 1.5), ("1:2", 2), ("1:3", 3), ("1:4", 4)):
        its = [having(DROPS, ratio=ratio, speed=speed, gap=0)[0] for speed in (1e-4, 0.01, 0.1)]
        cells = its[0]["textbook"], its[0]["hertz"], *(row["small"] for row in its)
        assert line(shown, *(f"{-each:.3f}" for each in cells)) in PAGE
    for shown, speed in (("10⁻⁴ c", 1e-4), ("0.01 c", 0.01), ("0.1 c", 0.1)):
        its = [having(DROPS, ratio=4, speed=speed, gap=gap)[0]["small"] for gap in (0, 1e-4, 1e-3, 0.01, 0.1)]
        assert line(shown, *(f"{-each:.3f}" for each in its)) in PAGE


def test_walls():
    for room in (0.5, 0.6):
        its = having(WALLS, gap=room)
        each = [row["restitution"] for row in its]
        last = its[-1]["speed"]
        cells = (f"{room:g}", f"{len(its)}", f"{min(each):.3f} to {max(each):.3f}", f"{sum(one > 1 for one in each)}",
                 f"{last:.4f}", f"{(last / 0.1) ** (1 / len(its)):.4f}")  # fmt: skip
        assert line(*cells) in PAGE


def test_pairwise_rules():
    names = ("velocity", "pairwise", "hertz_with_dashpot")
    for shown, values, bodies, places in (
        ("3 balls, 0.1 c", {"row": "3 balls", "material": "elastic", "speed": 0.1}, (0, 1, 2), 3),
        ("5 balls, 0.1 c, first and last", {"row": "5 balls", "material": "elastic", "speed": 0.1}, (0, 4), 3),
        ("3 balls, Q = 10", {"row": "3 balls", "material": "Q = 10", "speed": 1e-3}, (0, 1, 2), 3),
        ("5 balls, Q = 10, first and last", {"row": "5 balls", "material": "Q = 10", "speed": 1e-3}, (0, 4), 3),
    ):
        its = [row for row in having(PAIRWISE, **values) if row["body"] in bodies]
        assert line(shown, *(listed(its, places, name) for name in names)) in PAGE


def test_tables_are_those_of_the_command():
    for row, stored in zip(make.of_cradle(PROGRAM, "rubber", 3, 1), having(CRADLES, material="rubber", balls=3, speed=1)):
        assert float(row["velocity"]) == pytest.approx(stored["velocity"], abs=2 * stored["velocity_error"])
    for row, stored in zip(make.of_speed(PROGRAM, 5, 0.1), having(SLOW, balls=5, speed=0.1)):
        assert float(row["velocity"]) == pytest.approx(stored["velocity"], abs=2 * stored["velocity_error"])
    (stored,) = having(DROPS, ratio=2, speed=0.01, gap=0)
    assert float(make.of_drop(PROGRAM, 2.0, 0.01, 0.0)["small"]) == pytest.approx(stored["small"], abs=2 * stored["error"])
