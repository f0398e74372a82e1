"""The pictures of a film of an oblique impact: both bodies, and the contact magnified."""

from __future__ import annotations

from typing import Iterator, NamedTuple

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch, Rectangle, Wedge
import numpy as np
from numpy.typing import NDArray

from stoss.bodies._bodies import Disk, Sphere
from stoss.plot import _ground, _style
from stoss.plot._trajectory import GRIPS
from stoss.plot._sequence import spoken_times
from stoss.results._oblique_impact import ObliqueImpact
from stoss.results._oblique_impact import ObliqueTrajectory

Array = NDArray[np.float64]

SIZE = (640, 380)  # pixels
FLIGHTS = 0.25  # of the pictures, before and after the contact each
WAY, FALL = 2.0, 1.0  # longest flight along the surface and along the normal, R
ARROWS = 21  # at most
LOW, HIGH, WIDE = -0.15, 2.2, 1.7  # of the picture of the contact: in longest arrows; in half-widths
ROUND = (Disk, Sphere)
COLORS = tuple(color for color, _ in GRIPS.values())
BODIES_LOOK = ({"facecolor": "0.88"}, {"facecolor": "0.8"})


class Moment(NamedTuple):
    """What is seen at one time."""

    time: float
    row: int  # of the trajectory, or the nearest one
    centers: list[tuple[float, float]]  # to the right and up, of each body
    angles: list[float]


def pictures(impact: ObliqueImpact, count: int, size: tuple[int, int], dpi: int) -> Iterator[NDArray[np.uint8]]:
    """The pictures of an oblique impact."""
    path = impact.trajectory()
    moments = [_moment(path, time) for time in _times(path, count)]
    figure = Figure(figsize=(size[0] / dpi, size[1] / dpi), dpi=dpi, layout="constrained")
    scene, contact = figure.subplots(1, 2, width_ratios=(1.0, 1.0))
    names = [f"t = {time} R/c" for time in spoken_times(np.array([now.time for now in moments]))]
    title = figure.suptitle(max(names, key=len), fontsize=9.0)
    sizes = _sizes(impact)
    _frame_scene(scene, path, moments, sizes)
    arrows = _Arrows(contact, path)

    def draw(k: int) -> list[Artist]:
        bodies, ways = _draw_bodies(scene, moments[k], sizes), _draw_ways(scene, moments[: k + 1])
        return [*bodies, *ways, *arrows.draw(moments[k].row)]

    yield from _style.moving_pictures(figure, title, names, draw)


def _sizes(impact: ObliqueImpact) -> list[float]:
    """Radius of each body, R."""
    first, second = impact.body, impact.against
    if isinstance(first, ROUND) and isinstance(second, ROUND):
        return [1.0, second.radius / first.radius]
    return [1.0]


def _times(path: ObliqueTrajectory, count: int) -> Array:
    """Even times of a flight to the contact, of the contact in slow motion, and of a flight away from it."""
    touching = path.time[path.touching > 0]
    first, last = (touching[0], touching[-1]) if touching.size else (path.time[0], path.time[-1])
    flying = max(1, round(FLIGHTS * count)) if count > 3 else 0
    flights = [min(FALL / abs(path.velocity[k]), WAY / max(abs(path.tangential[k]), 1e-300)) for k in (0, -1)]
    before = np.linspace(first - flights[0], first, flying, endpoint=False)
    after = np.linspace(last + flights[1], last, flying, endpoint=False)[::-1]
    return np.concatenate((before, np.linspace(first, last, count - 2 * flying), after))


def _moment(path: ObliqueTrajectory, time: float) -> Moment:
    """At the nearest row; before and after the impact in free flight."""
    row = int(np.abs(path.time - time).argmin())
    flight = time - float(path.time[row]) if not 0.0 <= time <= path.time[-1] else 0.0
    share = 1.0 if path.second_x is None else _share(path)
    away, along = -float(path.velocity[row]) * flight, float(path.tangential[row]) * flight
    centers = [(float(path.y[row]) + share * along, -float(path.x[row]) + share * away)]
    angles = [float(path.angle[row] + path.spin[row] * flight)]
    if path.second_x is not None and path.second_y is not None:
        rest = 1.0 - share
        centers.append((float(path.second_y[row]) - rest * along, -float(path.second_x[row]) - rest * away))
        angles.append(float(path.second_angle[row] + path.second_spin[row] * flight))
    return Moment(float(time), row, centers, angles)


def _share(path: ObliqueTrajectory) -> float:
    """Of the first body in the relative motion of both."""
    assert path.second_x is not None
    way = float(path.center[0] - path.center[path.force.argmax()])
    return float(path.x[0] - path.x[path.force.argmax()]) / way


def _frame_scene(axes: Axes, path: ObliqueTrajectory, moments: list[Moment], sizes: list[float]) -> None:
    """Places in R, equal on both axes; x points down, as the second body or the wall is below."""
    axes.set_aspect("equal")
    margin = 0.15
    reach = [[(side + s * size, height + s * size) for s in (-1.0, 1.0)]
             for now in moments for (side, height), size in zip(now.centers, sizes)]  # fmt: skip
    sides, heights = (np.array([[each[k] for each in pair] for pair in reach]) for k in (0, 1))
    low = float(heights.min()) if len(sizes) > 1 else -2.0 * _ground.WALL
    axes.set(xlim=(sides.min() - margin, sides.max() + margin), ylim=(low - margin, heights.max() + margin))
    if len(sizes) == 1:
        left, right = axes.get_xlim()
        axes.add_patch(Rectangle((left, low - margin), right - left, margin - low, **_ground.LOOK))
    axes.set(xlabel="y / R", ylabel="−x / R")
    _style.small_ticks(axes)


def _draw_bodies(axes: Axes, now: Moment, sizes: list[float]) -> list[Artist]:
    """Rigid circles, with a sector that shows how they have turned; what the wall hides is not seen."""
    drawn: list[Artist] = []
    for center, angle, size, look in zip(now.centers, now.angles, sizes, BODIES_LOOK):
        turned = float(np.degrees(angle))
        drawn.append(axes.add_patch(Wedge(center, size, 0.0, 360.0, edgecolor=_style.BLACK, linewidth=1.0, **look)))
        drawn.append(axes.add_patch(Wedge(center, size, turned + 60.0, turned + 120.0, color="0.45", linewidth=0.0)))
        drawn.append(axes.add_patch(Wedge(center, 0.05 * size, 0.0, 360.0, color=_style.BLACK, linewidth=0.0)))
    if len(sizes) == 1:
        (left, right), (low, _) = axes.get_xlim(), axes.get_ylim()
        drawn.append(axes.add_patch(Rectangle((left, low), right - left, -low, **_ground.LOOK)))
        drawn += axes.plot((left, right), (0.0, 0.0), color=_style.BLACK, linewidth=1.0)
    return drawn


def _draw_ways(axes: Axes, moments: list[Moment]) -> list[Artist]:
    """The ways of the centres so far."""
    ways = zip(*(now.centers for now in moments))
    return [axes.plot(*zip(*way), color=_style.VERMILION, linewidth=1.0)[0] for way in ways]


class _Arrows:
    """The contact, magnified: an arrow at each point for what acts on the first body there."""

    def __init__(self, axes: Axes, path: ObliqueTrajectory) -> None:
        sided = path.place[0] < 0.0  # rings are shown on both sides
        self._order = np.arange(path.place.size) if sided else np.concatenate(
            (np.arange(path.place.size)[::-1], np.arange(path.place.size)))  # fmt: skip
        place = path.place[self._order].copy()
        if not sided:
            place[: path.place.size] *= -1.0
        touched = (path.grip != 2).any(axis=0)[self._order]
        half = WIDE * float(np.abs(place[touched]).max(initial=float(np.abs(place).min())))
        self._axes, self._place, self._grip = axes, place, path.grip
        self._pressure = path.point_pressure / path.measure
        friction = path.impact.friction
        self._friction = path.point_friction / path.measure / friction if friction else 0.0 * path.point_friction
        self._most = max(float(self._pressure.max()), 1e-300)
        seen = int(np.count_nonzero(touched))
        self._every = -(-seen // ARROWS)
        axes.set(xlim=(-half, half), ylim=(LOW, HIGH), yticks=[])
        axes.set_xlabel("y / R" if sided else "y / R, section through rings")
        axes.set_title("contact: traction on the first body,\nits friction over μ", fontsize=8.0)
        patches = [Patch(facecolor=color, label=said) for color, said in GRIPS.values()]
        _style.legend(axes, handles=patches, loc="upper right", handlelength=1.0, fontsize=7.0)
        _style.small_ticks(axes)

    def draw(self, row: int) -> list[Artist]:
        grip, pressure = self._grip[row][self._order], self._pressure[row][self._order] / self._most
        friction = self._friction[row][self._order] / self._most
        touching = np.flatnonzero(grip != 2)
        if touching.size == 0:
            return []
        colors = [GRIPS[int(each)][0] for each in grip[touching]]
        width = 1.05 * float(np.abs(np.diff(self._place)).min())
        strip = self._axes.bar(self._place[touching], 0.1, width, bottom=LOW + 0.02, color=colors, linewidth=0.0)
        shown = touching % self._every == 0
        chosen, own = touching[shown], [color for color, its in zip(colors, shown) if its]
        # As long to the side as up: what slips is at 45 degrees.
        (left, right), (low, high), box = self._axes.get_xlim(), self._axes.get_ylim(), self._axes.get_window_extent()
        side = (right - left) / box.width * box.height / (high - low)
        arrows = self._axes.quiver(
            self._place[chosen], np.zeros(chosen.size), -side * friction[chosen], pressure[chosen], color=own,
            angles="xy", scale_units="xy", scale=1.0, width=0.006, headwidth=4.0, headlength=4.5, minlength=0.1,
        )  # fmt: skip
        return [*strip.patches, arrows]
