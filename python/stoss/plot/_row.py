"""Bodies on a line: velocities before and after, and forces in space and time."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator
import numpy as np
from numpy.typing import NDArray

from stoss.bodies._bodies import Disk
from stoss.rows._line import fastest
from stoss.plot import _style
from stoss.rows._row import Row
from stoss.rows._row_impact import RowImpact

Array = NDArray[np.float64]

NAMED = 5  # bodies that a legend can name
SHOWN = 1.2  # of the time until the last contact ends
MANY = 30  # bars with a width of their own


@_style.picture_of(Row, method="plot")
def row(result: Row, ax: Axes | None = None) -> Axes:
    """Velocities of each body before and after, with error bars; of several cases those after against the speed.

    Bodies are numbered from the left, from 0. With several cases there is a curve for each body: its
    velocity after over the greatest difference of speeds before, against this difference, or against
    the number of the case where all have the same.

    Examples:
        >>> ax = stoss.plot.row(stoss.row([stoss.Sphere(poisson=0.3)] * 3, speed=[0.1], tolerance=1e-2))
        >>> ax.get_xlabel(), ax.get_ylabel()
        ('body', 'velocity / c')
    """
    with _style.canvas(ax) as axes:
        if result.velocities.ndim > 1:
            _draw_cases(axes, result)
        else:
            _draw_bars(axes, result)
    return axes


def _draw_bars(axes: Axes, result: Row) -> None:
    number = np.arange(result.velocities.size)
    few = number.size <= MANY
    wide = 0.4 if few else 0.5
    look: dict[str, Any] = {"linewidth": 0.6 if few else 0.0, "edgecolor": _style.BLACK}
    axes.bar(number - 0.5 * wide, result.velocities, wide, color="0.8", label="before", **look)
    error = np.where(np.isfinite(result.velocities_after_error), result.velocities_after_error, 0.0)
    bars: dict[str, Any] = {"ecolor": _style.VERMILION, "capsize": 2.0 if few else 0.0, "error_kw": {"elinewidth": 1.0}}
    look |= bars | {"color": _style.BLUE, "label": "after"}
    axes.bar(number + 0.5 * wide, result.velocities_after, wide, yerr=error, **look)
    axes.axhline(0.0, color=_style.BLACK, linewidth=0.6)
    axes.xaxis.set_major_locator(MaxNLocator(integer=True, nbins=10))
    axes.set(xlabel="body", ylabel=_style.speed_label(result.material, "velocity"))
    axes.margins(y=0.12)
    _above(axes, ncol=2)


def _draw_cases(axes: Axes, result: Row) -> None:
    scale = fastest(result._line(), result.velocities)
    order = np.argsort(scale, kind="stable")
    differ = np.unique(scale).size > 1
    at = scale[order] if differ else np.arange(scale.size, dtype=np.float64)
    count = result.velocities.shape[1]
    unit = np.where(scale > 0.0, scale, 1.0)[order]
    for b in range(count):
        after, error = (each[order, b] / unit for each in (result.velocities_after, result.velocities_after_error))
        color, line = (_style.COLORS[b], _style.LINES[b]) if count <= NAMED else (_shade(b, count), "-")
        style: dict[str, Any] = {"color": color, "linestyle": line, "marker": _style.MARKERS[b % len(_style.MARKERS)]}
        error = np.where(np.isfinite(error), error, 0.0)
        axes.errorbar(at, after, yerr=error, label=_name(b, count), markersize=2.5, capsize=1.5, **style)
    axes.axhline(0.0, color=_style.GREY, linewidth=0.6, zorder=0)
    if differ and scale[scale > 0.0].size and scale.max() / scale[scale > 0.0].min() > 5.0:
        axes.set_xscale("log")
    name = "greatest difference of speeds"
    axes.set_xlabel(_style.speed_label(result.material, name) if differ else "case")
    axes.set_ylabel("velocity after / that difference" if differ else "velocity after / difference of speeds")
    _above(axes, ncol=min(count, NAMED))


@_style.picture_of(RowImpact, method="plot")
def row_impact(result: RowImpact, ax: Axes | None = None) -> Axes:
    """A row in time, in two pictures inside the Axes, its `child_axes`.

    Above, the velocities of the bodies. Below, the space-time diagram of the forces: time runs to
    the right, contacts are one above the other from the left end of the row to its right one, and
    colours are forces. Bodies are numbered from the left, from 0, and a contact lies between its two.

    Examples:
        >>> ax = stoss.plot.row_impact(stoss.row_impact([stoss.Sphere(poisson=0.3)] * 3, speed=[0.1]))
        >>> [each.get_ylabel() for each in ax.child_axes[:2]]
        ['velocity / c', 'body']
    """
    with _style.canvas(ax, size=(_style.COLUMN, 3.8)) as axes:
        upper, lower = _style.panels(axes, {"velocity": (0.55, 0.45), "force": (0.0, 0.48)})
        count = result.velocity.shape[1]
        for b in range(count):
            color, line = (_style.COLORS[b], _style.LINES[b]) if count <= NAMED else (_shade(b, count), "-")
            look = {"color": color, "linestyle": line, "linewidth": 1.2 if count <= NAMED else 0.8}
            upper.plot(result.time, result.velocity[:, b], label=_name(b, count), **look)
        upper.axhline(0.0, color=_style.GREY, linewidth=0.6, zorder=0)
        upper.set_ylabel(f"velocity / {result._unit('velocity')}")
        _above(upper, ncol=min(count, NAMED))
        _draw_forces(lower, result)
        upper.set_xlim(lower.get_xlim())
    return axes


def _draw_forces(axes: Axes, result: RowImpact) -> None:
    count, first = result.force.shape[1], 0 if result.before is None else -1
    time = result.time
    edges = np.concatenate((time[:1], 0.5 * (time[1:] + time[:-1]), time[-1:]))
    across = first + np.arange(count + 1, dtype=np.float64)
    top = float(result.force.max(initial=0.0))
    look: dict[str, Any] = {"cmap": "magma_r", "vmin": 0.0, "vmax": top or 1.0, "rasterized": True}
    mesh = axes.pcolormesh(edges, across, result.force.T, **look)
    if count <= MANY:
        axes.hlines(across, time[0], time[-1], color="0.75", linewidth=0.5)
    last = float(np.nanmax(result.contacts["last_touch"])) if np.isfinite(result.contacts["last_touch"]).any() else 0.0
    axes.set(xlim=(time[0], min(float(time[-1]), SHOWN * last) or time[-1]), ylim=(across[0], across[-1]))
    axes.yaxis.set_major_locator(MaxNLocator(integer=True, nbins=8))
    axes.set_xlabel(f"time t / ({result._unit('time')})")
    axes.set_ylabel("body")
    bar = axes.inset_axes((1.03, 0.0, 0.03, 1.0), label="colours")
    axes.figure.colorbar(mesh, cax=bar)
    unit = "πRE" if isinstance(result.body, Disk) else result._unit("force").replace("^2", "²")
    bar.set_ylabel(f"force F / ({unit})", size=axes.yaxis.label.get_size())
    _style.small_ticks(bar)


def _name(number: int, count: int) -> str | None:
    """In the legend: each of a few bodies, of many the first and the last."""
    if count > NAMED:
        return f"body {number}" if number in (0, count - 1) else None
    return f"body {number}" if number == 0 or count <= 3 else f"{number}"


def _shade(number: int, count: int) -> Any:
    """From the first body to the last."""
    from matplotlib import colormaps

    return colormaps["viridis"](0.9 * number / max(count - 1, 1))


def _above(axes: Axes, **options: Any) -> None:
    """A legend in a row above the picture, where no curve is."""
    look = {"loc": "lower center", "columnspacing": 0.9, "handlelength": 1.6, "handletextpad": 0.4}
    _style.above(axes, **look | options)
