"""Impact of a disk or a sphere that follows the wall's force statically."""

from __future__ import annotations

from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, broadcast, numbers
from stoss.bodies._bodies import Disk, Sphere, speed_unit, speeds_in_si
from stoss.quasistatic._line_or_point import choose_law, poissons_of
from stoss.results._result import columns
from stoss.results._si import warn_of_yielding
from stoss.quasistatic._slow_impact import PointSlowImpact, SlowImpact


def slow_inputs(
    body: Any, speed: Any, poisson: Any, law: Any
) -> tuple[str, NDArray[np.float64], NDArray[np.float64]]:
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


def slow_impact(
    body: Disk | Sphere | None = None, *, speed: ArrayLike, poisson: ArrayLike | None = None, law: str = "center"
) -> SlowImpact | PointSlowImpact:
    """Impacts that are so slow that the body follows the wall's force statically: δ̈ = −F(δ).

    Parameters
    ----------
    body : Disk or Sphere
    speed : array_like
        Of the centre of mass towards the wall, 1e-100 (of a sphere 1e-12) to `limit_speed`, c (with
        a material: m/s). Two equal bodies that each move at `speed` towards each other are the same
        problem.
    poisson : array_like
        In place of `body`: 2-D Poisson's ratio of disks, −0.95 to 0.995; broadcasts with `speed`.
    law : {'center', 'diameter', 'printed', 'hertz'}, optional
        Of compression, see `stoss.quasistatic`.

    Returns
    -------
    SlowImpact, or of a sphere PointSlowImpact

    Raises
    ------
    InvalidInput
        For arguments out of range.

    Warns
    -----
    StossWarning
        If there are values beyond the speed at which a sphere begins to yield.

    Examples
    --------
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
    if isinstance(body, Sphere):
        result = PointSlowImpact(law=chosen, body=body, **shaped)
        warn_of_yielding(result, 2)
        return result
    return SlowImpact(law=chosen, body=body, **shaped)
