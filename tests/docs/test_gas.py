"""The numbers of docs/understand/findings/gas.md: those of its CSV file and of the command."""

import itertools
import math
import re

import pytest
from conftest import ROOT, command, line, page, power, table

PAGE, WORDS = page("docs/understand/findings/gas.md")
FILE = "docs/results/gas.csv"
NAMES = {"constant": "constant ε", "power": "1 − ε ∝ $v^{1/5}$", "stoss": "stoss"}
ROWS = {law: [row for row in table(FILE) if row["law"] == law] for law in NAMES}
END = 3e-4  # of the energy


def when(law, share, name="time"):
    """Time, or another column, when so much of the energy is left: between rows its logarithm is linear in theirs."""
    for a, b in itertools.pairwise(ROWS[law]):
        if b["energy"] <= share:
            part = math.log(a["energy"] / share) / math.log(a["energy"] / b["energy"])
            return a[name] ** (1 - part) * b[name] ** part
    raise AssertionError(law)


def over_homogeneous(law, exponent):
    """Energy over that of the homogeneous gas, whose τ follows from where half is left."""
    half = next(row for row in ROWS[law] if row["energy"] < 0.5)
    tau = half["time"] / (half["energy"] ** (-1 / exponent) - 1)
    return [row["energy"] * (1 + row["time"] / tau) ** exponent for row in ROWS[law]]


def obeys_for(law, exponent, within):
    """Collisions of a disk until the energy leaves the law of the homogeneous gas."""
    ratios = over_homogeneous(law, exponent)
    return next(before["collisions"] for before, after, ratio in zip(ROWS[law], ROWS[law][1:], ratios[1:])
                if abs(ratio - 1) > within)  # fmt: skip


def slope(time):
    """−d ln E/d ln t of the gas with ε of stoss."""
    rows = ROWS["stoss"]
    k = min(range(3, len(rows) - 3), key=lambda k: abs(math.log(rows[k]["time"] / time)))
    before, after = rows[k - 3], rows[k + 3]
    return math.log(before["energy"] / after["energy"]) / math.log(after["time"] / before["time"])


@pytest.mark.parametrize("law", NAMES)
def test_times(law):
    times = [power(when(law, share), 2) for share in (0.1, 0.01, 1e-3, END)]
    assert line(NAMES[law], *times, f"{when(law, END, 'collisions'):.0f}") in PAGE


def test_laws_take_the_same():
    constant, factor = re.search(r"restitution ([\d.]+), power: 1 - ([\d.]+)", (ROOT / FILE).read_text()).groups()
    assert f"ε = {float(constant):.5f};" in WORDS and f"= {float(factor):.5f} (v/c)^{{1/5}}$" in WORDS
    assert f"remove {1 - float(constant) ** 2:.2f} of the energy of the motion along the line of centres:" in WORDS


def test_the_homogeneous_gas():
    for law, exponent, within in (("constant", 2, 0.02), ("constant", 2, 0.1), ("power", 5 / 3, 0.05)):
        assert f"to {100 * within:.0f} % for {obeys_for(law, exponent, within):.0f}" in WORDS
    constant, by_power = over_homogeneous("constant", 2)[-1], over_homogeneous("power", 5 / 3)[-1]
    assert f"at the end {constant:.1f} times what Haff's law leaves, with the power law {by_power:.1f} times" in WORDS


def test_clusters():
    first, last = (ROWS["constant"][k]["fluctuation"] for k in (0, -1))
    assert f"from {first:.2f} to {last:.1f} times" in WORDS
    at_end = {law: when(law, END, "fluctuation") for law in NAMES}
    said = f"{at_end['constant']:.1f} with constant ε, {at_end['power']:.1f} with the power law and"
    assert f"{said} {at_end['stoss']:.2f} with ε of stoss" in WORDS


def test_slope():
    steepest = max(slope(row["time"]) for row in ROWS["stoss"])
    assert f"from {slope(3e3):.2f} at 3·10³ to {slope(3e4):.2f} at 3·10⁴ R/c" in WORDS
    assert f"gather, to {slope(3e5):.2f} at 3·10⁵" in WORDS and steepest - slope(3e4) < 0.02


def test_loss_of_slow_disks():
    fast, slow = command("restitution --body disk --poisson 0.33 --against disk,radius=2 --speed 0.1,1e-3")
    said = f"from {fast['lost_fraction']:.3f} at v = 0.1 c to {slow['lost_fraction']:.3f} at 10⁻³"
    assert said in WORDS
