"""Stress inside the deformed disk or sphere."""

from __future__ import annotations

from typing import NamedTuple, Sequence

from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.lines import Line2D
import numpy as np
from numpy.typing import NDArray

from stoss._arguments import number, refusal
from stoss.plot import _disk, _ground, _style
from stoss.results._field import Field

Array = NDArray[np.float64]

QUANTITIES = ("von_mises", "principal_difference", "fringes")
COVERED = 0.99  # of the area is within the default colour range
FRINGES = 6.0  # in the default colour range
FINER = {"von_mises": 2, "principal_difference": 2, "fringes": 3}  # interpolated points for each, in each direction


class Scale(NamedTuple):
    """How numbers become colours, the same for all frames of an animation."""

    quantity: str
    limit: float
    fringe: float
    clipped: bool  # whether some stress is above the limit

    @property
    def colors(self) -> str:
        return {"von_mises": "viridis", "principal_difference": "cividis", "fringes": "gray"}[self.quantity]

    @property
    def label(self) -> str:
        if self.quantity == "fringes":
            return f"intensity sin²(π (σ₁ − σ₂)/f), f = {self.fringe:.2g} E"
        return {"von_mises": "von Mises stress / E", "principal_difference": "|σ₁ − σ₂| / E"}[self.quantity]

    @property
    def top(self) -> float:
        return 1.0 if self.quantity == "fringes" else self.limit

    def shown(self, stress: Array) -> Array:
        """What is coloured: the stress, or the light that a polariscope lets through."""
        if self.quantity != "fringes":
            return stress
        return np.asarray(np.sin(np.pi * stress / self.fringe) ** 2)


@_style.picture_of(Field, method="plot")
def stress(
    field: Field,
    ax: Axes | None = None,
    *,
    quantity: str = "von_mises",
    fringe: float | None = None,
    limit: float | None = None,
    frame: int | None = None,
) -> Axes:
    """Stress on the deformed disk or sphere at the wall, or on two, with a colour bar.

    At small speeds stress peaks at the contact, where it is a hundred times that of the rest. So
    the colours end where 99 % of the picture's area is covered; what is above has the last colour,
    and the colour bar a point. Give the maximum stress as `limit` to see the peak instead.

    Parameters:
        ax: Where to draw; the colour bar takes some of its space.
        quantity ({'von_mises', 'principal_difference', 'fringes'}): Von Mises stress, ``|σ₁ −
            σ₂|`` (of a sphere that in the plane), or what a polariscope shows in a dark field,
            sin²(π (σ₁ − σ₂)/fringe).
        fringe: σ₁ − σ₂ from one dark fringe to the next, E; default: a sixth of the default colour
            range of ``|σ₁ − σ₂|``. Fringes closer than the field's points cannot be seen: use finer
            radii and angles.
        limit: Where the colours end, E.

    Examples:
        >>> hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=12.5)
        >>> ax = stoss.plot.stress(hit.field(time=hit.contact_time / 2), quantity="fringes", fringe=0.03)
    """
    bodies = _disk.instants(field, frame)
    scale = scale_of(bodies, quantity, fringe, limit)
    shown = _disk.view([now.field for now in bodies], bodies)
    with _style.canvas(ax, size=_disk.size_for(shown, 2.25)) as axes:
        for now in bodies:
            mesh, _ = draw_stress(axes, now, scale)
        if len(bodies) == 1:
            _ground.draw(axes, field.impact, bodies[0].time, shown.half, shown.right)
        _disk.frame_axes(axes, shown)
        axes.set_title(f"t = {_style.written(bodies[0].time)} R/c")
        draw_bar(axes, mesh, scale)
    return axes


def scale_of(
    instants: Sequence[_disk.Instant], quantity: str, fringe: float | None = None, limit: float | None = None
) -> Scale:
    """The colours for these instants of one impact."""
    _style.choice("quantity", quantity, QUANTITIES)
    for name, value in (("fringe", fringe), ("limit", limit)):
        if value is not None and not 0.0 < number(name, value) < np.inf:
            raise refusal(name, value, "a stress above 0 (E)")
    values = [_stress_of(now.field, quantity)[now.where] for now in instants]
    covering = max(_covering(each, now.field.radius, now.field.angle) for each, now in zip(values, instants))
    if covering <= 0.0:  # no stress at all, as before the first contact
        covering = instants[0].field.impact.max_force
    top = covering if limit is None else float(limit)
    clipped = max(float(each.max()) for each in values) > top
    return Scale(quantity, top, covering / FRINGES if fringe is None else float(fringe), clipped)


def draw_stress(axes: Axes, now: _disk.Instant, scale: Scale, *, smooth: bool = True) -> tuple[QuadMesh, Line2D]:
    """The coloured disk and its edge; if not `smooth`, in pieces of one colour, twice as fast."""
    x, y, values = now.x, now.y, _stress_of(now.field, scale.quantity)[now.where]
    if scale.quantity == "fringes" or not smooth:
        # Colours between points are interpolated; so the stress has to be before it becomes
        # fringes.
        x, y, values = (_finer(each, FINER[scale.quantity]) for each in (x, y, values))
    mesh = axes.pcolormesh(
        x, y, scale.shown(values if smooth else values[:-1, :-1]), cmap=scale.colors, vmin=0.0, vmax=scale.top,
        shading="gouraud" if smooth else "flat", rasterized=True, zorder=1.6,
    )  # fmt: skip
    edge = np.argmax(now.field.radius)
    (line,) = axes.plot(now.x[edge], now.y[edge], color=_style.BLACK, linewidth=0.6, zorder=1.9)
    return mesh, line


def draw_bar(axes: Axes, mesh: QuadMesh, scale: Scale) -> None:
    """The colour bar, with print as small as that of the axes."""
    extend = "max" if scale.clipped and scale.quantity != "fringes" else "neither"
    bar = axes.figure.colorbar(mesh, ax=axes, extend=extend, shrink=0.9, pad=0.03, aspect=22)
    bar.set_label(scale.label, size=axes.xaxis.label.get_size())
    _style.small_ticks(bar.ax, axes.xaxis.get_major_ticks()[0].label1.get_size())


def _stress_of(field: Field, quantity: str) -> Array:
    return field.von_mises if quantity == "von_mises" else field.principal_difference


def _covering(values: Array, radius: Array, angle: Array) -> float:
    """The stress that is not exceeded in 99 % of the area."""
    weight = (radius * np.abs(np.gradient(radius)))[:, None] * np.abs(np.gradient(angle))
    order = np.argsort(values, axis=None)
    share = np.cumsum(weight.ravel()[order])
    k = int(np.searchsorted(share, COVERED * share[-1]))
    return float(values.ravel()[order[min(k, order.size - 1)]])


def _finer(values: Array, times: int) -> Array:
    """The same on more points, bilinear."""
    for axis in (0, 1):
        size = values.shape[axis]
        left = np.moveaxis(values, axis, 0)
        share = (np.arange(times) / times).reshape((-1,) + (1,) * (values.ndim - 1))
        inner = left[:-1, None] * (1.0 - share) + left[1:, None] * share
        joined = np.concatenate((inner.reshape((times * (size - 1),) + left.shape[1:]), left[-1:]))
        values = np.moveaxis(joined, 0, axis)
    return values
