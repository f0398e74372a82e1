"""Spheroidal modes of a hollow sphere by Bessel's functions, in units with R = E = ρ = 1.

Potentials, as in A. C. Eringen, E. S. Suhubi, Elastodynamics II (1975), section 8.13, and for the
solid sphere H. Lamb, Proc. London Math. Soc. 13 (1882): u = ∇φ + ∇×∇×(𝐫ψ) with φ = z(hr) Y and
ψ = z(kr) Y, z both spherical Bessel functions, h = ω/c_p, k = ω/c_s.
"""

import numpy as np
from scipy.special import spherical_jn, spherical_yn


def fields(n, omega, poisson, r):
    """U, V, σ_rr/Y and σ_rθ/(∂Y/∂θ) at the radius r, a column for each of the four functions."""
    lame, shear = poisson / ((1 + poisson) * (1 - 2 * poisson)), 0.5 / (1 + poisson)
    product = n * (n + 1)
    columns = []
    for speed, pressure in ((np.sqrt(lame + 2 * shear), True), (np.sqrt(shear), False)):
        k = omega / speed
        for bessel in (spherical_jn, spherical_yn):
            z, dz = bessel(n, k * r), k * bessel(n, k * r, derivative=True)
            ddz = -2 / r * dz - (k**2 - product / r**2) * z
            if pressure:
                u, v, du, dv, dilated = dz, z / r, ddz, dz / r - z / r**2, -(k**2) * z
            else:
                u, du = product * z / r, product * (dz / r - z / r**2)
                v, dv, dilated = z / r + dz, dz / r - z / r**2 + ddz, 0.0
            columns.append([u, v, lame * dilated + 2 * shear * du, shear * (dv + (u - v) / r)])
    return np.array(columns).T


def _stresses(n, omega, poisson, inner):
    """On both surfaces, each function scaled to one, and the scales."""
    rows = np.vstack([fields(n, omega, poisson, r)[2:] for r in (inner, 1.0)])
    if n == 0:  # neither shear nor a second potential
        rows = rows[np.ix_([0, 2], [0, 1])]
    scale = np.linalg.norm(rows, axis=0)
    return rows / scale, scale


def determinant(n, omega, poisson, inner):
    """It changes its sign at each frequency of the degree."""
    return np.linalg.det(_stresses(n, omega, poisson, inner)[0])


def at_surface(n, omega, poisson, inner):
    """|U|, V in the sign of U, of a mode of unit mass; how close to 0 the determinant is."""
    rows, scale = _stresses(n, omega, poisson, inner)
    _, singular, vectors = np.linalg.svd(rows)
    amplitudes, used = vectors[-1] / scale, range(len(scale))
    x, weight = np.polynomial.legendre.leggauss(60)
    r = inner + 0.5 * (1 - inner) * (x + 1)
    inside = np.array([fields(n, omega, poisson, each)[:2, used] @ amplitudes for each in r])
    mass = 0.5 * (1 - inner) * np.sum(weight * r**2 * (inside**2 @ [1, n * (n + 1)]))
    u, v = fields(n, omega, poisson, 1.0)[:2, used] @ amplitudes / np.sqrt(mass)
    return abs(u), v * np.sign(u), singular[-1] / singular[0]
