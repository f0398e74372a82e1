"""ε(v) of pairs of several ratios of radii."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from stoss._arguments import instance, numbers
from stoss.bodies._bodies import speed_unit
from stoss.results._pair_table import PairTable
from stoss.plot import _style

POINTS = 600
USUAL = 5  # ratios that are drawn if none are named


def pair_table(table: PairTable, ax: Axes | None = None, *, ratio: ArrayLike | None = None, **style: Any) -> Axes:
    """ε against speed for several ratios of radii, each in a band of its error.

    Parameters
    ----------
    table : PairTable
    ax : Axes, optional
        Where to draw; further calls with the same Axes add curves.
    ratio : array_like, optional
        Default: five, evenly in (r − 1)/(r + 1) over the range.
    **style
        Handed on to `matplotlib.axes.Axes.plot`: color, linestyle, …

    Returns
    -------
    Axes

    Examples
    --------
    >>> table = stoss.pair_table(poisson=0.33, ratio=(1, 1.5), speed=(0.02, 0.3), error=2e-2)
    >>> ax = stoss.plot.pair_table(table, ratio=[1, 1.5])
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['ratio 1', 'ratio 1.5']
    """
    instance("table", table, (PairTable,))
    ends = (table.ratio[[0, -1]] - 1) / (table.ratio[[0, -1]] + 1)
    places = np.linspace(float(ends[0]), float(ends[1]), USUAL)
    usual = np.clip((1 + places) / (1 - places), table.ratio[0], table.ratio[-1])
    chosen = usual if ratio is None else numbers("ratio", ratio).ravel()
    unit = speed_unit(table.body)
    speed = np.clip(np.geomspace(table.speed[0], table.speed[-1], POINTS), table.speed[0], table.speed[-1]) * unit
    if table.body.material is not None:  # rounded inwards
        speed = np.clip(speed, np.nextafter(speed[0], np.inf), np.nextafter(speed[-1], 0.0))
    with _style.canvas(ax) as axes:
        axes.set_xscale("log")
        for each in chosen:
            value, error = table(speed, each), table.error(speed, each)
            color = _style.COLORS[len(axes.lines) % len(_style.COLORS)]
            look = {"color": color, "label": f"ratio {each:.3g}", "linewidth": 1.0} | style
            (line,) = axes.plot(speed, value, **look)
            axes.fill_between(speed, value - error, value + error, alpha=0.3, color=line.get_color(), linewidth=0.0)
        axes.set_xlabel("speed of approach v / c" if table.body.material is None else "speed of approach v / (m/s)")
        axes.ticklabel_format(axis="y", useOffset=False)
        axes.set_ylabel("restitution ε")
        _style.legend(axes)
    return axes
