"""How chains of rods cool."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from stoss._arguments import instance
from stoss.results._rod_chain import RodChain
from stoss.plot import _style

COOLED = 1e-2  # share of the energy below which t⁻² is drawn


def cooling(chain: RodChain, ax: Axes | None = None) -> Axes:
    """Energies of a chain of rods against time, as shares of the initial one, with a line ∝ t⁻².

    Translation is a solid line, vibration a dashed one, which is left out where vibrations are gone
    at the next collision. The dotted line is the law of late times; there is none while translation
    has more than a hundredth of its energy.

    Parameters
    ----------
    chain : RodChain
    ax : Axes, optional
        Where to draw.

    Returns
    -------
    Axes

    Examples
    --------
    >>> rods = [stoss.Rod(length=length) for length in (1.0, 1.1, 0.9, 1.05)]
    >>> chain = stoss.rod_chain(rods, circumference=40, temperature=1, collisions=200, decay_time=0)
    >>> stoss.plot.cooling(chain).get_xscale()
    'log'
    """
    instance("chain", chain, (RodChain,))
    after = chain.time > 0.0
    time, first = chain.time[after], chain.translation[0] or 1.0
    translation, vibration = chain.translation[after] / first, chain.vibration[after] / first
    with _style.canvas(ax) as axes:
        axes.set_xscale("log")
        axes.set_yscale("log")
        unit = chain._unit("time")
        axes.set_xlabel(f"time ({unit})" if unit else "time")
        axes.set_ylabel("energy / initial energy")
        if time.size:
            axes.plot(time, translation, color=_style.BLUE, label="translation")
            if chain.decay_time != 0.0 and np.any(vibration > 0.0):
                shown = vibration > 1e-6 * translation  # a chain without damping may start with none
                axes.plot(time[shown], vibration[shown], color=_style.VERMILION, linestyle="--", label="vibration")
            late = (translation < COOLED) & (translation > 0.0)
            if translation[-1] < COOLED and np.any(late):
                moment = np.log(time[late])
                law = np.median(np.log(translation[late]) + 2.0 * moment) - 2.0 * moment
                axes.plot(time[late], np.exp(law), color=_style.BLACK, linestyle=":", label="∝ t⁻²")
            _style.legend(axes)
    return axes


def restitution_histogram(chain: RodChain, ax: Axes | None = None) -> Axes:
    """How often each coefficient of restitution occurs in a chain of rods.

    The rare values above the 99.8th percentile are left out. A line marks ε = 1, and the dotted
    one the mean of all.

    Parameters
    ----------
    chain : RodChain
    ax : Axes, optional
        Where to draw.

    Returns
    -------
    Axes

    Examples
    --------
    >>> rods = [stoss.Rod(length=length) for length in (1.0, 1.1, 0.9, 1.05)]
    >>> chain = stoss.rod_chain(rods, circumference=40, temperature=1, collisions=200, decay_time=5)
    >>> stoss.plot.restitution_histogram(chain).get_xlabel()
    'coefficient of restitution ε'
    """
    instance("chain", chain, (RodChain,))
    values = chain.restitution
    with _style.canvas(ax) as axes:
        axes.set_xlabel("coefficient of restitution ε")
        axes.set_ylabel("probability density")
        if values.size:
            top = max(float(np.percentile(values, 99.8)), float(values.min()) + 1e-3)
            bins = int(np.clip(np.sqrt(values.size), 10, 60))
            counts, edges = np.histogram(values, bins=bins, range=(float(values.min()), top))
            axes.stairs(counts / (values.size * np.diff(edges)), edges, fill=True, color=_style.SKY)
            axes.set_ylim(0.0, 1.2 * axes.get_ylim()[1])
            axes.axvline(1.0, color=_style.BLACK, linewidth=0.6)
            axes.axvline(float(values.mean()), color=_style.VERMILION, linestyle=":", label="mean")
            _style.legend(axes)
    return axes
