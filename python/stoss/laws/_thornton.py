"""Thornton's elastic–plastic spheres: Hertz' force up to a contact pressure, then a line; back along a flatter Hertz.

In units of the first yield, where overlap, force and speed are 1, the way in has F = δ^{3/2} up to 1 and
F = (3δ − 1)/2 beyond. From the largest overlap y with the force Y the bodies part by Hertz' law of the radius
R y^{3/2}/Y. So
ε² = Y² y^{−1/2}/v², v² = 1 + (15/8)(y² − 1) − (5/4)(y − 1). Source: C. Thornton, J. Appl. Mech. 64, 383, 1997.
"""

from __future__ import annotations

import dataclasses

import numpy as np
from scipy import special

from stoss.laws._collision import Spring
from stoss.laws._law import Array, Impacts, Law, nearest, scale

HERTZ = 2.0 * np.sqrt(np.pi) * special.gamma(1.4) / special.gamma(0.9)
"""Duration of an impact by Hertz' law over largest overlap and speed, 2.9433."""

MASS = 0.8
"""In units of the first yield: ½ m v² is the work ∫₀¹ δ^{3/2} dδ = 2/5 at v = 1."""


def bounce(speed: Array) -> tuple[Array, Array]:
    """ε and duration at these speeds, in units of the first yield."""
    v = np.maximum(speed, 1.0)
    y = (1.25 + np.sqrt(1.5625 + 7.5 * (v**2 - 1.0 + 0.625))) / 3.75
    force = 1.5 * y - 0.5
    epsilon = force * y**-0.25 / v
    way, turn = y - 1.0 / 3.0, np.sqrt(1.5 / MASS)  # the line is a spring around δ = 1/3
    in_by_hertz = special.hyp2f1(0.5, 0.4, 1.4, v**-2.0) / v
    in_by_line = (np.pi / 2.0 - np.arcsin(np.minimum(2.0 / 3.0 / way, 1.0))) / turn
    back = 0.5 * HERTZ * (force / y**0.5) / (epsilon * v)  # its overlap is y over the ratio of radii
    elastic = speed <= 1.0
    duration = np.where(elastic, HERTZ * np.minimum(speed, 1.0) ** -0.2, in_by_hertz + in_by_line + back)
    return np.where(elastic, 1.0, epsilon), duration


@dataclasses.dataclass(frozen=True)
class Thornton(Law):
    """Hertz, then a limiting contact pressure."""

    NAME = "thornton"
    EQUATION = "F = k δ^(3/2) up to the yield speed, then at a limiting pressure"
    UNITS = {"stiffness": "N/m^1.5", "yield_speed": "m/s"}

    stiffness: float
    yield_speed: float

    @classmethod
    def fitted(cls, impacts: Impacts, spring: Spring, ratios: tuple[float, float]) -> Thornton:
        """The nearest such law."""
        speed = impacts.speed
        low, high = 1e-3 * speed.min(), speed.max()
        its = nearest(lambda at: bounce(speed / at)[0], impacts.restitution, low, high, 61)
        # In units of the first yield a time is δ/v, and k δ^{5/2} = (5/4) m v².
        time = scale(bounce(speed / its)[1], impacts.contact_time)
        stiffness = 1.25 * impacts.pair.mass * its**2 / (time * its) ** 2.5
        return cls(impacts.pair, spring, impacts.friction, stiffness, its)

    def restitution(self, speed: Array) -> Array:
        return bounce(speed / self.yield_speed)[0]

    def contact_time(self, speed: Array) -> Array:
        overlap = (1.25 * self.pair.mass * self.yield_speed**2 / self.stiffness) ** 0.4
        return bounce(speed / self.yield_speed)[1] * overlap / self.yield_speed  # type: ignore[no-any-return]
