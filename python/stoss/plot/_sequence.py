"""Rows of pictures: an impact, and the waves that run away below a surface or in a plate."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.colors import PowerNorm
from matplotlib.patches import Rectangle
import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss._arguments import number, numbers, refusal
from stoss._errors import InvalidInput
from stoss.bodies._walls import lower_face
from stoss.bodies._solid import is_rigid
from stoss.plot import _disk, _ground, _style
from stoss.results import _replay
from stoss.results._field import Wave
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

    The wall, x = 0, or the surface of a half-space is below, and the body comes from above. With two
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


COVERED = 99.0  # per cent of the points in the default colour range, each time by itself
SPACE = 0.06  # between two pictures, of their width
MARK = 0.55  # angle of the fronts' names from the axis


@_style.picture_of(Wave, method="plot")
def wave(wave: Wave, ax: Axes | None = None, *, columns: int = 2, limit: float | None = None) -> Axes:
    """Speed of the half-space or plate below the body at each of the wave's times, with the fronts of its waves.

    Colours go with the square root of the speed, because the fast pressure wave is weak compared with what
    follows. The arcs are c_p t and c_s t from the first point of contact; between them a straight
    front leads from where the pressure wave grazes the surface. The triangles are at c_R t, where
    the Rayleigh wave would be that leaves at once, if there is no lower face. Deformations have their true size, and a bar has
    a round number of radii.

    Parameters:
        wave (Wave): From `Impact.wave`, at 1 to 64 times.
        ax: Where to draw; the colour bar takes some of its space.
        limit: Where the colours end, in speeds of the impact.

    Examples:
        >>> hit = stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.1, cutoff=4)
        >>> ax = stoss.plot.wave(hit.wave(time=[4, 8], distance=np.linspace(0, 9, 28), depth=np.linspace(0, 9, 28)))
    """
    _style.count("columns", columns, LARGEST)
    if limit is not None and not 0.0 < number("limit", limit) < np.inf:
        raise refusal("limit", limit, "a speed above 0 (of the impact)")
    times, centers = np.ravel(wave.time), np.ravel(wave.center)
    if not 1 <= times.size <= LARGEST:
        raise InvalidInput.out_of_range("wave", f"{times.size} times", f"1 to {LARGEST}")
    if min(wave.normal.shape[-2:]) < 2:
        raise InvalidInput.out_of_range("wave", "one depth or distance", "at least 2 of each")
    impact, shape = wave.impact, (times.size, wave.depth.size, wave.distance.size)
    lateral, normal = wave.lateral.reshape(shape), wave.normal.reshape(shape)
    speed = np.hypot(wave.lateral_velocity, wave.normal_velocity).reshape(shape) / impact.speed
    top = float(np.percentile(speed, COVERED, axis=(1, 2)).max()) if limit is None else float(limit)
    norm = PowerNorm(0.5, 0.0, top if top > 0.0 else 1.0)

    half, depth = float(wave.distance.max()), float(wave.depth.max())
    above = 2.0 + max(0.0, float(-centers.min()) - 1.0) + 0.04 * half
    columns = min(columns, times.size)
    rows = -(-times.size // columns)
    pitch, line = 2.0 * half * (1.0 + SPACE), 0.17 * half
    height = above + depth + line
    wide, high = columns * pitch, rows * height
    column = _style.COLUMN if columns == 1 else 2.0 * _style.COLUMN + 0.2
    faces = [0, -1] if np.isclose(depth, lower_face(impact.against, impact.body)) else [0]
    balls = None if is_rigid(impact.body) else _replay.field(
        impact, time=times, radius=_disk.GRID_RADIUS, angle=_disk.GRID_ANGLE
    )  # fmt: skip

    with _style.canvas(ax, size=(column, min(9.0, 0.88 * column * high / wide + 0.1))) as axes:
        first, *later = spoken_times(times)
        names = [f"t = {first} R/c", *later]
        for k in range(times.size):
            x, y = (k % columns) * pitch, -(k // columns) * height
            across, down = wave.distance + lateral[k], wave.depth[:, None] + normal[k]
            mesh = axes.pcolormesh(
                x + _mirrored(across, -1.0), y - _mirrored(down), _mirrored(speed[k]), cmap="magma_r", norm=norm,
                shading="gouraud", rasterized=True, zorder=1.6,
            )  # fmt: skip
            for face in faces:
                course = (x + _mirrored(across, -1.0)[face], y - _mirrored(down)[face])
                axes.plot(*course, color=_style.BLACK, linewidth=0.8)
            if balls is None:
                toward, along = _disk.circle(centers[k])
                _disk.draw_outline(axes, x + along, y - toward)
            else:
                now = _disk.instant(balls, k)
                circles = max(1, round(_disk.CIRCLES * min(1.0, 6.0 / half)))
                _disk.draw_grid(axes, x + now.y, y - now.x, balls.radius, balls.angle, circles, 4 * circles, width=0.8)
            _draw_fronts(axes, wave, times[k], (x, y), named=k == times.size - 1)
            axes.text(x, y - depth - 0.5 * line, names[k], ha="center", va="center")
        _draw_scale(axes, -half, -depth - 0.5 * line, half)
        axes.set(aspect="equal", xlim=(-0.5 * pitch, wide - 0.5 * pitch), ylim=(above - high, above))
        _style.bare(axes)
        bar = axes.figure.colorbar(mesh, ax=axes, extend="max", shrink=0.8, pad=0.01, aspect=28)
        bar.set_label("speed / speed of the impact", size=axes.xaxis.label.get_size())
        _style.small_ticks(bar.ax)
    return axes


def _draw_scale(axes: Axes, x: float, y: float, half: float) -> None:
    """A bar of a round length, a tenth to a quarter of a picture wide."""
    power = 10.0 ** np.floor(np.log10(0.5 * half))
    length = power * max(step for step in (1.0, 2.0, 5.0) if step * power <= 0.5 * half)
    axes.plot([x, x + length], [y, y], color=_style.BLACK, linewidth=1.2, solid_capstyle="butt")
    axes.text(x + length + 0.02 * half, y, f"{_style.written(length)} R", ha="left", va="center")


def _mirrored(values: Array, sign: float = 1.0) -> Array:
    """Both sides of the axis, from the one with distances above 0."""
    return np.concatenate((sign * values[..., ::-1], values), axis=-1)


def _draw_fronts(axes: Axes, wave: Wave, time: float, place: tuple[float, float], *, named: bool) -> None:
    """Arcs of the pressure and the shear wave as far as the picture reaches, and where the Rayleigh wave is."""
    x, y = place
    angle = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 181)
    half, depth = float(wave.distance.max()), float(wave.depth.max())
    for speed, style, name in ((wave.pressure_speed, "-", "$c_p t$"), (wave.shear_speed, "--", "$c_s t$")):
        reach = speed * time
        across, down = reach * np.sin(angle), reach * np.cos(angle)
        across[(np.abs(across) > half) | (down > depth)] = np.nan
        axes.plot(x + across, y - down, color=_style.BLUE, linestyle=style, linewidth=0.7, zorder=2.2)
        if named and reach * np.sin(MARK) <= half and reach * np.cos(MARK) <= depth:
            mark = (x + 1.02 * reach * np.sin(MARK), y - 1.02 * reach * np.cos(MARK))
            axes.text(*mark, name, color=_style.BLUE, ha="left", va="top", zorder=2.3)
    surface = wave.rayleigh_speed * time
    if 0.0 < surface <= half and not np.isfinite(lower_face(wave.impact.against, wave.impact.body)):
        marks = [x - surface, x + surface]
        axes.plot(marks, [y, y], linestyle="none", marker=7, markersize=4.0, color=_style.GREEN, zorder=2.4)
        if named:
            axes.text(x + surface, y + 0.05 * half, "$c_R t$", color=_style.GREEN, ha="center", va="bottom")
