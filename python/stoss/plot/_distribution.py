"""How the coefficient of restitution of bodies that vibrate is distributed."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes

from stoss._arguments import instance
from stoss.bodies._bodies import speed_unit
from stoss.results._distribution import RestitutionDistribution
from stoss._errors import NotConverged
from stoss.results._curves import restitution
from stoss.plot import _style


def distribution(result: RestitutionDistribution, ax: Axes | None = None, *, bins: Any = "auto") -> Axes:
    """Histogram of ε, with its mean and ε of the same bodies, unexcited.

    The latter is computed for the picture.

    Parameters
    ----------
    result : RestitutionDistribution
    ax : Axes, optional
        Where to draw.
    bins : optional
        As `numpy.histogram` has them.

    Returns
    -------
    Axes

    Examples
    --------
    >>> warm = stoss.restitution_distribution(poisson=0.33, speed=0.1, temperature=0.02, samples=50)
    >>> ax = stoss.plot.distribution(warm)
    >>> ax.get_xlabel(), ax.get_ylabel()
    ('restitution ε', 'samples')
    """
    instance("result", result, (RestitutionDistribution,))
    count, edges = result.histogram(bins)
    at_rest = _at_rest(result)
    with _style.canvas(ax) as axes:
        axes.stairs(count, edges, fill=True, facecolor=_style.SKY, edgecolor=_style.BLUE, linewidth=0.6)
        for value, name, look in (
            (result.mean, "mean", {"color": _style.BLACK, "linestyle": "-"}),
            (at_rest, "at rest", {"color": _style.VERMILION, "linestyle": "--"}),
        ):
            axes.axvline(value, ymax=0.86, label=f"{name} {_style.written(value)}", **look)  # below the legend
        axes.set_ylim(0.0, 1.25 * max(1, count.max(initial=1)))
        axes.ticklabel_format(axis="x", useOffset=False)
        axes.locator_params(axis="x", nbins=5)  # numbers near 1 are long
        axes.set_xlabel("restitution ε")
        axes.set_ylabel("samples")
        _style.legend(axes, loc="upper left", ncol=2)
    return axes


def _at_rest(result: RestitutionDistribution) -> float:
    """ε of the bodies when they do not vibrate, as accurate as the samples."""
    speed = result.speed * speed_unit(result.body)
    asked: dict[str, Any] = {"against": result.against, "tolerance": 1e-15, "absolute": result.error}
    try:
        return float(restitution(result.body, speed=speed, **asked).restitution)
    except NotConverged as missed:
        return float(missed.best.restitution)
