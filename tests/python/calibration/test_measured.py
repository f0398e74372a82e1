"""Published rebounds: what one constant explains, and what it does not (docs/understand/measured.md)."""

import importlib
import sys
from pathlib import Path

import pytest
import stoss

ROOT = Path(__file__).parents[3]
PAGE = (ROOT / "docs/understand/measured.md").read_text(encoding="utf-8")


@pytest.fixture
def measured(monkeypatch):
    """The study that makes the table."""
    monkeypatch.setattr(sys, "path", [str(ROOT / "studies/measured"), *sys.path])
    return importlib.import_module("calibrated")


@pytest.mark.long
@pytest.mark.filterwarnings("ignore::stoss.StossWarning")
def test_the_table_of_series_is_that_of_the_study(measured):
    for cells in measured.rows():
        assert f"| {' | '.join(map(str, cells))} |" in PAGE


@pytest.mark.long
def test_a_croquet_ball_by_rebounds_and_contact_times_at_once(measured):
    """T = 2.87 (m²/R E*² v)^{1/5} of Hertz at 2.19 m/s is 0.97 ms with E = 0.7 GPa; loss and time are told apart."""
    rows = measured.points("croquet_on_mallet")
    data = {
        "speed": [float(row["speed_m_s"]) for row in rows],
        "restitution": [float(row["restitution"] or "nan") for row in rows],
        "contact_time": [float(row["contact_time_s"] or "nan") for row in rows],
    }
    data |= {"restitution_uncertainty": [0.015] * 7, "contact_time_uncertainty": [2e-5] * 7}
    ball = measured.ball(0.046, 0.4536, 5e8, 0.4)
    found = stoss.calibrate(data, ball, against=measured.WOOD, unknown={"quality": 10.0, "young": 5e8})
    quality, young = found.constants
    assert 5.5 < quality.value < 7.0
    assert young.value == pytest.approx(7e8, rel=0.1)
    assert abs(found.correlation[0, 1]) < 0.5


@pytest.mark.parametrize(("material", "radius", "value", "error"), [
    ("phenolic resin", 0.0286, 0.94, 0.01), ("glass", 0.00155, 0.9696, 0.003),
])  # fmt: skip
def test_one_value_of_two_alike_is_one_quality(material, radius, value, error):
    """1 − ε² = 2.409/Q of slow balls with little loss, by an independent integral over Hertz' pulse."""
    its = stoss.materials[material]
    ball = stoss.Sphere(
        radius=radius, material=stoss.Material(young=its.young, poisson=its.poisson, density=its.density, quality=30)
    )
    data = {"speed": [0.5], "restitution": [value], "restitution_uncertainty": [error]}
    (quality,) = stoss.calibrate(data, ball, against="same", unknown="quality").constants
    slow = 2.409 / (1.0 - value**2)
    assert quality.value == pytest.approx(slow, rel=0.06)
    assert quality.uncertainty == pytest.approx(slow * 2.0 * value * error / (1.0 - value**2), rel=0.15)
