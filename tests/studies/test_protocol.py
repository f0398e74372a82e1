"""What the reproduction of the paper computes by itself: its two limits, its relaxation at rest, its law of compression."""

import re
import sys

import numpy as np
import pytest
from scipy import optimize

from study_runs import ROOT

sys.path.insert(0, str(ROOT / "studies"))
import stoss  # noqa: E402
from gerl_zippelius_1999 import printed_law, two_limits  # noqa: E402
from gerl_zippelius_1999.relaxation import relaxed_force  # noqa: E402

WAYS = [(0.33, 0.05), (0.33, 0.1), (0.33, 0.2), (0.33, 0.3), (0.9, 0.1), (0.9, 0.3)]


@pytest.mark.filterwarnings("ignore::stoss.StossWarning")
def test_both_ways_agree_as_the_page_says():
    page = (ROOT / "docs/developer/numerics.md").read_text(encoding="utf-8")
    for poisson, speed in WAYS:
        mine = stoss.restitution(poisson=poisson, speed=speed)
        two = two_limits.two_limits(poisson, speed, np.array(two_limits.SCALED) / speed)
        errors = mine.lost_fraction_error + two.lost_fraction_error
        off = abs(mine.lost_fraction - two.lost_fraction) / errors
        assert off < 1 and abs(mine.restitution - two.restitution) < mine.restitution_error + two.restitution_error
        cells = (f"{poisson:g}", f"{speed:g}", f"{mine.lost_fraction:.5f} ± {mine.lost_fraction_error:.5f}",
                 f"{two.lost_fraction:.4f} ± {two.lost_fraction_error:.4f}", f"{off:.2f}")  # fmt: skip
        assert "| " + " | ".join(cells) + " |" in page
        # Each number of modes leaves out some that soften the impact.
        assert all(hard.value > mine.lost_fraction and hard.error > 0 for hard in two.hard_wall)


def test_a_line_has_the_errors_of_its_scatter_and_of_its_points():
    x, y, errors = np.array([1.0, 2.0, 4.0, 5.0]), np.array([2.0, 2.9, 5.2, 5.9]), np.array([0.1, 0.2, 0.1, 0.3])
    (_, value), covariance = np.polyfit(x, y, 1, cov=True)
    found = two_limits.line(x, y, errors)
    shifts = [np.polyfit(x, y + errors * (np.arange(4) == k), 1)[1] - value for k in range(4)]
    assert found.value == pytest.approx(value, rel=1e-12)
    assert found.error == pytest.approx(np.hypot(4.303 * np.sqrt(covariance[1, 1]), np.linalg.norm(shifts)), rel=1e-9)


@pytest.mark.parametrize("hardness", [30.0, 500.0])
@pytest.mark.parametrize("compression", [-0.03, 0.0, 0.04])
def test_relaxation_is_the_minimum_over_the_modes(hardness, compression):
    modes = stoss.modes(poisson=0.33, cutoff=5)
    phi = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 1201)
    n = modes.order[:, None]
    shape = modes.radial[:, None] * np.cos(n * phi) * np.cos(phi) - modes.tangential[:, None] * np.sin(n * phi) * np.sin(phi)

    def wall(q):
        return np.exp(hardness * (compression - 1 + np.cos(phi) + q @ shape))

    def energy(q):
        return 0.5 * np.pi * np.sum((modes.omega * q) ** 2) + np.trapz(wall(q), phi)

    def slope(q):
        return np.pi * modes.omega**2 * q + hardness * np.trapz(wall(q) * shape, phi, axis=1)

    best = optimize.minimize(energy, np.zeros(len(modes)), jac=slope, method="BFGS", options={"gtol": 1e-9})
    force = hardness * np.trapz(wall(best.x), phi) / np.pi
    assert relaxed_force(0.33, compression, hardness, 5.0) == pytest.approx(force, rel=1e-5)


@pytest.mark.parametrize("hardness, compression", [(50.0, 0.2), (500.0, 0.03), (5000.0, 0.0)])
def test_relaxation_does_not_depend_on_the_nodes(hardness, compression):
    usual, finer = (relaxed_force(0.33, compression, hardness, 54.1, nodes) for nodes in (None, 400))
    assert usual == pytest.approx(finer, rel=1e-9)


def test_relaxation_tends_to_the_hard_wall_with_all_modes():
    for compression in (0.03, 0.1):
        exact = stoss.quasistatic.static_contact(poisson=0.33, compression=compression).force
        at = {a: [relaxed_force(0.33, compression + np.log(0.1 / a) / a, a, cutoff) for cutoff in (50.0, 100.0)]
              for a in (4000.0, 8000.0)}  # fmt: skip
        coarse, fine = 2 * np.array(at[8000.0]) - np.array(at[4000.0])
        assert coarse / exact - 1 > 1.5 * (fine / exact - 1) > 0  # like 1/cutoff, and fewer modes are stiffer
        assert (2 * fine - coarse) / exact == pytest.approx(1, abs=2e-3)


def test_the_printed_law_is_equation_56():
    for poisson in (-0.5, 0.33, 0.9):
        force = printed_law.force_by("printed", poisson, np.array([1e-6, 1e-3, 0.05]))
        assert force * (np.log(4 / force) - 1 - poisson) == pytest.approx([1e-6, 1e-3, 0.05], rel=1e-13)
    assert printed_law.force_by("center", 0.3, 0.01) == stoss.quasistatic.compression_force(poisson=0.3, compression=0.01)


def test_each_erratum_of_the_theory_names_tests_that_exist():
    errata = (ROOT / "docs/developer/derivations/errata.md").read_text(encoding="utf-8").split("\n## ")[1:]
    assert [entry.partition(" ")[0] for entry in errata] == "E1 E4 E5 E6 E7 E8 E9 E11 E12 E13".split()
    there = set()
    for path in (ROOT / "tests").rglob("test_*.*"):
        text = path.read_text(encoding="utf-8")
        there |= {".".join(names) for names in re.findall(r"^TEST(?:_[PF])?\((\w+), (\w+)\)", text, re.MULTILINE)}
        there |= {f"{path.name}::{name}" for name in re.findall(r"^def (test_\w+)", text, re.MULTILINE)}
    for erratum in errata:
        named = re.findall(r"`([\w./]+(?:\.|::)\w+)`", erratum.rpartition("\nTests: ")[2])
        assert named and set(named) <= there, (erratum.partition("\n")[0], set(named) - there)
