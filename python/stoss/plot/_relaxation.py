"""Measured moduli and the Prony series that comes near them."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
import numpy as np

from stoss.bodies._measurement import FittedRelaxation
from stoss.plot import _style


@_style.picture_of(FittedRelaxation)
def master_curve(fitted: FittedRelaxation, ax: Axes | None = None) -> Axes:
    """Measured E′ and E″ against frequency, as points, and those of the fitted relaxation, as lines.

    Examples:
        >>> omega = np.geomspace(1, 1e4, 30)
        >>> moduli = 2e6 * (1 - 0.5 / (1 + 1j * omega * 0.01))
        >>> ax = stoss.plot.master_curve(stoss.relaxation_of_measurement(omega, moduli.real, moduli.imag))
        >>> ax.get_xlabel(), ax.get_ylabel()
        ('frequency ω / (rad/s)', 'modulus / Pa')
    """
    omega = np.geomspace(fitted.frequency[0], fitted.frequency[-1], 300)
    its = fitted.modulus(omega)
    labels: dict[str, Any] = {"xlabel": "frequency ω / (rad/s)", "ylabel": "modulus / Pa"}
    with _style.canvas(ax, size=(_style.COLUMN, 2.5), xscale="log", yscale="log", **labels) as axes:
        for measured, line, name, colour in (
            (fitted.storage, its.real, "E′", _style.BLUE), (fitted.loss, its.imag, "E″", _style.ORANGE),
        ):  # fmt: skip
            axes.plot(fitted.frequency, measured, "o", ms=3, color=colour)
            axes.plot(omega, line, color=colour, label=name)
        _style.legend(axes)
    return axes
