"""Figure 2: displacement in the modes (0, 0), (1, 0) and (2, 0).

The paper sketches what becomes of the radii and circles of the disk in three simple eigenmodes. The
frequencies are the roots of the free edge's determinant (eqs. 20 and 24, exact as printed), the
shapes those of eq. (19), normalised by eq. (25). The text says: the centre stays for n = 0, moves
for n = 1, and for n ≥ 2 the displacement vanishes like r^(n−1); (2, 0) is the lowest mode of all.

As a check independent of stoss' Bessel functions, the printed determinants are evaluated here with
Bessel's integral, and with them the overlap of two modes as eq. (26) prints them, with κ and κ′
exchanged in u_φ (erratum E4).
"""

from __future__ import annotations

import numpy as np
import stoss
from matplotlib.figure import Figure
from numpy.typing import NDArray
from stoss.plot import mode_shape

from gerl_zippelius_1999.common import NONE, PAGE, Row, Tables, axes_of, power, written

TITLE = "Figure 2: displacement in three simple modes"
CAPTION = (
    "The lowest modes of angular order 0, 1 and 2 of a disk with ν = 0.33. The radii and circles, even in the disk at "
    "rest, are drawn displaced, by at most 0.15 R; grey is the edge at rest. In (0, 0) the disk breathes; in (1, 0) "
    "the centre moves against the rim while the centre of mass stays; (2, 0), the quadrupole, has the lowest frequency "
    "of all."
)
ALT = "Three disks with a polar grid, deformed: breathing, with the centre shifted, and stretched to an oval."

POISSON = 0.33
MODES = ((0, 0), (1, 0), (2, 0))


def compute(quick: bool) -> Tables:
    """Modes, displacement along the radius, and overlaps of neighbours. The same quick or not."""
    modes = stoss.modes(poisson=POISSON, cutoff=12.0)
    radius = np.linspace(0.0, 1.0, 101)
    shapes: dict[str, NDArray] = {"radius[R]": radius}
    for order, index in MODES:
        u_r, u_phi = modes.displacement(order=order, index=index, radius=radius)
        shapes |= {f"radial_{order}_{index}": u_r, f"tangential_{order}_{index}": u_phi}
    # Near the centre, for the exponents: |u| at r and 2r.
    near = {}
    for order, index in (*MODES, (3, 0), (4, 0)):
        sizes = np.hypot(*modes.displacement(order=order, index=index, radius=[0.001, 0.002]))
        near[order] = np.log2(sizes[1] / sizes[0])
    misprint = np.array([[_overlap(modes, n, swapped) for swapped in (True, False)] for n in (1, 2, 3)])
    return {
        "modes": {
            "order": modes.order, "index": modes.index, "omega[c/R]": modes.omega, "radial": modes.radial,
            "tangential": modes.tangential,
        },
        "shapes": shapes,
        "printed_equation": {
            "order": np.array([n for n, _ in MODES]), "index": np.array([l for _, l in MODES]),
            "omega[c/R]": np.array([_root(n, modes.omega[modes.find(n, l)]) for n, l in MODES]),
        },
        "centre": {"order": np.array(list(near)), "exponent": np.array(list(near.values()))},
        "overlap": {"order": np.array([1, 2, 3]), "as_printed": misprint[:, 0], "as_in_eigen_u": misprint[:, 1]},
    }  # fmt: skip


def _bessel(n: int, x: NDArray | float) -> NDArray:
    """J_n by Bessel's integral. The trapezium rule over a period is exact for x < 50."""
    turn = 2.0 * np.pi * np.arange(128) / 128.0
    return np.cos(n * turn - np.multiply.outer(x, np.sin(turn))).mean(axis=-1)


def _determinant(n: int, omega: float) -> float:
    """The left-hand side of eq. (20), for n = 0, or (24), term by term as printed, with R = 1."""
    nu = POISSON
    k, s = omega * np.sqrt(1.0 - nu**2), omega * np.sqrt(2.0 * (1.0 + nu))
    if n == 0:
        return float(k * _bessel(0, k) - _bessel(1, k) + nu * _bessel(1, k))
    low, high, low_s, high_s = _bessel(n - 1, k), _bessel(n, k), _bessel(n - 1, s), _bessel(n, s)
    return float(
        (1 - nu) ** 2 * (1 - n**2) * k * s * low * low_s
        + (1 - nu) * (k**2 - (1 - nu) * (1 - n**2) * n) * (k * low * high_s + s * low_s * high)
        + (k**4 - 2 * (n**2 + n) * (1 - nu) * k**2) * high * high_s
    )


def _root(n: int, near: float) -> float:
    """The root of the printed equation, halving the interval 1 % around `near`."""
    low, high = 0.99 * near, 1.01 * near
    sign = np.sign(_determinant(n, low))
    if sign == np.sign(_determinant(n, high)):
        raise ArithmeticError(f"eq. (24) has no root within 1 % of {near:g} for n = {n}")
    while high - low > 4e-15 * near:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if np.sign(_determinant(n, middle)) == sign else (low, middle)
    return 0.5 * (low + high)


def _slope(n: int, q: float, r: NDArray | float) -> NDArray:
    """dJ_n(qr)/dr."""
    return q * _bessel(n - 1, q * r) - n * _bessel(n, q * r) / r


def _overlap(modes: stoss.Modes, n: int, swapped: bool) -> float:
    """∫ r u·u dr of (n, 0) and (n, 1), normalised: u_φ of eq. (26), swapped, or of eq. (19)."""
    points, weights = np.polynomial.legendre.leggauss(40)
    r, weights = 0.5 * (points + 1.0), 0.5 * weights
    fields = []
    for index in (0, 1):
        omega = modes.omega[modes.find(n, index)]
        k, s = omega * np.sqrt(1.0 - POISSON**2), omega * np.sqrt(2.0 * (1.0 + POISSON))
        a = 2.0 * _slope(n, s, 1.0) + (s**2 - 2.0 * n**2) * _bessel(n, s)  # A : B from eq. (22), no shear at the edge
        b = 2.0 * n * (_slope(n, k, 1.0) - _bessel(n, k))
        p, q = (s, k) if swapped else (k, s)
        u_r = a * _slope(n, k, r) + n * b * _bessel(n, s * r) / r
        u_phi = -(n * a * _bessel(n, p * r) / r + b * _slope(n, q, r))
        sign = np.sign(a * _slope(n, k, 1.0) + n * b * _bessel(n, s))  # C ≥ 0
        fields.append((sign * u_r, sign * u_phi))
    (f_r, f_phi), (g_r, g_phi) = fields
    mixed, first, second = (
        float(np.sum(weights * r * each)) for each in (f_r * g_r + f_phi * g_phi, f_r**2 + f_phi**2, g_r**2 + g_phi**2)
    )
    return float(mixed / np.sqrt(first * second))


def draw(tables: Tables) -> Figure:
    """Three shapes side by side."""
    table = tables["modes"]
    modes = stoss.Modes(
        body=stoss.Disk(poisson=POISSON), poisson=POISSON, cutoff=12.0, order=table["order"],
        index=table["index"], omega=table["omega[c/R]"], radial=table["radial"], tangential=table["tangential"],
    )  # fmt: skip
    figure, axes = axes_of(PAGE, 2.75, 1, 3, sharey=True)
    for each, (order, index) in zip(axes, MODES):
        mode_shape(modes, each, order=order, index=index)
        each.set(xlim=(-1.2, 1.2), ylim=(-1.2, 1.2))
        each.label_outer()
    return figure


def numbers(tables: Tables) -> list[Row]:
    """Frequencies by the printed equation and by stoss; what the text says of the centre."""
    modes, printed = tables["modes"], tables["printed_equation"]
    rows = []
    for n, l, omega in zip(printed["order"], printed["index"], printed["omega[c/R]"]):
        found = modes["omega[c/R]"][(modes["order"] == n) & (modes["index"] == l)][0]
        equation = 20 if n == 0 else 24
        what = f"ω({n},{l}) in c/R; protocol: root of eq. ({equation}), the free edge, as printed"
        rows.append((what, NONE, f"{omega:.10f}", f"{found:.10f}"))
    first = np.argmin(modes["omega[c/R]"])
    lowest = f"({modes['order'][first]}, {modes['index'][first]})"
    rows.append(("mode with the lowest frequency", "(2, 0)", lowest, lowest))
    _, shift, exponents = _centre(tables)
    rows.append(("displacement of the centre in (1, 0), in units of that at φ = 0", "finite", NONE, written(shift, 3)))
    for n in (2, 3, 4):
        what = f"exponent of r in the displacement near the centre, n = {n}"
        rows.append((what, f"n − 1 = {n - 1}", NONE, f"{exponents[n]:.4f}"))
    for n, as_printed, right in zip(*tables["overlap"].values()):
        what = f"overlap of ({n}, 0) and ({n}, 1); protocol: eq. (26) as printed, converged: eq. (19)"
        none = "0 to rounding" if abs(right) < 1e-13 else power(abs(right), 0)
        rows.append((what, "orthonormal: 0", written(abs(as_printed), 2), none))
    return rows


def _centre(tables: Tables) -> tuple[float, float, dict[int, float]]:
    """Displacement of the centre over that of the edge in (0, 0) and (1, 0); exponents near it."""
    shapes = tables["shapes"]
    still, moved = shapes["radial_0_0"], shapes["radial_1_0"]
    exponents = {int(n): float(p) for n, p in zip(*tables["centre"].values())}
    return float(still[0] / still[-1]), float(moved[0] / moved[-1]), exponents


def meaning(tables: Tables) -> str:
    """What the figure says."""
    modes, printed = tables["modes"], tables["printed_equation"]
    quadrupole = np.min(modes["omega[c/R]"])
    both = [modes["omega[c/R]"][(modes["order"] == n) & (modes["index"] == l)][0] for n, l in MODES]
    worst = np.max(np.abs(printed["omega[c/R]"] / both - 1.0))
    return (
        "The frequencies agree with the printed equations, evaluated independently, to "
        f"{power(max(worst, 1e-15), 0)}, and the centre moves as the text says. The quadrupole has the period "
        f"{2 * np.pi / quadrupole:.3f} R/c, comparable with the duration of an impact (Figure 11): through this "
        "resonance it can take much of the energy, and its share of the loss waxes and wanes with the speed (Figure "
        "12). The exchange of κ and κ′ in eq. (26), the normalised displacement, must be a misprint, since with it "
        "the modes would not be orthogonal."
    )
