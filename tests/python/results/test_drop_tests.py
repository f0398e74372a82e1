"""The tables of drop tests and of materials in docs/reference/materials.md, and the example of drop tests, are what the package
has."""

import csv
import re
from pathlib import Path

import numpy as np
import pytest

import stoss

pytestmark = pytest.mark.filterwarnings("ignore::stoss.StossWarning")
ROOT = Path(__file__).parents[3]
SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
PAGE = (ROOT / "docs/reference/materials.md").read_text(encoding="utf-8")


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


PAIRS = [
    ("bearing steel", "glass", (0.01, 0.1, 1.0)),
    ("glass", "glass", (0.01, 0.1, 1.0)),
    ("bearing steel", "bearing steel", (0.01, 0.1, 1.0)),
    ("rubber", "structural steel", (0.1, 1.0, 5.0)),
    ("ice", "ice", (0.01, 0.1, 1.0)),
]
RADIUS = 5e-3  # m


def solids(one, other, **loss):
    ball = stoss.Sphere(radius=RADIUS, material=stoss.materials[one], **loss)
    return ball, stoss.HalfSpace(material=stoss.materials[other], **loss)


@pytest.fixture(scope="module")
def rows():
    """What the page says, by direct calls and closed forms."""
    made = []
    for one, other, speeds in PAIRS:
        ball, block = solids(one, other, loss_time=0)
        drop = stoss.restitution(ball, against=block, speed=speeds)
        nu = block.poisson
        wave = np.sqrt(block.young * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / block.density)
        for speed, time in zip(speeds, drop.contact_time_si):
            made.append({"ball": one, "block": other, "speed_m_s": speed, "contact_time_s": time,
             "block_m": 0.5 * time * wave})
    return made


@pytest.fixture(scope="module")
def predicted(example_folder):
    folder = example_folder("08_drop_test") / "out"
    return list(csv.DictReader((folder / "drop_test.csv").read_text(encoding="utf-8").splitlines()))


@pytest.mark.long
def test_example_agrees_with_direct_calls(predicted, rows):
    assert [(row["ball"], row["block"], float(row["speed_m_s"])) for row in predicted] == [
        (row["ball"], row["block"], row["speed_m_s"]) for row in rows
    ]
    for row, plain in list(zip(predicted, rows))[::2]:
        ball, block = solids(row["ball"], row["block"])
        made = stoss.predict(ball, against=block, speed=plain["speed_m_s"])
        for name in ("restitution", "restitution_without_models", *CHANNELS):
            said = getattr(made, "yielding" if name == "yield" else name)
            assert float(row[name]) == pytest.approx(said, rel=1e-6, abs=1e-300), name
        uncertain = (made.restitution_error, made.by_models, made.by_constants)
        assert [float(row[name]) for name in ("numerical", "models", "constants")] == pytest.approx(uncertain)
        assert sum(float(row[name]) for name in CHANNELS) == pytest.approx(float(row["lost_fraction"]), rel=1e-6)
        assert row["dominant"] == made.dominant == max(CHANNELS, key=lambda name: float(row[name]))
        # What takes little leaves the time of contact as it is.
        if row["ball"] != "rubber" and made.yielding == 0 and made.adhesion < 1e-3:
            assert float(row["contact_time_s"]) == pytest.approx(plain["contact_time_s"], rel=0.03)
            assert float(row["block_m"]) == pytest.approx(plain["block_m"], rel=0.03)


CHANNELS = ("radiation", "ringing", "material", "yield", "adhesion")


def test_table_of_materials_is_that_of_the_package():
    (header, _, *lines), *_ = tables(PAGE)
    assert header[1:7] == ["E / Pa", "ν", "ρ / kg m⁻³", "yield / Pa", "Q", "γ / J m⁻²"]
    assert [line[0] for line in lines] == list(stoss.materials)
    for name, young, poisson, density, strength, quality, energy, source in lines:
        material = stoss.materials[name]
        shown, unit = written(young)  # that of a relaxation is E(0), of which the page has four digits
        assert shown == pytest.approx(material.young, abs=0.5 * unit if material.relaxation else 1e-6 * shown)
        assert float(poisson) == material.poisson
        assert float(density) == material.density and source
        assert (float(quality) if quality else None) == material.quality
        assert (written(strength)[0] if strength else None) == pytest.approx(material.yield_strength)
        assert (float(energy) if energy else None) == material.surface_energy


# The numbers are those of a constant Q (studies/loss/constant_quality.py): 2.41/Q at small loss, of ice 2.40/Q.
@pytest.mark.parametrize("speed", [0.01, 0.1])
def test_loss_of_a_slow_ball_to_its_material(speed):
    words = " ".join(PAGE.split())
    assert "a slow ball loses 2.41/Q at every speed" in words and "3.54/Q" not in words
    ice = stoss.Sphere(radius=5e-3, material=stoss.materials["ice"])
    assert stoss.restitution(ice, speed=speed).dissipated == pytest.approx(2.40 / 200, rel=0.02)
