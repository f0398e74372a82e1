"""The numbers of docs/results/oblique.md: those of its CSV files."""

import functools
import math
import runpy
import statistics

import pytest
from conftest import ROOT, line, page
from conftest import table as table_of

PAGE, WORDS = page("docs/results/oblique.md")
XS = (0.2, 0.5, 1, 2, 3, 4, 5, 6)
SUPERSCRIPTS = {1e-6: "10⁻⁶", 1e-5: "10⁻⁵", 1e-4: "10⁻⁴"}


def table(name):
    return table_of(f"docs/results/oblique/{name}.csv")


def having(rows, **values):
    return [row for row in rows if all(row[name] == value for name, value in values.items())]


def one(rows, **values):
    (row,) = having(rows, **values)
    return row


def signed(value, places=3):
    """With a minus sign that is one."""
    return f"{value:.{places}f}".replace("-", "−")


def written(speed):
    return SUPERSCRIPTS.get(speed, f"{speed:g}")


CURVES, SIZE, GLASS, DEM = table("curves"), table("size"), table("glass"), table("dem")
COUPLING, BEST, NORMAL = table("coupling"), table("superball"), table("normal")
FINITE_ELEMENTS, MEASURED = table("finite_elements"), table("measured")


@functools.cache
def curve(bodies, speed, friction=0.1):
    return {row["x"]: row for row in having(CURVES, bodies=bodies, speed=speed, friction=friction)}


def spheres():
    for name, bodies, speed in (
        ("Maw", "maw", 0.0), *((f"{written(v)}", "sphere", v) for v in (1e-6, 1e-4, 1e-3, 0.01, 0.1)),
        ("0.001, half-space", "half_space", 1e-3),
    ):  # fmt: skip
        its = curve(bodies, speed)
        yield line(name, *(signed(its[x]["tangential_restitution"]) for x in XS))


def disks():
    for speed in (1e-4, 0.01, 0.1):
        for name, its in (("equal", curve("equal_disks", speed)), ("μ = 0.3", curve("disk", speed, 0.3)),
                          ("μ = 0.1", curve("disk", speed))):  # fmt: skip
            cells = (signed(its[x]["tangential_restitution"]) for x in XS if x != 0.5)
            yield line(written(speed), name, *cells)


def size_law(against, poisson, psi):
    """A and B of (Maw − ψ₂)R/a = A + B ln(R/a), by least squares from 1e-6 to 1e-4 c."""
    its = [row for row in having(SIZE, against=against, poisson=poisson, psi1=psi) if row["speed"] < 1.1e-4]
    over = [math.log(1 / row["contact_radius"]) for row in its]
    less = [(row["maw"] - row["psi2"]) / row["contact_radius"] for row in its]
    fit = statistics.linear_regression(over, less)
    rest = max(abs(y - fit.intercept - fit.slope * x) for x, y in zip(over, less))
    return fit.intercept, fit.slope, rest


def size_laws():
    for name, against, poisson in (("0", "wall", 0.0), ("0.3", "wall", 0.3), ("0.45", "wall", 0.45),
                                   ("0.3, half-space", "half_space", 0.3)):  # fmt: skip
        laws = [size_law(against, poisson, psi) for psi in (0.5, 1.0, 2.0, 3.0)]
        yield line(name, *(f"{a:.2f} {'+' if b > 0 else '−'} {abs(b):.2f} L" for a, b, _ in laws))


DRAW = runpy.run_path(str(ROOT / "studies/oblique/figure.py"))["measured"]


def at(rows, angle, name):
    """A column of the ball on glass at an angle, between whole degrees by a line."""
    for low, high in zip(rows, rows[1:]):
        if low["angle"] <= angle <= high["angle"]:
            share = (angle - low["angle"]) / (high["angle"] - low["angle"])
            return (1 - share) * low[name] + share * high[name]
    raise ValueError(angle)


def measurements():
    for quantity, its in DRAW(ROOT / "docs/results/oblique").items():
        for angle, value in its:
            yield quantity, angle, value


def near_stick():
    names = {"et": "centre", "spin": "spin", "patch": "contact"}
    for quantity, angle, value in sorted(measurements(), key=lambda each: each[1]):
        if angle < 12:
            found, maw, rings, disks = (
                at(GLASS, angle, name)
                for name in ("tangential_restitution", "maw", "neglected_coupling", "added_by_coupling_of_disks")
            )
            cells = (signed(each, 2) for each in (value, found, maw, found + rings, found + disks))
            yield line(f"{angle:.1f}°", names[quantity], *cells)


def superballs():
    for poisson in (0.0, 0.2, 0.3, 0.4, 0.49):
        slow = one(BEST, bodies="maw", poisson=poisson)["tangential_restitution"]
        its = (one(BEST, bodies="sphere", poisson=poisson, speed=v) for v in (1e-4, 1e-3, 0.01, 0.03, 0.07, 0.1, 0.2))
        yield line(f"{poisson:g}", f"{slow:.3f}", *(f"{row['tangential_restitution']:.3f}" for row in its))


LAWS = {"history": "Mindlin spring", "rescale": "rescaled", "force": "in force", "rescale_force": "in force, rescaled",
        "linear_1": "Hooke, k_t = k_n", "linear_2/7": "2k_n/7, Hooke or Hertz"}  # fmt: skip
FASTER = (1e-6, 1e-3, 0.1)


def worst(law, speed):
    """The maximum error of ε_t for x of 0.2 and more, and where."""
    its = curve("sphere", speed)
    errors = {x: law[x] - row["tangential_restitution"] for x, row in its.items() if x >= 0.2}
    x = max(errors, key=lambda each: abs(errors[each]))
    return errors[x], x


def of_law(name):
    return {row["x"]: row["tangential_restitution"] for row in having(DEM, law=name)}


def walton(limit, speed=1e-6):
    return {x: min(limit, 3.5 * (1 + row["restitution"]) / x - 1) for x, row in curve("sphere", speed).items()}


def best_limit(speed):
    return min((0.005 * i for i in range(200)), key=lambda limit: abs(worst(walton(limit, speed), speed)[0]))


def codes():
    for name, law in (*((LAWS[key], of_law(key)) for key in LAWS), ("Walton, β₀ = 0.44", walton(0.44))):
        errors = (worst(law, speed) for speed in FASTER)
        yield line(name, *(signed(law[x], 2) for x in (0.2, 1, 2, 3, 4, 5)),
                   *(f"{signed(error, 2)} ({x:g})" for error, x in errors))  # fmt: skip


def linear():
    for row in having(FINITE_ELEMENTS, kinematics="linear"):
        along = row["tangential"] > 0
        yield line(f"{row['friction']:g}", f"{row['tangential']:g}", f"{row['finite_elements']:.5f}",
                   f"{row['restitution']:.5f}({1e5 * row['restitution_error']:.0f})",
                   signed(row["finite_elements_tangential"], 4) if along else "–",
                   f"{signed(row['tangential_restitution'], 4)}({1e4 * row['tangential_restitution_error']:.0f})"
                   if along else "–")  # fmt: skip


def turned():
    for row in having(FINITE_ELEMENTS, kinematics="turning"):
        turn = abs(row["spin_after"]) * row["contact_time"]
        error = math.ceil(1e3 * row["tangential_restitution_error"])
        yield line(f"{row['speed']:g}", f"{row['friction']:g}", f"{row['tangential']:g}", f"{turn:.2f}",
                   f"{row['finite_elements']:.4f}", f"{row['restitution']:.4f}",
                   f"{row['finite_elements_tangential']:.3f}",
                   f"{row['tangential_restitution']:.3f}({error})")  # fmt: skip


def couplings():
    ratios = (0.1, 0.2, 0.3, 0.5, 1.0, 2.0)
    for x in (0.25, 0.5, 1.0, 2.0, 3.0):
        cells = []
        for ratio in ratios:
            its = having(COUPLING, x=x, speed=0.003)
            added = [row["tangential_restitution"] - row["equal_disks"] for row in its
                     if math.isclose(row["friction"], ratio * row["beta"], rel_tol=1e-4)]  # fmt: skip
            cells.append(f"{signed(min(added), 2)} … {signed(max(added), 2)}")
        yield line(f"{x:g}", *cells)


TABLES = (spheres, disks, size_laws, near_stick, superballs, codes, linear, turned, couplings)


@pytest.mark.parametrize("lines", TABLES, ids=lambda lines: lines.__name__)
def test_table(lines):
    for each in lines():
        assert each in PAGE


def test_who_meets_the_tolerance():
    for rows in (CURVES, SIZE, GLASS, BEST):
        assert all(row["converged"] == "true" for row in rows)
    missed = [row for row in COUPLING + NORMAL if row["converged"] == "false"]
    assert f"{len(missed)} of fast disks there" in WORDS
    assert all(row["speed"] >= 0.05 for row in missed)


def test_claims_about_steel():
    row = one(SIZE, against="wall", poisson=0.3, psi1=1, speed=1e-3)
    assert f"has ε_t = {-row['psi2']:.2f}, Maw's curve {-row['maw']:.2f}" in WORDS


def test_claims_about_published_finite_elements():
    maw = [{"angle": x, **row} for x, row in sorted(curve("maw", 0.0).items())]
    found = [(row["at"], -row["value"] / row["at"]) for row in having(MEASURED, quantity="fem") if row["at"] < 8]
    off = {x: value - at(maw, x, "tangential_restitution") for x, value in found if x > 0.6}
    assert all(abs(each) < 0.02 for x, each in off.items() if 2 < x < 5)
    near = [each for x, each in off.items() if 0.8 < x < 1.25]
    assert len(near) == 2 and all(round(each, 2) in (0.12, 0.13) for each in near)


def test_claims_about_size():
    rest = max(size_law(*each, psi)[2] for each in (("wall", 0.0), ("wall", 0.3), ("wall", 0.45), ("half_space", 0.3))
               for psi in (0.5, 1.0, 2.0, 3.0))  # fmt: skip
    assert f"to within {rest:.2f}" in WORDS


def root_mean_square(values):
    return math.sqrt(sum(each * each for each in values) / len(values))


def test_claims_about_the_experiment():
    first = GLASS[0]["restitution"]
    loss = 100 * (1 - first**2)
    assert f"stoss gives {first:.4f} for the central impact: the waves in the glass take {loss:.1f} %" in WORDS
    assert f"some {100 * loss / (100 * (1 - 0.98**2)):.0f} % of the measured loss" in WORDS
    near, far = (at(GLASS, angle, "neglected_coupling") for angle in (2, 10))
    most = max(abs(row["neglected_coupling"]) for row in GLASS if row["angle"] >= 12)
    assert f"{near:.2f} at 2°, {far:.2f} at 10°, at most {most:.2f} from 12° on" in WORDS
    off = {}
    for quantity, name in (("et", "tangential_of_center"), ("spin", "spin"), ("patch", "angle_of_patch")):
        its = [row for row in having(MEASURED, quantity=quantity) if row["at"] > 15]
        off[quantity] = [row["value"] - at(GLASS, row["at"], name) for row in its]
    said = f"v_t′/v_t to {root_mean_square(off['et']):.3f} (root mean square of {len(off['et'])} points"
    assert said in WORDS
    spin, patch = off["spin"], off["patch"]
    assert f"the spin to {root_mean_square(spin):.0f} rad/s of up to 612 ({len(spin)} points)" in WORDS
    said = f"rebounds to {root_mean_square(patch):.1f}° ({len(patch)} points, {statistics.fmean(patch):.1f}° above"
    assert said in WORDS


def test_claims_about_superballs():
    best = max(having(BEST, bodies="sphere"), key=lambda row: row["tangential_restitution"])
    said = f"is {best['tangential_restitution']:.2f}, at ν = {best['poisson']:g}, v = {best['speed']:g} c"
    assert f"{said} and x = {best['x']:.1f}" in WORDS
    disk = max(row["tangential_restitution"] for row in having(BEST, bodies="equal_disks"))
    assert f"Two equal disks reach {disk:.2f}" in WORDS
    assert all(row["tangential_restitution"] < 0.6 for row in having(BEST, bodies="maw"))


def test_claims_about_codes():
    limits = [best_limit(speed) for speed in FASTER]
    errors = [abs(worst(walton(limit, speed), speed)[0]) for limit, speed in zip(limits, FASTER)]
    said = "The best β₀ is {:.2f} at 10⁻⁶ c, {:.2f} at 0.001 c and {:.2f} at 0.1 c".format(*limits)
    assert f"{said}, with errors of " + "{:.2f}, {:.2f} and {:.2f}".format(*errors) in WORDS
    superball = of_law("linear_2/7")
    assert all(value == pytest.approx(1, abs=1e-3) for x, value in superball.items() if x < 3.45)
    assert all(of_law("history_2/7")[x] == pytest.approx(value, abs=1e-3) for x, value in superball.items())
    slow = curve("sphere", 1e-6)
    for name in ("history", "rescale", "force", "rescale_force", "linear_1"):
        law = of_law(name)
        assert all(abs(law[x] - slow[x]["tangential_restitution"]) < 0.16 for x in law if x > 2.95)


def test_claims_about_coupling():
    assert f"{len(COUPLING)} impacts, ν = 0, 0.33, 0.7" in WORDS
    added = {(row["x"], row["speed"], round(row["friction"] / row["beta"], 3), row["poisson"]):
             row["tangential_restitution"] - row["equal_disks"] for row in COUPLING}  # fmt: skip
    slow = {key: value for key, value in added.items() if key[1] == 0.003}
    assert all(abs(value) < 0.03 for (x, _, ratio, _), value in slow.items() if x <= 1 and ratio >= 1.99)
    beyond = [value for (x, *_), value in added.items() if x >= 2]
    assert max(map(abs, beyond)) < 0.2 and sum(value < 0 for value in beyond) > len(beyond) / 2
    slowly = having(COUPLING, speed=0.003)
    stuck = [row for row in slowly if row["x"] <= 1 and row["friction"] < 0.11 * row["beta"]]
    assert all(0.495 < row["tangential_restitution"] < 0.75 and -0.25 < row["equal_disks"] < 0.35 for row in stuck)


def test_claims_about_restitution_along_the_normal():
    more = [row["restitution"] - row["without_friction"] for row in NORMAL]
    said = f"by {signed(min(more))} to {max(more):.3f}: {len(NORMAL)} impacts"
    assert said in WORDS
    assert f"maximum of all is {max(row['restitution'] for row in NORMAL):.3f}" in WORDS
    soft = having(NORMAL, against="soft")
    assert f"where ε_n is {soft[0]['without_friction']:.3f}" in WORDS
    assert max(abs(row["restitution"] - row["without_friction"]) for row in soft) < 0.005
