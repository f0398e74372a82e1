"""Laws F = k δⁿ + g δ^q δ̇: springs and dashpots, each a choice of the two powers."""

from __future__ import annotations

import dataclasses
import math
from typing import ClassVar, TypeVar

import numpy as np

from stoss._errors import InvalidInput
from stoss.laws._law import (
    STIFFEST, Array, Impacts, Law, Spring, along_normal, along_surface, nearest, nearest_to, scale,
)

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


@dataclasses.dataclass(frozen=True)
class Linear(PowerLaw):
    """The linear spring and dashpot: F = k δ + g δ̇.

    ε is the same at all speeds. With ζ = g/(2√(mk)) and ω = √(k/m), a contact that pulls before it ends, at δ = 0, has
    ε = exp(−πζ/√(1 − ζ²)) and lasts π/(ω√(1 − ζ²)), if ζ < 1. One that ends where its force is gone has ε = exp(−ζωt)
    and lasts t = 2 arccos ζ/(ω√(1 − ζ²)); of ζ > 1 this is 2 arcosh ζ/(ω√(ζ² − 1)). Source: T. Schwager and T. Pöschel,
    Granular Matter 9, 465, 2007.
    """

    NAME = "linear"
    EQUATION = "F = k δ + g δ̇"
    UNITS = {"stiffness": "N/m", "damping": "kg/s", "tangential_ratio": ""}
    n = 1.0
    q = 0.0

    @property
    def epsilon(self) -> float:
        """ε, the same at all speeds."""
        return float(self.restitution(np.ones(1))[0])

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


@dataclasses.dataclass(frozen=True)
class Mujoco(Linear):
    """MuJoCo's contact with constant impedance: a = −(2/T) v − r/(Tζ)² while it pushes, for solref = (T, ζ).

    A contact constrains an acceleration, so mass does not count: it is the linear law with ω = 1/(Tζ), which never
    pulls. With solimp = (d, d, width) the impedance is d at every overlap, and drops out of what happens along the
    normal. Source: MuJoCo's documentation, Computation, Constraint model, and Modeling, Solver parameters.
    """

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


@dataclasses.dataclass(frozen=True)
class Tsuji(PowerLaw):
    """Hertz' spring with the dashpot of Tsuji: F = k δ^{3/2} + α √(mk) δ^{1/4} δ̇.

    ε is the same at all speeds, that of the linear law with ζ = α/√5 (E. Antypov and J. A. Elliott, EPL 94, 50004,
    2011): δ^{5/4} as a function of the speed is its overlap. Source: Y. Tsuji, T. Tanaka and T. Ishida, Powder
    Technology 71, 239, 1992.
    """

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


PADE = (0.501086, (0.501086, 1.15345, 0.577977, 0.532178))
"""c₁ and b₁ to b₄ of the expression of P. Müller and T. Pöschel (Phys. Rev. E 84, 021302, 2011)."""


@dataclasses.dataclass(frozen=True)
class Viscoelastic(PowerLaw):
    """Viscoelastic spheres: F = k (δ^{3/2} + (3/2) A √δ δ̇).

    Found by G. Kuwabara and K. Kono (Jpn. J. Appl. Phys. 26, 1230, 1987) and N. V. Brilliantov and others (Phys. Rev. E
    53, 5382, 1996). ε falls with x = (3/2) A (k/m)^{2/5} v^{1/5} as 1 − 1.153449 x + …
    """

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


@dataclasses.dataclass(frozen=True)
class HuntCrossley(PowerLaw):
    """The law of Hunt and Crossley: F = k δ^{3/2} (1 + λ δ̇).

    Its force vanishes where the bodies part. ε falls with λv alone: λv (1 + ε) = ln[(1 + λv)/(1 − ε λv)]. Source:
    K. H. Hunt and F. R. E. Crossley, J. Appl. Mech. 42, 440, 1975.
    """

    NAME = "hunt-crossley"
    EQUATION = "F = k δ^(3/2) (1 + λ δ̇)"
    UNITS = {"stiffness": "N/m^1.5", "hysteresis": "s/m", "tangential_ratio": ""}
    n = 1.5
    q = 1.5

    @property
    def hysteresis(self) -> float:
        """λ."""
        return self.damping / self.stiffness


@dataclasses.dataclass(frozen=True)
class LinearHuntCrossley(HuntCrossley):
    """The same with a linear spring, as Drake has it: F = k δ (1 + λ δ̇). ε falls with λv alone, as above."""

    EQUATION = "F = k δ (1 + λ δ̇)"
    UNITS = {"stiffness": "N/m", "hysteresis": "s/m", "tangential_ratio": ""}
    n = 1.0
    q = 1.0
