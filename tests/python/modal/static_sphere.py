"""The compliance c0 of a sphere by its series of Legendre polynomials, in units with R = E = 1."""

import math

import numpy as np


def half_space_terms(poisson):
    """(1 − ν²)/π and g: G(r) = (1 − ν²)/π (1/r − g ln r) + c0."""
    return (1 - poisson**2) / math.pi, (1 - 2 * poisson) ** 2 / (2 * (1 - poisson))


def radial(poisson, degrees):
    """Radial displacement under σ_rr = −(2n + 1)/(4π) P_n, the load of a unit force at the pole."""
    n = np.asarray(degrees, dtype=np.longdouble)
    lame, shear = poisson / ((1 + poisson) * (1 - 2 * poisson)), 0.5 / (1 + poisson)
    # Love's solutions ∇(rⁿP_n) and r²∇ω + α r ω with ω = rⁿP_n, as u_r and the factor of dP_n/dθ.
    second = n - 2 * (n * lame + (3 * n + 1) * shear) / ((n + 3) * lame + (n + 5) * shear)

    def stresses(u, v, power):
        return (
            lame * ((power + 2) * u - n * (n + 1) * v) + 2 * shear * power * u,
            shear * (u + (power - 1) * v),
        )

    (s1, t1), (s2, t2) = stresses(n, 1, n - 1), stresses(second, 1, n + 1)
    load = -(2 * n + 1) / (4 * np.longdouble(np.pi))
    return load * (n * t2 - second * t1) / (s1 * t2 - s2 * t1)


def uniform_acceleration(poisson):
    """The same for n = 1, where inertia balances the force: u = x r² e + y z r + c e."""
    lame, shear = poisson / ((1 + poisson) * (1 - 2 * poisson)), 0.5 / (1 + poisson)
    balance = [2 * (lame + shear) + 6 * shear, 4 * (lame + shear) + 2 * shear]
    x, y = np.linalg.solve([balance, [2 * shear, shear]], [-3 / (4 * math.pi), 0])
    return x + y - (3 * x + y) / 5


def compliance(poisson, terms=100_000):
    """c0, of axial displacement.

    The series without its half-space term, Σ P_n → 1/r, and its logarithm, Σ P_n/n → −ln(r/2), has
    terms ~ 1/n². A force at the pole also pulls the surface beside it inward, where it is tilted.
    """
    front, bend = half_space_terms(poisson)
    n = np.arange(2, terms + 1)
    rest = -radial(poisson, n) - front - front * bend / n
    first = -uniform_acceleration(poisson) - front - front * bend
    breathing = (1 - 2 * poisson) / (4 * math.pi) - front
    sums = breathing + first + np.cumsum(rest)
    limit = 2 * sums[-1] - sums[terms // 2 - 2]  # the remainder is ~ 1/terms
    tilt = (1 - 2 * poisson) * (1 + poisson) / (2 * math.pi)
    return float(limit + front * bend * math.log(2) - tilt)
