"""Eigenmodes: the spectrum and the shapes."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from stoss._arguments import number, refusal
from stoss.bodies._bodies import Sphere
from stoss.plot import _disk, _style
from stoss.results._modes import Modes


@_style.picture_of(Modes, method="plot")
def spectrum(modes: Modes, ax: Axes | None = None) -> Axes:
    """Eigenfrequencies ω against the order or degree n, radial and tangential modes told apart.

    Radial are those whose surface moves mostly along the radius, ``C > |S|``, of a sphere
    ``U > √(n(n+1)) |V|``.

    Examples
    --------
    >>> ax = stoss.plot.spectrum(stoss.modes(poisson=0.33, cutoff=10))
    >>> ax.get_ylabel()
    'frequency ω / (c/R)'
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

    Of a sphere it is the plane through the axis, which is horizontal.

    Parameters
    ----------
    amplitude : float, optional
        Maximum displacement in the picture, R, −1 to 1.

    Examples
    --------
    >>> ax = stoss.plot.mode_shape(stoss.modes(poisson=0.33, cutoff=10), order=2, index=0)
    >>> ax.get_title()
    '(n, l) = (2, 0), ω = 1.439 c/R'
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
