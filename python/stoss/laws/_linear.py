"""The linear spring and dashpot: F = k δ + g δ̇.

ε is the same at all speeds. With ζ = g/(2√(mk)) and ω = √(k/m), a contact that pulls before it ends, at δ = 0, has
ε = exp(−πζ/√(1 − ζ²)) and lasts π/(ω√(1 − ζ²)), if ζ < 1. One that ends where its force is gone has ε = exp(−ζωt) and
lasts t = 2 arccos ζ/(ω√(1 − ζ²)); of ζ > 1 this is 2 arcosh ζ/(ω√(ζ² − 1)). Source: T. Schwager and T. Pöschel,
Granular Matter 9, 465, 2007.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from stoss.laws._collision import Spring
from stoss.laws._law import Array
from stoss.laws._power import PowerLaw


@dataclasses.dataclass(frozen=True)
class Linear(PowerLaw):
    """F = k δ + g δ̇."""

    NAME = "linear"
    EQUATION = "F = k δ + g δ̇"
    UNITS = {"stiffness": "N/m", "damping": "kg/s", "tangential_ratio": ""}
    n = 1.0
    q = 0.0

    @classmethod
    def _head_on(cls, damping: Array, spring: Spring) -> tuple[Array, Array]:
        """The closed form."""
        zeta = 0.5 * np.asarray(damping, dtype=np.float64)
        root = np.sqrt(np.abs((1.0 - zeta) * (1.0 + zeta)))
        ends = root > 0.0
        if spring.tension:
            ends &= zeta < 1.0
            duration = np.divide(np.pi, root, out=np.full_like(zeta, np.inf), where=ends)
            return np.exp(-zeta * duration), duration
        angle = np.where(zeta < 1.0, np.arccos(np.minimum(zeta, 1.0)), np.arccosh(np.maximum(zeta, 1.0)))
        duration = 2.0 * np.divide(angle, root, out=np.ones_like(zeta), where=ends)
        return np.exp(-zeta * duration), duration
