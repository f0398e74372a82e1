"""A hollow sphere by its modes in closed form: ./hollow_sphere.py [FILE] writes hollow_sphere.json.

With u = U(r) Y r̂ + V(r) r ∇Y, Y the spherical harmonic of degree n without a node through the pole and
N = n(n + 1), the elastic energy and the mass are integrals over the radius,

    ½∫[λ(U′ + (2U − NV)/r)² + 2μ(U′² + 2((U − NV/2)/r)² + ½N(N − 2)(V/r)² + ½N(V′ + (U − V)/r)²)] r² dr,
    ½∫ρ(U² + NV²) r² dr.

Polynomials of a high degree for U and V make of them two small matrices for each n, whose eigenvalues ω² are those
of Bessel's functions to rounding, from above and one by one, so that none is missed
(tests/python/modal/test_hollow_sphere.py compares both). All of them together, Σ U²/ω², are the static response;
what it differs from that of a solid sphere falls as (r/R)²ⁿ, and c₀ is that of the sphere and this.
"""

import argparse

import numpy as np
from numpy.polynomial import legendre
from scipy.linalg import eigh

import stoss

OUTER, INNER = 10e-3, 8e-3  # m
SOLID = -0.5059087  # c₀ of a solid sphere with ν = 0.3, in 1/(ER) (docs/theory/any_body.md)
DEGREE, HARMONICS = 64, 60  # of the polynomials; degrees n whose static response differs
HIGHEST = 16.0  # ω of the modes that are listed, in c/R


def radial(n: int, inner: float, poisson: float, degree: int = DEGREE) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """ω of all modes of a degree, rising, and their U and V at the surface, with E = ρ = R = 1 and unit mass."""
    x, weight = legendre.leggauss(degree + 8)
    half = 0.5 * (1 - inner)
    r = inner + half * (x + 1)
    value = legendre.legvander(x, degree)
    slope = legendre.legval(x, legendre.legder(np.eye(degree + 1))).T / half
    none = np.zeros_like(value)
    u, v = np.hstack([value, none]), np.hstack([none, value])
    du, dv = np.hstack([slope, none]), np.hstack([none, slope])
    lame, shear = poisson / ((1 + poisson) * (1 - 2 * poisson)), 0.5 / (1 + poisson)
    product, r = n * (n + 1), r[:, None]

    def square(strain: np.ndarray) -> np.ndarray:
        return strain.T @ ((half * weight)[:, None] * r**2 * strain)

    stiffness = lame * square(du + (2 * u - product * v) / r) + 2 * shear * (
        square(du) + 2 * square((u - product * v / 2) / r) + product * (product - 2) / 2 * square(v / r)
        + product / 2 * square(dv + (u - v) / r))  # fmt: skip
    mass = square(u) + product * square(v)
    free = slice(0, 2 * degree + 2 if n else degree + 1)  # a breathing sphere has no V
    squares, shapes = eigh(stiffness[free, free], mass[free, free])
    shapes = np.vstack([shapes, np.zeros((2 * degree + 2 - len(shapes), len(squares)))])
    return np.sqrt(np.abs(squares)), shapes[: degree + 1].sum(axis=0), shapes[degree + 1 :].sum(axis=0)


def modes(inner: float, poisson: float, highest: float) -> np.ndarray:
    """Rows of all modes that move the pole: ω, displacement there, half its mean curvature; E = ρ = R = 1."""
    rows = []
    for n in range(HARMONICS):
        omega, u, v = radial(n, inner, poisson)
        pole, product = np.sqrt((2 * n + 1) / (4 * np.pi)) * np.sign(u), n * (n + 1)
        bent = product / 2 * v - (product / 4 + 0.5) * u  # of u_r cos θ − u_θ sin θ
        listed = (omega > 1e-4) & (omega < highest)
        rows += [np.array([omega, pole * u, pole * bent]).T[listed]]
    table = np.concatenate(rows)
    return table[np.argsort(table[:, 0])]


def compliance(inner: float, poisson: float, solid: float) -> float:
    """c₀ in 1/(ER): that of the solid sphere, and how much softer the shell is, degree by degree."""
    softer = 0.0
    for n in range(HARMONICS):
        for sign, hole in ((1, inner), (-1, 0.0)):
            omega, u, _ = radial(n, hole, poisson)
            softer += sign * (2 * n + 1) / (4 * np.pi) * np.sum((u / omega)[omega > 1e-4] ** 2)
    return solid + softer


def main(path: str) -> None:
    steel = stoss.materials["structural steel"]
    inner, weight = INNER / OUTER, steel.density * OUTER**3
    table = modes(inner, steel.poisson, HIGHEST)
    hertz = np.sqrt(steel.young / steel.density) / OUTER / (2 * np.pi)
    rounding = 1e-8  # of eigenvalues and sums
    stoss.ModalBody(
        name="hollow sphere", origin="closed forms (hollow_sphere.py)", mass=4 / 3 * np.pi * weight * (1 - inner**3),
        curvature=1 / OUTER, young=steel.young, poisson=steel.poisson, density=steel.density,
        compliance=float(f"{compliance(inner, steel.poisson, SOLID) / (steel.young * OUTER):.9g}"),
        compliance_error=1e-6 / (steel.young * OUTER), complete_to=float(f"{HIGHEST * hertz:.9g}"),
        **{name: [float(f"{value:.9g}") for value in scale * table[:, column]] for name, scale, column in (
            ("frequency", hertz, 0), ("frequency_error", rounding * hertz, 0), ("displacement", weight**-0.5, 1),
            ("displacement_error", rounding * weight**-0.5, 1),
            ("displacement_curvature", weight**-0.5 / OUTER**2, 2))},
    ).save(path)  # fmt: skip
    print(f"written: {path}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", nargs="?", default="hollow_sphere.json", help="that it writes")
    main(parser.parse_args().file)
