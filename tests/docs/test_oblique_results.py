"""The numbers of docs/results/oblique.md: those of its CSV files."""

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


def curve(bodies, speed, friction=0.1):
    return {row["x"]: row for row in having(CURVES, bodies=bodies, speed=speed, friction=friction)}


def spheres():
    for name, bodies, speed in (
        ("Maw", "maw", 0.0), *((f"{written(v)}", "sphere", v) for v in (1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1)),
        ("0.001, half-space", "half_space", 1e-3),
    ):  # fmt: skip
        its = curve(bodies, speed)
        yield line(name, *(signed(its[x]["tangential_restitution"]) for x in XS))


def disks():
    for speed in (1e-4, 0.01, 0.1):
        for name, bodies, friction in (("equal", "equal_disks", 0.1), ("μ = 0.3", "disk", 0.3), ("μ = 0.1", "disk", 0.1)):
            its = curve(bodies, speed, friction)
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
        yield line(name, *(f"{signed(a, 2)} + {signed(b, 2)} L" for a, b, _ in laws))


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
            found, maw, added = (
                at(GLASS, angle, name) for name in ("tangential_restitution", "maw", "added_by_coupling_of_disks")
            )
            yield line(f"{angle:.1f}°", names[quantity], *(signed(each, 2) for each in (value, found, maw, found + added)))


def superballs():
    for poisson in (0.0, 0.2, 0.3, 0.4, 0.45, 0.49):
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
        yield line(f"{row['speed']:g}", f"{row['friction']:g}", f"{row['tangential']:g}", f"{turn:.2f}",
                   f"{row['finite_elements']:.4f}", f"{row['restitution']:.4f}",
                   f"{row['finite_elements_tangential']:.3f}", f"{row['tangential_restitution']:.3f}")  # fmt: skip


def couplings():
    ratios = (0.1, 0.3, 0.5, 1.0, 2.0, 5.0)
    for x in (0.25, 0.5, 1.0, 2.0, 3.0):
        cells = []
        for ratio in ratios:
            its = [row for row in having(COUPLING, x=x, speed=0.003) if math.isclose(row["friction"], ratio * row["beta"], rel_tol=1e-4)]
            added = [row["tangential_restitution"] - row["equal_disks"] for row in its]
            cells.append(f"{signed(min(added), 2)} … {signed(max(added), 2)}")
        yield line(f"{x:g}", *cells)


def normals():
    more = [row["restitution"] - row["without_friction"] for row in NORMAL]
    yield len(NORMAL), min(more), max(more), max(row["restitution"] for row in NORMAL)
    yield max(NORMAL, key=lambda row: row["restitution"] - row["without_friction"])
    yield min(NORMAL, key=lambda row: row["restitution"] - row["without_friction"])
