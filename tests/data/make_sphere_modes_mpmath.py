#!/usr/bin/python3
"""Writes sphere_modes_mpmath.csv: every spheroidal mode of a free sphere in chosen windows of frequency, to 50 digits.

    /usr/bin/python3 make_sphere_modes_mpmath.py > sphere_modes_mpmath.csv        (a minute)

Independent of the library: the displacement u = grad(A j_n P_n) + curl curl(r B j_n P_n) with spherical Bessel
functions of mpmath, its derivatives by their recurrences, Hooke's law, and the determinant of the traction as it is.
Roots are found as for the disk (make_modes_mpmath.py).
"""

import sys

from make_modes_mpmath import DIGITS, roots_in
from mpmath import besselj, mp, mpf, pi, quad, sqrt

# (Poisson's ratio, degree, low, high)
WINDOWS = [
    ("-0.95", 0, "1", "30"), ("-0.95", 1, "1", "25"), ("-0.95", 2, "1", "25"), ("-0.95", 9, "10", "40"),
    ("-0.95", 40, "85", "105"), ("-0.95", 150, "330", "345"),
    ("-0.7", 3, "1", "16"), ("-0.7", 100, "95", "110"), ("-0.5", 0, "1", "15"), ("-0.5", 1, "1", "14"),
    ("-0.5", 6, "3", "16"), ("-0.5", 60, "45", "58"), ("-0.5", 1, "163", "167"), ("-0.5", 450, "355", "360"),
    ("0", 0, "1", "20"), ("0", 1, "1", "13"), ("0", 2, "1", "13"), ("0", 5, "3", "14"), ("0", 25, "15", "28"),
    ("0", 200, "124", "135"), ("0", 1, "242", "245"), ("0", 10, "396", "399"),
    ("0.2", 1, "1", "12"), ("0.2", 8, "4", "14"), ("0.2", 90, "54", "68"),
    ("0.25", 0, "1", "20"), ("0.25", 1, "1", "10"), ("0.25", 2, "1", "10"), ("0.25", 3, "1", "11"),
    ("0.25", 4, "1", "11"),
    ("0.3", 0, "1", "24"), ("0.3", 1, "1", "12"), ("0.3", 2, "1", "12"), ("0.3", 3, "1", "12"), ("0.3", 6, "3", "14"),
    ("0.3", 40, "23", "36"), ("0.3", 300, "172", "184"), ("0.3", 1, "98", "102"), ("0.3", 640, "368", "380"),
    ("0.3", 5, "396", "400"),
    ("0.45", 0, "1", "40"), ("0.45", 1, "1", "10"), ("0.45", 2, "1", "10"), ("0.45", 20, "11", "22"),
    ("0.45", 150, "84", "96"), ("0.45", 3, "396", "399"),
    ("0.49", 0, "1", "60"), ("0.49", 1, "1", "10"), ("0.49", 2, "1", "10"), ("0.49", 70, "39", "50"),
    ("0.49", 2, "286", "289"),
    ("0.4999", 0, "1", "400"), ("0.4999", 1, "1", "12"), ("0.4999", 2, "1", "10"), ("0.4999", 4, "2", "12"),
    ("0.4999", 45, "25", "36"), ("0.4999", 3, "337", "340"), ("0.4999", 600, "335", "345"),
    ("-0.5", 3, "14", "120"), ("0", 2, "13", "120"), ("0.3", 4, "40", "160"), ("0.45", 6, "40", "140"),
]


def speeds(poisson):
    pressure = sqrt((1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)))
    return pressure, 1 / sqrt(2 * (1 + poisson))


def spherical(n, x):
    """j_n, x j_n' and x^2 j_n''."""
    j = sqrt(pi / (2 * x)) * besselj(n + mpf(1) / 2, x)
    after = sqrt(pi / (2 * x)) * besselj(n + mpf(3) / 2, x)
    slope = n * j - x * after
    return j, slope, (n * (n + 1) - x**2) * j - 2 * slope


def at_radius(poisson, n, omega, r):
    """Rows u_r, u_theta and, over 2 mu, sigma_rr, sigma_r theta, of the two potentials (A, B)."""
    pressure, shear = speeds(poisson)
    wave = n * (n + 1)
    f, f1, f2 = spherical(n, omega / pressure * r)
    g, g1, g2 = spherical(n, omega / shear * r)
    # u_r = A f' + B L g/r, u_theta = (A f + B (r g)')/r; slopes in r times r
    ur = (f1 / r, wave * g / r)
    ut = (f / r, (g + g1) / r)
    ur_slope = (f2 / r, wave * (g1 - g) / r)
    ut_slope = ((f1 - f) / r, (g1 + g2 - g) / r)
    ratio = poisson / (1 - 2 * poisson)
    volume = (-(omega / pressure) ** 2 * f, mpf(0))
    rr = tuple(ratio * v + s / r for v, s in zip(volume, ur_slope))
    rt = tuple((s - t + u) / (2 * r) for s, t, u in zip(ut_slope, ut, ur))
    return ur, ut, rr, rt


def determinant(poisson, n, omega):
    _, _, rr, rt = at_radius(poisson, n, omega, mpf(1))
    return rr[0] if n == 0 else rr[0] * rt[1] - rr[1] * rt[0]


def surface(poisson, n, omega, check):
    """(U, V) of the normalised mode, by Lommel's integrals; in some cases checked by quadrature."""
    pressure, shear = speeds(poisson)
    ur, ut, rr, rt = at_radius(poisson, n, omega, mpf(1))
    if n == 0:
        A, B = mpf(1), mpf(0)
    else:
        row = max((rr, rt), key=lambda pair: abs(pair[0] / ur[0]) + abs(pair[1] / ut[1]))
        A, B = row[1], -row[0]
    wave = n * (n + 1)

    def own(x):
        # r^2 f'^2 + L f^2 over 0 ... 1, by parts: f f' + x^2 int r^2 f^2
        j, slope, _ = spherical(n, x)
        return j * slope + (slope**2 + slope * j + (x**2 - wave) * j**2) / 2

    f, g = spherical(n, omega / pressure), spherical(n, omega / shear)
    norm = A**2 * own(omega / pressure)
    if n > 0:
        norm += wave * B**2 * (own(omega / shear) + g[0] ** 2) + 2 * A * B * wave * f[0] * g[0]
    if check:
        def density(r):
            inside_r, inside_t, _, _ = at_radius(poisson, n, omega, r)
            return r**2 * ((A * inside_r[0] + B * inside_r[1]) ** 2 + wave * (A * inside_t[0] + B * inside_t[1]) ** 2)
        assert abs(quad(density, [mpf(10) ** -12] + [mpf(i) / 4 for i in range(1, 5)]) / norm - 1) < mpf(10) ** -15
    scale = sqrt(mpf(2 * n + 1) / (3 * norm))
    U, V = (A * ur[0] + B * ur[1]) * scale, (A * ut[0] + B * ut[1]) * scale
    if n == 0:
        V = mpf(0)
    return (U, V) if U >= 0 else (-U, -V)


def main():
    print("# Spheroidal modes of a free sphere, R = c = rho = 1, computed with mpmath at 50 digits by")
    print("# make_sphere_modes_mpmath.py: all roots with window_low < omega < window_high.")
    print("poisson,n,window_low,window_high,omega,U,V")
    for poisson, n, low, high in WINDOWS:
        mp.dps = DIGITS
        # The library is given the nearest double: so is the reference.
        nu = mpf(float(poisson))
        for i, omega in enumerate(roots_in(lambda w, n=n, nu=nu: determinant(nu, n, w), mpf(low), mpf(high))):
            mp.dps = DIGITS
            U, V = surface(nu, n, omega, check=i == 0 and omega < 8)
            texts = [mp.nstr(v, 22, strip_zeros=False) for v in (omega, U, V)]
            print(",".join([poisson, str(n), low, high] + texts), flush=True)
        print(poisson, n, low, high, file=sys.stderr)


if __name__ == "__main__":
    main()
