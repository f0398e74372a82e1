"""The linear spring and dashpot: F = k δ + g δ̇.

ε is the same at all speeds. With ζ = g/(2√(mk)) and ω = √(k/m), a contact that pulls before it ends, at δ = 0, has
ε = exp(−πζ/√(1 − ζ²)) and lasts π/(ω√(1 − ζ²)). One that ends where its force is gone has
ε = exp(−ζt/√(1 − ζ²)), t = π − arctan(2ζ√(1 − ζ²)/(1 − 2ζ²)). Source: T. Schwager and T. Pöschel, Granular Matter 9,
465, 2007.
"""

from __future__ import annotations

import dataclasses

from stoss.laws._power import PowerLaw


@dataclasses.dataclass(frozen=True)
class Linear(PowerLaw):
    """F = k δ + g δ̇."""

    NAME = "linear"
    EQUATION = "F = k δ + g δ̇"
    UNITS = {"stiffness": "N/m", "damping": "kg/s", "tangential_ratio": ""}
    n = 1.0
    q = 0.0
