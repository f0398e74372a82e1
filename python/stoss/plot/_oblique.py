"""What oblique impacts do to the motion along the surface, and where the energy is, against the angle of incidence."""

from __future__ import annotations

import itertools
from typing import Any

from matplotlib.axes import Axes
import numpy as np
from numpy.typing import NDArray

from stoss._errors import InvalidInput
from stoss.plot import _style
from stoss.plot._modes import HATCHES
from stoss.results._oblique import ObliqueRestitution
from stoss.results._oblique_impact import ObliqueImpact

LABELS = {"angle": "angle of incidence (degrees)", "sliding": "sliding speed $s/(\\mu v_n)$"}
NAMES = {"speed": "v", "friction": "μ", "spin": "Ω", "second_spin": "Ω₂"}
NAMED = 7  # curves that a legend can hold


@_style.picture_of(ObliqueRestitution, method="plot")
def oblique(result: ObliqueRestitution, ax: Axes | None = None, *, over: str = "angle", **style: Any) -> Axes:
    """ε_t with error bars and, thin and grey, ε_n, a curve for each speed, friction and spin.

    Values that did not converge are hollow; where nothing slides before there is no ε_t. Speeds are
    in c, or in m/s if the result has a material, and spins in c/R or in rad/s.

    Parameters:
        over ({'angle', 'sliding'}): The horizontal axis: the angle between the velocity of the
            centre and the normal, or the sliding speed s over μv_n.
        **style: Handed on to `matplotlib.axes.Axes.errorbar`: color, marker, linestyle, …

    Examples:
        >>> fan = stoss.oblique(stoss.Sphere(poisson=0.3), speed=0.01, angle=np.linspace(2, 80, 14), friction=0.1)
        >>> ax = stoss.plot.oblique(fan, over="sliding")
    """
    _style.choice("over", over, tuple(LABELS))
    flat = {name: np.asarray(getattr(result, name)).ravel() for name in (*NAMES, "converged", "restitution")}
    place = _places(result, over)
    value, error = (np.asarray(getattr(result, f"tangential_restitution{end}")).ravel() for end in ("", "_error"))
    told = [name for name in NAMES if np.unique(flat[name]).size > 1]
    groups = np.unique(np.stack([flat[name] for name in NAMES], axis=1), axis=0)
    with _style.canvas(ax, xlabel=LABELS[over], ylabel="restitution") as axes:
        every = -(-len(groups) // NAMED)
        for k, group in enumerate(groups):
            same = np.all([flat[name] == its for name, its in zip(NAMES, group)], axis=0) & np.isfinite(place)
            order = np.flatnonzero(same)
            order = order[np.argsort(place[order], kind="stable")]
            slides = order[np.isfinite(error[order])]
            n = k % len(_style.COLORS)
            look = {"color": _style.COLORS[n], "marker": _style.MARKERS[n], "linestyle": _style.LINES[n]}
            name = ", ".join(_named(result, each, its) for each, its in zip(NAMES, group) if each in told)
            label = f"$\\varepsilon_t$, {name}" if name else "$\\varepsilon_t$"
            shown = {"label": label if k % every == 0 else None, "capsize": 1.5}
            line = axes.errorbar(place[slides], value[slides], yerr=error[slides], **look | shown | style).lines[0]
            normal = "$\\varepsilon_n$" if k == 0 else None
            axes.plot(place[order], flat["restitution"][order], color=_style.GREY, linewidth=0.8, label=normal)
            doubtful = slides[~flat["converged"][slides].astype(bool)]
            if doubtful.size:
                hollow = {"linestyle": "none", "markerfacecolor": "white", "zorder": 3}
                axes.plot(place[doubtful], value[doubtful], marker="o", color=line.get_color(), **hollow)
        _style.legend(axes)
    return axes


def _places(result: ObliqueRestitution, over: str) -> NDArray[np.float64]:
    if over == "angle":
        return np.asarray(result.angle).ravel()
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.ravel(np.asarray(result.sliding) / (np.asarray(result.friction) * np.asarray(result.speed)))


def _named(result: ObliqueRestitution, name: str, value: float) -> str:
    """The value of a curve, as in v = 0.1 c."""
    dimension = result._dimensions()[name]
    if not dimension:
        return f"{NAMES[name]} = {_style.written(value)}"
    in_si = result.material is not None
    scale = getattr(result.body.scales, dimension) if in_si else 1.0
    unit = result._unit(f"{name}_si" if in_si else name)
    return f"{NAMES[name]} = {_style.written(value * scale)} {unit}"


ENTRIES = {
    "translation": "translation, normal", "across": "translation, along", "rotation": "rotation",
    "second_rotation": "rotation of the second", "vibration": "vibration",
    "second_vibration": "vibration of the second", "dissipated": "lost to the material", "friction": "friction",
    "unresolved": "unresolved", "stored": "stored",
}  # fmt: skip
LEAST, THIN = 1e-4, 2e-3  # what is less in one impact, or in all of several, is left out


@_style.picture_of(ObliqueImpact, ObliqueRestitution)
def oblique_ledger(result: ObliqueImpact | ObliqueRestitution, ax: Axes | None = None) -> Axes:
    """Where the energy is after an oblique impact, as bars; of several, one above the other against the angle.

    Entries below 10⁻⁴, of several below 0.002 everywhere, are left out.

    Examples:
        >>> ball = stoss.Sphere(poisson=0.3)
        >>> ax = stoss.plot.oblique_ledger(stoss.oblique_impact(ball, speed=0.05, angle=40, friction=0.3))
        >>> fan = stoss.oblique(ball, speed=0.05, angle=np.linspace(0, 80, 30), friction=0.3)
        >>> ax = stoss.plot.oblique_ledger(fan)
    """
    entries = {name: np.asarray(share) for name, share in result.energy.entries().items()}
    shape = entries["translation"].shape
    if len(shape) > 1 or 0 in shape:
        raise InvalidInput.out_of_range(
            "result", f"shape {shape}", "one impact or a row of them", "select one, as result[0]"
        )
    least = LEAST if not shape else THIN
    kept = {ENTRIES[name]: share for name, share in entries.items() if np.nanmax(np.abs(share), initial=0.0) > least}
    if not shape:
        return _bars(ax, {name: float(share) for name, share in kept.items()})
    order = np.argsort(np.asarray(result.angle), kind="stable")
    look = {"xlabel": LABELS["angle"], "ylabel": "energy / initial energy"}
    with _style.canvas(ax, size=(_style.COLUMN, 3.0), **look) as axes:
        angles, looks = np.asarray(result.angle)[order], itertools.cycle(zip(_style.COLORS, HATCHES))
        shares = zip(kept.items(), looks)
        _style.stacked(axes, angles, ((share[order], *look, name) for (name, share), look in shares))
        axes.set_xlim(angles[0], angles[-1])
        axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=2, frameon=False, handlelength=1.6)
    return axes


def _bars(ax: Axes | None, shares: dict[str, float]) -> Axes:
    with _style.canvas(ax, xlabel="energy / initial energy", size=(_style.COLUMN, 2.0)) as axes:
        places = np.arange(len(shares))[::-1]
        axes.barh(places, list(shares.values()), color=_style.BLUE, height=0.7)
        for place, share in zip(places, shares.values()):
            axes.annotate(_style.written(share, 3), (share, place), (3, 0), textcoords="offset points", va="center")
        axes.set_yticks(places, list(shares))
        axes.set_xlim(0.0, 1.3 * max(shares.values(), default=1.0))
    return axes
