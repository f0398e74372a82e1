"""The numbers of docs/understand/findings/vibration.md: those of its CSV files."""

import math
import statistics

import pytest
from conftest import line, page
from conftest import table as table_of

PAGE, WORDS = page("docs/understand/findings/vibration.md")
POWERS = {1e-4: "10⁻⁴", 1e-3: "10⁻³"}
CASES = [("sphere", 0.001), ("sphere", 0.01), ("sphere", 0.1), ("disk", 0.01), ("disk", 0.1)]
MODES = 18  # of the disk that bounces


def table(name):
    return table_of(f"docs/results/vibration/{name}.csv")


def having(rows, **values):
    return [row for row in rows if all(row[name] == value for name, value in values.items())]


def ratio(row):
    return row["amplitude"] / row["amplitude_from_share"]


def amplitudes():
    for body, speed in CASES:
        its = having(table("modes"), body=body, speed=speed)
        (first,) = having(its, order=2, index=0)
        ratios = [ratio(row) for row in its]
        taken = sum(row["amplitude_from_share"] ** 2 for row in its)
        phase = f"{first['phase_of_slow_theory']:.2f}" if body == "sphere" else "–"
        yield line(body, f"{speed:g}", f"{first['amplitude']:.5f}", f"{ratio(first):.4f}",
                   f"{min(ratios):.2f} … {max(ratios):.2f}",
                   f"{sum(row['amplitude'] ** 2 for row in its) / taken:.3f}",
                   f"{first['phase']:.2f}", phase)  # fmt: skip


def spreads():
    for row in table("temperatures"):
        temperature = POWERS.get(row["temperature"], f"{row['temperature']:g}")
        places = 1 - math.floor(math.log10(row["mean_statistical_error"]))
        error = row["mean_statistical_error"] * 10**places
        yield line(row["body"], temperature, f"{row['mean']:.{places}f}({error:.0f})",
                   f"{row['standard_deviation']:.2e}", f"{row['law']:.2e}",
                   f"{row['least']:.3f} … {row['greatest']:.3f}", f"{row['share_above_one']:.2f}")  # fmt: skip


def gains():
    rows = table("heat")
    for sphere, disk in zip(having(rows, body="sphere"), having(rows, body="disk")):
        cells = []
        for row in (sphere, disk):
            cells.append(f"{row['gain']:+.3f} ± {row['gain_error']:.3f}".replace("-", "−"))
            fluctuation = row["fluctuation"] != ""
            cells.append(f"{row['fluctuation']:.3f} ± {row['fluctuation_error']:.3f}" if fluctuation else "–")
        yield line(f"{sphere['ratio']:g}", *cells)


def slope(rows):
    """Of log E against log t at late times, by least squares."""
    points = [(math.log(row["time"]), math.log(row["translation"])) for row in rows if row["time"] > 1e6]
    return statistics.linear_regression(*zip(*points)).slope


@pytest.mark.parametrize("lines, count", [(amplitudes, 4), (spreads, 4), (gains, 3)])
def test_table_is_that_of_the_file(lines, count):
    assert sum(expected in PAGE.splitlines() for expected in lines()) == count


def test_all_is_converged():
    assert all(row["converged"] == "true" for row in table("phases"))
    assert all(row["not_converged"] == 0 for row in table("temperatures"))


def test_a_small_energy_gives_the_sinusoid_and_a_large_one_less():
    for body in ("sphere", "disk"):
        for energy, least, most in ((0.01, 0.0, 0.1), (1.0, 0.1, 0.6)):
            its = having(table("phases"), body=body, energy=energy)
            middle = statistics.mean(row["sinusoid"] for row in its)
            height = max(row["sinusoid"] for row in its) - middle
            off = max(abs(row["restitution"] - row["sinusoid"]) for row in its) / height
            assert least < off < most, (body, energy, off)
            assert f"{100 * off:.0f} %" in WORDS
        greatest = max(row["restitution"] for row in having(table("phases"), body=body))
        assert greatest > 1 and f"{greatest:.3f}" in WORDS


def test_a_slow_sphere_takes_and_gives_by_one_amplitude():
    its = having(table("modes"), body="sphere", speed=0.001)
    assert all(abs(ratio(row) - 1) < 0.03 for row in its)
    (first,) = having(its, order=2)
    assert abs(ratio(first) - 1) < 1e-3


def test_spread_follows_the_root_of_the_temperature():
    rows = table("temperatures")
    for row in having(rows, body="sphere"):
        if row["temperature"] <= 0.01:  # 400 samples: 3.5 %
            assert row["standard_deviation"] == pytest.approx(row["law"], rel=0.05)
    for row in having(rows, body="disk"):
        if row["temperature"] <= 0.01:
            assert row["standard_deviation"] == pytest.approx(0.9 * row["law"], rel=0.05)


def test_energy_flows_from_hot_to_cold_and_not_at_equal_temperature():
    for row in table("heat"):
        error = 3 * row["gain_error"]
        if row["ratio"] == 1.0:
            assert abs(row["gain"]) < error
        elif abs(row["ratio"] - 1.0) > 0.3:
            assert row["gain"] * (row["ratio"] - 1.0) > 0
        if row["fluctuation"] != "":
            assert abs(row["fluctuation"] - 1.0) <= 3 * row["fluctuation_error"] + 1e-9


def test_bounces_share_the_energy_alike():
    *modes, translation = table("equipartition")
    assert len(modes) == MODES and translation["order"] == "translation"
    assert sum(row["mean_share"] for row in (*modes, translation)) == pytest.approx(1, abs=3e-3)
    for row in (*modes, translation):
        assert abs(row["mean_share"] - 1 / (MODES + 1)) < 4 * row["error"]  # of eight sequences
    assert f"{translation['mean_share']:.4f} ± {translation['error']:.4f}" in WORDS
    shares = [row["mean_share"] for row in modes]
    assert f"{min(shares):.3f} to {max(shares):.3f}" in WORDS
    whole = sum(row["impacts"] for row in table("shares"))
    assert whole == 8 * 4000
    beyond = sum(row["impacts"] for row in table("shares") if row["from"] >= 0.1) / whole
    assert beyond == pytest.approx(0.9**MODES, abs=0.03)
    assert f"{beyond:.2f} of the impacts have more than a tenth" in WORDS


def test_damped_bounces_slow_down():
    (its,) = having(table("bounces"), number=200.0)
    assert max(its["complete_damping"], its["partial_damping"]) < 1e-2 < its["no_damping"]


def test_chain_cools_with_the_square_of_the_time():
    rows = table("chain")
    for damping in ("complete", "partial"):
        found = slope(having(rows, damping=damping))
        assert found == pytest.approx(-2, abs=0.15) and f"{found:.2f}".replace("-", "−") in WORDS
    none = having(rows, damping="none")
    late = [row["translation"] for row in none if row["collisions"] > 2000]
    mean = statistics.mean(late)
    expected = 19.5 / (19.5 + 20 * 50 + 20 * 55)
    assert mean == pytest.approx(expected, rel=0.3)
    assert all(row["translation"] + row["vibration"] == pytest.approx(1, abs=1e-4) for row in none)


def test_restitution_in_the_chain():
    rows = table("chain_restitution")
    for damping in ("none", "partial", "complete"):
        its = having(rows, damping=damping)[0]
        cells = f"{its['mean']:.3f} ± {its['standard_deviation']:.3f}"
        assert cells in WORDS, cells
