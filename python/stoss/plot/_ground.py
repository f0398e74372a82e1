"""What a single body meets in a picture: the wall, or the moved surface of a half-space."""

from __future__ import annotations

from typing import Any, NamedTuple, Sequence

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
import numpy as np
from numpy.typing import NDArray

from stoss.bodies._walls import UNBOUNDED
from stoss.plot import _style
from stoss.results import _replay
from stoss.results._field import Field
from stoss.results._impact import Impact

Array = NDArray[np.float64]

WALL = 0.12  # thickness of what is drawn as the wall, R, and of a half-space below the deepest point


LOOK: dict[str, Any] = {"facecolor": "0.8", "edgecolor": "none", "zorder": 1.0}


class Surface(NamedTuple):
    """The surface of a half-space at several times, R."""

    y: Array
    x: Array  # times × places


def gives_way(impact: Impact) -> bool:
    """Whether it is a half-space."""
    return isinstance(impact.against, UNBOUNDED)


def surface(impact: Impact, times: Array, reach: float) -> Surface | None:
    """That of the half-space that is met, if there is one."""
    return Surface(*_replay.surface(impact, times, reach)) if gives_way(impact) else None


def thickness(fields: Sequence[Field]) -> float:
    """How far what is met is drawn, R."""
    deepest = float(fields[0].x.max()) if gives_way(fields[0].impact) else 0.0
    return WALL + max(0.0, deepest)


def draw(axes: Axes, impact: Impact, time: float, half: float, right: float) -> None:
    """What is met at this time, in a picture that is `half` high to each side and ends at `right`."""
    moved = surface(impact, np.array([time]), half)
    if moved is None:
        draw_wall(axes)
    else:
        draw_half_space(axes, moved.y, moved.x[0], right)


def draw_wall(axes: Axes) -> Line2D:
    """The wall at x = 0, as high as the picture, and its face."""
    axes.axvspan(0.0, WALL, **LOOK)
    return axes.axvline(0.0, color=_style.BLACK, linewidth=1.0, zorder=1.8)


def draw_half_space(axes: Axes, y: Array, x: Array, depth: float) -> list[Artist]:
    """The half-space from its moved surface down to some depth."""
    body = axes.fill_betweenx(y, x, depth, **LOOK)
    return [body, *axes.plot(x, y, color=_style.BLACK, linewidth=1.0, zorder=1.8)]
