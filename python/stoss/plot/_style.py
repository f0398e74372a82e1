"""What all pictures share: where they are drawn, colours, small print, refusals."""

from __future__ import annotations

import contextlib
import functools
import inspect
import weakref
from typing import Any, Callable, Iterable, Iterator, Mapping, Sequence, TypeVar, cast

import matplotlib
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
import numpy as np
from numpy.typing import NDArray

from stoss._arguments import choice as choice, instance, integer, refusal
from stoss._documentation import documented

COLUMN = 3.4  # inches, one column of a journal

# Okabe and Ito's colours, those first that also differ most in lightness.
BLACK, BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY = (
    "#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9",
)  # fmt: skip
COLORS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK)
LINES = ("-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (8, 2)), (0, (3, 1)))
MARKERS = ("o", "s", "^", "D", "v", "P", "X")
GREY = "0.6"

PRINT: dict[str, Any] = {
    "font.size": 8.0,
    "axes.labelsize": 8.0,
    "axes.titlesize": 8.0,
    "axes.linewidth": 0.6,
    "xtick.labelsize": 7.0,
    "ytick.labelsize": 7.0,
    "legend.fontsize": 7.0,
    "legend.title_fontsize": 7.0,
    "lines.linewidth": 1.2,
    "lines.markersize": 3.5,
    "patch.linewidth": 0.6,
    "figure.dpi": 200.0,
}

Picture = TypeVar("Picture", bound=Callable[..., Axes])

PICTURES: dict[tuple[type, str], Callable[..., Axes]] = {}
"""Draws the picture of each method of a result."""

_made_here: weakref.WeakSet[Axes] = weakref.WeakSet()


def picture_of(*kinds: type, method: str = "") -> Callable[[Picture], Picture]:
    """Make a function refuse what is of none of these kinds, and draw what that method of them shows."""

    def made(function: Picture) -> Picture:
        name = next(iter(inspect.signature(function).parameters))
        documented(function, **{name: "What is drawn."})

        @functools.wraps(function)
        def checked(*given: Any, **named: Any) -> Axes:
            if given or name in named:
                instance(name, given[0] if given else named[name], kinds)
            return function(*given, **named)

        PICTURES.update({(kind, method): checked for kind in kinds})
        return cast(Picture, checked)

    return made


@contextlib.contextmanager
def canvas(ax: Axes | None, *, size: tuple[float, float] = (COLUMN, 2.5), **look: Any) -> Iterator[Axes]:
    """The given Axes, or those of a new figure, which is closed again if drawing fails; with this look.

    Whoever brings Axes has chosen their style; those made here keep their small print when more is
    drawn in them.
    """
    if ax is not None:
        if not isinstance(ax, Axes):
            hint = "one matplotlib Axes or None (pyplot.subplots gives an array of them: take one)"
            raise refusal("ax", ax, hint)
        with matplotlib.rc_context(PRINT if ax in _made_here else {}):
            ax.set(**look)
            yield ax
        return

    from matplotlib import pyplot

    with matplotlib.rc_context(PRINT):
        figure, made = pyplot.subplots(figsize=size, layout="constrained")
        try:
            small_ticks(made)
            made.set(**look)
            yield made
            _made_here.add(made)
        except BaseException:
            pyplot.close(figure)
            raise


def small_ticks(axes: Axes, labelsize: float = PRINT["xtick.labelsize"]) -> None:
    """Small print for ticks, which are made late, when the settings of `canvas` have gone."""
    axes.tick_params(which="both", width=0.6, labelsize=labelsize)
    axes.tick_params(which="major", length=2.5)
    axes.tick_params(which="minor", length=1.5)


def panels(axes: Axes, places: Mapping[str, tuple[float, float]]) -> list[Axes]:
    """Pictures inside the Axes, one above the other: where each begins and how high it is."""
    bare(axes)
    made = [axes.inset_axes((0.0, low, 1.0, high), label=name) for name, (low, high) in places.items()]
    for panel in made:
        small_ticks(panel)
    for panel in made[:-1]:
        panel.tick_params(labelbottom=False)
    return made


def above(axes: Axes, **options: Any) -> None:
    """A legend in a row above the picture, where no curve is."""
    legend(axes, **{"bbox_to_anchor": (0.5, 0.98), "frameon": False} | options)


def stacked(axes: Axes, x: Any, shares: Iterable[tuple[Any, str, str, str]]) -> None:
    """Shares of one whole, one above the other: each with its colour, hatch and label."""
    below = 0.0 * x
    for share, color, hatch, label in shares:
        over = below + share
        look = {"facecolor": color, "hatch": hatch, "edgecolor": "white", "linewidth": 0.0}
        axes.fill_between(x, below, over, label=label, **look)
        axes.plot(x, over, color=BLACK, linewidth=0.4)
        below = over
    axes.set_ylim(0.0, 1.0)


def moving_pictures(
    figure: Figure,
    title: Artist,
    names: Sequence[str],
    draw: Callable[[int], list[Artist]],
    last: Sequence[Artist] = (),
) -> Iterator[NDArray[np.uint8]]:
    """Pictures, height × width × RGB, of a figure that pyplot does not know of: one for each name.

    Most of it never changes. It is drawn once, and over it what `draw` adds, then `last` and the title.
    """
    agg: Any = FigureCanvasAgg(figure)
    title.set_animated(True)
    agg.draw()
    figure.set_layout_engine("none")
    ground = agg.copy_from_bbox(figure.bbox)
    for k, name in enumerate(names):
        agg.restore_region(ground)
        title.set(text=name)
        drawn = draw(k)
        for artist in (*drawn, *last, title):
            figure.draw_artist(artist)
        for artist in drawn:
            artist.remove()
        yield np.array(agg.buffer_rgba())[..., :3]


def count(name: str, value: Any, high: int, low: int = 1) -> int:
    """An integer in a range."""
    chosen = integer(name, value)
    if not low <= chosen <= high:
        raise refusal(name, value, f"{low} to {high}")
    return chosen


def bare(axes: Axes) -> None:
    """Neither ticks nor a frame."""
    axes.set(xticks=[], yticks=[])
    axes.spines[:].set_visible(False)


def speed_label(material: object, name: str = "speed v") -> str:
    """What stands at an axis of speeds."""
    return f"{name} / c" if material is None else f"{name} / (m/s)"


def legend(axes: Axes, **options: Any) -> None:
    """A legend without a frame line, over a light ground so that it stays legible above curves."""
    axes.legend(**{"framealpha": 0.8, "edgecolor": "none", "handlelength": 2.4, "borderaxespad": 0.3} | options)


def written(value: float, digits: int = 4) -> str:
    """A number for labels, with a minus sign instead of a hyphen."""
    return f"{value:.{digits}g}".replace("-", "−")
