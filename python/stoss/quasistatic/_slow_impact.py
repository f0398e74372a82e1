"""Slow impacts as results."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np

from stoss.bodies._bodies import Disk, Sphere
from stoss.results._result import Number, span
from stoss.results._si import InSi


class SlowImpactOfABody(InSi):
    """What slow impacts of disks and spheres have in common."""

    _name: ClassVar[str] = "slow impact"
    _given = {"poisson": "", "speed": "speed"}

    law: str
    poisson: Number

    def __repr__(self) -> str:
        count = "" if isinstance(self.speed, float) else f"{np.size(self.speed)} values, "
        return (
            f"{type(self).__name__}({count}poisson={span(self.poisson)}, speed={span(self.speed)} c: "
            f"contact time {span(self.contact_time)} R/c, compression {span(self.max_compression)} R)"
        )

    def plot(self, ax: Any = None) -> Any:
        """Contact time against speed. See `stoss.plot.slow_impact`."""
        return self._picture(ax)

    def _inputs(self) -> dict[str, Any]:
        return {"law": self.law} | ({"body": self.body} if self.body else {})


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SlowImpact(SlowImpactOfABody):
    """Slow impacts, by conservation of energy: nothing is lost.

    Numbers if all inputs were numbers, otherwise arrays of the shape to which `poisson` and `speed`
    broadcast. Relative errors, as solutions of their equation, are below 1e-14.

    Attributes
    ----------
    law : str
        Of compression.
    poisson : float or ndarray
        2-D Poisson's ratio.
    speed : float or ndarray
        Of the centre of mass towards the wall, c.
    contact_time : float or ndarray
        From first to last contact, R/c.
    max_compression : float or ndarray
        In R.
    max_force : float or ndarray
        πRE = mc²/R.
    body : Disk or None
        What it was made with, if it was one.
    material : Material or None
        Of the body. If there is one, `speed_si`, `contact_time_si`, `max_force_si` and
        `max_compression_si` are the SI values.
    """

    _kind = "slow impact"

    law: str
    poisson: Number
    speed: Number
    contact_time: Number
    max_compression: Number
    max_force: Number
    body: Disk | None


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class PointSlowImpact(SlowImpactOfABody):
    """Slow impacts of a sphere, by conservation of energy: nothing is lost.

    Numbers, or arrays of the shape of `speed`. Relative errors are below 1e-13.

    Attributes
    ----------
    law : str
        Of compression.
    poisson : float or ndarray
        Poisson's ratio.
    speed : float or ndarray
        Of the centre of mass towards the wall, c.
    contact_time : float or ndarray
        From first to last contact, R/c.
    max_compression : float or ndarray
        In R.
    max_force : float or ndarray
        mc²/R = (4π/3)R²E.
    max_radius : float or ndarray
        Maximum radius of the contact, R.
    body : Sphere
    material : Material or None
        Of the body. If there is one, `speed_si`, `contact_time_si`, `max_force_si`,
        `max_compression_si` and `max_radius_si` are the SI values. With a yield strength,
        `yield_speed`, `yield_speed_si` and `beyond_yield` say where yielding begins.
    """

    _kind = "point slow impact"

    law: str
    poisson: Number
    speed: Number
    contact_time: Number
    max_compression: Number
    max_force: Number
    max_radius: Number
    body: Sphere

    @property
    def max_radius_si(self) -> Number:
        """Maximum radius of the contact, m."""
        return self._in_si("max_radius")
