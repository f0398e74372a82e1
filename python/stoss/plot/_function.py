"""ε(v) as a function."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes

from stoss._arguments import instance
from stoss.results._function import RestitutionFunction
from stoss.plot import _style

FINE = 12  # points of the curve between computed values


def function(result: RestitutionFunction, ax: Axes | None = None, *, label: str | None = None, **style: Any) -> Axes:
    """ε against speed as a curve in a band of its error, with the computed values and their bars.

    Parameters
    ----------
    result : RestitutionFunction
    ax : Axes, optional
        Where to draw; further calls with the same Axes add curves.
    label : str, optional
        Name of the curve.
    **style
        Handed on to `matplotlib.axes.Axes.plot`: color, linestyle, …

    Returns
    -------
    Axes

    Examples
    --------
    >>> epsilon = stoss.restitution_function(poisson=0.33, speed=(0.01, 0.3), error=1e-2)
    >>> ax = stoss.plot.function(epsilon)
    >>> ax.get_xlabel(), ax.get_ylabel()
    ('speed of approach v / c', 'restitution ε')
    """
    instance("result", result, (RestitutionFunction,))
    knots = result.knots
    between = [np.geomspace(low, high, FINE, endpoint=False) for low, high in zip(knots["speed"], knots["speed"][1:])]
    speed = np.clip(np.append(np.concatenate(between), knots["speed"][-1]), *result.range)
    value, error = result(speed), result.error(speed)
    with _style.canvas(ax) as axes:
        axes.set_xscale("log")
        color = _style.COLORS[len(axes.lines) // 2 % len(_style.COLORS)]
        (line,) = axes.plot(speed, value, **{"color": color, "label": label, "linewidth": 0.9} | style)
        look = {"color": line.get_color(), "linewidth": 0.0}
        axes.fill_between(speed, value - error, value + error, alpha=0.3, **look)
        axes.errorbar(
            knots["speed"], knots["restitution"], yerr=knots["error"], color=line.get_color(), linestyle="none",
            marker="o", markersize=1.8, capsize=1.2, elinewidth=0.6,
        )  # fmt: skip
        unit = "c" if result.body.material is None else "(m/s)"
        axes.set_xlabel(f"speed of approach v / {unit}")
        axes.ticklabel_format(axis="y", useOffset=False)
        axes.set_ylabel("restitution ε")
        if label is not None:
            _style.legend(axes)
    return axes
