"""Impacts on exponential walls, the lines through them to the hard wall, and the modes with most energy in them."""

from __future__ import annotations

from typing import Mapping, NamedTuple

import matplotlib
import numpy as np
import stoss
from matplotlib.axes import Axes
from numpy.typing import NDArray

Column = NDArray[np.float64]

POISSON = 0.33
SPEEDS = (0.005, 0.01, *(round(0.02 * k, 2) for k in range(1, 16)))  # c
SCALED = (25.0, 100.0 / 3.0, 50.0, 100.0)  # αv, c/R
COUNTS = (300, 400, 600, 940)  # lowest modes
SLOW = 0.1  # c; up to here three points make a line


class Line(NamedTuple):
    value: float  # at x = 0
    error: float  # 95 %, as that of the slope
    slope: float
    slope_error: float


def walls(speed: float) -> Column:
    """α of the walls whose impacts carry the line, 1/R: at v ≤ 0.1 c the three hardest."""
    return np.array(SCALED[-3:] if speed <= SLOW else SCALED) / speed


def cutoff(count: int, poisson: float = POISSON) -> float:
    """A frequency below which there are `count` modes, c/R: midway between two of them."""
    weyl = np.sqrt(8.0 * (count + 60) / ((1.0 + poisson) * (3.0 - poisson)))
    omega = np.sort(stoss.modes(poisson=poisson, cutoff=weyl).omega)
    return float(0.5 * (omega[count - 1] + omega[count]))


def line(x: Column, y: Column, errors: Column | float = 0.0) -> Line:
    """The line through points of equal weight; its errors contain those of the points."""
    mean, spread = x.mean(), np.sum((x - x.mean()) ** 2)
    slope = float(np.sum((x - mean) * y) / spread)
    intercept = float(y.mean() - slope * mean)
    scatter = np.sqrt(np.sum((y - intercept - slope * x) ** 2) / (len(x) - 2))
    student = 12.706 if len(x) == 3 else 4.303
    in_slope = (x - mean) / spread  # weight of a point
    at_zero, of_slope = (
        float(np.hypot(student * scatter * np.linalg.norm(weight), np.linalg.norm(weight * errors)))
        for weight in (1.0 / len(x) - mean * in_slope, in_slope)
    )
    return Line(intercept, at_zero, slope, of_slope)


def lost_fraction(speed: float, at: float, alpha: float, poisson: float = POISSON) -> float:
    """1 − ε² of one impact with the modes up to the frequency `at`, c/R, on the wall α, 1/R."""
    wall = stoss.ExponentialWall(hardness=float(alpha))
    return stoss.impact(poisson=poisson, speed=speed, cutoff=at, against=wall, tail="none").lost_fraction


class Limits(NamedTuple):
    """ε and 1 − ε² for α → ∞ and N → ∞, with the errors of the regressions."""

    restitution: float
    restitution_error: float
    lost_fraction: float
    lost_fraction_error: float
    hard_wall: tuple[Line, ...]  # 1 − ε² for α → ∞ with the modes of COUNTS


def two_limits(poisson: float, speed: float, hardnesses: Column) -> Limits:
    """The protocol of the paper: 1 − ε² extrapolated in 1/α (figure 7), those limits in 1/√N (figure 8).

    Both lines have equal weights; the errors of the first are carried into that of the second. For −0.9 ≤ ν ≤ 0.995 and
    speeds from 0.005 to 0.5 c the difference from `stoss.restitution` is typically 0.5 % of 1 − ε², the error 3 %, and
    the difference exceeds it in one of a hundred cases. Only the double limit is that of the hard wall: with N modes
    much harder walls make the edge bounce, and 1 − ε² rises by up to a fifth above the first line. Below 0.005 c the
    contact is too narrow for 940 modes. For ν below −0.7 above 0.2 c the wall of `stoss.restitution`, which absorbs
    what the kept modes do not resolve, takes less than this one.
    """
    lines = []
    for count in COUNTS:
        at = cutoff(count, poisson)
        lost = [lost_fraction(speed, at, alpha, poisson) for alpha in hardnesses]
        lines.append(line(1.0 / hardnesses, np.array(lost)))
    hard = np.array([each[:2] for each in lines])
    limit, error, *_ = line(np.array(COUNTS) ** -0.5, hard[:, 0], hard[:, 1])
    value = float(np.sqrt(max(0.0, 1.0 - limit)))
    return Limits(value, error / (float(np.sqrt(value * value + error)) + value), limit, error, tuple(lines))


def colour(speed: float) -> tuple[float, ...]:
    """From dark, slow, to light, fast: viridis without yellow, too light for white paper."""
    return tuple(matplotlib.colormaps["viridis"](0.87 * np.sqrt(speed / 0.3)))


def name_curve(axes: Axes, text: str, x: float, y: float) -> None:
    """A speed at the right end of its curve."""
    axes.annotate(text, (x, y), (4, 0), textcoords="offset points", va="center", fontsize=6.5, color="0.25")


# The paper's choice of modes: ranked by mean energy in a preliminary run with more of them, one at the exponential
# wall (eq. 40) with all modes up to a cutoff. The mean is taken over the contact; the paper does not say which mean.


def ranked(energies: NDArray) -> NDArray[np.intp]:
    """Places of the modes, the most energetic first; of equals the first in the list."""
    return np.argsort(-energies["average"], kind="stable")


def selected_impact(preliminary: stoss.Impact, count: int) -> stoss.Impact:
    """The final run: the same impact, with the `count` modes that rank first in `preliminary`."""
    keep = np.zeros(preliminary.modes, dtype=bool)
    keep[ranked(preliminary.mode_energies)[:count]] = True
    return stoss.impact(
        preliminary.body, speed=preliminary.speed, cutoff=preliminary.cutoff, against=preliminary.against, tail="none",
        keep=keep,
    )  # fmt: skip


def ranked_intercepts(poisson: float, speed: float, pool: int, counts: tuple[int, ...]) -> NDArray:
    """1 − ε² at the hard wall (α → ∞, as in figure 7) and its error: counts × 2.

    With the `counts` modes that rank first in a preliminary run with `pool` modes.
    """
    highest = cutoff(pool, poisson)

    def run(alpha: float, keep: NDArray[np.bool_] | None = None) -> stoss.Impact:
        wall = stoss.ExponentialWall(hardness=float(alpha))
        return stoss.impact(poisson=poisson, speed=speed, cutoff=highest, against=wall, tail="none", keep=keep)

    rank = np.argsort(ranked(run(np.sort(walls(speed))[-2]).mode_energies))
    lost = [[run(alpha, rank < n).lost_fraction for alpha in walls(speed)] for n in counts]
    return np.array([line(1.0 / walls(speed), np.array(of_count))[:2] for of_count in lost])


def place(energies: Mapping[str, NDArray] | NDArray, order: int, index: int) -> int:
    """Row of the mode (n, l) in a list or table."""
    return int(np.flatnonzero((energies["order"] == order) & (energies["index"] == index))[0])
