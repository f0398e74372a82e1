"""The numbers of docs/understand/findings/loss.md: those of its CSV file."""

import itertools
import math
import re
import runpy

import pytest
from conftest import ROOT, SUPERSCRIPTS, command, line, page, table, with_error

PAGE, WORDS = page("docs/understand/findings/loss.md")
CURVES = (0.0, 0.003, 0.01, 0.03, 0.1)
SPEEDS = 120
ROWS = table("docs/results/loss.csv")
SINGLE = ROWS[len(CURVES) * SPEEDS :]


def curve(loss_time):
    k = CURVES.index(loss_time)
    return ROWS[k * SPEEDS : (k + 1) * SPEEDS]


def turning_points(its):
    """Speeds of the extrema of 1 − ε², and by how many error bars the least of the steps between them stands out."""
    loss = [row["lost_fraction"] for row in its]
    found = [i for i in range(1, len(its) - 1) if (loss[i] - loss[i - 1]) * (loss[i + 1] - loss[i]) < 0]
    steps = [abs(loss[i] - loss[j]) / its[i]["lost_fraction_error"] for j, i in itertools.pairwise(found)]
    return [its[i]["speed"] for i in found], min(steps, default=math.inf)


def shown(speed):
    return f"10{str(round(math.log10(speed))).translate(SUPERSCRIPTS)}" if speed < 1e-3 else f"{speed:g}"


def laws():
    for row in SINGLE:
        yield line(f"{shown(row['speed'])}, {row['loss_time']:g}", with_error(row["restitution"], row["restitution_error"]),
                   f"{row['restitution_of_ting']:.7f}", f"{row['restitution_of_point_law']:.7f}")  # fmt: skip


def test_curves_are_what_the_page_says():
    assert [row["loss_time"] for row in ROWS[: len(CURVES) * SPEEDS]] == [eta for eta in CURVES for _ in range(SPEEDS)]
    for its in map(curve, CURVES):
        assert (its[0]["speed"], its[-1]["speed"]) == (1e-3, 0.2)
        assert all(a["speed"] < b["speed"] for a, b in itertools.pairwise(its))
        # Errors are written with two digits.
        assert all(row["lost_fraction_error"] <= 1.05 * 3e-4 * row["lost_fraction"] for row in its)
    assert f"{len(CURVES) * SPEEDS} impacts" in PAGE


def test_turning_points_are_those_of_the_page_and_no_noise():
    for eta, count in zip(CURVES, (10, 10, 2, 0, 0)):
        found, step = turning_points(curve(eta))
        assert len(found) == count and step > 15
    assert "10, 10, 2, 0 and 0 turning points" in WORDS


def test_the_wave_dies_out_as_the_page_says():
    pytest.importorskip("matplotlib")
    wave = runpy.run_path(str(ROOT / "studies/loss/figure.py"))["wave"]
    import numpy as np

    for eta, (found, _) in ((eta, turning_points(curve(eta))) for eta in CURVES):
        its = curve(eta)
        rest = wave(*(np.array([row[name] for row in its]) for name in ("speed", "lost_fraction")))
        heat = [row["dissipated"] / row["lost_fraction"] for row in (its[0], its[-1])]
        cells = (f"{eta:g}", len(found), f"{np.sqrt(np.mean(rest**2)):.3f}", f"{heat[0]:.3f} … {heat[1]:.3f}")
        assert line(*cells) in PAGE.splitlines(), line(*cells)


@pytest.mark.parametrize("expected", laws())
def test_laws(expected):
    assert expected in PAGE.splitlines(), expected


def test_slow_balls_are_stiffer_than_hertz():
    speeds = (1e-6, 1e-3)  # of four
    job = "restitution --body sphere --poisson 0.3 --absolute 0 --quiet --speed " + ",".join(map(str, speeds))
    lossy, elastic = command(f"{job} --tolerance 1e-4 --loss-time 0.01"), command(job)
    _, theory = page("docs/developer/derivations/loss.md")
    said = re.search(r"exceeds it by (.*?) % at .*? errors of (\S+) %", theory)
    values = [float(each) for each in re.findall(r"\d\.\d", said[1])][::3]
    first, second = 0.8 * 1.25**0.6 * math.gamma(0.6) * math.gamma(1.5) / math.gamma(2.1), 1.08872
    assert f"{first:.5f}" in theory and f"-{second} " in theory
    for speed, a, b, value in zip(speeds, lossy, elastic, values):
        x = 1.5 * 0.01 * (4 / 3 / (1 - 0.3**2) / (4 * math.pi / 3)) ** 0.4 * speed**0.2
        excess = (b["restitution"] - a["restitution"]) / (first * x - second * x**2) - 1
        assert abs(100 * excess - value) < float(said[2])
