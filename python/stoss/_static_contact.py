"""A disk held against a wall, at rest."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import instance, integer, number
from stoss._bodies import Disk
from stoss._contact import resolved
from stoss._result import Column, Result
from stoss._walls import ExponentialWall


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class StaticContact(Result):
    """A disk held against a hard wall, at rest.

    Attributes
    ----------
    poisson : float
        2-D Poisson number.
    compression : float
        δ = R + x₀, R.
    force, force_error : float
        F, πRE = mc²/R, and its estimated error.
    half_width : float
        Of the contact, along the undeformed edge, R.
    energy : float
        Stored in the disk, mc²; its derivative by δ is F.
    contact_nodes : int
        Nodes with a pressure, the first ones.
    spacing : float
        Of the nodes, R.
    position : ndarray
        Of the nodes along the undeformed edge, from the middle of the contact, R.
    pressure : ndarray
        At the nodes, in the direction of x, per length of the undeformed edge, E. The sum of
        2·spacing·pressure is πF.
    """

    _name: ClassVar[str] = "static contact"
    _units = {"position": "R", "pressure": "E"}

    poisson: float
    compression: float
    force: float
    force_error: float
    half_width: float
    energy: float
    contact_nodes: int
    spacing: float
    position: NDArray[np.float64]
    pressure: NDArray[np.float64]

    def __repr__(self) -> str:
        return (
            f"StaticContact(poisson={self.poisson:g}, compression={self.compression:g} R: "
            f"force {self.force:.7g} ± {self.force_error:.1g} piRE, half-width {self.half_width:.6g} R)"
        )

    def plot(self, ax: Any = None) -> Any:
        """Pressure along the edge. See `stoss.plot.static_contact`."""
        return self._picture(ax)

    def _inputs(self) -> dict[str, Any]:
        names = ("poisson", "compression", "force", "force_error", "half_width", "energy")
        return {name: getattr(self, name) for name in names}

    def _table(self) -> dict[str, Column]:
        return {"position": self.position, "pressure": self.pressure}


def static_contact(*, poisson: float, compression: float, nodes: int = 160) -> StaticContact:
    """The contact of a disk whose centre of mass is held at the distance R − δ from a hard wall.

    Small-strain elasticity with the compliance of all modes and the exact shape of the edge; no law
    of contact enters. It means little for δ above about 0.1.

    Parameters
    ----------
    poisson : float
        2-D Poisson number, −0.95 to 0.995.
    compression : float
        δ, 1e-12 to 0.5, R.
    nodes : int, optional
        On half of the contact, 16 to 1024; the force converges with their square.

    Returns
    -------
    StaticContact

    Raises
    ------
    InvalidInput
        For arguments out of range.
    NotConverged
        If the contact cannot be solved.

    Examples
    --------
    >>> contact = stoss.quasistatic.static_contact(poisson=0.33, compression=0.01)
    >>> by_law = stoss.quasistatic.compression_force(poisson=0.33, compression=0.01)
    >>> round(by_law / contact.force - 1, 4)
    0.0011
    """
    nu, delta = number("poisson", poisson), number("compression", compression)
    found = _core.static_contact(nu, delta, integer("nodes", nodes))
    return StaticContact(poisson=nu, compression=delta, **found)


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SoftStaticContact(Result):
    """A disk held at rest in front of an exponential wall.

    Attributes
    ----------
    poisson : float
        2-D Poisson number.
    compression : float
        δ beyond the plane where V₀e^{αx} = 1, R.
    cutoff : float
        Highest frequency of the modes that give way, c/R.
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
        2-D Poisson number, −0.95 to 0.995.
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
    found = _core.soft_static_contact(resolved(disk, highest), against._made(), delta, count)
    return SoftStaticContact(poisson=disk.poisson, compression=delta, cutoff=highest, against=against, **found)
