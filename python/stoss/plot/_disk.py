"""The deformed disk or sphere at the wall, or two of them."""

from __future__ import annotations

from typing import Any, NamedTuple, Sequence

from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.ticker import MultipleLocator
import numpy as np
from numpy.typing import NDArray

from stoss._arguments import instance, integer, refusal
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._bodies import BODIES
from stoss.plot import _ground, _style
from stoss.results import _replay
from stoss.results._computed_impact import ComputedImpact
from stoss.results._field import Field

CIRCLES, SPOKES = 6, 24

# Points for pictures that need the grid only: fine along the lines, and every line on a point.
GRID_RADIUS = np.linspace(0.0, 1.0, 4 * CIRCLES + 1)
GRID_ANGLE = np.linspace(-np.pi, np.pi, 8 * SPOKES + 1)

Array = NDArray[np.float64]


class Instant(NamedTuple):
    """One frame of a `Field`."""

    field: Field
    time: float
    center: float
    x: Array
    y: Array
    where: tuple[Any, ...]  # of this frame in the field's arrays


class View(NamedTuple):
    """What a picture shows, R."""

    left: float
    right: float
    half: float  # of the height


def instant(field: Field, frame: int | None) -> Instant:
    """The frame that was meant; a field with several needs to be told which."""
    instance("field", field, (Field,))
    shape = field.x.shape[:-2]
    count = int(np.prod(shape))
    if min(field.x.shape[-2:]) < 2:
        points = " x ".join(str(n) for n in field.x.shape[-2:])
        raise InvalidInput.out_of_range("field", f"{points} points", "at least 2 radii and 2 angles")
    if frame is None:
        if count != 1:
            hint = f" (say which, as in frame={count // 2})" if count else ""
            raise InvalidInput.out_of_range("field", f"{count} times", f"one{hint}")
        frame = 0
    k = integer("frame", frame)
    if not -count <= k < count:
        raise refusal("frame", frame, f"0 to {count - 1} (the field has {count} times)")
    where = tuple(np.unravel_index(k % count, shape)) if shape else ()
    time, center = np.asarray(field.time)[where], np.asarray(field.center)[where]
    return Instant(field, float(time), float(center), field.x[where], field.y[where], where)


def instants(field: Field, frame: int | None) -> list[Instant]:
    """The same of all bodies."""
    now = instant(field, frame)
    if not isinstance(field.impact.against, BODIES):
        return [now]
    other = _replay.field(field.impact, time=now.time, radius=field.radius, angle=field.angle, of=1 - field.of)
    return sorted((now, instant(other, None)), key=lambda each: each.field.of)


def all_fields(impact: ComputedImpact, times: Array, **points: Array) -> list[Field]:
    """The field of each body at these times."""
    return [_replay.field(impact, time=times, of=of, **points) for of in range(1 + isinstance(impact.against, BODIES))]


@documented
def disk(
    field: Field,
    ax: Axes | None = None,
    *,
    frame: int | None = None,
    circles: int = CIRCLES,
    spokes: int = SPOKES,
    outline: bool = True,
    color: Any = _style.BLUE,
) -> Axes:
    """The deformed disk at what it meets: circles and radii that were even before the impact.

    Deformations have their true size. Two disks are both drawn. `sphere` is the same function:
    of a sphere it draws the plane through the axis.

    Parameters:
        field: From `Impact.field`, with any radii and angles: the nearest to even ones are drawn.
        circles, spokes: Number of circles and of radii.
        outline: Also the undeformed disk around the same centre of mass, in grey.
        color (color, optional): Colour of the grid.

    Examples:
        >>> hit = stoss.impact(poisson=0.33, speed=0.2, cutoff=12.5)
        >>> ax = stoss.plot.disk(hit.field(time=hit.contact_time / 2))
    """
    bodies = instants(field, frame)
    for name, value in (("circles", circles), ("spokes", spokes)):
        _style.count(name, value, 1000)
    shown = view([now.field for now in bodies], bodies)
    with _style.canvas(ax, size=size_for(shown, 2.85)) as axes:
        for now, edge in zip(bodies, undeformed(bodies)):
            if outline:
                draw_outline(axes, *edge)
            draw_grid(axes, now.x, now.y, field.radius, field.angle, circles, spokes, color=color)
        if len(bodies) == 1:
            _ground.draw(axes, field.impact, bodies[0].time, shown.half, shown.right)
        frame_axes(axes, shown)
        axes.set_title(f"t = {_style.written(bodies[0].time)} R/c")
    return axes


sphere = disk


def draw_grid(
    axes: Axes,
    x: Array,
    y: Array,
    radius: Array,
    angle: Array,
    circles: int = CIRCLES,
    spokes: int = SPOKES,
    *,
    color: Any = _style.BLUE,
    width: float = 1.0,
) -> LineCollection:
    """Circles and radii nearest to even ones, the edge heavier; `width` scales all lines."""
    rings = _nearest(radius, np.arange(1, circles + 1) / circles)
    rays = _nearest(angle, -np.pi + 2.0 * np.pi * np.arange(spokes) / spokes)
    lines = [np.column_stack((x[i], y[i])) for i in rings] + [np.column_stack((x[:, j], y[:, j])) for j in rays]
    edge = np.argmax(radius)
    widths = [width * (1.2 if i == edge else 0.5) for i in rings] + [width * 0.5] * len(rays)
    drawn = LineCollection(lines, colors=color, linewidths=widths, capstyle="round", joinstyle="round", zorder=2.0)
    axes.add_collection(drawn)
    axes.autoscale_view()
    return drawn


def _nearest(values: Array, wanted: Array) -> NDArray[np.intp]:
    return np.unique(np.abs(values[:, None] - wanted).argmin(axis=0))  # type: ignore[no-any-return]


def circle(center: float = 0.0, size: float = 1.0) -> tuple[Array, Array]:
    """Edge of an undeformed disk or sphere."""
    return center + size * np.cos(GRID_ANGLE), size * np.sin(GRID_ANGLE)


def undeformed(bodies: Sequence[Instant]) -> list[tuple[Array, Array]]:
    """Edges of undeformed disks with these centres, as far as nothing is before them."""
    edges = []
    for now, other in zip(bodies, (*bodies[1:], bodies[0])):
        x, y = circle(now.center, now.field.size)
        end = np.inf if _ground.gives_way(now.field.impact) else 0.0
        free = x <= end if other is now else np.hypot(x - other.center, y) >= other.field.size
        edges.append((np.where(free, x, np.nan), y))
    return edges


def draw_outline(axes: Axes, x: Array, y: Array, width: float = 1.0) -> Line2D:
    """The undeformed disk, in grey."""
    (line,) = axes.plot(x, y, color=_style.GREY, linewidth=0.8 * width, zorder=1.5)
    return line


def view(fields: Sequence[Field], bodies: Sequence[Instant] = ()) -> View:
    """What holds all points of these fields, or of one of their instants, with a margin."""
    margin = 0.06
    points = [(now.x, now.y) for now in bodies] or [(each.x, each.y) for each in fields]
    half = max(max(each.size, float(np.abs(y).max())) for each, (_, y) in zip(fields, points))
    left = min(-2.0, float(points[0][0].min()))
    right = _ground.thickness(fields)
    if len(fields) > 1:
        right = max(2.0 * fields[1].size, float(points[1][0].max())) + margin
    return View(left - margin, right, half + margin)


def size_for(shown: View, width: float) -> tuple[float, float]:
    """Size in inches of a figure for one column, in which the disk's Axes can be `width` wide.

    It is a little too high, so that the width decides: the layout leaves space for labels where
    equal axes would end if they filled theirs.
    """
    return _style.COLUMN, min(6.0, width * 2.0 * shown.half / (shown.right - shown.left) + 0.7)


def frame_axes(axes: Axes, shown: View) -> None:
    """Places in R, equal on both axes."""
    left, right, half = shown
    axes.set_aspect("equal")
    axes.set(xlim=(left, right), ylim=(-half, half), xlabel="x / R", ylabel="y / R")
    # The same ticks however large the Axes become: or the layout would not leave enough space for them.
    step = 0.5 * 2.0 ** max(0.0, np.ceil(np.log2((right - left) / 4.0)))
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MultipleLocator(step))
