"""A table of ε against the speed, between whose rows programs interpolate linearly."""

from __future__ import annotations

import dataclasses

import numpy as np

from stoss.laws._collision import Spring
from stoss.laws._law import Array, Impacts, Law

ROWS = 5
"""Of a table; they are equally spaced in the logarithm of the speed."""


@dataclasses.dataclass(frozen=True)
class Table(Law):
    """ε at a few speeds; at others on straight lines between them, beyond the ends as at them."""

    NAME = "table"
    EQUATION = "ε between rows (v, ε), linear in v"
    UNITS = {}

    speeds: tuple[float, ...]
    values: tuple[float, ...]

    @classmethod
    def fitted(cls, impacts: Impacts, spring: Spring, ratios: tuple[float, float]) -> Table:
        """The values at the rows with the least squares of errors."""
        rows = np.geomspace(impacts.speed.min(), impacts.speed.max(), ROWS)
        shapes = np.stack([np.interp(impacts.speed, rows, each) for each in np.eye(ROWS)], axis=1)
        values = np.linalg.lstsq(shapes, impacts.restitution, rcond=None)[0]
        return cls(impacts.pair, spring, impacts.friction, tuple(rows.tolist()), tuple(values.tolist()))

    def restitution(self, speed: Array) -> Array:
        return np.interp(speed, self.speeds, self.values)

    @property
    def constants(self) -> dict[str, float]:
        return {f"restitution at {speed:.6g}": value for speed, value in zip(self.speeds, self.values)}
