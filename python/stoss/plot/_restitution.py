"""ε(v) as curves: computed values, functions and pairs of several ratios of radii."""

from __future__ import annotations

from typing import Any, NamedTuple

import matplotlib
from matplotlib.axes import Axes
from matplotlib.container import ErrorbarContainer
import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss._arguments import numbers
from stoss.bodies._bodies import Body, Rod
from stoss.plot import _style
from stoss.results._function import RestitutionFunction
from stoss.results._pair_table import PairTable
from stoss.results._restitution import Restitution


LABELS = {"restitution": "restitution ε", "lost_fraction": "lost fraction 1 − ε²"}
DOUBTFUL = "not converged"
NAMED = 7  # curves that a legend can hold
MARKED = 25  # points of a curve whose markers do not run together in one column


class _Curve(NamedTuple):
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    error: NDArray[np.float64]
    converged: NDArray[np.bool_]
    name: str


@_style.picture_of(Restitution, method="plot")
def restitution(
    result: Restitution,
    ax: Axes | None = None,
    *,
    quantity: str = "restitution",
    scale: str = "log",
    label: str | None = None,
    **style: Any,
) -> Axes:
    """ε or 1 − ε² against speed with error bars, a curve for each Poisson's ratio.

    Speeds are in c, or in m/s if the result has a material. A curve of few points marks them, a
    dense one is a line. Values that did not converge are hollow, values whose error is unknown have
    no bar, missing ones (NaN) are left out.
    If there is only one speed but several Poisson's ratios, they are the horizontal axis.

    Parameters:
        quantity ({'restitution', 'lost_fraction'}):
        scale ({'log', 'linear'}): Scale of the speed, and of the lost fraction with it; ε has a linear
            axis.
        **style: Handed on to `matplotlib.axes.Axes.errorbar`: color, marker, linestyle, …

    Examples:
        >>> curve = stoss.restitution(poisson=[[0.0], [0.33]], speed=np.geomspace(1e-3, 0.3, 8))
        >>> ax = stoss.plot.restitution(curve, quantity="lost_fraction")
    """
    _style.choice("quantity", quantity, tuple(LABELS))
    logarithmic = _style.choice("scale", scale, ("log", "linear")) == "log"
    over_poisson = np.unique(result.speed).size == 1 and np.unique(result.poisson).size > 1
    curves = _over_poisson(result, quantity) if over_poisson else _over_speed(result, quantity)

    with _style.canvas(ax) as axes:
        if over_poisson:
            axes.set_xlabel("2-D Poisson's ratio ν")
        else:
            axes.set_xscale(scale)
            axes.set_xlabel(_style.speed_label(result.material))
        if logarithmic and quantity == "lost_fraction":
            axes.set_yscale("log")
        else:
            axes.set_yscale("linear")
            axes.ticklabel_format(axis="y", useOffset=False)
        axes.set_ylabel(LABELS[quantity])
        before = sum(isinstance(each, ErrorbarContainer) for each in axes.containers)
        every = -(-len(curves) // NAMED)
        for k, curve in enumerate(curves):
            name = curve.name if label is None else label if len(curves) == 1 else f"{label}, {curve.name}"
            look = _look(k, len(curves), before)
            if every > 1:  # too many to be told apart by more than an order of colours
                look |= {"marker": "none", "linestyle": "-"}
            _draw(axes, curve, look, {"label": name if k % every == 0 else None} | style)
        _style.legend(axes)
    return axes


def _values(result: Restitution, name: str) -> NDArray[Any]:
    return np.asarray(getattr(result, name)).ravel()


def _sorted(x: NDArray[Any], where: NDArray[np.bool_], result: Restitution, quantity: str, name: str) -> _Curve:
    value, error = _values(result, quantity), _values(result, f"{quantity}_error")
    kept = np.flatnonzero(where & np.isfinite(x) & np.isfinite(value))
    kept = kept[np.argsort(x[kept], kind="stable")]
    return _Curve(x[kept], value[kept], error[kept], _values(result, "converged")[kept].astype(bool), name)


def _over_speed(result: Restitution, quantity: str) -> list[_Curve]:
    poisson = _values(result, "poisson")
    speed = _values(result, "speed" if result.material is None else "speed_si")
    if isinstance(result.body, Rod):
        return [_sorted(speed, np.full(speed.shape, True), result, quantity, "rod")]
    numbers = {each: f"ν = {_style.written(each)}" for each in np.unique(poisson)}
    return [_sorted(speed, poisson == each, result, quantity, name) for each, name in numbers.items()]


def _over_poisson(result: Restitution, quantity: str) -> list[_Curve]:
    poisson = _values(result, "poisson")
    name = f"v = {_style.written(_values(result, 'speed')[0])} c"
    return [_sorted(poisson, np.full(poisson.shape, True), result, quantity, name)]


def _look(k: int, count: int, before: int) -> dict[str, Any]:
    if count > NAMED:
        return {"color": matplotlib.colormaps["viridis"](0.9 * k / (count - 1))}
    n = (k + before) % len(_style.COLORS)
    return {"color": _style.COLORS[n], "marker": _style.MARKERS[n], "linestyle": _style.LINES[n]}


def _draw(axes: Axes, curve: _Curve, look: dict[str, Any], style: dict[str, Any]) -> None:
    known = np.isfinite(curve.error)  # values without an error have no bar
    bars = {"capsize": 1.5, "elinewidth": 0.8} | ({} if known.all() else {"errorevery": known})
    dense = {"marker": "none", "capsize": 0.0} if curve.x.size > MARKED else {}
    drawn = axes.errorbar(curve.x, curve.y, yerr=curve.error, **bars | look | dense | style)
    if dense:  # bars are hardly to be seen there: the legend shows a line
        drawn.lines[0].set_label(drawn.get_label())
        drawn.set_label("_nolegend_")
    doubtful = ~curve.converged
    if not doubtful.any():
        return
    line = drawn.lines[0]
    marker = "o" if line.get_marker() in (None, "", " ", "none", "None") else line.get_marker()
    told = DOUBTFUL in axes.get_legend_handles_labels()[1]
    axes.plot(
        curve.x[doubtful], curve.y[doubtful], linestyle="none", marker=marker, color=line.get_color(),
        markerfacecolor="white", markersize=line.get_markersize() + 1.5,
        zorder=line.get_zorder() + 0.5, label=None if told else DOUBTFUL,
    )  # fmt: skip


FINE = 12  # points of the curve between computed values


@_style.picture_of(RestitutionFunction, method="plot")
def function(result: RestitutionFunction, ax: Axes | None = None, *, label: str | None = None, **style: Any) -> Axes:
    """ε against speed as a curve in a band of its error, with the computed values and their bars.

    Examples:
        >>> ax = stoss.plot.function(stoss.restitution_function(poisson=0.33, speed=(0.01, 0.3), error=1e-2))
        >>> ax.get_xlabel(), ax.get_ylabel()
        ('speed of approach v / c', 'restitution ε')
    """
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

    Parameters:
        ratio: Default: five, evenly in (r − 1)/(r + 1) over the range.

    Examples:
        >>> table = stoss.pair_table(poisson=0.33, ratio=(1, 1.5), speed=(0.02, 0.3), error=2e-2)
        >>> ax = stoss.plot.pair_table(table, ratio=[1, 1.5])
    """
    ends = (table.ratio[[0, -1]] - 1) / (table.ratio[[0, -1]] + 1)
    places = np.linspace(float(ends[0]), float(ends[1]), USUAL)
    usual = np.clip((1 + places) / (1 - places), table.ratio[0], table.ratio[-1])
    chosen = usual if ratio is None else numbers("ratio", ratio).ravel()
    unit = table._given_unit[1]
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
