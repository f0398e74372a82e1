#!/usr/bin/python3
"""Writes modes_mpmath.csv: every mode of a free disk in chosen windows of frequency, to 50 digits.

    /usr/bin/python3 make_modes_mpmath.py > modes_mpmath.csv        (a few minutes)

Independent of the library: the paper's eigenvalue equations ((24), and (20) for n = 0) in mpmath. In each window
D_n is sampled; every sign change is a root, and every minimum of |D_n| between two samples of the same sign is
followed to its bottom, where a close pair of roots shows as a change of sign (the paper's own advice).
C and S follow from eqs. (19), the field, (21), the free edge, and (25), the norm.
"""

import sys

from mpmath import besselj, findroot, mp, mpf, quad, sqrt

# (Poisson's ratio, order, low, high): windows from below the lowest mode upwards, windows at high frequency, and
# windows that hold nearly degenerate pairs.
WINDOWS = [
    ("-0.95", 0, "1", "9"), ("-0.95", 1, "1", "14"), ("-0.95", 2, "1", "14"), ("-0.95", 7, "3", "20"),
    ("-0.95", 30, "14", "35"), ("-0.95", 200, "98", "103"), ("-0.95", 700, "345", "350"),
    ("-0.9", 0, "1", "12"), ("-0.9", 3, "1", "15"), ("-0.9", 12, "5", "25"), ("-0.9", 1, "274", "277"),
    ("-0.9", 350, "176", "182"),
    ("-0.5", 1, "1", "10"), ("-0.5", 5, "2", "14"), ("-0.5", 60, "31", "45"), ("-0.5", 1, "163.5", "165.5"),
    ("-0.5", 280, "396", "397.5"), ("-0.5", 650, "363", "366"),
    ("0", 0, "1", "15"), ("0", 2, "1", "11"), ("0", 4, "2", "12"), ("0", 25, "14", "29"), ("0", 200, "115", "135"),
    ("0", 1, "242", "244"), ("0", 10, "396", "399"),
    ("0.2", 1, "1", "9"), ("0.2", 8, "4", "14"), ("0.2", 90, "53", "70"), ("0.2", 1, "330", "332"),
    ("0.33", 0, "1", "17"), ("0.33", 1, "1", "10"), ("0.33", 2, "1", "10"), ("0.33", 6, "3", "13"),
    ("0.33", 40, "24", "36"), ("0.33", 300, "180", "190"), ("0.33", 1, "63.5", "65"), ("0.33", 500, "300", "312"),
    ("0.33", 640, "385", "400"), ("0.33", 5, "398", "400"),
    ("0.5", 0, "340", "350"), ("0.5", 3, "1", "9"), ("0.5", 20, "11", "20"), ("0.5", 150, "150", "152"),
    ("0.5", 19, "398.5", "400"),
    ("0.9", 0, "1", "24"), ("0.9", 1, "1", "8"), ("0.9", 2, "1", "8"), ("0.9", 70, "41", "50"),
    ("0.9", 1, "354", "356"), ("0.9", 2, "286", "287"), ("0.9", 350, "350", "352"), ("0.9", 600, "375", "385"),
    ("0.99", 0, "1", "120"), ("0.99", 1, "1", "6"), ("0.99", 4, "2", "8"), ("0.99", 45, "29", "36"),
    ("0.99", 3, "338", "340"), ("0.99", 2, "300", "302"),
    ("0.995", 0, "310", "400"), ("0.995", 2, "1", "6"), ("0.995", 4, "398", "400"), ("0.995", 5, "286", "287.5"),
    ("0.995", 400, "394", "397"),
]
SAMPLES_PER_UNIT = 16
DIGITS = 50


def pair(n, x):
    """J_n(x) and x J_n'(x)."""
    value = besselj(n, x)
    return value, x * besselj(n - 1, x) - n * value


def determinant(poisson, n, omega):
    """Paper eq. (24) for n >= 1, eq. (20) for n = 0, R = 1."""
    soft = 1 - poisson
    x = omega * sqrt(1 - poisson**2)
    if n == 0:
        value, slope = pair(1, x)
        return slope + poisson * value
    y = omega * sqrt(2 * (1 + poisson))
    below, here = x * besselj(n - 1, x), besselj(n, x)
    below_s, here_s = y * besselj(n - 1, y), besselj(n, y)
    return (soft**2 * (1 - n**2) * below * below_s
            + soft * (x**2 - soft * (1 - n**2) * n) * (below * here_s + below_s * here)
            + (x**4 - 2 * (n**2 + n) * soft * x**2) * here * here_s)


def roots_in(f, low, high):
    """All roots of f between low and high."""
    def bisect(a, b):
        fa = f(a)
        for _ in range(20):
            middle = (a + b) / 2
            fm = f(middle)
            if (fm > 0) == (fa > 0):
                a, fa = middle, fm
            else:
                b = middle
        return findroot(f, (a, b), solver="anderson", tol=mpf(10) ** -80, maxsteps=60, verify=False)

    count = int((high - low) * SAMPLES_PER_UNIT)
    mp.dps = 20
    omega = [low + (high - low) * i / count for i in range(count + 1)]
    value = [f(w) for w in omega]
    brackets = []
    for i in range(count):
        if (value[i] > 0) != (value[i + 1] > 0):
            brackets.append((omega[i], omega[i + 1]))
        elif (
            0 < i
            and (value[i - 1] > 0) == (value[i] > 0)
            and abs(value[i]) <= min(abs(value[i - 1]), abs(value[i + 1]))
        ):
            # Golden section to the bottom of |f|; a change of sign on the way splits a pair.
            mp.dps = DIGITS
            sign = 1 if value[i] > 0 else -1
            a, b = omega[i - 1], omega[i + 1]
            for _ in range(60):
                c, d = a + (b - a) * 0.382, a + (b - a) * 0.618
                fc, fd = sign * f(c), sign * f(d)
                if fc < 0 or fd < 0:
                    inside = c if fc < 0 else d
                    brackets += [(omega[i - 1], inside), (inside, omega[i + 1])]
                    break
                a, b = (a, d) if fc < fd else (c, b)
            mp.dps = 20
    mp.dps = DIGITS
    return sorted(bisect(a, b) for a, b in brackets)


def edge(poisson, n, omega, check):
    """(C, S) of the normalised mode."""
    x, y = omega * sqrt(1 - poisson**2), omega * sqrt(2 * (1 + poisson))
    if n == 0:
        norm = quad(lambda r: r * besselj(1, x * r) ** 2, [mpf(i) / 4 for i in range(5)]) if check else None
        closed = (besselj(1, x) ** 2 - besselj(0, x) * besselj(2, x)) / 2
        assert norm is None or abs(norm / closed - 1) < mpf(10) ** -20
        return abs(besselj(1, x)) / sqrt(2 * closed), mpf(0)
    (b, a), (bs, as_) = pair(n, x), pair(n, y)
    # A and B from the larger of eqs. (21) (divided by 1 - nu) and (22) (divided by 2).
    q = y**2 / 2 - n**2
    rows = [(-(a + q * b), n * (as_ - bs)), (-n * (a - b), as_ + q * bs)]
    size = abs(b) + abs(a), abs(bs) + abs(as_)
    row = max(rows, key=lambda pq: abs(pq[0]) / size[0] + abs(pq[1]) / size[1])
    A, B = row[1], -row[0]
    # ∫ r (u_r² + u_φ²) dr in closed form (Lommel's integrals).
    def own(k, value, slope):
        return value * slope + (slope**2 + (k**2 - n**2) * value**2) / 2
    norm = A**2 * own(x, b, a) + B**2 * own(y, bs, as_) + 2 * n * A * B * b * bs
    if check:
        def density(r):
            (p, dp), (s, ds) = pair(n, x * r), pair(n, y * r)
            return ((A * dp + n * B * s) ** 2 + (n * A * p + B * ds) ** 2) / r
        assert abs(quad(density, [mpf(i) / 4 for i in range(5)]) / norm - 1) < mpf(10) ** -15
    C, S = (A * a + n * B * bs) / sqrt(norm), -(n * A * b + B * as_) / sqrt(norm)
    return (C, S) if C >= 0 else (-C, -S)


def main():
    print("# Modes of a free disk, R = c = rho = 1, computed with mpmath at 50 digits by make_modes_mpmath.py:")
    print("# all roots of paper eqs. (24) and (20) with window_low < omega < window_high.")
    print("poisson,n,window_low,window_high,omega,C,S")
    for poisson, n, low, high in WINDOWS:
        mp.dps = DIGITS
        # The library is given the nearest double: so is the reference.
        nu = mpf(float(poisson))
        for i, omega in enumerate(roots_in(lambda w, n=n, nu=nu: determinant(nu, n, w), mpf(low), mpf(high))):
            mp.dps = DIGITS
            C, S = edge(nu, n, omega, check=i == 0 and omega < 8)
            texts = [mp.nstr(v, 22, strip_zeros=False) for v in (omega, C, S)]
            print(",".join([poisson, str(n), low, high] + texts), flush=True)
        print(poisson, n, low, high, file=sys.stderr)


if __name__ == "__main__":
    main()
