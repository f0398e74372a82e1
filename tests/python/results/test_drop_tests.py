"""The tables of drop tests and of materials in docs/materials.md are what the example and the
package have."""

import csv
import re
from pathlib import Path

import numpy as np
import pytest

import stoss

ROOT = Path(__file__).parents[3]
SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
PAGE = (ROOT / "docs/materials.md").read_text(encoding="utf-8")


def written(text):
    """A number of a page, as 1.4·10⁻⁷ or 46 µs, and one unit of its last digit."""
    shown, unit = (text.split() + [""])[:2]
    mantissa, _, power = shown.partition("·10")
    scale = 10.0 ** int(power.translate(SUPERSCRIPTS) or 0) * {"": 1, "µs": 1e-6, "ms": 1e-3, "cm": 1e-2}[unit]
    return float(mantissa) * scale, scale * 10.0 ** -len(mantissa.partition(".")[2])


def tables(text):
    """The tables of a part of the page, each a list of rows of cells."""
    blocks = re.findall(r"(?:^\|.*\n)+", text, re.MULTILINE)
    return [[[cell.strip() for cell in line.split("|")[1:-1]] for line in block.splitlines()] for block in blocks]


@pytest.fixture(scope="module")
def rows(example_folder):
    folder = example_folder("08_drop_test") / "out"
    return list(csv.DictReader((folder / "drop_test.csv").read_text(encoding="utf-8").splitlines()))


LINES = {
    "ε, elastic": "restitution",
    "1 − ε², elastic": "lost_fraction",
    "– radiation into the block": "radiation",
    "– ringing of the ball": "ringing",
    "ε, with typical losses": "lossy_restitution",
    "1 − ε², with typical losses": "lossy_lost_fraction",
    "– material": "material",
    "adhesion, estimated": "adhesion",
    "air, estimated": "air",
    "contact time": "contact_time_s",
    "block at least": "block_m",
}


def test_page_has_the_numbers_of_the_example(rows, closed):
    shown = tables(PAGE.partition("## Drop tests")[2].partition("### Beside")[0])
    assert len(shown) == 5 and len(rows) == 15
    for k, table in enumerate(shown):
        three = rows[3 * k : 3 * k + 3]
        assert table[0][0] == f"{three[0]['ball']} on {three[0]['block']}"
        assert [float(cell.split()[0]) for cell in table[0][1:]] == [float(row["speed_m_s"]) for row in three]
        assert [line[0] for line in table[2:]] == list(LINES)
        for name, *cells in table[2:]:
            for cell, row in zip(cells, three):
                value, digit = written(cell)
                assert abs(value - float(row[LINES[name]])) <= 0.51 * digit, (table[0][0], name, cell)


def test_example_agrees_with_direct_calls_and_closed_forms(rows):
    for row in rows:
        ball = stoss.Sphere(radius=5e-3, material=stoss.materials[row["ball"]], loss_time=0)
        block = stoss.HalfSpace(material=stoss.materials[row["block"]], loss_time=0)
        speed = float(row["speed_m_s"])
        direct = stoss.restitution(ball, against=block, speed=speed)
        assert direct.lost_fraction == pytest.approx(float(row["lost_fraction"]), rel=1e-6)
        # The shares are those of the finest run, which the value corrects: both are within an error
        # bar of the truth.
        shares = float(row["ringing"]) + float(row["radiation"])
        assert abs(shares - direct.lost_fraction) <= direct.lost_fraction_error + abs(direct.energy_error)
        # Heat is what a lossy impact loses besides: waves are no more than without.
        waves = float(row["lossy_lost_fraction"]) - float(row["material"])
        assert waves <= direct.lost_fraction + 1e-3 * float(row["lossy_lost_fraction"])
        # The drag of a fall from v²/2g and of the rise, as a sum over its path.
        depth = np.linspace(0.0, speed**2 / (2 * 9.81), 2001)
        force = 0.5 * 0.45 * 1.2 * np.pi * ball.radius**2 * 2 * 9.81 * depth
        mass = 4 / 3 * np.pi * ball.radius**3 * ball.density
        assert float(row["air"]) == pytest.approx(2 * np.trapz(force, depth) / (0.5 * mass * speed**2), rel=1e-6)
        # Hertz: contacts of hard balls last 2.94 δ/v.
        if direct.speed < 1e-3:
            soft = sum((1 - body.poisson**2) / body.young for body in (ball, block))
            delta = (15 * mass * speed**2 * soft / (16 * np.sqrt(ball.radius))) ** 0.4
            assert float(row["contact_time_s"]) == pytest.approx(2.9432 * delta / speed, rel=0.02)


# In JKR theory (K. L. Johnson, K. Kendall, A. D. Roberts 1971) the work between the approach 0, at
# which the surfaces snap together, and pull-off is what the contact takes. R = E* = Γ = 1, contact
# radius a.
def test_sticking_speed_is_that_of_jkr():
    a = np.linspace((np.pi / 8) ** (1 / 3), (2 * np.pi) ** (1 / 3), 100001)
    approach = a**2 - np.sqrt(2 * np.pi * a)
    force = 4 / 3 * a**3 - np.sqrt(8 * np.pi * a**3)
    assert 14.18 == pytest.approx(-2 * np.trapz(force, approach), rel=1e-3)


def test_speeds_of_the_text(rows):
    said = {(row["ball"], row["block"]): row for row in rows}
    text = " ".join(PAGE.partition("- **Plastic flow**")[2].split())
    steel = stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"])
    for block, words in (("bearing steel", "0.51 m/s"), ("glass", "2.2 m/s"), ("brass", "34 mm/s"), ("aluminium", "22 mm/s")):
        begins = stoss.quasistatic.yield_speed(steel, against=stoss.HalfSpace(material=stoss.materials[block]))
        number, unit = words.split()
        assert float(number) * {"m/s": 1, "mm/s": 1e-3}[unit] == pytest.approx(begins, rel=0.03) and words in text
    hard = [float(row["sticking_m_s"]) for (ball, _), row in said.items() if ball != "rubber"]
    assert 5e-5 < min(hard) < 5.5e-5 and 4e-4 < max(hard) < 4.5e-4 and "0.05 to 0.4 mm/s" in text
    assert float(said["rubber", "steel"]["sticking_m_s"]) == pytest.approx(5e-3, rel=0.05)


def test_table_of_materials_is_that_of_the_package():
    (header, _, *lines), *_ = tables(PAGE)
    assert header[1:6] == ["E / Pa", "ν", "ρ / kg m⁻³", "yield / Pa", "Q"]
    assert [line[0] for line in lines] == list(stoss.materials)
    for name, young, poisson, density, strength, quality, source in lines:
        material = stoss.materials[name]
        assert written(young)[0] == pytest.approx(material.young) and float(poisson) == material.poisson
        assert float(density) == material.density and source
        frequency = 2 * np.pi * (500 if name == "rubber" else 1e4)
        known = None if material.loss_time is None else 1 / (frequency * material.loss_time)
        assert (float(quality) if quality else None) == pytest.approx(known)
        assert (written(strength)[0] if strength else None) == pytest.approx(material.yield_strength)


# To first order 1 − ε² = 2c₁x, x = (3/2)η(k/m)^(2/5)v^(1/5), and Hertz' contact time is 2.9432 δ/v.
def test_loss_of_a_slow_ball_to_its_material():
    in_units_of_time = 2.9432 * 1.25**0.4  # τ (k/m)^(2/5) v^(1/5)
    assert 2 * 1.153449 * 1.5 * in_units_of_time / np.pi == pytest.approx(3.54, abs=0.005)
    assert "1 − ε² = 3.54/Q" in " ".join(PAGE.split())
    ice = stoss.Sphere(radius=5e-3, material=stoss.materials["ice"])
    slow = stoss.restitution(ice, speed=0.01)
    expected = 3.54 / 200 * 50e-6 / slow.contact_time_si
    assert slow.dissipated == pytest.approx(expected, rel=0.02)
