"""The numbers of Rayleigh's estimate in docs/developer/derivations/quasistatic.md: those of the command and of the results."""

import json
import os
import subprocess

import pytest
from conftest import command, line, page, table

PAGE, WORDS = page("docs/developer/derivations/quasistatic.md")
SPEEDS = (1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 0.001, 0.003, 0.01, 0.02, 0.03, 0.1)
ALL = ",".join(map(str, SPEEDS))


def quadrupole(arguments):
    """Energy after an impact in the mode (2,0)."""
    words = [os.environ["STOSS"], *arguments.split(), *"--body disk --poisson 0.33".split(), "--format", "json", "--quiet"]
    found = json.loads(subprocess.run(words, capture_output=True, text=True, check=True, timeout=120).stdout)
    return next(mode["after"] for mode in found["modes"] if (mode["order"], mode["index"]) == (2, 0))


@pytest.fixture(scope="module")
def computed():
    return (command(f"restitution --body disk --poisson 0.33 --speed {ALL} --tolerance 1e-4 --absolute 0"),
            command(f"quasistatic --body disk --poisson 0.33 --speed {ALL} --quiet"))  # fmt: skip


@pytest.mark.parametrize("k", range(len(SPEEDS)), ids=map(str, SPEEDS))
def test_estimate(computed, k):
    speed, found, slow = SPEEDS[k], *(rows[k] for rows in computed)
    impact, estimate = (quadrupole(f"{what} --speed {speed}") for what in ("impact --cutoff 60", "quasistatic"))
    cells = (f"{found['lost_fraction']:.5f}", f"{slow['lost_fraction']:.5f}", f"{slow['lost_fraction_error']:.4f}",
             f"{impact:.5f}", f"{estimate:.5f}", f"{found['contact_time']:.2f}", f"{slow['contact_time']:.2f}",
             f"{slow['kinetic_share']:.4f}")  # fmt: skip
    shown = f"{speed:g}" if speed > 1e-4 else f"$10^{{{round(-8 + SPEEDS.index(speed))}}}$"
    assert line(shown, *cells) in PAGE


def test_where_it_holds():
    rows = [row for row in table("docs/results/restitution.csv") if row["quasistatic_lost_fraction"] != ""]
    ratios = [row["quasistatic_lost_fraction"] / row["lost_fraction"] for row in rows]
    assert f"{min(ratios):.2f} to {max(ratios):.1f} times the full solution" in WORDS
    found = command("quasistatic --body disk --poisson 0.33 --speed 0.0235,0.024 --quiet")
    assert [row["beyond_perturbation"] for row in found] == ["false", "true"]
    assert "v = 0.024$ at $\\nu = 0.33" in WORDS.replace("$v", "v")
