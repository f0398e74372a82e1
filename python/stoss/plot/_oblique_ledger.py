"""Where the energy is after oblique impacts."""

from __future__ import annotations

from matplotlib.axes import Axes
import numpy as np

from stoss._errors import InvalidInput
from stoss.plot import _style
from stoss.plot._modes import HATCHES
from stoss.plot._oblique import LABELS
from stoss.results._oblique import ObliqueRestitution
from stoss.results._oblique_impact import ObliqueImpact

NAMES = {
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
    kept = {NAMES[name]: share for name, share in entries.items() if np.nanmax(np.abs(share), initial=0.0) > least}
    if not shape:
        return _bars(ax, {name: float(share) for name, share in kept.items()})
    order = np.argsort(np.asarray(result.angle), kind="stable")
    look = {"xlabel": LABELS["angle"], "ylabel": "energy / initial energy"}
    with _style.canvas(ax, size=(_style.COLUMN, 3.0), **look) as axes:
        angles, below = np.asarray(result.angle)[order], np.zeros(order.size)
        for k, (name, share) in enumerate(kept.items()):
            above = below + share[order]
            n = k % len(_style.COLORS)
            hatch = {"hatch": HATCHES[n], "edgecolor": "white", "linewidth": 0.0}
            axes.fill_between(angles, below, above, facecolor=_style.COLORS[n], label=name, **hatch)
            axes.plot(angles, above, color=_style.BLACK, linewidth=0.4)
            below = above
        axes.set(xlim=(angles[0], angles[-1]), ylim=(0.0, 1.0))
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
