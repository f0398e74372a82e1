"""A disk held at rest in front of an exponential wall."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

from stoss import _core
from stoss._arguments import instance, integer, number
from stoss.bodies._bodies import Disk
from stoss.bodies._encounter import contact
from stoss.results._result import Result
from stoss.bodies._walls import ExponentialWall


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SoftStaticContact(Result):
    """A disk held at rest in front of an exponential wall.

    Attributes
    ----------
    poisson : float
        2-D Poisson's ratio.
    compression : float
        δ beyond the plane where V₀e^{αx} = 1, R.
    cutoff : float
        Highest frequency of the modes that deform, c/R.
    against : ExponentialWall
    force : float
        F, πRE = mc²/R.
    energy, wall_energy : float
        Of modes and wall, and the wall's share in it, mc².
    modes, nodes, newton_steps : int
        Of the disk; of the contact grid; of the solution.
    """

    _name: ClassVar[str] = "soft static contact"
    _kind = "soft static contact"
    _given = {"poisson": "", "compression": "length", "cutoff": "frequency"}

    poisson: float
    compression: float
    cutoff: float
    against: ExponentialWall
    force: float
    energy: float
    wall_energy: float
    modes: int
    nodes: int
    newton_steps: int

    def __repr__(self) -> str:
        return (
            f"SoftStaticContact(poisson={self.poisson:g}, compression={self.compression:g} R, {self.against!r}: "
            f"force {self.force:.7g} piRE, {self.modes} modes)"
        )

    def _inputs(self) -> dict[str, Any]:
        return {"against": self.against}


def soft_static_contact(
    *,
    poisson: float,
    compression: float,
    cutoff: float = 50.0,
    against: ExponentialWall = ExponentialWall(),
    nodes: int | None = None,
) -> SoftStaticContact:
    """The static calculation of Gerl and Zippelius, at a soft wall.

    The modes take the coordinates of least energy. The compression counts from the plane where
    V₀e^{αx} = 1. A pressure p stands ln(α/p)/α before that plane, 0.017 R for αR = 500 and p = 0.1,
    by which a hard wall is farther away.

    Parameters
    ----------
    poisson : float
        2-D Poisson's ratio, −0.95 to 0.995.
    compression : float
        δ, −0.5 to 0.5, R.
    cutoff : float, optional
        Highest frequency of the modes, c/R; those above it are left out.
    against : ExponentialWall, optional
    nodes : int, optional
        Of the contact grid, 64 to 2048; default: as many as wall and modes need.

    Returns
    -------
    SoftStaticContact

    Raises
    ------
    InvalidInput
        For arguments out of range.
    NotConverged
        If the minimum is not found.

    Examples
    --------
    >>> wall = stoss.ExponentialWall(hardness=4000)
    >>> soft = stoss.quasistatic.soft_static_contact(poisson=0.33, compression=0.03, cutoff=50, against=wall)
    >>> hard = stoss.quasistatic.static_contact(poisson=0.33, compression=0.03)
    >>> 1.0 < soft.force / hard.force < 1.3
    True
    """
    disk = Disk(poisson=poisson)
    delta, highest = number("compression", compression), number("cutoff", cutoff)
    instance("against", against, (ExponentialWall,))
    count = None if nodes is None else integer("nodes", nodes)
    found = _core.soft_static_contact(contact(disk, against, highest, 1.0), delta, count)
    return SoftStaticContact(poisson=disk.poisson, compression=delta, cutoff=highest, against=against, **found)
