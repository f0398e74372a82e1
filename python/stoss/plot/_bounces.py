"""A sequence of impacts: ε, and where the energy is."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from stoss._arguments import instance, refusal
from stoss.results._bounce import Bounces
from stoss.results._impact import Impact
from stoss.plot import _style

PARTS = {  # from below, told apart without colour by how dark they are
    "translation": ("translation", "#08519c"),
    "vibration": ("vibration", "#6baed6"),
    "dissipated": ("dissipated", "#fdd0a2"),
    "unresolved": ("above the cutoff", "0.75"),
}
SPEEDS = 12  # at which the unexcited body is computed
MARKED = 60  # impacts whose markers do not run together in one column


def bounces(result: Bounces, ax: Axes | None = None) -> Axes:
    """ε of each impact and that of the unexcited body, and below it where the energy is.

    The line is ε(v) of single impacts of the same cutoff at the speeds of the sequence. Energies
    are those after each impact, as shares of the initial energy of the first, from below:
    translation, vibration, dissipated, and what the modes above the cutoff or a half-space have
    taken.

    Parameters
    ----------
    result : Bounces
    ax : Axes, optional
        Where to draw, of `matplotlib.pyplot.subplots`; its lower half becomes an Axes of its own.

    Returns
    -------
    Axes
        The upper one. The lower one is the last of its figure.

    Examples
    --------
    >>> ax = stoss.bounce(poisson=0.33, speed=0.2, count=20, flight_time=30, cutoff=8).plot()
    >>> ax.get_ylabel(), ax.figure.axes[-1].get_ylabel()
    ('restitution ε', 'energy / initial')
    """
    instance("result", result, (Bounces,))
    if len(result) == 0:
        raise refusal("result", result, "a sequence of at least one impact")
    with _style.canvas(ax, size=(_style.COLUMN, 4.0)) as axes:
        place = getattr(axes, "get_subplotspec", lambda: None)()  # before matplotlib 3.7 only subplots have it
        if place is None:
            raise refusal("ax", ax, "an Axes of pyplot.subplots, of which the lower half can be taken")
        upper_place, lower_place = place.subgridspec(2, 1, hspace=0.06)
        axes.set_subplotspec(upper_place)
        lower = axes.figure.add_subplot(lower_place, sharex=axes)
        if ax is None:
            _style.small_ticks(lower)
        rest = _at_rest(result)
        look = {"marker": ".", "linestyle": "none"} if len(result) > MARKED else {"marker": "o", "linestyle": "none"}
        axes.plot(result.number, rest, color=_style.BLACK, label="unexcited", zorder=3)
        axes.plot(result.number, result.restitution, color=_style.VERMILION, label="impact", **look)
        axes.set_ylabel("restitution ε")
        axes.tick_params(labelbottom=False)
        axes.ticklabel_format(axis="y", useOffset=False)
        _style.legend(axes)

        shown = {name: each for name, each in PARTS.items() if np.any(getattr(result, name) > 0.0)}
        lower.stackplot(
            np.append(result.number - 0.5, result.number[-1] + 0.5),
            [np.append(values, values[-1]) for values in (getattr(result, name) for name in shown)],
            labels=[label for label, _ in shown.values()], colors=[color for _, color in shown.values()],
            step="post", linewidth=0.0,
        )  # fmt: skip
        lower.set_xlim(0.5, float(result.number[-1]) + 0.5)
        lower.set_ylim(0.0, 1.0)
        lower.set_xlabel("impact")
        lower.set_ylabel("energy / initial")
        _style.legend(lower, loc="lower left", handlelength=1.2)
    return axes


def _at_rest(result: Bounces) -> NDArray[np.float64]:
    """ε of the unexcited body at each of the speeds, between some of them by a line."""
    who, speeds = (result.body, result.against), np.unique(result.speed)
    if speeds.size > SPEEDS:
        speeds = np.geomspace(speeds[0], speeds[-1], SPEEDS)
    single = [Impact._made(*who, float(v), result.cutoff, None, None, None, result.tail, None, None).restitution for v in speeds]
    return np.interp(np.log(result.speed), np.log(speeds), single)
