"""Rows of a restitution curve, as the core fills them."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss.bodies._bodies import Body
from stoss.bodies._encounter import Against, refinable


class Curve:
    """The values of one body: rows that the core fills."""

    def __init__(
        self, body: Body, against: Against, where: NDArray[np.intp], speeds: NDArray[np.float64]
    ) -> None:
        self.body = body
        self.against = against
        self.where = where
        self.speeds = speeds
        self.rows = np.zeros(speeds.size, dtype=_core.restitution_row)
        for name, (kind, *_) in (self.rows.dtype.fields or {}).items():
            if kind.kind == "f":
                self.rows[name] = np.nan
        self.reasons: list[str] = []

    def compute(
        self,
        tolerance: float,
        absolute: float,
        threads: int,
        state: NDArray[Any],
        tick: Callable[[], None] | None,
    ) -> None:
        contact = refinable(self.body, self.against)
        _core.restitution_curve(
            contact, self.speeds, tolerance, absolute, threads, state, self.rows, self.reasons, tick
        )


def gather(curves: list[Curve], size: int) -> tuple[NDArray[Any], NDArray[np.object_]]:
    """Rows and reasons of all curves in their places; missing ones are NaN, "interrupted"."""
    reasons = np.full(size, "interrupted", dtype=object)
    for curve in curves:
        reasons[curve.where[: len(curve.reasons)]] = curve.reasons
    if len(curves) == 1:
        return curves[0].rows, reasons
    table = np.zeros(size, dtype=_core.restitution_row)
    for curve in curves:
        table[curve.where] = curve.rows
    return table, reasons
