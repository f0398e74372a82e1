"""The tables of docs/understand/findings/oblique.md are those of its CSV files."""

import pytest
from conftest import line
from oblique_results import (
    BEST,
    CODES,
    FASTER,
    FINITE_ELEMENTS,
    PAGE,
    WORDS,
    curve,
    having,
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
        ("Maw", "maw", 0.0), *((f"{written(v)}", "sphere", v) for v in (1e-6, 1e-3, 0.01, 0.1)),
    ):  # fmt: skip
        its = curve(bodies, speed)
        yield line(name, *(signed(its[x]["tangential_restitution"]) for x in XS))


def size_laws():
    for against, poisson in (("wall", 0.0), ("wall", 0.3), ("half_space", 0.3)):
        a, b, _ = size_law(against, poisson, 1.0)
        yield f"{a:.2f} {'+' if b > 0 else '−'} {abs(b):.2f} L"


LAWS = {"history": "Mindlin spring", "rescale": "rescaled", "force": "in force", "rescale_force": "in force, rescaled",
        "linear_1": "Hooke, k_t = k_n", "linear_2/7": "2k_n/7, Hooke or Hertz"}  # fmt: skip


def codes():
    for name, law in (*((LAWS[key], of_law(key)) for key in LAWS), ("Walton, β₀ = 0.44", walton(0.44))):
        errors = (worst(law, speed) for speed in FASTER)
        yield line(name, *(signed(law[x], 2) for x in (0.2, 1, 2, 3, 4, 5)),
                   *(f"{signed(error, 2)} ({x:g})" for error, x in errors))  # fmt: skip


def superballs():
    its = (one(BEST, bodies="sphere", poisson=0.49, speed=v) for v in (1e-4, 1e-3, 0.01, 0.07, 0.2))
    rows = (one(BEST, bodies="maw", poisson=0.49), *its)
    yield line("largest ε_t", *(f"{row['tangential_restitution']:.3f}" for row in rows))


TABLES = (spheres, size_laws, superballs, codes)


@pytest.mark.parametrize("lines", TABLES, ids=lambda lines: lines.__name__)
def test_table(lines):
    for each in lines():
        assert each in (CODES if lines is codes else PAGE)


def test_finite_elements_of_disks():
    for row in having(FINITE_ELEMENTS, kinematics="linear"):
        assert abs(row["restitution"] - row["finite_elements"]) < row["restitution_error"] + 5e-5
        if row["tangential"] > 0:
            off = abs(row["tangential_restitution"] - row["finite_elements_tangential"])
            assert off < row["tangential_restitution_error"] + (1e-3 if row["friction"] == 1 else 2e-4)


def test_finite_rotation():
    its = having(FINITE_ELEMENTS, kinematics="turning")
    normal = [row["finite_elements"] - row["restitution"] for row in its]
    along = [row["finite_elements_tangential"] - row["tangential_restitution"] for row in its]
    turns = [abs(row["spin_after"]) * row["contact_time"] for row in its]
    assert f"changes ε_t by {signed(min(along), 2)} to {max(along):.2f}" in WORDS
    assert f"and ε_n by {min(normal):.3f} to {max(normal):.3f}, for turns of {min(turns):.2f} to {max(turns):.2f} rad" in WORDS
