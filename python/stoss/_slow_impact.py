"""Impact of a disk that follows the wall's force statically."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, broadcast, choice, instance, numbers
from stoss._bodies import Disk, speed_unit, speeds_in_si
from stoss._compression import LAWS
from stoss._contact import choose_body
from stoss._result import Number, columns, span
from stoss._si import InSi


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SlowImpact(InSi):
    """Slow impacts, by conservation of energy: nothing is lost.

    Numbers if all inputs were numbers, otherwise arrays of the shape to which `poisson` and `speed`
    broadcast. Relative errors, as solutions of their equation, are below 1e-14.

    Attributes
    ----------
    law : str
        Of compression.
    poisson : float or ndarray
        2-D Poisson number.
    speed : float or ndarray
        Of the centre of mass towards the wall, c.
    contact_time : float or ndarray
        From first to last contact, R/c.
    max_compression : float or ndarray
        R.
    max_force : float or ndarray
        πRE = mc²/R.
    body : Disk or None
        What it was made with, if it was one.
    material : Material or None
        Of the body. If there is one, `speed_si`, `contact_time_si`, `max_force_si` and
        `max_compression_si` are the SI values.
    """

    _name: ClassVar[str] = "slow impact"
    _kind = "slow impact"
    _given = {"poisson": "", "speed": "speed"}

    law: str
    poisson: Number
    speed: Number
    contact_time: Number
    max_compression: Number
    max_force: Number
    body: Disk | None

    def __repr__(self) -> str:
        count = "" if isinstance(self.speed, float) else f"{np.size(self.speed)} values, "
        return (
            f"SlowImpact({count}poisson={span(self.poisson)}, speed={span(self.speed)} c: "
            f"contact time {span(self.contact_time)} R/c, compression {span(self.max_compression)} R)"
        )

    def plot(self, ax: Any = None) -> Any:
        """Contact time against speed. See `stoss.plot.slow_impact`."""
        return self._picture(ax)

    def _inputs(self) -> dict[str, Any]:
        return {"law": self.law} | ({"body": self.body} if self.body else {})


def slow_inputs(
    body: Any, speed: Any, poisson: Any, law: Any
) -> tuple[str, NDArray[np.float64], NDArray[np.float64]]:
    """The law, and Poisson numbers and speeds in c of one shape."""
    chosen = choice("law", law, LAWS)
    if body is not None or poisson is None:
        instance("body", choose_body(body, poisson), (Disk,))
    speeds = numbers("speed", speed) / speed_unit(body)
    poissons = numbers("poisson", body.poisson if poisson is None else poisson)
    poissons, speeds = broadcast(3, poisson=poissons, speed=speeds)
    return chosen, poissons, speeds


def slow_impact(
    body: Disk | None = None, *, speed: ArrayLike, poisson: ArrayLike | None = None, law: str = "center"
) -> SlowImpact:
    """Impacts that are so slow that the disk follows the wall's force statically: δ̈ = −F(δ).

    Parameters
    ----------
    body : Disk
    speed : array_like
        Of the centre of mass towards the wall, 1e-100 to `limit_speed`, c (with a material: m/s).
        Two equal disks that each move at `speed` towards each other are the same problem.
    poisson : array_like
        In place of `body`: 2-D Poisson number, −0.95 to 0.995; broadcasts with `speed`.
    law : {'center', 'diameter', 'printed'}, optional
        Of compression, see `stoss.quasistatic`.

    Returns
    -------
    SlowImpact

    Raises
    ------
    InvalidInput
        For arguments out of range.

    Examples
    --------
    >>> slow = stoss.quasistatic.slow_impact(poisson=0.33, speed=[1e-12, 1e-6, 1e-3])
    >>> slow.contact_time.round(3)
    array([16.968, 12.174,  8.754])
    """
    chosen, poissons, speeds = slow_inputs(body, speed, poisson, law)
    with speeds_in_si(body):
        table = _core.slow_impact(chosen, poissons.ravel(), speeds.ravel())
    values = {"poisson": poissons, "speed": speeds, **columns(table)}
    shaped = {name: arranged(column, speeds.shape) for name, column in values.items()}
    return SlowImpact(law=chosen, body=body, **shaped)
