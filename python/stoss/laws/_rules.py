"""Laws that are no spring and dashpot: Thornton's spheres, and rules of what an impact does."""

from __future__ import annotations

import dataclasses

import numpy as np
from scipy import special

from stoss.laws._law import TURN, Array, Impacts, Law, Spring, nearest, scale

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
    """Thornton's elastic–plastic spheres: Hertz' force up to a pressure, then a line; back along a flatter Hertz.

    In units of the first yield, where overlap, force and speed are 1, the way in has F = δ^{3/2} up to 1 and F = (3δ −
    1)/2 beyond. From the largest overlap y with the force Y the bodies part by Hertz' law of the radius R y^{3/2}/Y. So
    ε² = Y² y^{−1/2}/v², v² = 1 + (15/8)(y² − 1) − (5/4)(y − 1). Source: C. Thornton, J. Appl. Mech. 64, 383, 1997.
    """

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


BETAS = np.linspace(-1.0, 1.0, 4001)
"""Among which the best β₀ is chosen."""


@dataclasses.dataclass(frozen=True)
class Walton(Law):
    """Walton's rule of three numbers: ε, the friction μ, and β₀, the largest ε_t.

    Bodies that slide to the end have ε_t = (7/2) μ (1 + ε) v/s − 1; all others have β₀. Source: O. R. Walton, in
    Particulate Two-Phase Flow (M. C. Roco, ed.), 1993; S. F. Foerster and others, Phys. Fluids 6, 1108, 1994.
    """

    NAME = "walton"
    EQUATION = "ε_n = e, ε_t = min(β₀, (7/2) μ (1 + e) v/s − 1)"
    UNITS = {"e": "", "beta0": ""}

    e: float
    beta0: float | None
    slowest: float
    """Of the fitted speeds, where programs with a threshold begin to bounce."""

    @classmethod
    def fitted(cls, impacts: Impacts, spring: Spring, ratios: tuple[float, float]) -> Walton:
        """The nearest such rule: ε is the mean."""
        mean, slowest = float(np.mean(impacts.restitution)), float(impacts.speed.min())
        made = cls(impacts.pair, spring, impacts.friction, mean, None, slowest)
        if impacts.friction == 0.0:
            return made
        tried = np.minimum(BETAS[:, None], made._sliding_on(impacts.sliding))  # the same at all speeds
        errors = ((tried[:, None, :] - impacts.tangential) ** 2).mean(axis=(1, 2))
        return dataclasses.replace(made, beta0=float(BETAS[np.argmin(errors)]))

    def _sliding_on(self, sliding: Array) -> Array:
        return TURN * (1.0 + self.e) / sliding - 1.0

    def restitution(self, speed: Array) -> Array:
        return np.full_like(speed, self.e)

    def tangential_restitution(self, speed: Array, sliding: Array) -> Array | None:
        if self.beta0 is None:
            return None
        return np.broadcast_to(np.minimum(self.beta0, self._sliding_on(sliding)), (speed.size, sliding.size))


ROWS = 5
"""Of a table; they are equally spaced in the logarithm of the speed."""


@dataclasses.dataclass(frozen=True)
class Table(Law):
    """A table of ε against the speed, between whose rows programs interpolate linearly."""

    NAME = "table"
    EQUATION = "ε between rows (v, ε), linear in v"
    UNITS = {}

    speeds: tuple[float, ...]
    values: tuple[float, ...]

    @classmethod
    def fitted(cls, impacts: Impacts, spring: Spring, ratios: tuple[float, float]) -> Table:
        """The values at the rows with the least squares of errors."""
        rows = np.geomspace(impacts.speed.min(), impacts.speed.max(), ROWS)
        shapes = np.stack([np.interp(impacts.speed, rows, each) for each in np.eye(ROWS)], axis=1)
        values = np.linalg.lstsq(shapes, impacts.restitution, rcond=None)[0]
        return cls(impacts.pair, spring, impacts.friction, tuple(rows.tolist()), tuple(values.tolist()))

    def restitution(self, speed: Array) -> Array:
        return np.interp(speed, self.speeds, self.values)

    @property
    def constants(self) -> dict[str, float]:
        return {f"restitution at {speed:.6g}": value for speed, value in zip(self.speeds, self.values)}


POWERS = 3
"""Of the angle, up to which polynomials go."""

ANGLES = np.linspace(1.0, 90.0, 90)
"""In degrees, at which polynomials are fitted."""


@dataclasses.dataclass(frozen=True)
class Polynomial(Law):
    """What becomes of a ball without spin that hits a wall, by polynomials of the angle between path and wall.

    ε = Σ aᵢ θⁱ, and the velocity along the wall is multiplied by Σ bᵢ θⁱ, which is 1 − (2/7)(1 + ε_t); θ is in degrees.
    Both are fitted at the fastest speed V, where the ball approaches with V sin θ and slides with s = V cos θ:
    throughout, beyond the largest s/(μv) that was computed. Impacts slower along the normal than the range count as its
    slowest.
    """

    NAME = "polynomial"
    EQUATION = "ε = Σ aᵢ θⁱ, tangent Σ bᵢ θⁱ, θ in degrees"
    UNITS = {}

    normal: tuple[float, ...]
    tangent: tuple[float, ...]
    fastest: float

    @classmethod
    def fitted(cls, impacts: Impacts, spring: Spring, ratios: tuple[float, float]) -> Polynomial:
        """The least squares of errors at each degree."""
        speed, fastest, mu = impacts.speed, float(impacts.speed.max()), impacts.friction
        angle = np.radians(ANGLES)
        along = np.log(np.maximum(fastest * np.sin(angle), speed.min()))
        epsilon = np.interp(along, np.log(speed), impacts.restitution)
        kept = np.ones_like(angle)
        if mu > 0.0:
            sliding = 1.0 / (mu * np.tan(angle))
            columns = [np.interp(along, np.log(speed), each) for each in impacts.tangential.T]
            least = np.minimum(np.maximum(sliding, impacts.sliding[0]), impacts.sliding[-1])
            sticks = np.array([np.interp(x, impacts.sliding, row) for x, row in zip(least, np.transpose(columns))])
            slides = TURN * (1.0 + epsilon) / sliding - 1.0
            kept = 1.0 - (1.0 + np.where(sliding > impacts.sliding[-1], slides, sticks)) / TURN
        degrees = np.arange(POWERS + 1)
        powers = (ANGLES[:, None] / 90.0) ** degrees
        normal, tangent = (
            tuple((np.linalg.lstsq(powers, each, rcond=None)[0] / 90.0**degrees).tolist())
            for each in (epsilon, kept)
        )
        return cls(impacts.pair, spring, mu, normal, tangent, fastest)

    def restitution(self, speed: Array) -> Array:
        angle = np.degrees(np.arcsin(np.clip(speed / self.fastest, 0.0, 1.0)))
        return np.polynomial.Polynomial(self.normal)(angle)  # type: ignore[no-any-return]

    def tangential_restitution(self, speed: Array, sliding: Array) -> Array | None:
        if self.friction == 0.0:
            return None
        angle = np.degrees(np.arctan(1.0 / (self.friction * sliding)))
        along = TURN * (1.0 - np.polynomial.Polynomial(self.tangent)(angle)) - 1.0
        return np.broadcast_to(along, (speed.size, sliding.size))

    @property
    def constants(self) -> dict[str, float]:
        both = (("normal", self.normal), ("tangent", self.tangent))
        return {f"{name} {power}": value for name, values in both for power, value in enumerate(values)}
