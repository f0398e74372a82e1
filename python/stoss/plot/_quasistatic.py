"""Slow impacts and static contacts."""

from __future__ import annotations

from typing import Any, Iterator, Union

from matplotlib.axes import Axes
import numpy as np
from numpy.typing import NDArray

from stoss.plot import _style
from stoss.quasistatic._hertz import hertz_pressure
from stoss.quasistatic._slow_impact import RayleighEstimate, SlowImpact
from stoss.quasistatic._compression import StaticContact

Slow = Union[SlowImpact, RayleighEstimate]
BEYOND = "beyond perturbation theory"


@_style.picture_of(SlowImpact, method="plot")
def slow_impact(result: SlowImpact, ax: Axes | None = None) -> Axes:
    """Contact time against speed, a curve for each Poisson's ratio.

    Speeds are in c, or in m/s if the result has a material.

    Examples:
        >>> ax = stoss.plot.slow_impact(stoss.quasistatic.slow_impact(poisson=0.33, speed=np.geomspace(1e-8, 0.1, 30)))
        >>> ax.get_xlabel(), ax.get_ylabel()
        ('speed v / c', 'contact time τ / (R/c)')
    """
    with _style.canvas(ax, **_speed_axis(result), ylabel="contact time τ / (R/c)") as axes:
        for speed, where, look in _curves(result, axes):
            axes.plot(speed, np.ravel(result.contact_time)[where], **look)
        _style.legend(axes)
    return axes


@_style.picture_of(RayleighEstimate, method="plot")
def rayleigh(result: RayleighEstimate, ax: Axes | None = None) -> Axes:
    """Rayleigh's estimate of 1 − ε² against speed, with a band for its error.

    Speeds are in c, or in m/s if the result has a material. Values beyond perturbation theory are
    hollow circles without a band.

    Examples:
        >>> ax = stoss.plot.rayleigh(stoss.quasistatic.rayleigh(poisson=0.33, speed=np.geomspace(1e-8, 0.01, 30)))
        >>> ax.get_xlabel(), ax.get_ylabel()
        ('speed v / c', 'lost fraction 1 − ε²')
    """
    with _style.canvas(ax, **_speed_axis(result), yscale="log", ylabel="lost fraction 1 − ε²") as axes:
        lost, error = np.ravel(result.lost_fraction), np.ravel(result.lost_fraction_error)
        beyond = np.ravel(result.beyond_perturbation).astype(bool)
        for speed, where, look in _curves(result, axes):
            (line,) = axes.plot(speed, lost[where], **look)
            good = ~beyond[where]
            value, off = lost[where][good], error[where][good]
            # A logarithmic axis has no place for a lower end below 0: the band then ends below the picture.
            low = np.maximum(value - off, 1e-3 * value)
            axes.fill_between(speed[good], low, value + off, color=line.get_color(), alpha=0.2, linewidth=0.0)
            _hollow(axes, speed[~good], lost[where][~good], line.get_color())
        drawn = [np.min(line.get_ydata()) for line in axes.lines if np.size(line.get_ydata())]
        if drawn:
            axes.set_ylim(bottom=0.3 * min(drawn))
        _style.legend(axes)
    return axes


@_style.picture_of(StaticContact, method="plot")
def static_contact(result: StaticContact, ax: Axes | None = None) -> Axes:
    """Pressure of a static contact along the edge, with that of Hertz' contact of the same force.

    Examples:
        >>> ax = stoss.plot.static_contact(stoss.quasistatic.static_contact(poisson=0.33, compression=0.03))
        >>> [line.get_label() for line in ax.lines]
        ['δ = 0.03 R', 'Hertz']
    """
    touching = slice(0, result.contact_nodes)
    y = np.concatenate((-result.position[touching][::-1], result.position[touching]))
    pressure = np.concatenate((result.pressure[touching][::-1], result.pressure[touching]))
    with _style.canvas(ax, xlabel="position along the edge / R", ylabel="pressure p / E") as axes:
        axes.plot(y, pressure, color=_style.BLUE, label=f"δ = {_style.written(result.compression)} R")
        hertz = np.asarray(hertz_pressure(result.body, force=result.force, y=np.abs(y)))
        axes.plot(y, hertz, color=_style.BLACK, linestyle="--", label="Hertz")
        axes.set_ylim(bottom=0.0)
        _style.legend(axes)
    return axes


def _speed_axis(result: Slow) -> dict[str, Any]:
    return {"xscale": "log", "xlabel": _style.speed_label(result.material)}


def _curves(result: Slow, axes: Axes) -> Iterator[tuple[NDArray[np.float64], NDArray[np.intp], dict[str, Any]]]:
    """For each Poisson's ratio: sorted speeds, where they are in the flat result, and a look."""
    poisson = np.ravel(result.poisson)
    speed = np.ravel(result.speed if result.material is None else result.speed_si)
    before = sum(line.get_label() not in (BEYOND, "_hollow") for line in axes.lines)
    for k, nu in enumerate(np.unique(poisson), start=before):
        where = np.flatnonzero(poisson == nu)
        where = where[np.argsort(speed[where], kind="stable")]
        n = k % len(_style.COLORS)
        look = {"color": _style.COLORS[n], "linestyle": _style.LINES[n], "label": f"ν = {_style.written(nu)}"}
        yield speed[where], where, look | ({"marker": _style.MARKERS[n]} if where.size == 1 else {})


def _hollow(axes: Axes, x: NDArray[np.float64], y: NDArray[np.float64], color: Any) -> None:
    if x.size:
        told = BEYOND in axes.get_legend_handles_labels()[1]
        look = {"marker": "o", "markerfacecolor": "white", "linestyle": "none", "color": color}
        axes.plot(x, y, label="_hollow" if told else BEYOND, **look)
