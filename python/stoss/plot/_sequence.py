"""An impact as a row of pictures."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss._arguments import numbers
from stoss._errors import InvalidInput
from stoss.plot import _disk, _ground, _style
from stoss.results._impact import Impact

Array = NDArray[np.float64]

BEFORE, AFTER = 0.15, 0.6  # of the contact time
LARGEST = 64
GAP = 0.3  # between two disks, R
LINE = 0.62  # height of the line that says the time, R


@_style.picture_of(Impact)
def sequence(
    impact: Impact, ax: Axes | None = None, *, times: ArrayLike | None = None, count: int = 6, columns: int = 3
) -> Axes:
    """The deformed disk or sphere at several times, in rows, each above the wall with its time below.

    The wall, x = 0, or the surface of a half-space is below, and the body comes from above. Of two
    bodies the second is below, and the picture moves with their common centre of mass. Deformations
    and distances have their true size. The grey circles are the undeformed disks around the same
    centre of mass: what differs from them is deformation.

    Parameters:
        times: R/c from the start of the impact, 1 to 64 of them; default: `count` even ones from
            just before contact until the disk has flown for some time, vibrating.
        count: Number of default times, 2 to 64.
        columns: Disks in a row; up to 3 are legible in one column, 6 in two.

    Examples:
        >>> ax = stoss.plot.sequence(stoss.impact(poisson=0.33, speed=0.2, cutoff=12.5), count=3)
    """
    _style.count("count", count, LARGEST, low=2)
    _style.count("columns", columns, LARGEST)
    chosen = default_times(impact, count) if times is None else numbers("times", times).ravel()
    if not 1 <= chosen.size <= LARGEST:
        raise InvalidInput.out_of_range("times", f"{chosen.size} of them", f"1 to {LARGEST}")
    fields = _disk.all_fields(impact, chosen, radius=_disk.GRID_RADIUS, angle=_disk.GRID_ANGLE)

    # The picture is turned: along the wall is to the right, away from it is up.
    columns = min(columns, chosen.size)
    rows = -(-chosen.size // columns)
    pitch = 2.0 * max(max(each.size, float(np.abs(each.y).max())) for each in fields) + GAP
    lowest = [min(float(-each.x.max()), -float(np.max(each.center)) - each.size) for each in fields]
    ground = _ground.thickness(fields) if len(fields) == 1 else 0.05 - lowest[-1]
    moved = _ground.surface(impact, chosen, 0.5 * pitch)
    top = max(float(-fields[0].x.min()), 1.0 - float(np.min(fields[0].center)))  # also of the undeformed disk
    height = top + 0.05 + ground + LINE
    wide, high = columns * pitch, rows * height
    column = _style.COLUMN if columns <= 3 else 2.0 * _style.COLUMN + 0.2
    size = (column, min(9.0, column * high / wide + 0.35))

    with _style.canvas(ax, size=size) as axes:
        line = 3.0 / max(columns, 3)
        first, *later = spoken_times(chosen)
        names = [f"t = {first} R/c", *later]
        for k in range(chosen.size):
            x, y = (k % columns) * pitch, -(k // columns) * height
            bodies = [_disk.instant(each, k) for each in fields]
            for now, (toward, along) in zip(bodies, _disk.undeformed(bodies)):
                _disk.draw_outline(axes, x + along, y - toward, line)
                _disk.draw_grid(axes, x + now.y, y - now.x, now.field.radius, now.field.angle, width=line)
            if moved is not None:
                bottom = _ground.bottom(moved, k, ground)
                axes.fill_between(x + moved.y, y - moved.x[k], y - bottom, **_ground.LOOK)
                for face in (moved.x[k], bottom if moved.lower is not None else None):
                    if face is not None:
                        axes.plot(x + moved.y, y - face, color=_style.BLACK, linewidth=line, zorder=1.8)
            axes.text(x, y - ground - 0.5 * LINE, names[k], ha="center", va="center")
        for row in range(rows if len(fields) == 1 and moved is None else 0):
            filled = min(columns, chosen.size - row * columns)
            corner = (-0.5 * pitch, -row * height - _ground.WALL)
            axes.add_patch(Rectangle(corner, filled * pitch, _ground.WALL, **_ground.LOOK))
            edge = (corner[0], corner[0] + filled * pitch)
            axes.plot(edge, (-row * height,) * 2, color=_style.BLACK, linewidth=1.0, zorder=1.8)
        end = height - ground - LINE
        axes.set(aspect="equal", xlim=(-0.5 * pitch, wide - 0.5 * pitch), ylim=(end - high, end))
        _style.bare(axes)
    return axes


def default_times(impact: Impact, count: int) -> Array:
    """Even times from just before contact until the disk has left and vibrates freely."""
    path = impact.trajectory()
    # Not 0 and contact_time: an exponential wall is felt before it is touched.
    touching = path.time[path.contact_half_width > 0.0]
    first, last = (touching[0], touching[-1]) if touching.size else (0.0, impact.contact_time)
    span = last - first
    return np.linspace(first - BEFORE * span, last + AFTER * span, count)  # type: ignore[no-any-return]


def spoken_times(times: Array) -> list[str]:
    """The times with as many decimals as tell them apart, at least two."""
    steps = np.diff(np.unique(times))
    least = float(steps.min()) if steps.size else 1.0
    decimals = int(np.clip(1 - np.floor(np.log10(least)), 2, 12))
    return [f"{time:.{decimals}f}".replace("-", "−") for time in times]
