"""What all laws have in common: constants, and what they make of impacts that stoss has computed."""

from __future__ import annotations

import abc
import dataclasses
from typing import Callable, ClassVar, Mapping, TypeVar

import numpy as np
from numpy.typing import NDArray
from scipy import optimize

from stoss.laws._collision import Spring

Array = NDArray[np.float64]
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
