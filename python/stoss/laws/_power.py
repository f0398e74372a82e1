"""Laws F = k δⁿ + g δ^q δ̇: springs and dashpots, each a choice of the two powers."""

from __future__ import annotations

import dataclasses
import math
from typing import ClassVar, TypeVar

import numpy as np

from stoss._errors import InvalidInput
from stoss.laws._collision import STIFFEST, Spring, along_normal, along_surface
from stoss.laws._law import Array, Impacts, Law, nearest, nearest_to, scale

Made = TypeVar("Made", bound="PowerLaw")


@dataclasses.dataclass(frozen=True)
class PowerLaw(Law):
    """F = k δⁿ + g δ^q δ̇, with a spring of the stiffness κ dF/dδ along the surface.

    ε depends on d = g/m (m/k)^{(q+1)/(n+1)} v^p alone, p = (2q + 1 − n)/(n + 1): so d/v^p follows from
    ε, then k from the contact time, and κ from ε_t.
    """

    n: ClassVar[float]
    q: ClassVar[float]

    stiffness: float
    damping: float
    tangential_ratio: float | None

    @classmethod
    def fitted(cls: type[Made], impacts: Impacts, spring: Spring, ratios: tuple[float, float]) -> Made:
        """The nearest such law."""
        n, q, p, pair = cls.n, cls.q, cls._power(), impacts.pair
        speeds = impacts.speed if p else impacts.speed[:1]  # without p all impacts are alike
        reference = float(np.exp(np.mean(np.log(impacts.speed))))  # so that the number is that of a middle speed

        def number(at: float) -> Array:
            return at * (speeds / reference) ** p

        lost = max(1.0 - float(np.mean(impacts.restitution)), 1e-12)  # to first order as much as d
        most = STIFFEST * float((reference / speeds).min()) ** p
        at = nearest_to(lambda d: cls._head_on(number(d), spring)[0], impacts.restitution, lost, most)
        unit = cls._head_on(number(at), spring)[1] * impacts.speed ** ((1.0 - n) / (n + 1.0))
        if not np.isfinite(unit).all():
            raise InvalidInput.out_of_range(
                "law", cls.NAME, "another one", "with so much loss its contacts would not end"
            )
        time = scale(unit, impacts.contact_time)  # (m/k)^{1/(n+1)}
        ratio = None
        if impacts.friction > 0.0:
            impact = along_normal(n, q, number(at), spring)
            ratio = nearest(
                lambda each: along_surface(n, impact, each, spring, impacts.sliding), impacts.tangential, *ratios
            )
        damping = at / reference**p * pair.mass * time ** -(q + 1.0)
        return cls(pair, spring, impacts.friction, pair.mass * time ** -(n + 1.0), damping, ratio)

    @classmethod
    def _head_on(cls, damping: Array, spring: Spring) -> tuple[Array, Array]:
        """ε and duration, in units of the impact, by the number d: integrated where there is no closed form."""
        impact = along_normal(cls.n, cls.q, damping, spring)
        return impact.restitution, impact.duration

    @classmethod
    def _power(cls) -> float:
        return (2.0 * cls.q + 1.0 - cls.n) / (cls.n + 1.0)

    @property
    def _time(self) -> float:
        return float((self.pair.mass / self.stiffness) ** (1.0 / (self.n + 1.0)))

    def _number(self, speed: Array) -> Array:
        slow = self.damping / self.pair.mass * self._time ** (self.q + 1.0)
        return slow * speed ** self._power()  # type: ignore[no-any-return]

    def restitution(self, speed: Array) -> Array:
        return self._head_on(self._number(speed), self.spring)[0]

    def contact_time(self, speed: Array) -> Array:
        duration = self._head_on(self._number(speed), self.spring)[1]
        return duration * self._time * speed ** ((1.0 - self.n) / (self.n + 1.0))

    def tangential_restitution(self, speed: Array, sliding: Array) -> Array | None:
        if self.tangential_ratio is None:
            return None
        impact = along_normal(self.n, self.q, self._number(speed), self.spring)
        return along_surface(self.n, impact, self.tangential_ratio, self.spring, sliding)

    @property
    def modulus(self) -> float:
        """E* of a Hertzian contact, k = (4/3) E* √R."""
        return 0.75 * self.stiffness / math.sqrt(self.pair.radius)
