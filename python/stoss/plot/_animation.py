"""An impact as a film."""

from __future__ import annotations

import contextlib
import os
import subprocess
import tempfile
from typing import Any, Callable, Iterator, NamedTuple

from PIL import Image
from matplotlib import colormaps, rc_context
from matplotlib.animation import FFMpegWriter
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
import numpy as np
from numpy.typing import NDArray

from stoss._arguments import instance, integer, number, refusal, require_memory
from stoss._documentation import documented
from stoss.export._files import whole_file
from stoss.plot import _disk, _ground, _oblique_film, _row_film, _sequence, _stress, _style
from stoss.results._impact import Impact
from stoss.results._oblique_impact import ObliqueImpact
from stoss.rows._row_impact import RowImpact

DPI = 100
SUFFIXES = (".gif", ".mp4")


@documented
def animate(
    impact: Impact | ObliqueImpact | RowImpact,
    path: str | os.PathLike[str],
    *,
    frames: int = 60,
    fps: float = 20.0,
    size: tuple[int, int] | None = None,
    quantity: str | None = None,
    fringe: float | None = None,
) -> str | os.PathLike[str]:
    """Write the impact as a GIF or MP4.

    It goes from just before contact until the body, or two, have flown for some time, vibrating.
    The file appears whole or not at all. `path` is returned. RuntimeError says that ffmpeg failed.

    In an oblique impact half of the frames show the contact, in slow motion. The bodies are drawn
    as rigid ones, with a sector that turns. The contact is beside them, magnified: arrows are the
    traction on the first body, with its friction over μ, so that they are inclined by 45 degrees
    where points slip; black points stick, orange ones slip along +y and blue ones along −y.

    A row of bodies is drawn with its displacements magnified, by the factor that the title says. Red
    marks between bodies are as high as the forces there, and arrows are velocities.

    Parameters:
        impact (Impact, ObliqueImpact or RowImpact): The impact of a disk or a sphere, or a row.
        path: Where to; an existing file is replaced. Its suffix, .gif or .mp4, says what is
            written; the latter needs ffmpeg.
        frames: Number of frames, 2 to 2000.
        fps: Frames per second, 1 to 50. A GIF counts time in 1/100 s.
        size: Width and height, 100 to 4000 pixels; those of an MP4 are made
            even. Default: 400 wide, with colours 480; of an oblique impact 640 x 380, of a
            row 640 wide.
        quantity ({'von_mises', 'principal_difference', 'fringes'}, optional): Colours, on one scale
            for all frames (see `stoss.plot.stress`); default: a grid of radii and circles.
        fringe: As in `stoss.plot.stress`.

    Examples:
        >>> hit = stoss.impact(poisson=0.33, speed=0.2, cutoff=12.5)
        >>> stoss.animate(hit, "impact.gif", frames=10)
        'impact.gif'
        >>> slip = stoss.oblique_impact(stoss.Sphere(poisson=0.3), speed=0.05, angle=40, friction=0.3)
        >>> stoss.animate(slip, "slip.gif", frames=10)
        'slip.gif'
    """
    instance("impact", impact, (Impact, ObliqueImpact, RowImpact))
    suffix = _suffix(path)
    count, rate = _style.count("frames", frames, 2000, low=2), number("fps", fps)
    if not 1.0 <= rate <= 50.0:
        raise refusal("fps", fps, "1 to 50 (frames per second)")
    pixels = None if size is None else _pixels(size)
    if pixels is not None and suffix == ".gif":  # all pictures are held, a byte for each pixel
        got = f"{count} of {pixels[0]} x {pixels[1]} pixels"
        require_memory("frames", got, float(count * pixels[0] * pixels[1]), "give fewer, a smaller size, or an .mp4")
    if quantity is not None:
        if isinstance(impact, (ObliqueImpact, RowImpact)):
            what = "an oblique impact" if isinstance(impact, ObliqueImpact) else "a row"
            raise refusal("quantity", quantity, f"None for {what} (which has no field)")
        _style.choice("quantity", quantity, _stress.QUANTITIES)
    if suffix == ".mp4" and not FFMpegWriter.isAvailable():
        hint = "install it, or give a path that ends in .gif"
        raise RuntimeError(f"animate: ffmpeg, which .mp4 needs, was not found ({hint})")

    with whole_file(os.fspath(path), suffix) as temporary, rc_context(_style.PRINT | {"figure.dpi": DPI}):
        if isinstance(impact, ObliqueImpact):
            film = _oblique(impact, count, pixels)
        elif isinstance(impact, RowImpact):
            film = _row(impact, count, pixels)
        else:
            film = _central(impact, count, pixels, quantity, fringe)
        shape = film.size
        if suffix == ".mp4":  # its colours are those of pairs of pixels
            shape = shape[0] + shape[0] % 2, shape[1] + shape[1] % 2
        if suffix == ".gif":
            _write_gif(film.pictures(shape), rate, film.palette, temporary)
        else:
            _write_mp4(film.pictures(shape), rate, shape, temporary)
    return path


# The method of a result.
_style.PICTURES[RowImpact, "animate"] = lambda result, write: write(result, animate)


class _Film(NamedTuple):
    """What a film shows."""

    size: tuple[int, int]  # pixels
    pictures: Callable[[tuple[int, int]], Iterator[NDArray[np.uint8]]]  # of a size
    palette: list[NDArray[np.float64]]  # colours beside greys


def _central(
    impact: Impact, count: int, pixels: tuple[int, int] | None, quantity: str | None, fringe: float | None
) -> _Film:
    times = _sequence.default_times(impact, count)
    points = {"radius": _disk.GRID_RADIUS, "angle": _disk.GRID_ANGLE} if quantity is None else {}
    fields = _disk.all_fields(impact, times, **points)
    film = [[_disk.instant(each, k) for each in fields] for k in range(count)]
    scale = None if quantity is None else _stress.scale_of([now for each in film for now in each], quantity, fringe)
    shown = _disk.view(fields)
    ground = _ground.surface(impact, times, shown.half)
    ramp = _ramp(_style.BLUE, 24) if scale is None else colormaps[scale.colors](np.linspace(0.0, 1.0, 96))
    size = _default_pixels(shown, scale) if pixels is None else pixels
    return _Film(size, lambda shape: _film(film, shown, scale, shape, ground), [ramp])


def _oblique(impact: ObliqueImpact, count: int, pixels: tuple[int, int] | None) -> _Film:
    ramps = [_ramp(color, 24) for color in (*_oblique_film.COLORS, _style.VERMILION) if color.startswith("#")]
    return _Film(pixels or _oblique_film.SIZE, lambda shape: _oblique_film.pictures(impact, count, shape, DPI), ramps)


def _row(impact: RowImpact, count: int, pixels: tuple[int, int] | None) -> _Film:
    ramps = [_ramp(color, 24) for color in _row_film.COLORS]
    size = pixels or _row_film.default_size(impact, count)
    return _Film(size, lambda shape: _row_film.pictures(impact, count, shape, DPI), ramps)


def _ramp(color: str, levels: int) -> NDArray[np.float64]:
    """From white to a colour."""
    shades: NDArray[np.float64] = LinearSegmentedColormap.from_list("", ["white", color])(np.linspace(0.0, 1.0, levels))
    return shades


def _suffix(path: Any) -> str:
    if not isinstance(path, (str, os.PathLike)):
        raise refusal("path", path, "a path that ends in .gif or .mp4")
    suffix = os.path.splitext(os.fspath(path))[1].lower()
    if suffix not in SUFFIXES:
        raise refusal("path", os.fspath(path), "a path that ends in .gif or .mp4 (the suffix says what is written)")
    return suffix


def _pixels(size: Any) -> tuple[int, int]:
    try:
        width, height = (integer("size", each) for each in size)
    except (TypeError, ValueError):
        raise refusal("size", size, "two integers (width and height, pixels)") from None
    if not (100 <= width <= 4000 and 100 <= height <= 4000):
        raise refusal("size", size, "100 to 4000 pixels, both")
    return width, height


def _default_pixels(shown: _disk.View, scale: _stress.Scale | None) -> tuple[int, int]:
    _, height = _disk.size_for(shown, 3.3)
    return (400 if scale is None else 480), round(DPI * height)


def _film(
    film: list[list[_disk.Instant]], shown: _disk.View, scale: _stress.Scale | None, size: tuple[int, int],
    surface: _ground.Surface | None,
) -> Iterator[NDArray[np.uint8]]:
    """The pictures of an impact along the normal."""
    figure = Figure(figsize=(size[0] / DPI, size[1] / DPI), dpi=DPI, layout="constrained")
    axes = figure.add_subplot()
    _style.small_ticks(axes)
    _disk.frame_axes(axes, shown)
    faces = [_ground.draw_wall(axes)] if len(film[0]) == 1 and surface is None else []
    names = [f"t = {time} R/c" for time in _sequence.spoken_times(np.array([each[0].time for each in film]))]
    title = axes.set_title(names[0])
    if scale is not None:
        drawn = _stress.draw_stress(axes, film[0][0], scale, smooth=False)
        _stress.draw_bar(axes, drawn[0], scale)
        for artist in drawn:
            artist.remove()

    def draw(k: int) -> list[Artist]:
        moving = [] if surface is None else _ground.draw_half_space(axes, surface, k, shown.right)
        return moving + _draw_frame(axes, film[k], scale)

    yield from _style.moving_pictures(figure, title, names, draw, faces)


def _draw_frame(axes: Axes, bodies: list[_disk.Instant], scale: _stress.Scale | None) -> list[Artist]:
    if scale is not None:
        return [artist for now in bodies for artist in _stress.draw_stress(axes, now, scale, smooth=False)]
    edges = [_disk.draw_outline(axes, *edge) for edge in _disk.undeformed(bodies)]
    return edges + [_disk.draw_grid(axes, now.x, now.y, now.field.radius, now.field.angle, width=1.2) for now in bodies]


def _write_gif(pictures: Iterator[NDArray[np.uint8]], rate: float, ramps: list[NDArray[np.float64]], path: str) -> None:
    # One palette for all: colours keep their meaning from frame to frame, and the file stays small.
    shades = np.concatenate((colormaps["gray"](np.linspace(0.0, 1.0, 32)), *ramps))
    palette = Image.new("P", (1, 1))
    palette.putpalette(np.round(255.0 * shades[:, :3]).astype(np.uint8).tobytes())
    flat = [Image.fromarray(each).quantize(palette=palette, dither=0) for each in pictures]
    duration = 10 * max(2, round(100.0 / rate))
    flat[0].save(path, format="GIF", save_all=True, append_images=flat[1:], duration=duration, loop=0)


def _write_mp4(pictures: Iterator[NDArray[np.uint8]], rate: float, size: tuple[int, int], path: str) -> None:
    command = [
        FFMpegWriter.bin_path(), "-loglevel", "error", "-y",
        "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{size[0]}x{size[1]}", "-r", f"{rate:g}", "-i", "pipe:0",
        "-pix_fmt", "yuv420p", path,
    ]  # fmt: skip
    with tempfile.TemporaryFile() as complaints:
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=complaints, stderr=complaints) as ffmpeg:
            assert ffmpeg.stdin is not None
            try:
                for picture in pictures:
                    ffmpeg.stdin.write(picture.tobytes())
            except BrokenPipeError:  # ffmpeg has given up, and says why below
                pass
            except BaseException:
                ffmpeg.kill()
                raise
            with contextlib.suppress(BrokenPipeError):
                ffmpeg.stdin.close()
        if ffmpeg.returncode != 0:
            complaints.seek(0)
            said = " ".join(complaints.read(300).decode(errors="replace").split())
            raise RuntimeError(f"animate: ffmpeg failed (give a path that ends in .gif instead): {said}")
