"""Viscoelastic spheres: F = k (δ^{3/2} + (3/2) A √δ δ̇).

Found by G. Kuwabara and K. Kono (Jpn. J. Appl. Phys. 26, 1230, 1987) and N. V. Brilliantov and others (Phys. Rev. E 53,
5382, 1996). ε falls with x = (3/2) A (k/m)^{2/5} v^{1/5} as 1 − 1.153449 x + …
"""

from __future__ import annotations

import dataclasses

import numpy as np

from stoss.laws._law import Array
from stoss.laws._power import PowerLaw

PADE = (0.501086, (0.501086, 1.15345, 0.577977, 0.532178))
"""c₁ and b₁ to b₄ of the expression of P. Müller and T. Pöschel (Phys. Rev. E 84, 021302, 2011)."""


@dataclasses.dataclass(frozen=True)
class Viscoelastic(PowerLaw):
    """F = k (δ^{3/2} + (3/2) A √δ δ̇)."""

    NAME = "viscoelastic"
    EQUATION = "F = k (δ^(3/2) + (3/2) A √δ δ̇)"
    UNITS = {"stiffness": "N/m^1.5", "loss_time": "s", "tangential_ratio": ""}
    n = 1.5
    q = 0.5

    @property
    def loss_time(self) -> float:
        """A."""
        return self.damping / (1.5 * self.stiffness)

    def pade(self, speed: Array) -> Array:
        """ε by the expression of Müller and Pöschel, for a contact that ends where its force is gone."""
        root = np.sqrt(self._number(speed))
        above, below = PADE
        powers = root[..., None] ** np.arange(1, 5)
        return (1.0 + above * root) / (1.0 + powers @ np.array(below))  # type: ignore[no-any-return]
