"""Impact of a disk or a sphere that follows the wall's force statically."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, broadcast, numbers
from stoss._documentation import documented
from stoss.bodies._bodies import Disk, Sphere, speed_unit, speeds_in_si
from stoss.export._text import span
from stoss.quasistatic._compression import choose_law, poissons_of
from stoss.results._result import Number, columns, picture
from stoss.results._si import ImpactsInSi, Si, warn_of_materials


class SlowOfABody(ImpactsInSi):
    """What slow impacts and their estimates have in common.

    Attributes:
        speed: Of the centre of mass towards the wall, c.
        body (Disk, Sphere or None): What it was made with, if it was one.
    """

    _given = {"poisson": "", "speed": "speed"}
    _told: ClassVar[tuple[str, ...]] = ("law", "body")

    law: str
    poisson: Number


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SlowImpactOfABody(SlowOfABody):
    """What slow impacts of disks and spheres have in common."""

    plot = picture("Contact time against speed. See `stoss.plot.slow_impact`.")
    _name: ClassVar[str] = "slow impact"

    law: str
    poisson: Number
    speed: Number
    contact_time: Number
    max_compression: Number
    max_force: Number

    def __repr__(self) -> str:
        count = "" if isinstance(self.speed, float) else f"{np.size(self.speed)} values, "
        return (
            f"{type(self).__name__}({count}poisson={span(self.poisson)}, speed={span(self.speed)} c: "
            f"contact time {span(self.contact_time)} R/c, compression {span(self.max_compression)} R)"
        )


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SlowImpact(SlowImpactOfABody):
    """Slow impacts, by conservation of energy: nothing is lost.

    Numbers if all inputs were numbers, otherwise arrays of the shape to which `poisson` and `speed`
    broadcast. Relative errors, as solutions of their equation, are below 1e-14.
    """

    _kind = "slow impact"

    body: Disk | None


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class PointSlowImpact(SlowImpactOfABody):
    """Slow impacts of a sphere, by conservation of energy: nothing is lost.

    Numbers, or arrays of the shape of `speed`. Relative errors are below 1e-13.
    """

    _kind = "point slow impact"
    max_radius_si = Si("Maximum radius of the contact, m.")

    max_radius: Number
    body: Sphere


def slow_inputs(body: Any, speed: Any, poisson: Any, law: Any) -> tuple[str, NDArray[np.float64], NDArray[np.float64]]:
    """The law, and Poisson's ratios and speeds in c of one shape."""
    poissons = poissons_of(body, poisson)
    chosen = choose_law(body, law)
    poissons, speeds = broadcast(3, poisson=poissons, speed=numbers("speed", speed) / speed_unit(body))
    return chosen, poissons, speeds


@overload
def slow_impact(body: Sphere, *, speed: ArrayLike, poisson: None = None, law: str = "center") -> PointSlowImpact: ...


@overload
def slow_impact(
    body: Disk | None = None, *, speed: ArrayLike, poisson: ArrayLike | None = None, law: str = "center"
) -> SlowImpact: ...


@documented
def slow_impact(
    body: Disk | Sphere | None = None, *, speed: ArrayLike, poisson: ArrayLike | None = None, law: str = "center"
) -> SlowImpact | PointSlowImpact:
    """Impacts that are so slow that the body follows the wall's force statically: δ̈ = −F(δ).

    A `StossWarning` says that a sphere of that material yields at such a speed.

    Parameters:
        speed: Of the centre of mass towards the wall, 1e-100 (of a sphere 1e-12) to `limit_speed`,
            c (with a material: m/s). Two equal bodies that each move at `speed` towards each other
            are the same problem.

    Examples:
        >>> slow = stoss.quasistatic.slow_impact(poisson=0.33, speed=[1e-12, 1e-6, 1e-3])
        >>> slow.contact_time.round(3)
        array([16.968, 12.174,  8.754])
        >>> stoss.quasistatic.slow_impact(stoss.Sphere(poisson=0.3), speed=1e-4)
        PointSlowImpact(poisson=0.3, speed=0.0001 c: contact time 30.5867 R/c, compression 0.00104057 R)
    """
    chosen, poissons, speeds = slow_inputs(body, speed, poisson, law)
    with speeds_in_si(body):
        function = _core.point_slow_impact if isinstance(body, Sphere) else _core.slow_impact
        table = function(chosen, poissons.ravel(), speeds.ravel())
    values = {"poisson": poissons, "speed": speeds, **columns(table)}
    shaped = {name: arranged(column, speeds.shape) for name, column in values.items()}
    made = PointSlowImpact if isinstance(body, Sphere) else SlowImpact
    result: SlowImpact | PointSlowImpact = made(law=chosen, body=body, **shaped)
    warn_of_materials(result, 2, lossy=False)
    return result
