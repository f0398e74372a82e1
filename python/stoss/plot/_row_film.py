"""The pictures of a film of bodies on a line, with the forces between them."""

from __future__ import annotations

from typing import Any, Iterator, NamedTuple

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle, FancyArrow, Rectangle
import numpy as np
from numpy.typing import NDArray

from stoss.bodies._bodies import Rod
from stoss.plot import _ground, _style
from stoss.plot._sequence import spoken_times
from stoss.rows._row_impact import RowImpact

Array = NDArray[np.float64]

BEFORE, AFTER = 0.1, 0.5  # of the time until the last contact ends
FARTHEST = 1.6  # that a body goes in the picture, in the greatest size
STEPS = (1.0, 2.0, 5.0)
WIDE = 640  # pixels
THICK = 0.25  # half the height of a rod, and of a mark of a force, in the greatest size
END = 0.4  # width of what stands at an end
COLORS = (_style.BLUE, _style.VERMILION)


class Scene(NamedTuple):
    """Where all is, R of the first body."""

    times: Array
    centers: Array  # times × bodies, with displacements as they are magnified
    velocities: Array
    forces: Array  # times × contacts
    sizes: Array  # half the length of each body
    ends: tuple[float, float]  # faces of what may stand there
    magnified: float


def default_size(impact: RowImpact, count: int) -> tuple[int, int]:
    """Pixels of its pictures."""
    left, right, low, high = _limits(scene_of(impact, count))
    return WIDE, int(np.clip(round(WIDE * (high - low) / (right - left)) + 40, 120, 400))


def pictures(impact: RowImpact, count: int, size: tuple[int, int], dpi: int) -> Iterator[NDArray[np.uint8]]:
    """The pictures of a row."""
    scene = scene_of(impact, count)
    figure = Figure(figsize=(size[0] / dpi, size[1] / dpi), dpi=dpi, layout="constrained")
    axes = figure.add_subplot()
    _style.bare(axes)
    left, right, low, high = _limits(scene)
    axes.set(aspect="equal", xlim=(left, right), ylim=(low, high))
    said = f"displacements × {scene.magnified:g}"
    names = [f"t = {time} R/c, {said}" for time in spoken_times(scene.times)]
    title = axes.set_title(max(names, key=len), fontsize=9.0)
    for side, stands in ((-1.0, impact.before), (1.0, impact.against)):
        if stands is not None:
            _draw_end(axes, scene, side)
    is_rod = [isinstance(each, Rod) for each in impact.bodies]

    def draw(k: int) -> list[Artist]:
        bodies = [_draw_body(axes, scene, k, b, rod) for b, rod in enumerate(is_rod)]
        return [*bodies, *_draw_velocities(axes, scene, k), *_draw_forces(axes, impact, scene, k)]

    yield from _style.moving_pictures(figure, title, names, draw)


def scene_of(impact: RowImpact, count: int) -> Scene:
    """The motion at even times, with free flights before and after."""
    touching = np.flatnonzero((impact.force > 0.0).any(axis=1))
    last = float(impact.time[touching[-1]]) if touching.size else float(impact.time[-1])
    times = np.linspace(-BEFORE * last, (1.0 + AFTER) * last, count)
    inside = np.clip(times, impact.time[0], impact.time[-1])
    flight = (times - inside)[:, None]

    def at(values: Array, beyond: float | None = None) -> Array:
        columns = [np.interp(inside, impact.time, values[:, k]) for k in range(values.shape[1])]
        found = np.stack(columns, axis=1)
        return found if beyond is None else np.where(flight == 0.0, found, beyond)

    velocities = at(impact.velocity)
    moved = at(impact.displacement) + flight * velocities
    sizes, gaps = _sizes(impact), _gaps(impact)
    most = max(float(np.abs(moved).max()), float(gaps.max(initial=0.0)), 1e-300)
    magnified = _round(FARTHEST * float(sizes.max()) / most)
    inner = gaps[1:] if impact.before is not None else gaps
    rest = np.zeros(sizes.size)
    for b in range(1, sizes.size):
        rest[b] = rest[b - 1] + sizes[b - 1] + magnified * float(inner[b - 1]) + sizes[b]
    before = magnified * float(gaps[0]) if impact.before is not None else 0.0
    after = magnified * float(gaps[-1]) if impact.against is not None else 0.0
    ends = float(-sizes[0] - before), float(rest[-1] + sizes[-1] + after)
    return Scene(times, rest + magnified * moved, velocities, at(impact.force, 0.0), sizes, ends, magnified)


def _length(body: Any) -> float:
    """The unit of length of a body, as it was given."""
    given = getattr(body, "length", None) or getattr(body, "radius", None)
    return float(given or body.scales.length)  # those of a file are in SI


def _sizes(impact: RowImpact) -> Array:
    """Half the length of each body, in the unit of length of the first."""
    lengths = [_length(each) * (0.5 if isinstance(each, Rod) else 1.0) for each in impact.bodies]
    return np.array(lengths) / _length(impact.bodies[0])


def _gaps(impact: RowImpact) -> Array:
    """Where the bodies are when the first two touch."""
    count = impact.force.shape[1]
    if impact.gaps is None:
        return np.zeros(count)
    gaps, speeds = impact.gaps / _length(impact.bodies[0]), impact.velocity[0]
    left = np.concatenate((np.zeros(int(impact.before is not None)), speeds))
    others = speeds if impact.before is not None else speeds[1:]
    right = np.concatenate((others, np.zeros(int(impact.against is not None))))
    approach = left[:count] - right[:count]
    nearing = approach > 0.0
    wait = float((gaps[nearing] / approach[nearing]).min()) if nearing.any() else 0.0
    return np.asarray(np.maximum(gaps - wait * approach, 0.0))


def _round(value: float) -> float:
    """The nearest number below that is 1, 2 or 5 times a power of ten."""
    power = 10.0 ** np.floor(np.log10(value))
    return float(power * max(each for each in STEPS if each * power <= value * (1.0 + 1e-9)))


def _limits(scene: Scene) -> tuple[float, float, float, float]:
    most = float(scene.sizes.max())
    left = min(float((scene.centers - scene.sizes).min()), scene.ends[0]) - END * most
    right = max(float((scene.centers + scene.sizes).max()), scene.ends[1]) + END * most
    return left, right, -1.55 * most, 1.1 * most


def _draw_end(axes: Axes, scene: Scene, side: float) -> None:
    most = float(scene.sizes.max())
    at = scene.ends[side > 0.0]
    corner = at if side > 0.0 else at - END * most
    axes.add_patch(Rectangle((corner, -1.05 * most), END * most, 2.1 * most, **_ground.LOOK))
    axes.plot([at, at], [-1.05 * most, 1.05 * most], color=_style.BLACK, linewidth=1.0)


def _draw_body(axes: Axes, scene: Scene, k: int, b: int, rod: bool) -> Artist:
    at, size = float(scene.centers[k, b]), float(scene.sizes[b])
    look = {"facecolor": "0.88", "edgecolor": _style.BLACK, "linewidth": 0.8}
    if rod:
        high = THICK * float(scene.sizes.max())
        return axes.add_patch(Rectangle((at - size, -high), 2.0 * size, 2.0 * high, **look))
    return axes.add_patch(Circle((at, 0.0), size, **look))


def _draw_velocities(axes: Axes, scene: Scene, k: int) -> list[Artist]:
    """Arrows below the bodies."""
    fastest, most = float(np.abs(scene.velocities).max()), float(scene.sizes.max())
    drawn: list[Artist] = []
    for at, velocity in zip(scene.centers[k].tolist(), scene.velocities[k].tolist()):
        length = 1.2 * most * velocity / fastest if fastest > 0.0 else 0.0
        if abs(length) < 0.05 * most:
            continue
        head = min(0.3 * most, abs(length))
        arrow = FancyArrow(at, -1.3 * most, length, 0.0, width=0.05 * most, head_width=max(0.7 * head, 0.05 * most),
                           head_length=head, length_includes_head=True, color=_style.BLUE, linewidth=0.0)  # fmt: skip
        drawn.append(axes.add_patch(arrow))
    return drawn


def _draw_forces(axes: Axes, impact: RowImpact, scene: Scene, k: int) -> list[Artist]:
    """Marks at the contacts, as high as their force."""
    top, most = float(scene.forces.max(initial=0.0)), float(scene.sizes.max())
    first, drawn = 0 if impact.before is None else -1, list[Artist]()
    for c, force in enumerate(scene.forces[k].tolist()):
        if not force > 0.0:
            continue
        left, right = first + c, first + c + 1
        sides = [scene.centers[k, left] + scene.sizes[left]] if left >= 0 else []
        sides += [scene.centers[k, right] - scene.sizes[right]] if right < scene.sizes.size else []
        at, high = float(np.mean(sides)), 0.9 * most * force / top
        mark = Rectangle((at - 0.05 * most, -high), 0.1 * most, 2.0 * high, color=_style.VERMILION, linewidth=0.0)
        drawn.append(axes.add_patch(mark))
    return drawn
