"""ε(v) as a function, ε of pairs of several ratios of radii, and the two limits of Gerl and Zippelius."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
import numpy as np
from numpy.typing import ArrayLike

from stoss._arguments import numbers
from stoss.bodies._bodies import Body, speed_unit
from stoss.plot import _style
from stoss.results._extrapolation import Extrapolation
from stoss.results._function import RestitutionFunction
from stoss.results._pair_table import PairTable

FINE = 12  # points of the curve between computed values


@_style.picture_of(RestitutionFunction, method="plot")
def function(result: RestitutionFunction, ax: Axes | None = None, *, label: str | None = None, **style: Any) -> Axes:
    """ε against speed as a curve in a band of its error, with the computed values and their bars."""
    knots = result.knots
    between = [np.geomspace(low, high, FINE, endpoint=False) for low, high in zip(knots["speed"], knots["speed"][1:])]
    speed = np.clip(np.append(np.concatenate(between), knots["speed"][-1]), *result.range)
    value, error = result(speed), result.error(speed)
    with _style.canvas(ax, **_axes_of(result.body)) as axes:
        color = _style.COLORS[len(axes.lines) // 2 % len(_style.COLORS)]
        (line,) = axes.plot(speed, value, **{"color": color, "label": label, "linewidth": 0.9} | style)
        axes.fill_between(speed, value - error, value + error, alpha=0.3, color=line.get_color(), linewidth=0.0)
        axes.errorbar(
            knots["speed"], knots["restitution"], yerr=knots["error"], color=line.get_color(), linestyle="none",
            marker="o", markersize=1.8, capsize=1.2, elinewidth=0.6,
        )  # fmt: skip
        axes.ticklabel_format(axis="y", useOffset=False)
        if label is not None:
            _style.legend(axes)
    return axes


def _axes_of(body: Body) -> dict[str, Any]:
    named = _style.speed_label(body.material, "speed of approach v")
    return {"xscale": "log", "xlabel": named, "ylabel": "restitution ε"}


POINTS = 600
USUAL = 5  # ratios that are drawn if none are named


@_style.picture_of(PairTable, method="plot")
def pair_table(table: PairTable, ax: Axes | None = None, *, ratio: ArrayLike | None = None, **style: Any) -> Axes:
    """ε against speed for several ratios of radii, each in a band of its error.

    Parameters
    ----------
    ratio : array_like, optional
        Default: five, evenly in (r − 1)/(r + 1) over the range.

    Examples
    --------
    >>> table = stoss.pair_table(poisson=0.33, ratio=(1, 1.5), speed=(0.02, 0.3), error=2e-2)
    >>> ax = stoss.plot.pair_table(table, ratio=[1, 1.5])
    """
    ends = (table.ratio[[0, -1]] - 1) / (table.ratio[[0, -1]] + 1)
    places = np.linspace(float(ends[0]), float(ends[1]), USUAL)
    usual = np.clip((1 + places) / (1 - places), table.ratio[0], table.ratio[-1])
    chosen = usual if ratio is None else numbers("ratio", ratio).ravel()
    unit = speed_unit(table.body)
    speed = np.clip(np.geomspace(table.speed[0], table.speed[-1], POINTS), table.speed[0], table.speed[-1]) * unit
    if table.body.material is not None:  # rounded inwards
        speed = np.clip(speed, np.nextafter(speed[0], np.inf), np.nextafter(speed[-1], 0.0))
    with _style.canvas(ax, **_axes_of(table.body)) as axes:
        for each in chosen:
            value, error = table(speed, each), table.error(speed, each)
            color = _style.COLORS[len(axes.lines) % len(_style.COLORS)]
            look = {"color": color, "label": f"ratio {each:.3g}", "linewidth": 1.0} | style
            (line,) = axes.plot(speed, value, **look)
            axes.fill_between(speed, value - error, value + error, alpha=0.3, color=line.get_color(), linewidth=0.0)
        axes.ticklabel_format(axis="y", useOffset=False)
        _style.legend(axes)
    return axes


@_style.picture_of(Extrapolation, method="plot")
def extrapolation(result: Extrapolation, ax: Axes | None = None) -> Axes:
    """1 − ε² against 1/α for each cutoff, with the straight lines to the hard wall, 1/α = 0.

    At 1/α = 0 stand the values that the lines reach, with the errors of the regressions, and a star
    for the limit of all modes.
    """
    cutoffs = np.unique(result.impacts["cutoff"])
    look = {"xlabel": "inverse hardness 1/(αR)", "ylabel": "lost fraction 1 − ε²"}
    with _style.canvas(ax, size=(_style.COLUMN, 2.8), **look) as axes:
        axes.locator_params(axis="x", nbins=5)
        for k, (cutoff, at_zero) in enumerate(zip(cutoffs, result.hard_wall)):
            n = k % len(_style.COLORS)
            color, marker = _style.COLORS[n], _style.MARKERS[n]
            series = result.impacts[result.impacts["cutoff"] == cutoff]
            x, y = 1.0 / series["hardness"], series["lost_fraction"]
            # Points of equal weight: the regression goes through their centre.
            slope = (y.mean() - at_zero["value"]) / x.mean()
            ends = np.array([0.0, x.max()])
            axes.plot(ends, at_zero["value"] + slope * ends, color=color, linestyle=_style.LINES[n])
            name = f"{series['modes'][0]} modes"
            axes.plot(x, y, color=color, marker=marker, linestyle="none", label=name)
            hollow = {"marker": marker, "markerfacecolor": "white"}
            axes.errorbar(0.0, at_zero["value"], at_zero["error"], color=color, capsize=2.0, **hollow)
        axes.errorbar(
            0.0, result.lost_fraction, result.lost_fraction_error, color=_style.BLACK, marker="*", markersize=8.0,
            capsize=3.0, linestyle="none", label="all modes", zorder=3.0,
        )  # fmt: skip
        _style.legend(axes)
    return axes
