"""The tables of docs/results/oblique.md are those of its CSV files."""

import math

import pytest
from conftest import line
from oblique_results import (
    BEST,
    COUPLING,
    FASTER,
    FINITE_ELEMENTS,
    GLASS,
    PAGE,
    at,
    curve,
    having,
    measurements,
    of_law,
    one,
    signed,
    size_law,
    walton,
    worst,
)

XS = (0.2, 0.5, 1, 2, 3, 4, 5, 6)
SUPERSCRIPTS = {1e-6: "10⁻⁶", 1e-5: "10⁻⁵", 1e-4: "10⁻⁴"}


def written(speed):
    return SUPERSCRIPTS.get(speed, f"{speed:g}")


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


def size_laws():
    for name, against, poisson in (("0", "wall", 0.0), ("0.3", "wall", 0.3), ("0.45", "wall", 0.45),
                                   ("0.3, half-space", "half_space", 0.3)):  # fmt: skip
        laws = [size_law(against, poisson, psi) for psi in (0.5, 1.0, 2.0, 3.0)]
        yield line(name, *(f"{a:.2f} {'+' if b > 0 else '−'} {abs(b):.2f} L" for a, b, _ in laws))


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
