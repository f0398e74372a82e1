"""What all laws have in common: their constants, how these come near to what stoss has computed, and power laws.

Impacts by power laws, F = k δⁿ + g δ^q δ̇, go along the normal and with a spring along the surface. In units of the
impact, L = (m v²/k)^{1/(n+1)} and L/v with the reduced mass m, the overlap x = δ/L obeys x″ = −xⁿ − d x^q x′ from
x = 0, x′ = 1, with the one number d. Along the surface s is the sliding velocity over μv. The spring has the stiffness
κ n x^{n−1}, κ times that along the normal, and its force f stays within the normal force: s′ = −(7/2) f for solid
spheres.
"""

from __future__ import annotations

import abc
import dataclasses
from typing import Callable, ClassVar, Mapping, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray
from scipy import optimize

Array = NDArray[np.float64]

STEPS = 1000
"""In a time of π: ε has an error of at most 2e-6, and of 5e-5 where 0 < q < ½ and its dashpot begins abruptly."""

LONGEST = 6
"""What lasts longer, in π, has not ended: ε is 0."""

STIFFEST = 500.0
"""Largest d that these steps can follow."""

TURN = 3.5
"""1 + m R²/I of solid spheres: what a force at the surface does to its velocity, over what it does to the centre's."""


@dataclasses.dataclass(frozen=True)
class Spring:
    """How a program integrates its contacts.

    `tension`: a contact ends where the bodies part, and pulls before; else where its force is gone. `rising`: the
    tangential force is what has been added to it, by the stiffness of each moment; else the path times today's.
    """

    tension: bool = False
    rising: bool = False


class Approach(NamedTuple):
    """An impact along the normal: ε, its duration, and overlap and force at each step, step by step."""

    restitution: Array
    duration: Array
    overlap: Array
    force: Array


def along_normal(n: float, q: float, damping: Array, spring: Spring) -> Approach:
    """Impacts with these numbers d, by the method of Runge and Kutta."""
    d, h = np.asarray(damping, dtype=np.float64), np.pi / STEPS

    def force(x: Array, u: Array) -> Array:
        x = np.maximum(x, 0.0)
        return x**n + d * x**q * u

    def left(x: Array, u: Array) -> Array:
        """What becomes negative at the end: the overlap, or the force over x^q."""
        return x if spring.tension or q >= n else np.maximum(x, 0.0) ** (n - q) + d * u

    x, u = np.zeros_like(d), np.ones_like(d)
    restitution, duration = np.full_like(d, np.nan), np.full_like(d, np.nan)
    overlaps, forces = [x], [force(x, u)]
    before = np.full_like(d, np.inf)
    for step in range(1, LONGEST * STEPS):
        k1 = -force(x, u)
        k2 = -force(x + h / 2 * u, u + h / 2 * k1)
        k3 = -force(x + h / 2 * u + h * h / 4 * k1, u + h / 2 * k2)
        k4 = -force(x + h * u + h * h / 2 * k2, u + h * k3)
        x, u, old = x + h * u + h * h / 6 * (k1 + k2 + k3), u + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), u
        after = left(x, u)
        ends = np.isnan(duration) & (u < 0.0) & (after <= 0.0)
        share = np.where(ends, before / np.where(ends, before - after, 1.0), 0.0)
        duration = np.where(ends, (step - 1 + share) * h, duration)
        restitution = np.where(ends, -(old + share * (u - old)), restitution)
        before, going = after, np.isnan(duration)
        overlaps.append(np.where(going, np.maximum(x, 0.0), 0.0))
        forces.append(np.where(going, force(x, u), 0.0))
        if not going.any():
            break
    restitution, duration = np.nan_to_num(restitution), np.where(np.isnan(duration), np.inf, duration)
    return Approach(restitution, duration, np.array(overlaps), np.array(forces))


def along_surface(n: float, approach: Approach, ratio: float, spring: Spring, sliding: Array) -> Array:
    """ε_t = −s′/s for each impact (rows) and each sliding velocity at first, over μv (columns)."""
    h = np.pi / STEPS
    velocity = np.broadcast_to(sliding, (approach.duration.size, sliding.size)).copy()
    start, kept, force = velocity.copy(), np.zeros_like(velocity), np.zeros_like(velocity)
    stiffness = ratio * n * np.maximum(approach.overlap, 1e-300) ** (n - 1.0)
    middle = 0.5 * (stiffness[1:] + stiffness[:-1])
    for stiff, rise, limit in zip(stiffness[1:, :, None], middle[:, :, None], np.abs(approach.force[1:, :, None])):
        if spring.rising:
            force = np.clip(force + rise * h * velocity, -limit, limit)
        else:
            force = np.clip(stiff * (kept + h * velocity), -limit, limit)
            kept = force / stiff
        velocity -= TURN * h * force
    return -velocity / start


Fitted = TypeVar("Fitted", bound="Law")

KAPPA = (0.1, 3.0)
"""Within which a stiffness along the surface is sought, over that along the normal."""


@dataclasses.dataclass(frozen=True)
class Pair:
    """Two spheres, or a sphere and a wall, in the units in which they were given: SI with a material.

    `mass` and `radius` are the reduced ones.
    """

    mass: float
    radius: float
    first_radius: float
    second_radius: float | None
    first_density: float
    second_density: float | None


@dataclasses.dataclass(frozen=True)
class Impacts:
    """What stoss computed: ε and contact time at each speed; at each speed and each s/(μv) also ε_t."""

    pair: Pair
    speed: Array
    restitution: Array
    contact_time: Array
    friction: float
    sliding: Array
    tangential: Array


@dataclasses.dataclass(frozen=True)
class Law(abc.ABC):
    """A law with its constants."""

    NAME: ClassVar[str]
    EQUATION: ClassVar[str]
    UNITS: ClassVar[Mapping[str, str]]  # of its constants in SI; "" of pure numbers

    pair: Pair
    spring: Spring
    friction: float

    @classmethod
    @abc.abstractmethod
    def fitted(cls: type[Fitted], impacts: Impacts, spring: Spring, ratios: tuple[float, float]) -> Fitted:
        """The law that comes nearest, with a ratio of stiffnesses along surface and normal in this range."""

    @abc.abstractmethod
    def restitution(self, speed: Array) -> Array:
        """ε at these speeds."""

    def contact_time(self, speed: Array) -> Array | None:
        """The contact time at these speeds; None of a rule that has none."""
        return None

    def tangential_restitution(self, speed: Array, sliding: Array) -> Array | None:
        """ε_t at each speed (rows) and each s/(μv) (columns); None of a law that says nothing of it."""
        return None

    @property
    def constants(self) -> dict[str, float]:
        """Its constants by name."""
        return {name: getattr(self, name) for name in self.UNITS if getattr(self, name) is not None}


Predicts = Callable[[float], Array]
"""ε or ε_t by one number above 0."""


def nearest_to(predict: Predicts, wanted: Array, guess: float, high: float) -> float:
    """The number up to `high` with the least root mean square error, found from a guess."""

    least = max(1.0 - float(np.mean(wanted)), 1e-12)  # so that errors are of the order of 1

    def errors(logarithm: Array) -> Array:
        return (predict(float(np.exp(logarithm[0]))) - wanted) / least

    def slopes(logarithm: Array) -> Array:
        step = 1e-4  # SciPy's own is relative, and the logarithm may be 0
        return ((errors(logarithm + step) - errors(logarithm - step)) / (2.0 * step))[:, None]

    fine = {"xtol": 1e-10, "ftol": 1e-12, "gtol": 1e-12, "max_nfev": 30}
    bounds = (-np.inf, np.log(high))
    found = optimize.least_squares(errors, [np.log(guess)], slopes, bounds=bounds, x_scale=0.1, **fine)
    return float(np.exp(found.x[0]))


def nearest(predict: Predicts, wanted: Array, low: float, high: float, grid: int = 25) -> float:
    """The number from `low` to `high` with the least root mean square error, as the best of a grid, refined."""

    def error(logarithm: float) -> float:
        return float(np.sqrt(np.mean((predict(float(np.exp(logarithm))) - wanted) ** 2)))

    places = np.linspace(np.log(low), np.log(high), grid)
    errors = [error(place) for place in places]
    best = int(np.argmin(errors))
    around = places[max(best - 1, 0)], places[min(best + 1, grid - 1)]
    found = optimize.minimize_scalar(error, bounds=around, method="bounded", options={"xatol": 1e-9})
    return float(np.exp(found.x if found.fun < errors[best] else places[best]))


def scale(unit: Array, wanted: Array) -> float:
    """The factor that brings these times nearest to the wanted ones, in relative errors."""
    ratio = unit / wanted
    return float(ratio.sum() / (ratio**2).sum())
