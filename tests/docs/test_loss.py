"""The numbers of docs/results/loss.md: those of its CSV file."""

import csv
import itertools
import math
import re
import runpy
from pathlib import Path

import pytest
from conftest import command

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs/results/loss.md").read_text(encoding="utf-8")
TABLE = ROOT / "docs/results/loss.csv"
CURVES = (0.0, 0.003, 0.01, 0.03, 0.1)
SPEEDS = 120
DIGITS = "⁰¹²³⁴⁵⁶⁷⁸⁹"


def rows():
    with open(TABLE, encoding="utf-8") as file:
        table = csv.DictReader(line for line in file if not line.startswith("#"))
        return [{key.partition("[")[0]: float(text) for key, text in row.items() if key != "converged"}
                for row in table]  # fmt: skip


ROWS = rows()
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


def digits(value, error):
    """0.9720953(68), the error in units of the last digits."""
    places = 1 - math.floor(math.log10(error))
    return f"{value:.{places}f}({error * 10**places:.0f})"


def line(*cells):
    return f"| {' | '.join(map(str, cells))} |"


def shown(speed):
    exponent = round(math.log10(speed))
    return f"10⁻{DIGITS[-exponent]}" if speed < 1e-3 else f"{speed:g}"


def laws():
    for row in SINGLE:
        yield line(f"{shown(row['speed'])}, {row['loss_time']:g}", digits(row["restitution"], row["restitution_error"]),
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
    assert "10, 10, 2, 0 and 0 turning points" in " ".join(PAGE.split())


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


# An independent program's values (its own modes, step and contact points) and Ting's law: docs/theory/loss.md.
@pytest.mark.parametrize(
    "speed, loss_time, known, ting, point",
    [
        (1e-8, 1, 0.9720963, 0.9721023, 0.9719554),
        (1e-8, 3, 0.9199665, 0.9199828, 0.9188992),
        (1e-6, 10, 0.5530874, 0.5534955, 0.5337549),
        (0.01, 0.1, 0.95074, None, None),
        (0.01, 0.3, 0.86565, None, None),
        (0.01, 1, 0.64929, None, None),
    ],
)
def test_values_agree_with_an_independent_program(speed, loss_time, known, ting, point):
    (row,) = (row for row in SINGLE if (row["speed"], row["loss_time"]) == (speed, loss_time))
    assert abs(row["restitution"] - known) <= row["restitution_error"] + (5e-6 if ting is None else 1e-7)
    if ting is not None:
        assert row["restitution_of_ting"] == pytest.approx(ting, abs=6e-8)
        assert row["restitution_of_point_law"] == pytest.approx(point, abs=6e-8)


def test_slow_balls_are_stiffer_than_hertz():
    speeds = (1e-6, 1e-5, 1e-4, 1e-3)
    job = "restitution --body sphere --poisson 0.3 --absolute 0 --quiet --speed " + ",".join(map(str, speeds))
    lossy, elastic = command(f"{job} --tolerance 1e-4 --loss-time 0.01"), command(job)
    theory = " ".join((ROOT / "docs/theory/loss.md").read_text(encoding="utf-8").split())
    said = re.search(r"exceeds it by (.*?) % at .*? errors of (\S+) %", theory)
    values = [float(each) for each in re.findall(r"\d\.\d", said[1])]
    assert len(values) == len(speeds)
    first, second = 0.8 * 1.25**0.6 * math.gamma(0.6) * math.gamma(1.5) / math.gamma(2.1), 1.08872
    assert f"{first:.5f}" in theory and f"-{second} " in theory
    for speed, a, b, value in zip(speeds, lossy, elastic, values):
        x = 1.5 * 0.01 * (4 / 3 / (1 - 0.3**2) / (4 * math.pi / 3)) ** 0.4 * speed**0.2
        excess = (b["restitution"] - a["restitution"]) / (first * x - second * x**2) - 1
        assert abs(100 * excess - value) < float(said[2])
