"""What the items share: figures without pyplot, colours, numbers with their errors."""

from __future__ import annotations

import matplotlib
import numpy as np
import stoss
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from stoss.plot import _style
from stoss.plot._style import BLACK, BLUE, COLORS, GREEN, GREY, LINES, MARKERS, ORANGE, PRINT, PURPLE, SKY, VERMILION
from stoss.plot._style import legend, small_ticks

Table = dict[str, NDArray]  # columns by name, "speed[c]"
Tables = dict[str, Table]
Row = tuple[str, str, str, str]  # quantity, paper, protocol, converged

NONE = "–"  # in place of a missing number
COLUMN, PAGE = 3.4, 7.0  # inches: one column of a journal, and two

__all__ = [
    "BLACK", "BLUE", "COLORS", "COLUMN", "GREEN", "GREY", "LINES", "MARKERS", "NONE", "ORANGE", "PAGE", "PRINT",
    "PURPLE", "Row", "SKY", "Table", "Tables", "VERMILION", "axes_of", "legend", "measured", "power", "small_ticks",
    "written",
]  # fmt: skip


def axes_of(
    width: float, height: float, rows: int = 1, columns: int = 1, **options: object
) -> tuple[Figure, list[Axes]]:
    """A figure of this size in inches and its axes, row by row, in the small print of `stoss.plot`.

    Options are those of `Figure.subplots`. Matplotlib reads some settings only when text is made,
    others when the figure is saved: draw inside ``with matplotlib.rc_context(PRINT)``, as the
    runner does.
    """
    with matplotlib.rc_context(PRINT):
        figure = Figure(figsize=(width, height), layout="constrained")
        axes = list(np.ravel(figure.subplots(rows, columns, **options)))
        for each in axes:
            small_ticks(each)
    return figure, axes


def measured(value: float, error: float | None = None) -> str:
    """A value with the digits that its error leaves it: '0.94704 ± 0.00005'."""
    return stoss.with_error(float(value), None if error is None else float(error)).replace("-", "−")


def written(value: float, digits: int = 4) -> str:
    """A value without an error, with a minus sign instead of a hyphen."""
    return _style.written(float(value), digits)


def power(value: float, digits: int = 1) -> str:
    """A value as a power of ten: '2.5·10⁻⁴'."""
    mantissa, exponent = f"{value:.{digits}e}".split("e")
    raised = str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"{mantissa}·10{raised}".replace("-", "−")
