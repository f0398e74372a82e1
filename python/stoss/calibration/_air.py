"""A sphere that falls and rises in air: speeds of impact from heights, and from times of flight.

    dv/dt = −g (1 − ρₐ/ρ) − (ρₐ A/2m) c_d v |v|,   c_d = 24/Re (1 + 0.15 Re^0.687) + 0.42/(1 + 42500 Re^−1.16)

with Re = 2Rv/ν: R. Clift and W. H. Gauvin, Chemeca 70 (1970), of smooth spheres up to Re = 3·10⁵, to 6 %. The air is
that of 20 °C at sea level, and rests; what the accelerated air adds to the mass, ρₐ/2ρ, is left out.
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

GRAVITY = 9.80665  # m/s²
DENSITY = 1.204  # of air, kg/m³
VISCOSITY = 1.516e-5  # its kinematic one, m²/s
HIGHEST_REYNOLDS_NUMBER = 3e5
ACCURACY = {"rtol": 1e-9, "atol": 1e-12}


def drag_coefficient(reynolds: NDArray[np.float64] | float) -> NDArray[np.float64]:
    """c_d of a smooth sphere, above Re = 0."""
    its = np.asarray(reynolds, dtype=np.float64)
    found: NDArray[np.float64] = 24.0 / its * (1.0 + 0.15 * its**0.687) + 0.42 / (1.0 + 42500.0 * its**-1.16)
    return found


@dataclasses.dataclass(frozen=True)
class Flight:
    """Vertical motion of a sphere between impacts.

    Attributes:
        radius: m.
        density: Mass over volume, kg/m³.
        air: Whether there is any.
    """

    radius: float
    density: float
    air: bool

    @property
    def weight(self) -> float:
        """g, less buoyancy, m/s²."""
        return GRAVITY * (1.0 - DENSITY / self.density) if self.air else GRAVITY

    def drag(self, speed: float) -> float:
        """Deceleration by the air, m/s²."""
        if not self.air or speed <= 0.0:
            return 0.0
        of = float(drag_coefficient(2.0 * self.radius * speed / VISCOSITY))
        return 0.375 * DENSITY / self.density * of * speed**2 / self.radius

    def reynolds(self, speed: float) -> float:
        """Re at this speed; 0 without air."""
        return 2.0 * self.radius * speed / VISCOSITY if self.air else 0.0

    def after_fall(self, height: float) -> float:
        """Speed after a fall from rest, m/s."""
        return self._over(height, -1.0)

    def before_rise(self, height: float) -> float:
        """Speed at which a rise to this height begins, m/s."""
        return self._over(height, 1.0)

    def of_flight(self, duration: float) -> tuple[float, float]:
        """Speeds at the begin and the end of a flight of this duration, s, up and down to the same place."""
        up, down = self._from_top(duration, 1.0), self._from_top(duration, -1.0)
        rise = brentq(lambda time: up(time)[1] - down(duration - time)[1], 0.0, duration, xtol=1e-15 * duration)
        return float(up(rise)[0]), float(down(duration - rise)[0])

    def _over(self, height: float, sign: float) -> float:
        """√w of dw/dy = 2 (g′ ± drag), from w = 0 at the top."""
        if not self.air:
            return math.sqrt(2.0 * GRAVITY * height)

        def slope(_: float, square: NDArray[np.float64]) -> list[float]:
            return [2.0 * (self.weight + sign * self.drag(math.sqrt(max(float(square[0]), 0.0))))]

        return math.sqrt(float(solve_ivp(slope, (0.0, height), [0.0], **ACCURACY).y[0, -1]))

    def _from_top(self, duration: float, sign: float):  # type: ignore[no-untyped-def]
        """Speed and distance at a time from the top: in a fall, or in a rise seen backwards."""
        if not self.air:
            return lambda time: (GRAVITY * time, 0.5 * GRAVITY * time**2)

        def slope(_: float, state: NDArray[np.float64]) -> list[float]:
            return [self.weight + sign * self.drag(float(state[0])), float(state[0])]

        return solve_ivp(slope, (0.0, duration), [0.0, 0.0], dense_output=True, **ACCURACY).sol
