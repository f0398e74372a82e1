"""The two limits of Gerl and Zippelius."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from stoss._arguments import instance
from stoss.results._extrapolation import Extrapolation
from stoss.plot import _style


def extrapolation(result: Extrapolation, ax: Axes | None = None) -> Axes:
    """1 − ε² against 1/α for each cutoff, with the straight lines to the hard wall, 1/α = 0.

    At 1/α = 0 stand the values that the lines reach, with the errors of the regressions, and a star
    for the limit of all modes.

    Parameters
    ----------
    result : Extrapolation
    ax : Axes, optional
        Where to draw.

    Returns
    -------
    Axes

    Examples
    --------
    >>> found = stoss.extrapolated_restitution(poisson=0.33, speed=0.1, cutoffs=[12, 15, 19])
    >>> ax = stoss.plot.extrapolation(found)
    >>> ax.get_xlabel()
    'inverse hardness 1/(αR)'
    """
    instance("result", result, (Extrapolation,))
    cutoffs = np.unique(result.impacts["cutoff"])
    with _style.canvas(ax, size=(_style.COLUMN, 2.8)) as axes:
        axes.set_xlabel("inverse hardness 1/(αR)")
        axes.set_ylabel("lost fraction 1 − ε²")
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
