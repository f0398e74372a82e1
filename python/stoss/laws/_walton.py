"""Walton's rule of three numbers: ε, the friction μ, and β₀, the largest ε_t.

Bodies that slide to the end have ε_t = (7/2) μ (1 + ε) v/s − 1; all others have β₀. Source: O. R. Walton, in
Particulate Two-Phase Flow (M. C. Roco, ed.), 1993; S. F. Foerster and others, Phys. Fluids 6, 1108, 1994.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from stoss.laws._collision import TURN, Spring
from stoss.laws._law import Array, Impacts, Law

BETAS = np.linspace(-1.0, 1.0, 4001)
"""Among which the best β₀ is chosen."""


@dataclasses.dataclass(frozen=True)
class Walton(Law):
    """ε_n = ε, ε_t = min(β₀, (7/2) μ (1 + ε) v/s − 1)."""

    NAME = "walton"
    EQUATION = "ε_n = e, ε_t = min(β₀, (7/2) μ (1 + e) v/s − 1)"
    UNITS = {"e": "", "beta0": ""}

    e: float
    beta0: float | None

    @classmethod
    def fitted(cls, impacts: Impacts, spring: Spring, ratios: tuple[float, float]) -> Walton:
        """The nearest such rule: ε is the mean."""
        made = cls(impacts.pair, spring, impacts.friction, float(np.mean(impacts.restitution)), None)
        if impacts.friction == 0.0:
            return made
        tried = np.minimum(BETAS[:, None], made._sliding_on(impacts.sliding))  # the same at all speeds
        errors = ((tried[:, None, :] - impacts.tangential) ** 2).mean(axis=(1, 2))
        return dataclasses.replace(made, beta0=float(BETAS[np.argmin(errors)]))

    def _sliding_on(self, sliding: Array) -> Array:
        return TURN * (1.0 + self.e) / sliding - 1.0

    def restitution(self, speed: Array) -> Array:
        return np.full_like(speed, self.e)

    def tangential_restitution(self, speed: Array, sliding: Array) -> Array | None:
        if self.beta0 is None:
            return None
        return np.broadcast_to(np.minimum(self.beta0, self._sliding_on(sliding)), (speed.size, sliding.size))
