"""The numbers of docs/understand/findings/spheres.md: those of its CSV file, and those of the command that it names."""

import itertools
import math

import pytest
from conftest import SUPERSCRIPTS, command, line, page, sampled, table, with_error

PAGE, WORDS = page("docs/understand/findings/spheres.md")
POISSON = (0.0, 0.2, 0.3, 0.45, 0.49)
SLOW = 1e-3  # up to where the wave is measured
ROWS = {nu: list(group) for nu, group in itertools.groupby(table("docs/results/spheres.csv"), lambda row: row["poisson"])}


def within(nu, low, high):
    return [row for row in ROWS[nu] if low * (1 - 1e-9) <= row["speed"] < high]


def over_speed(row, name="lost_fraction"):
    return row[name] / row["speed"]


def mean(rows, value):
    """Mean over v^(-1/5), in which the wave is even."""
    steps = [(a["speed"] ** -0.2 - b["speed"] ** -0.2, a, b) for a, b in itertools.pairwise(rows)]
    return sum(step * 0.5 * (value(a) + value(b)) for step, a, b in steps) / sum(step for step, _, _ in steps)


def share_of_quadrupole(rows):
    """Share of (2,0) in the mean loss."""
    return mean(rows, lambda row: row["quadrupole_share_of_loss"] * over_speed(row)) / mean(rows, over_speed)


def turning_points(rows):
    """Speeds of the extrema of 1 − ε², and by how many error bars the least of them stands out."""
    loss = [row["lost_fraction"] for row in rows]
    found = [i for i in range(1, len(rows) - 1) if (loss[i] - loss[i - 1]) * (loss[i + 1] - loss[i]) < 0]
    heights = [abs(loss[i] - loss[j]) / rows[i]["lost_fraction_error"] for j, i in itertools.pairwise(found)]
    return [rows[i]["speed"] for i in found], min(heights)


def deviations(nu, low, name="quasistatic_lost_fraction"):
    """Root mean square and maximum of the relative deviation of an estimate in a decade, in per cent."""
    ratios = [row[name] / row["lost_fraction"] - 1 for row in within(nu, low, 10 * low) if row[name] != ""]
    return 100 * math.sqrt(sum(x * x for x in ratios) / len(ratios)), 100 * max(map(abs, ratios))


def digits(value, error):
    """0.00278(2)·10⁻⁷, the error in units of the last digits."""
    exponent = math.floor(math.log10(value)) if value < 0.01 else 0
    power = f"·10{str(exponent).translate(SUPERSCRIPTS)}" if exponent else ""
    return with_error(value / 10.0**exponent, error / 10.0**exponent) + power


def waves():
    """A line for each Poisson's ratio: the factor, the swing, the share of (2,0), how often it turns."""
    for nu, rows in ROWS.items():
        slow = within(nu, 0.0, SLOW)
        factor = rows[0]["mean_loss_factor"]
        share = share_of_quadrupole(slow)
        least, most = min(map(over_speed, slow)), max(map(over_speed, slow))
        found = len(turning_points(rows)[0])
        periods = rows[0]["contact_time_over_quadrupole_period"] - rows[-1]["contact_time_over_quadrupole_period"]
        yield line(f"{nu:g}", f"{factor:.4f}", f"{mean(slow, over_speed):.4f}", f"{least:.3f} … {most:.3f}",
                   f"{2 * factor:.3f}", f"{rows[0]['mean_loss_factor_of_quadrupole'] / factor:.3f}",
                   f"{share:.3f}", found, f"{periods:.1f}")  # fmt: skip


def decade(low):
    return f"10{str(round(math.log10(low))).translate(SUPERSCRIPTS)}"


def test_all_values_are_converged_and_their_bars_small_beside_the_wave():
    assert tuple(ROWS) == POISSON
    assert all(row["converged"] == "true" for rows in ROWS.values() for row in rows)
    assert f"{sum(map(len, ROWS.values()))} impacts" in PAGE
    for rows in ROWS.values():
        assert rows[0]["speed"] == 1e-6 and rows[-1]["speed"] == 0.5
        assert max(row["lost_fraction_error"] / row["lost_fraction"] for row in rows) < 1.05e-3


def test_table_is_that_of_the_file():
    assert all(expected in PAGE.splitlines() for expected in waves())


def test_how_well_the_estimate_agrees():
    slow, fast = ([deviations(nu, low)[0] for nu in POISSON] for low in (1e-6, 1e-3))
    assert f"agree to {min(slow):.1f} to {max(slow):.1f} % (root mean square)" in WORDS
    assert f"to {min(fast):.1f} to {max(fast):.0f} % between" in WORDS
    name = "lost_fraction_of_ends_without_phase"
    ratios = [row[name] / row["lost_fraction"] for nu in POISSON for row in within(nu, 1e-6, 1e-2) if row[name] != ""]
    assert f"wrong by up to a factor of {max(*ratios, *(1 / each for each in ratios)):.1f}" in WORDS
    turns = [len(turning_points(rows)[0]) for rows in ROWS.values()]
    assert f"there are {min(turns)} to {max(turns)}" in WORDS


def test_mean_loss_and_its_share_of_the_quadrupole_are_those_of_the_theory():
    for nu, rows in ROWS.items():
        slow, factor = within(nu, 0.0, SLOW), rows[0]["mean_loss_factor"]
        assert mean(slow, over_speed) == pytest.approx(factor, rel=0.01)
        expected = rows[0]["mean_loss_factor_of_quadrupole"] / factor
        assert share_of_quadrupole(slow) == pytest.approx(expected, rel=0.015)


def test_loss_is_below_twice_its_mean_and_turning_points_are_no_noise():
    for nu, rows in ROWS.items():
        assert max(map(over_speed, within(nu, 0.0, 1e-2))) < 2 * rows[0]["mean_loss_factor"]
    least = min(turning_points(rows)[1] for rows in ROWS.values())
    assert f"by {least:.1f} error bars" in WORDS


def test_estimate_is_within_its_own_error_below_a_hundredth():
    for nu in POISSON:
        for row in within(nu, 0.0, 1e-2):
            error = row["quasistatic_error"] + row["lost_fraction_error"]
            assert abs(row["quasistatic_lost_fraction"] - row["lost_fraction"]) < error


def test_disk_beside_the_sphere():
    disk = {row["speed"]: row for row in table("docs/results/restitution.csv") if row["poisson"] == 0.33}
    sphere = ROWS[0.3][0]
    for row in (disk[1e-6], sphere):
        assert f"{row['contact_time']:.1f} R/c" in WORDS
    assert f"still loses {100 * disk[1e-6]['lost_fraction']:.2f} %" in WORDS
    factor = round(disk[1e-6]["lost_fraction"] / sphere["lost_fraction"], -3)
    assert f"{factor:,.0f} times".replace(",", " ") in WORDS


VALUES = ("1e-6", "1e-4", "0.001", "0.01", "0.1", "0.3")


@pytest.mark.parametrize("speed", sampled(VALUES))
def test_values_are_those_of_the_command(speed):
    poisson = ",".join(f"{nu:g}" for nu in POISSON)
    found = command(f"restitution --body sphere --absolute 0 --quiet --poisson {poisson} --speed {speed}")
    label = decade(float(speed)) if speed.startswith("1e") else speed
    cells = (digits(row["lost_fraction"], row["lost_fraction_error"]) for row in found)
    assert line(label, *cells) in PAGE.splitlines()
    for each in found:
        same = [row for row in ROWS[each["poisson"]] if row["speed"] == each["speed"]]
        assert all(row["lost_fraction"] == pytest.approx(each["lost_fraction"], rel=1e-5) for row in same)


def test_rayleigh_spoke_of_the_fundamental_mode():
    factors = [rows[0]["mean_loss_factor_of_quadrupole"] for rows in ROWS.values()]
    assert f"takes {25 * min(factors):.1f} to {25 * max(factors):.1f} times as much" in WORDS
    whole = [rows[0]["mean_loss_factor"] for rows in ROWS.values()]
    assert f"c(ν) is {min(whole):.2f} to {max(whole):.2f}" in WORDS
    assert (round(25 * min(whole)), round(25 * max(whole))) == (4, 8)
