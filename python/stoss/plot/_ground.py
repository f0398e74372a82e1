"""What a single body meets in a picture: the wall, or the moved surface of a half-space or a plate."""

from __future__ import annotations

from typing import Any, NamedTuple, Sequence

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss.bodies._encounter import encounter
from stoss.bodies._walls import UNBOUNDED, lower_face
from stoss.plot import _style
from stoss.results import _replay
from stoss.results._field import Field
from stoss.results._computed_impact import ComputedImpact

Array = NDArray[np.float64]

WALL = 0.12  # thickness of what is drawn as the wall, R, and of a half-space below the deepest point
THICK = 0.5  # a plate of which the lower face is not drawn, R
MARGIN = 0.05  # below a plate, R
LOOK: dict[str, Any] = {"facecolor": "0.8", "edgecolor": "none", "zorder": 1.0}


class Surface(NamedTuple):
    """The surface of a half-space or a plate at several times, R."""

    y: Array
    x: Array  # times × places
    lower: Array | None  # of the lower face, where one is near


def gives_way(impact: ComputedImpact) -> bool:
    """Whether it is a half-space or a plate."""
    return isinstance(impact.against, UNBOUNDED)


def surface(impact: ComputedImpact, times: ArrayLike, reach: float) -> Surface | None:
    """Where the surface of what gives way is at some times: places y, −reach to reach, times × places x, in R.

    The upper face is moved by the kept modes alone.
    """
    if not gives_way(impact):
        return None
    rising, made = _replay.Rising(np.ravel(times)), impact._contact()
    frames = _core.motion(made, impact._handle, rising.times)
    lateral, *faces = _core.surfaces(encounter(impact.body, impact.against), made, impact._handle, frames, reach, 256)

    def both_sides(face: Array) -> Array:
        x = rising.placed(face)
        return np.concatenate((x[:, ::-1], x), axis=1)

    upper, lower = (None if face is None else both_sides(face) for face in faces)
    assert upper is not None
    return Surface(np.concatenate((-lateral[::-1], lateral)), upper, lower)


def thickness(fields: Sequence[Field]) -> float:
    """How far what is met is drawn, R: a plate that is not thick to its lower face."""
    impact = fields[0].impact
    if not gives_way(impact):
        return WALL
    deepest = max(0.0, float(fields[0].x.max()))
    face = lower_face(impact.against, impact.body)
    return deepest + (face + MARGIN if face <= THICK else WALL)


def draw(axes: Axes, impact: ComputedImpact, time: float, half: float, right: float) -> None:
    """What is met at this time, in a picture that is `half` high to each side and ends at `right`."""
    moved = surface(impact, np.array([time]), half)
    if moved is None:
        draw_wall(axes)
    else:
        draw_half_space(axes, moved, 0, right)


def draw_wall(axes: Axes) -> Line2D:
    """The wall at x = 0, as high as the picture, and its face."""
    axes.axvspan(0.0, WALL, **LOOK)
    return axes.axvline(0.0, color=_style.BLACK, linewidth=1.0, zorder=1.8)


def draw_half_space(axes: Axes, moved: Surface, k: int, depth: float) -> list[Artist]:
    """A half-space or a plate at one of the times, from its moved surface down to some depth or to its lower face."""
    line: dict[str, Any] = {"color": _style.BLACK, "linewidth": 1.0, "zorder": 1.8}
    drawn: list[Artist] = [axes.fill_betweenx(moved.y, moved.x[k], bottom(moved, k, depth), **LOOK)]
    drawn += axes.plot(moved.x[k], moved.y, **line)
    if moved.lower is not None:
        drawn += axes.plot(moved.lower[k], moved.y, **line)
    return drawn


def bottom(moved: Surface, k: int, depth: float) -> Array:
    """Where it ends: at some depth, or at its lower face."""
    ends = np.full(moved.y.size, depth)
    return ends if moved.lower is None else np.minimum(ends, moved.lower[k])
