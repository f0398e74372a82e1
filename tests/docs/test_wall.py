"""The numbers of docs/understand/findings/wall.md: those of its CSV file, and those of the command that it names."""

import itertools
import math

import pytest
from conftest import command, line, page, power, table, with_error

PAGE, WORDS = page("docs/understand/findings/wall.md")
POISSON = (0.0, 0.2, 0.33, 0.5, 0.9)
SPEEDS = (1e-6, 1e-4, 0.001, 0.01, 0.1, 0.3)
ROWS = {nu: sorted((row for row in table("docs/results/restitution.csv") if row["poisson"] == nu),
                   key=lambda row: row["speed"]) for nu in POISSON}  # fmt: skip
WAVY = POISSON[1:]  # where the first maximum is that of the quadrupole


def short(speed):
    return power(speed, 1).removeprefix("1·") if speed < 1e-3 else f"{speed:g}"


def near(nu, speed):
    return min(ROWS[nu], key=lambda row: abs(math.log(row["speed"] / speed)))


def parabola(three, name, at):
    """The parabola in ln v through three rows, at a value of ln v."""
    x, y = [math.log(row["speed"]) for row in three], [row[name] for row in three]
    slope = (y[1] - y[0]) / (x[1] - x[0])
    bend = ((y[2] - y[1]) / (x[2] - x[1]) - slope) / (x[2] - x[0])
    if at is None:
        return 0.5 * (x[0] + x[1]) - 0.5 * slope / bend
    return y[0] + (at - x[0]) * (slope + bend * (at - x[1]))


def extrema(nu):
    """Extrema of 1 − ε² from the fastest on."""
    found = []
    for three in itertools.pairwise(itertools.pairwise(ROWS[nu][::-1])):
        three = (*three[0], three[1][1])
        before, here, after = (row["lost_fraction"] for row in three)
        if (here - before) * (after - here) < 0:
            top = parabola(three, "lost_fraction", None)
            names = ("contact_time", "contact_time_over_quadrupole_period", "quadrupole_share_of_loss")
            its = {name: parabola(three, name, top) for name in ("lost_fraction", *names)}
            found.append(its | {"kind": "minimum" if here < before else "maximum", "speed": math.exp(top)})
    return found


EXTREMA = {nu: extrema(nu) for nu in POISSON}


@pytest.fixture(scope="module")
def computed():
    speeds = ",".join(map(str, SPEEDS))
    found = command(f"restitution --body disk --poisson {','.join(map(str, POISSON))} --speed {speeds} --tolerance 3e-4")
    return {(row["poisson"], row["speed"]): row for row in found}


def test_table_is_that_of_the_command(computed):
    for speed in SPEEDS:
        rows = [computed[nu, speed] for nu in POISSON]
        assert line(short(speed), *(with_error(row["restitution"], row["restitution_error"]) for row in rows)) in PAGE


def test_what_the_file_holds():
    assert {nu: len(rows) for nu, rows in ROWS.items()} == {nu: 155 if nu == 0.33 else 115 for nu in POISSON}
    assert "115 speeds from 10⁻⁶ to 0.5 c" in WORDS and "another 40 down to 10⁻⁸ for ν = 0.33" in WORDS
    (missed,) = [row for row in itertools.chain(*ROWS.values()) if row["converged"] != "true"]
    share = power(missed["lost_fraction_error"] / missed["lost_fraction"], 2)
    assert f"ν = {missed['poisson']:g}, v = {missed['speed']:.3f} ends at {share}" in WORDS


def test_extrema():
    for k, it in enumerate(EXTREMA[0.33]):
        speed = f"{it['speed']:.4f}" if it["speed"] > 1e-3 else power(it["speed"], 2)
        names = ("contact_time", "contact_time_over_quadrupole_period", "quadrupole_share_of_loss")
        cells = (f"{it['lost_fraction']:.4f}", *(f"{it[name]:.2f}" for name in names))
        assert f"{line('' if k else '0.33', it['kind'], speed, *cells)}\n".replace("|  |", "| |") in PAGE
    assert PAGE.count("| minimum |") + PAGE.count("| maximum |") == len(EXTREMA[0.33])


def among(values, digits):
    """The least and the maximum, as the page writes them."""
    return f"{min(values):.{digits}f} to {max(values):.{digits}f}"


def test_waves():
    first, second, third = ([EXTREMA[nu][k] for nu in WAVY] for k in range(3))
    assert f"v = {max(it['speed'] for it in first):.3f} to {min(it['speed'] for it in first):.3f} c" in WORDS
    rises = [100 * (b["lost_fraction"] / a["lost_fraction"] - 1) for a, b in zip(first, second)]
    falls = [a["lost_fraction"] / b["lost_fraction"] for a, b in zip(second, third)]
    assert f"rises again by {among(rises, 0)} %, falls by a factor of {among(falls, 1)}" in WORDS

    def over_period(found):
        return [it["contact_time_over_quadrupole_period"] for it in found]

    assert f"is at {among(over_period(second), 2)} periods of the quadrupole mode for every ν ≥ 0.2" in WORDS
    speeds = [it["speed"] for it in second]
    assert f"factor of {max(speeds) / min(speeds):.0f}" in WORDS
    assert f"at {among(over_period(first), 2)} and {among(over_period(third), 2)} periods" in WORDS


def test_the_way_to_one():
    times = [near(0.33, speed)["contact_time"] for speed in (1e-3, 1e-6, 1e-8)]
    assert "9.0 R/c at v = 10⁻³, 12.2 at 10⁻⁶ and 14.0 at 10⁻⁸" in WORDS
    assert [f"{time:.1f}" for time in times] == ["9.0", "12.2", "14.0"]
    assert "8.3, 11.7 and 13.5" in WORDS
    assert [f"{math.pi * math.sqrt(math.log(1 / v)):.1f}" for v in (1e-3, 1e-6, 1e-8)] == ["8.3", "11.7", "13.5"]
    first, slow = EXTREMA[0.33][1], near(0.33, 1e-6)
    name = "contact_time_over_quadrupole_period"
    assert f"τ/T₂₀ = {first[name]:.2f} ({first['lost_fraction']:.4f} for ν = 0.33)" in WORDS
    assert f"{slow[name]:.1f} ({slow['lost_fraction']:.4f} at v = 10⁻⁶)" in WORDS
    by_law = (slow[name] / first[name]) ** 4
    assert f"factor of {by_law:.1f}, the computation {first['lost_fraction'] / slow['lost_fraction']:.1f}" in WORDS
    slowest = ROWS[0.33][0]
    assert f"1 − ε² = {slowest['lost_fraction']:.6f}({1e6 * slowest['lost_fraction_error']:.0f}) for ν = 0.33" in WORDS


def estimated(nu):
    return [row for row in ROWS[nu] if row["quasistatic_lost_fraction"] != ""]


def test_quasistatic_estimate():
    for speed in (1e-8, 1e-6, 1.1e-4, 0.0032, 0.018):
        row = near(0.33, speed)
        shown = f"{speed:g}" if speed > 1e-3 else short(speed) if speed != 1.1e-4 else power(speed, 2)
        found = [f"{row[name]:.{digits}f}" for name, digits in (
            ("contact_time", 2), ("quasistatic_contact_time", 2), ("lost_fraction", 5 if speed < 1e-3 else 4),
            ("quasistatic_lost_fraction", 5 if speed < 1e-3 else 4))]  # fmt: skip
        assert line(shown, *found) in PAGE

    def off(nu):
        ratios = [row["quasistatic_lost_fraction"] / row["lost_fraction"] for row in estimated(nu)]
        return max(*ratios, *(1 / each for each in ratios))

    assert f"by up to a factor of {off(0.33):.1f} at ν = 0.33 and {max(map(off, POISSON)):.1f} overall" in WORDS
    short_by = [100 * (1 - row["quasistatic_contact_time"] / row["contact_time"])
                for row in (ROWS[0.33][0], near(0.33, 0.018))]  # fmt: skip
    assert f"right to {short_by[0]:.1f} % at 10⁻⁸ and to {short_by[1]:.1f} % at 0.018" in WORDS


def test_where_the_estimate_ends():
    for nu, said in ((0.0, 0.033), (0.33, 0.024), (0.9, 0.008)):
        last, after = estimated(nu)[-1], next(row for row in ROWS[nu] if row["speed"] > estimated(nu)[-1]["speed"])
        assert last["speed"] < said < after["speed"] and f"{said:g} (ν = {nu:g})" in WORDS
