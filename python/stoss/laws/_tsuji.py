"""Hertz' spring with the dashpot of Tsuji: F = k δ^{3/2} + α √(mk) δ^{1/4} δ̇.

ε is the same at all speeds, that of the linear law with ζ = α/√5 (E. Antypov and J. A. Elliott, EPL 94, 50004, 2011):
δ^{5/4} as a function of the speed is its overlap. Source: Y. Tsuji, T. Tanaka and T. Ishida, Powder Technology 71, 239,
1992.
"""

from __future__ import annotations

import dataclasses
import math

from stoss.laws._power import PowerLaw


@dataclasses.dataclass(frozen=True)
class Tsuji(PowerLaw):
    """F = k δ^{3/2} + α √(mk) δ^{1/4} δ̇."""

    NAME = "tsuji"
    EQUATION = "F = k δ^(3/2) + α √(m k) δ^(1/4) δ̇"
    UNITS = {"stiffness": "N/m^1.5", "alpha": "", "tangential_ratio": ""}
    n = 1.5
    q = 0.25

    @property
    def alpha(self) -> float:
        """α."""
        return self.damping / math.sqrt(self.pair.mass * self.stiffness)

    @property
    def nominal(self) -> float:
        """ε of a contact that pulls before it ends: what programs ask for to find α."""
        zeta = self.alpha / math.sqrt(5.0)
        return math.exp(-math.pi * zeta / math.sqrt(1.0 - zeta**2))
