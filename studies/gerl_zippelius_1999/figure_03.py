"""Figure 3: the eigenfrequencies against the angular order.

The paper plots ω_{n,l} R/c against n for ν = 0.33 and tells radial from tangential modes by the
larger of the two amplitudes at the edge, C and |S|. The frequencies are the roots of eqs. (20) and
(24), the free edge. stoss counts them exactly (Wittrick and Williams), so none is missed, not even
where two are so close that the paper had to look for them through the zeros of the derivative.

The text's statements on the ratio C : S are tested for l ≫ n on all modes with n = 3 to 5 up to
ω = 400 c/R, and for small l on the modes shown with n ≥ 10, l = 0 and l = 1 apart. For n → ∞ the
modes with l = 0 are Rayleigh's surface wave, whose ratio follows from ν alone.
"""

from __future__ import annotations

import numpy as np
import stoss
from matplotlib.figure import Figure
from numpy.typing import NDArray
from stoss.plot import spectrum

from gerl_zippelius_1999.common import COLUMN, NONE, Row, Tables, axes_of, written

TITLE = "Figure 3: eigenfrequencies against angular order"
CAPTION = (
    "Eigenfrequencies ω R/c of a disk with ν = 0.33 against the angular order n, all of them up to 20. Filled "
    "circles: modes whose edge moves mostly along the radius, C > |S|; open triangles: mostly along the edge. For few "
    "nodes along the radius (l ≪ n, the lower right) the levels are even and go on smoothly from n to n + 1; for l ≫ "
    "n (upper left) radial and tangential modes hardly notice each other and their spacing becomes irregular."
)
ALT = "Scatter plot of frequency against angular order: points on lines that rise, radial and tangential."

POISSON = 0.33
SHOWN, HIGHEST = 20.0, 400.0
ORDERS = (3, 5)  # of the modes with l ≫ n
FROM = 10  # the least order of the modes with small l


def compute(quick: bool) -> Tables:
    """All modes to be shown, and those of a few orders up to a high frequency."""
    shown = stoss.modes(poisson=POISSON, cutoff=SHOWN)
    high = stoss.modes(poisson=POISSON, cutoff=150.0 if quick else HIGHEST)
    few = (high.order >= ORDERS[0]) & (high.order <= ORDERS[1])
    surface = np.argmax(np.where(high.index == 0, high.order, 0))
    counts = np.array([10.0, 20.0, 50.0, 100.0, 150.0])
    sorted_omega = np.sort(high.omega)
    gaps = [np.diff(high.omega[high.order == n]).min() for n in range(1, 21)]
    return {
        "modes": {
            "order": shown.order, "index": shown.index, "omega[c/R]": shown.omega, "radial": shown.radial,
            "tangential": shown.tangential,
        },
        "few_orders": {
            "order": high.order[few], "index": high.index[few], "omega[c/R]": high.omega[few],
            "radial": high.radial[few], "tangential": high.tangential[few],
        },
        "surface": {
            "order": high.order[[surface]], "radial": high.radial[[surface]], "tangential": high.tangential[[surface]],
        },
        "count": {"omega[c/R]": counts, "modes": np.searchsorted(sorted_omega, counts, side="right")},
        "gap": {"order": np.arange(1, 21), "least_gap[c/R]": np.array(gaps), "cutoff[c/R]": np.full(20, high.cutoff)},
    }  # fmt: skip


def draw(tables: Tables) -> Figure:
    """The spectrum, as `stoss.plot` draws it."""
    table = tables["modes"]
    modes = stoss.Modes(
        body=stoss.Disk(poisson=POISSON), poisson=POISSON, cutoff=SHOWN, order=table["order"],
        index=table["index"], omega=table["omega[c/R]"], radial=table["radial"], tangential=table["tangential"],
    )  # fmt: skip
    figure, (axes,) = axes_of(1.5 * COLUMN, 3.9)
    spectrum(modes, axes)
    axes.set(xlim=(-0.8, table["order"].max() + 0.8), ylim=(0.0, SHOWN + 0.4), ylabel="frequency ω R/c")
    return figure


def _ratios(tables: Tables) -> tuple[NDArray, NDArray, NDArray]:
    """Larger over smaller edge amplitude, l/n, and distance to the next mode of the same order."""
    table = tables["few_orders"]
    radial, tangential = table["radial"], np.abs(table["tangential"])
    next_one = np.full(len(radial), np.inf)
    for order in np.unique(table["order"]):
        where = np.flatnonzero(table["order"] == order)
        gaps = np.diff(table["omega[c/R]"][where])
        next_one[where] = np.minimum(np.append(gaps, np.inf), np.append(np.inf, gaps))
    ratio = np.maximum(radial, tangential) / np.minimum(radial, tangential)
    return ratio, table["index"] / table["order"], next_one


def _lowest(tables: Tables, index: int) -> tuple[NDArray, NDArray]:
    """Of the modes shown with this l and n ≥ 10: the orders, and C : S."""
    table = tables["modes"]
    chosen = np.flatnonzero((table["order"] >= FROM) & (table["index"] == index))
    chosen = chosen[np.argsort(table["order"][chosen])]
    return table["order"][chosen], table["radial"][chosen] / table["tangential"][chosen]


def _larger(ratio: NDArray) -> NDArray:
    """C : |S| or |S| : C, whichever is above 1."""
    return np.maximum(np.abs(ratio), 1.0 / np.abs(ratio))


def _surface_wave() -> float:
    """Amplitude of Rayleigh's surface wave normal to the edge over that along it.

    (1 − ξ/2)/√(1 − ξ), where ξ = (c_R/c_t)² solves ξ³ − 8ξ² + (24 − 16k)ξ − 16(1 − k) = 0 with
    k = (c_t/c_l)² = (1 − ν)/2.
    """
    k = 0.5 * (1.0 - POISSON)
    roots = np.roots([1.0, -8.0, 24.0 - 16.0 * k, -16.0 * (1.0 - k)])
    (xi,) = (float(root.real) for root in roots if abs(root.imag) < 1e-9 and 0.0 < root.real < 1.0)
    return float((1.0 - 0.5 * xi) / np.sqrt(1.0 - xi))


def numbers(tables: Tables) -> list[Row]:
    """The text's statements on C : S, the number of modes, and close pairs."""
    ratio, many, _ = _ratios(tables)
    pure, highest = ratio[many >= 10], many >= 0.75 * many.max()
    rows: list[Row] = []
    for index in (0, 1):
        orders, signed = _lowest(tables, index)
        even = _larger(signed)
        what = f"C : |S| or |S| : C for l = {index}, n = {orders[0]} to {orders[-1]}, median (range)"
        middle, least, greatest = (written(of(even), 3) for of in (np.median, np.min, np.max))
        rows.append((what, "≃ 1", NONE, f"{middle} ({least} to {greatest})"))
    order, radial, tangential = (float(column[0]) for column in tables["surface"].values())
    what = f"C : |S| for l = 0, n = {order:.0f} (Rayleigh’s surface wave: {written(_surface_wave())})"
    rows += [
        (what, NONE, NONE, written(radial / abs(tangential))),
        ("C : |S| or |S| : C for l ≥ 10 n, n = 3 to 5, median", "> 10", NONE, written(np.median(pure), 3)),
        ("share above 10 of the modes with l ≥ 10 n", "“typically”", NONE, f"{100 * np.mean(pure > 10):.0f} %"),
        (
            f"C : |S| or |S| : C for the highest l (l ≥ {0.75 * many.max():.0f} n), median", "> 100", NONE,
            written(np.median(ratio[highest]), 3),
        ),
        (
            "share above 100 of the modes with the highest l", "“exceeding 1:100”", NONE,
            f"{100 * np.mean(ratio[highest] > 100):.0f} %",
        ),
    ]  # fmt: skip
    count = tables["count"]
    for omega, modes in zip(count["omega[c/R]"], count["modes"]):
        leading = (1 + POISSON) * (3 - POISSON) * omega**2 / 8
        rows.append((f"modes up to ω = {omega:g} c/R (leading term {leading:.0f})", NONE, NONE, f"{modes}"))
    gap = tables["gap"]
    k = np.argmin(gap["least_gap[c/R]"])
    what = f"closest pair of one order, n ≤ 20, ω ≤ {gap['cutoff[c/R]'][0]:g} c/R: distance in c/R"
    rows.append((what, "“very closely spaced”", NONE, f"{gap['least_gap[c/R]'][k]:.5f} (n = {gap['order'][k]})"))
    return rows


def meaning(tables: Tables) -> str:
    """What the figure says."""
    ratio, many, next_one = _ratios(tables)
    mixed = (many >= 10) & (ratio <= 10)
    highest = ratio[many >= 0.75 * many.max()]
    gap = tables["gap"]["least_gap[c/R]"].min()
    (_, even), (orders, signed) = _lowest(tables, 0), _lowest(tables, 1)
    uneven = _larger(signed)
    turn = int(np.argmax(np.diff(np.sign(signed)) != 0))  # C ≥ 0, so this is the sign of S
    return (
        "The text’s account of the spectrum holds only in part. Of the modes with l ≥ 10 n, "
        f"{100 * np.mean(ratio[many >= 10] > 10):.0f} % are purer than 10 : 1; each of the others has a neighbour "
        f"within {next_one[mixed].max():.2f} c/R, with which it mixes, at a mean distance of {_mean_distance():.2f} "
        f"c/R. Of those with the highest l, {100 * np.mean(highest > 100):.0f} % are purer than 100 : 1. For small l "
        "the paper calls the difference between the magnitudes of C and S “small”. For l = 0 and n from "
        f"{orders[0]} on they differ by a factor of {_larger(even).min():.2f} to {_larger(even).max():.2f}, which "
        f"tends to the {_surface_wave():.2f} of Rayleigh’s surface wave; for l = 1 by {uneven.min():.1f} to "
        f"{uneven.max():.0f}, since S passes through zero between n = {orders[turn]} and {orders[turn + 1]}. The "
        f"closest pair of frequencies is {gap:.3f} c/R apart: a search in even steps would miss it, the exact count "
        "does not."
    )


def _mean_distance() -> float:
    """Of all modes of one order for l ≫ n, from the speeds of pressure and shear waves."""
    return float(np.pi / (np.sqrt(1 - POISSON**2) + np.sqrt(2 * (1 + POISSON))))
