"""Many impacts: sequences, ensembles and chains."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
import numpy as np
from numpy.typing import NDArray

from stoss._arguments import refusal
from stoss._errors import NotConverged
from stoss.plot import _style
from stoss.results._bounce import Bounces
from stoss.results._restitution import restitution
from stoss.results._distribution import RestitutionDistribution
from stoss.results._impact import Impact
from stoss.results._rod_chain import RodChain

PARTS = {  # from below, told apart without colour by how dark they are
    "translation": ("translation", "#08519c"),
    "vibration": ("vibration", "#6baed6"),
    "dissipated": ("dissipated", "#fdd0a2"),
    "unresolved": ("above the cutoff", "0.75"),
}
SPEEDS = 12  # at which the unexcited body is computed
MARKED = 60  # impacts whose markers do not run together in one column


@_style.picture_of(Bounces, method="plot")
def bounces(result: Bounces, ax: Axes | None = None) -> Axes:
    """ε of each impact and that of the unexcited body, and below it where the energy is.

    The line is ε(v) of single impacts of the same cutoff at the speeds of the sequence. Energies
    are those after each impact, as shares of the initial energy of the first, from below:
    translation, vibration, dissipated, and what the modes above the cutoff or a half-space have
    taken.

    Parameters:
        ax: Where to draw, of `matplotlib.pyplot.subplots`; its lower half becomes an Axes of its
            own, the last of its figure.

    Examples:
        >>> ax = stoss.bounce(poisson=0.33, speed=0.2, count=20, flight_time=30, cutoff=8).plot()
        >>> ax.get_ylabel(), ax.figure.axes[-1].get_ylabel()
        ('restitution ε', 'energy / initial')
    """
    if len(result) == 0:
        raise refusal("result", result, "a sequence of at least one impact")
    with _style.canvas(ax, size=(_style.COLUMN, 4.0), ylabel="restitution ε") as axes:
        place = getattr(axes, "get_subplotspec", lambda: None)()  # before matplotlib 3.7 only subplots have it
        if place is None:
            raise refusal("ax", ax, "an Axes of pyplot.subplots, of which the lower half can be taken")
        upper_place, lower_place = place.subgridspec(2, 1, hspace=0.06)
        axes.set_subplotspec(upper_place)
        lower = axes.figure.add_subplot(lower_place, sharex=axes)
        if ax is None:
            _style.small_ticks(lower)
        rest = _single(result)
        look = {"marker": ".", "linestyle": "none"} if len(result) > MARKED else {"marker": "o", "linestyle": "none"}
        axes.plot(result.number, rest, color=_style.BLACK, label="unexcited", zorder=3)
        axes.plot(result.number, result.restitution, color=_style.VERMILION, label="impact", **look)
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
        ends = (0.5, float(result.number[-1]) + 0.5)
        lower.set(xlim=ends, ylim=(0.0, 1.0), xlabel="impact", ylabel="energy / initial")
        _style.legend(lower, loc="lower left", handlelength=1.2)
    return axes


def _single(result: Bounces) -> NDArray[np.float64]:
    """ε of the unexcited body at each of the speeds, between some of them by a line."""
    who, speeds = (result.body, result.against), np.unique(result.speed)
    if speeds.size > SPEEDS:
        speeds = np.geomspace(speeds[0], speeds[-1], SPEEDS)
    single = [Impact._made(*who, float(v), result.cutoff, tail=result.tail).restitution for v in speeds]
    return np.interp(np.log(result.speed), np.log(speeds), single)


@_style.picture_of(RestitutionDistribution, method="plot")
def distribution(result: RestitutionDistribution, ax: Axes | None = None, *, bins: Any = "auto") -> Axes:
    """Histogram of ε, with its mean and ε of the same bodies, unexcited.

    The latter is computed for the picture.

    Parameters:
        bins (optional): As `numpy.histogram` has them.

    Examples:
        >>> warm = stoss.restitution_distribution(poisson=0.33, speed=0.1, temperature=0.02, samples=50)
        >>> ax = stoss.plot.distribution(warm)
        >>> ax.get_xlabel(), ax.get_ylabel()
        ('restitution ε', 'samples')
    """
    count, edges = result.histogram(bins)
    at_rest = _at_rest(result)
    with _style.canvas(ax, xlabel="restitution ε", ylabel="samples") as axes:
        axes.stairs(count, edges, fill=True, facecolor=_style.SKY, edgecolor=_style.BLUE, linewidth=0.6)
        for value, name, look in (
            (result.mean, "mean", {"color": _style.BLACK, "linestyle": "-"}),
            (at_rest, "unexcited", {"color": _style.VERMILION, "linestyle": "--"}),
        ):
            axes.axvline(value, ymax=0.86, label=f"{name} {_style.written(value)}", **look)  # below the legend
        axes.set_ylim(0.0, 1.25 * max(1, count.max(initial=1)))
        axes.ticklabel_format(axis="x", useOffset=False)
        axes.locator_params(axis="x", nbins=5)  # numbers near 1 are long
        _style.legend(axes, loc="upper left", ncol=2)
    return axes


def _at_rest(result: RestitutionDistribution) -> float:
    """ε of the bodies when they do not vibrate, as accurate as the samples."""
    speed = result.speed if result.material is None else result.speed * result.body.scales.speed
    asked: dict[str, Any] = {"against": result.against, "tolerance": 1e-15, "absolute": result.error}
    try:
        return float(restitution(result.body, speed=speed, **asked).restitution)
    except NotConverged as missed:
        return float(missed.best.restitution)


COOLED = 1e-2  # share of the energy below which t⁻² is drawn


@_style.picture_of(RodChain, method="plot")
def cooling(chain: RodChain, ax: Axes | None = None) -> Axes:
    """Energies of a chain of rods against time, as shares of the initial one, with a line ∝ t⁻².

    Translation is a solid line, vibration a dashed one, which is left out where vibrations are gone
    at the next collision. The dotted line is the law of late times; there is none while translation
    has more than a hundredth of its energy.

    Examples:
        >>> rods = [stoss.Rod(length=length) for length in (1.0, 1.1, 0.9, 1.05)]
        >>> chain = stoss.rod_chain(rods, circumference=40, temperature=1, collisions=200, decay_time=0)
        >>> stoss.plot.cooling(chain).get_ylabel()
        'energy / initial energy'
    """
    after = chain.time > 0.0
    time, first = chain.time[after], chain.translation[0] or 1.0
    translation, vibration = chain.translation[after] / first, chain.vibration[after] / first
    name = f"time ({chain._unit('time')})" if chain._unit("time") else "time"
    look: dict[str, Any] = {"xscale": "log", "yscale": "log", "xlabel": name, "ylabel": "energy / initial energy"}
    with _style.canvas(ax, **look) as axes:
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


@_style.picture_of(RodChain, method="histogram")
def restitution_histogram(chain: RodChain, ax: Axes | None = None) -> Axes:
    """How often each coefficient of restitution occurs in a chain of rods.

    The rare values above the 99.8th percentile are left out. A line marks ε = 1, and the dotted
    one the mean of all.

    Examples:
        >>> rods = [stoss.Rod(length=length) for length in (1.0, 1.1, 0.9, 1.05)]
        >>> chain = stoss.rod_chain(rods, circumference=40, temperature=1, collisions=200, decay_time=5)
        >>> stoss.plot.restitution_histogram(chain).get_xlabel()
        'coefficient of restitution ε'
    """
    values = chain.restitution
    with _style.canvas(ax, xlabel="coefficient of restitution ε", ylabel="probability density") as axes:
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
