"""Eigenmodes: the spectrum, the shapes, and how much energy each holds."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
import numpy as np
from numpy.typing import NDArray

from stoss._arguments import integer, number, refusal
from stoss.bodies._bodies import Sphere
from stoss.bodies._walls import UNBOUNDED
from stoss.plot import _disk, _style
from stoss.results._impact import Impact
from stoss.results._modes import Modes


@_style.picture_of(Modes, method="plot")
def spectrum(modes: Modes, ax: Axes | None = None) -> Axes:
    """Eigenfrequencies ω against the order or degree n, radial and tangential modes told apart.

    Radial are those whose surface moves mostly along the radius, ``C > |S|``, of a sphere
    ``U > √(n(n+1)) |V|``.

    Examples:
        >>> ax = stoss.plot.spectrum(stoss.modes(poisson=0.33, cutoff=10))
        >>> ax.get_xlabel(), ax.get_ylabel()
        ('angular order n', 'frequency ω / (c/R)')
    """
    size = 3.5 if len(modes) < 150 else 2.5 if len(modes) < 600 else 1.5
    ball = isinstance(modes.body, Sphere)
    names = ("U > √(n(n+1)) |V|", "U ≤ √(n(n+1)) |V|") if ball else ("C > |S|", "C ≤ |S|")
    kinds = (
        (modes.radial_family, f"radial, {names[0]}", {"color": _style.BLUE, "marker": "o"}),
        (~modes.radial_family, f"tangential, {names[1]}",
         {"color": _style.VERMILION, "marker": "^", "fillstyle": "none"}),
    )  # fmt: skip
    axis = {"xlabel": "degree n" if ball else "angular order n", "ylabel": "frequency ω / (c/R)"}
    with _style.canvas(ax, size=(_style.COLUMN, 2.8), **axis) as axes:
        for where, name, style in kinds:
            look = {"linestyle": "none", "markersize": size, "markeredgewidth": 0.7} | style
            axes.plot(modes.order[where], modes.omega[where], label=name, **look)
        axes.xaxis.get_major_locator().set_params(integer=True)
        axes.set_ylim(bottom=0.0)
        _style.legend(axes, loc="lower right", handlelength=1.0)
    return axes


@_style.picture_of(Modes)
def mode_shape(modes: Modes, ax: Axes | None = None, *, order: int, index: int, amplitude: float = 0.15) -> Axes:
    """Shape of the mode (n, l): a deformed grid over the undeformed outline in grey.

    For a sphere it is the plane through the axis, which is horizontal.

    Parameters:
        amplitude: Maximum displacement in the picture, R, −1 to 1.

    Examples:
        >>> ax = stoss.plot.mode_shape(stoss.modes(poisson=0.33, cutoff=10), order=2, index=0)
    """
    greatest = number("amplitude", amplitude)
    if not abs(greatest) <= 1.0:
        raise refusal("amplitude", amplitude, "-1 to 1 (R)")
    radius, angle = _disk.GRID_RADIUS, _disk.GRID_ANGLE
    u_r, u_phi = modes.displacement(order=order, index=index, radius=radius)
    across, turning = _around(modes, order, angle)
    out = u_r[:, None] * across
    along = u_phi[:, None] * turning
    scale = greatest / np.hypot(out, along).max()
    out, along = radius[:, None] + scale * out, scale * along
    x = out * np.cos(angle) - along * np.sin(angle)
    y = out * np.sin(angle) + along * np.cos(angle)

    reach = 1.05 * max(1.0, float(np.abs(x).max()), float(np.abs(y).max()))
    with _style.canvas(ax, size=(2.6, 2.6)) as axes:
        _disk.draw_outline(axes, *_disk.circle())
        _disk.draw_grid(axes, x, y, radius, angle)
        _disk.frame_axes(axes, _disk.View(-reach, reach, reach))
        omega = modes.omega[modes.find(order, index)]
        axes.set_title(f"(n, l) = ({order}, {index}), ω = {omega:.4g} c/R")
    return axes


def _around(modes: Modes, order: int, angle: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """How the two displacements of a mode vary with the angle: cos nφ and sin nφ, or P_n(cos θ) and its derivative."""
    if not isinstance(modes.body, Sphere):
        return np.cos(order * angle), np.sin(order * angle)
    legendre: Any = np.polynomial.legendre
    x, series = np.cos(angle), [0.0] * order + [1.0]
    return legendre.legval(x, series), -np.sin(angle) * legendre.legval(x, legendre.legder(series))


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
    mode has given what the bar lacks, and taken what is beyond. The waves of a half-space are a
    continuum: one bar is what they hold together. Another, after the impact, is what lossy materials
    have taken.

    Parameters:
        when ({'after', 'average'}): After the impact, or the mean during contact.
        orders, indices: How many n and l from 0 on, 1 to 100 and 1 to 20; modes above the cutoff
            have no bars.

    Examples:
        >>> ax = stoss.plot.ledger(stoss.impact(poisson=0.33, speed=0.1, cutoff=12.5))
    """
    _style.choice("when", when, tuple(LABELS))
    _style.count("orders", orders, 100)
    _style.count("indices", indices, 20)
    if integer("of", of) not in (0, 1):
        raise refusal("of", of, "0 or 1")
    block = impact.against._kind if isinstance(impact.against, UNBOUNDED) else ""
    if of == 1 and block:
        raise refusal("of", of, f"0 (a {block} has no modes (n, l); its energy is shown next to those of the body)")
    heat = impact.dissipated if when == "after" else 0.0
    waves = float(impact.mode_energies[when][impact.mode_energies["body"] == 1].sum()) if block else 0.0
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
            axes.hlines(before["before"], place - half, place + half, color=_style.BLACK, linewidth=1.5, label="before")
        axes.set_yscale("log")
        places, bars = np.unique(modes["order"]), np.append(modes[when], before["before"])
        whole = [each for each in ((block, waves, _style.GREY), ("heat", heat, _style.BLACK)) if each[1] > 0.0]
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
