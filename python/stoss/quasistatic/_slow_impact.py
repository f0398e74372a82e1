"""Impact of a disk or a sphere that follows the wall's force statically."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, broadcast, numbers
from stoss._documentation import documented
from stoss.bodies._bodies import Disk, Sphere
from stoss.export._text import span
from stoss.quasistatic._compression import choose_law, poissons_of
from stoss.results._quantities import Number, SlowImpactQuantities
from stoss.results._result import columns, picture
from stoss.results._si import MayYield, in_c, told_in_c, warn_of_materials


class OfSlowImpacts(MayYield):
    """What slow impacts and their estimates have in common.

    Attributes:
        speed: Of the centre of mass towards the wall, c.
        body (Disk, Sphere or None): What it was made with, if it was one.
        max_radius: Maximum radius of the contact of a sphere, R; None of disks.
    """

    _given = {"poisson": "", "speed": "speed"}
    _told: ClassVar[tuple[str, ...]] = ("law", "body")


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SlowImpact(SlowImpactQuantities, OfSlowImpacts):
    """Slow impacts of a disk or a sphere, by conservation of energy: nothing is lost.

    Numbers if all inputs were numbers, otherwise arrays of the shape to which `poisson` and `speed`
    broadcast. Relative errors, as solutions of their equation, are below 1e-14, of spheres 1e-13.
    """

    plot = picture("Contact time against speed. See `stoss.plot.slow_impact`.")
    _name: ClassVar[str] = "slow impact"

    law: str
    poisson: Number
    speed: Number
    body: Disk | Sphere | None

    def __repr__(self) -> str:
        count = "" if isinstance(self.speed, float) else f"{np.size(self.speed)} values, "
        return (
            f"SlowImpact({count}poisson={span(self.poisson)}, speed={span(self.speed)} c: "
            f"contact time {span(self.contact_time)} R/c, compression {span(self.max_compression)} R)"
        )


def slow_inputs(body: Any, speed: Any, poisson: Any, law: Any) -> tuple[str, NDArray[np.float64], NDArray[np.float64]]:
    """The law, and Poisson's ratios and speeds in c of one shape."""
    poissons = poissons_of(body, poisson)
    chosen = choose_law(body, law)
    poissons, speeds = broadcast(3, poisson=poissons, speed=in_c(body, numbers("speed", speed)))
    return chosen, poissons, speeds


@documented
def slow_impact(
    body: Disk | Sphere | None = None, *, speed: ArrayLike, poisson: ArrayLike | None = None, law: str = "center"
) -> SlowImpact:
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
        SlowImpact(poisson=0.3, speed=0.0001 c: contact time 30.5867 R/c, compression 0.00104057 R)
    """
    chosen, poissons, speeds = slow_inputs(body, speed, poisson, law)
    with told_in_c(body):
        function = _core.point_slow_impact if isinstance(body, Sphere) else _core.slow_impact
        table = function(chosen, poissons.ravel(), speeds.ravel())
    values = {"poisson": poissons, "speed": speeds, **columns(table)}
    shaped: dict[str, Any] = {name: arranged(column, speeds.shape) for name, column in values.items()}
    of_spheres: dict[str, Any] = {"max_radius": None}
    result = SlowImpact(law=chosen, body=body, **of_spheres | shaped)
    warn_of_materials(result, 2, lossy=False)
    return result
