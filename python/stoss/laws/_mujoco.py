"""MuJoCo's contact with constant impedance: a = −(2/T) v − r/(Tζ)² while it pushes, for solref = (T, ζ).

A contact constrains an acceleration, so mass does not count: it is the linear law with ω = 1/(Tζ), which never pulls.
With solimp = (d, d, width) the impedance is d at every overlap, and drops out of what happens along the normal.
Source: MuJoCo's documentation, Computation, Constraint model, and Modeling, Solver parameters.
"""

from __future__ import annotations

import dataclasses
import math

from stoss.laws._linear import Linear


@dataclasses.dataclass(frozen=True)
class Mujoco(Linear):
    """The linear law in MuJoCo's numbers."""

    NAME = "mujoco"
    EQUATION = "a = -(2/T) v - r/(T ζ)², solref = (T, ζ)"
    UNITS = {"timeconst": "s", "dampratio": ""}

    @property
    def timeconst(self) -> float:
        """T."""
        return 2.0 * self.pair.mass / self.damping

    @property
    def dampratio(self) -> float:
        """ζ."""
        return self.damping / (2.0 * math.sqrt(self.pair.mass * self.stiffness))

    tangential_ratio: None = None
