"""The law of Hunt and Crossley: F = k δ^{3/2} (1 + λ δ̇).

Its force vanishes where the bodies part. ε falls with λv alone: λv (1 + ε) = ln[(1 + λv)/(1 − ε λv)]. Source:
K. H. Hunt and F. R. E. Crossley, J. Appl. Mech. 42, 440, 1975.
"""

from __future__ import annotations

import dataclasses

from stoss.laws._power import PowerLaw


@dataclasses.dataclass(frozen=True)
class HuntCrossley(PowerLaw):
    """F = k δ^{3/2} (1 + λ δ̇)."""

    NAME = "hunt-crossley"
    EQUATION = "F = k δ^(3/2) (1 + λ δ̇)"
    UNITS = {"stiffness": "N/m^1.5", "hysteresis": "s/m", "tangential_ratio": ""}
    n = 1.5
    q = 1.5

    @property
    def hysteresis(self) -> float:
        """λ."""
        return self.damping / self.stiffness
