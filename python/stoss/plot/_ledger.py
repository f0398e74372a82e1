"""Which mode holds how much energy."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from stoss._arguments import integer, refusal
from stoss.bodies._blocks import UNBOUNDED
from stoss.bodies._bodies import Disk, Sphere
from stoss.plot import _style
from stoss.results._impact import Impact

LABELS = {"after": "energy after impact / initial", "average": "mean energy in contact / initial"}
HATCHES = ("", "/////", "xxxxx", ".....", "\\\\\\\\\\", "-----", "+++++")
COLUMNS = 4  # of the legend
DECADES = 8.0  # below the maximum bar; what is less is left out


@_style.picture_of(Impact)
def ledger(
    impact: Impact, ax: Axes | None = None, *, when: str = "after", orders: int = 8, indices: int = 4, of: int = 0
) -> Axes:
    """Energy of the modes (n, l), as bars in a group for each n on a logarithmic axis.

    Where the bodies vibrated before the impact, a line over a bar says with how much energy: the
    mode has given what the bar lacks, and taken what is beyond. The waves of a half-space are a continuum: one bar is what they hold together. Another, after
    the impact, is what lossy materials have taken.

    Parameters
    ----------
    when : {'after', 'average'}
        After the impact, or the mean during contact.
    orders, indices : int, optional
        How many n and l from 0 on, 1 to 100 and 1 to 20; modes above the cutoff have no bars.

    Examples
    --------
    >>> ax = stoss.plot.ledger(stoss.impact(poisson=0.33, speed=0.1, cutoff=12.5))
    >>> ax.get_ylabel()
    'energy after impact / initial'
    """
    _style.choice("when", when, tuple(LABELS))
    for name, value, limit in (("orders", orders, 100), ("indices", indices, 20)):
        if not 1 <= integer(name, value) <= limit:
            raise refusal(name, value, f"1 to {limit}")
    if integer("of", of) not in (0, 1):
        raise refusal("of", of, "0 or 1")
    unbounded = isinstance(impact.against, UNBOUNDED)
    if of == 1 and unbounded:
        raise refusal("of", of, "0 (a half-space has no modes (n, l); its energy is shown next to those of the body)")
    heat = impact.dissipated if when == "after" else 0.0
    waves = float(impact.mode_energies[when][impact.mode_energies["body"] == 1].sum()) if unbounded else 0.0
    modes = impact.mode_energies[impact.mode_energies["body"] == of]
    modes = modes[(modes["order"] < orders) & (modes["index"] < indices) & (modes[when] > 0.0)]
    before = modes[(modes["before"] > 0.0) & (when == "after")]

    look = {"xlabel": "degree n" if isinstance(impact.body, Sphere) else "angular order n", "ylabel": LABELS[when]}
    with _style.canvas(ax, size=(_style.COLUMN, 2.7), **look) as axes:
        width = 0.84 / indices
        for index in range(indices):
            chosen = modes[modes["index"] == index]
            if chosen.size == 0:
                continue
            n = index % len(_style.COLORS)
            place = chosen["order"] + (index - 0.5 * (indices - 1)) * width
            axes.bar(
                place, chosen[when], width, color=_style.COLORS[n], edgecolor="white", linewidth=0.0,
                hatch=HATCHES[n], label=f"l = {index}",
            )  # fmt: skip
        if before.size:
            place = before["order"] + (before["index"] - 0.5 * (indices - 1)) * width
            half = 0.6 * width
            axes.hlines(
                before["before"], place - half, place + half, color=_style.BLACK, linewidth=1.5, label="before"
            )
        axes.set_yscale("log")
        places, bars = np.unique(modes["order"]), np.append(modes[when], before["before"])
        name = "half-plane" if isinstance(impact.body, Disk) else "half-space"
        whole = [each for each in ((name, waves, _style.GREY), ("heat", heat, _style.BLACK)) if each[1] > 0.0]
        for k, (label, energy, color) in enumerate(whole):
            last = places[-1] + 1.5 if places.size else 0
            axes.bar(last + k, energy, 0.84, color=color, edgecolor="white", linewidth=0.0, label=label)
            bars = np.append(bars, energy)
        if bars.size:
            top = np.log10(bars.max())
            low = np.floor(max(np.log10(0.7 * bars.min()), top - DECADES))
            rows = -(-(np.unique(modes["index"]).size + bool(before.size) + len(whole)) // COLUMNS)
            head = 0.03 + 0.09 * rows  # of the picture's height, for the legend
            axes.set_ylim(10.0**low, 10.0 ** ((top - head * low) / (1.0 - head)))
            axes.set_xticks(places[:: -(-places.size // 12)] if places.size else [])
            _style.legend(axes, ncol=COLUMNS, loc="upper right", columnspacing=0.8, handlelength=1.2, handletextpad=0.5)
    return axes
