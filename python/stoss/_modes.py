"""Eigenmodes of a disk."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import instance, integer, number, numbers
from stoss._bodies import Disk
from stoss._contact import choose_body
from stoss._errors import InvalidInput
from stoss._result import Result, columns, span


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Modes(Result):
    """The symmetric in-plane modes of a free disk up to a cutoff, by order, then by frequency.

    Inside the disk u = (u_r(r) cos nφ, u_φ(r) sin nφ), normalised so that every mode has the mass
    of the disk. All arrays have one element for each mode; ``len()`` is their number.

    Attributes
    ----------
    poisson : float
        2-D Poisson number.
    cutoff : float
        Highest frequency, c/R.
    order : ndarray of int
        Angular order n.
    index : ndarray of int
        Number l of the root for this order, from 0.
    omega : ndarray
        Eigenfrequency ω, c/R.
    radial, tangential : ndarray
        Amplitudes C = u_r and S = u_φ at the edge; C ≥ 0.
    """

    _name: ClassVar[str] = "modes"
    _kind = "mode"

    poisson: float
    cutoff: float
    order: NDArray[np.int32]
    index: NDArray[np.int32]
    omega: NDArray[np.float64]
    radial: NDArray[np.float64]
    tangential: NDArray[np.float64]

    def __len__(self) -> int:
        return len(self.omega)

    def __repr__(self) -> str:
        return f"Modes(poisson={self.poisson:g}, cutoff={self.cutoff:g}: {len(self)} modes, omega {span(self.omega)})"

    @property
    def radial_family(self) -> NDArray[np.bool_]:
        """Whether the edge moves mostly along the radius, C > |S|."""
        return self.radial > np.abs(self.tangential)

    def find(self, order: int, index: int) -> int:
        """Position of the mode (n, l) in the arrays.

        Raises
        ------
        InvalidInput
            If there is no such mode below the cutoff.
        """
        order, index = integer("order", order), integer("index", index)
        found = np.flatnonzero((self.order == order) & (self.index == index))
        if found.size == 0:
            raise InvalidInput(f"mode: got (n, l) = ({order}, {index}), allowed those up to the cutoff {self.cutoff:g}")
        return int(found[0])

    def displacement(
        self, *, order: int, index: int, radius: ArrayLike
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Displacement of the mode (n, l) inside the disk.

        Parameters
        ----------
        order, index : int
            n and l.
        radius : array_like
            Radii r, 0 to 1, R.

        Returns
        -------
        u_r, u_phi : ndarray
            Of the shape of `radius`, to be multiplied by cos nφ and sin nφ.

        Examples
        --------
        >>> u_r, u_phi = stoss.modes(poisson=0.33, cutoff=5).displacement(order=2, index=0, radius=[0.0, 1.0])
        >>> u_r.round(6)
        array([0.      , 1.388815])
        """
        k = self.find(order, index)
        radii = numbers("radius", radius)
        field = _core.displacement(
            self.poisson, int(self.order[k]), float(self.omega[k]), float(self.radial[k]), float(self.tangential[k]),
            radii.ravel(),
        )
        return field["radial"].reshape(radii.shape), field["tangential"].reshape(radii.shape)

    def plot(self, ax: Any = None) -> Any:
        """Spectrum, ω against n. See `stoss.plot.spectrum`."""
        return self._picture(ax)

    def _inputs(self) -> dict[str, Any]:
        return {"poisson": self.poisson, "cutoff": self.cutoff}


def modes(body: Disk | None = None, *, cutoff: float, poisson: float | None = None) -> Modes:
    """All symmetric in-plane modes of a free disk up to a cutoff.

    The frequencies are the roots of D_n(ω) = 0, the free edge's determinant. None
    is missed: they are counted exactly.

    Parameters
    ----------
    body : Disk
    cutoff : float
        Highest frequency, c/R, up to 1000.
    poisson : float
        In place of `body`: 2-D Poisson number ν, −0.95 to 0.995.

    Returns
    -------
    Modes

    Raises
    ------
    InvalidInput
        For arguments out of range.

    Examples
    --------
    >>> modes = stoss.modes(poisson=0.33, cutoff=30)
    >>> modes
    Modes(poisson=0.33, cutoff=30: 421 modes, omega 1.43853 to 29.9516)
    >>> modes.omega[modes.find(2, 0)].round(5)
    1.43853
    """
    disk: Disk = instance("body", choose_body(body, poisson), (Disk,))
    highest = number("cutoff", cutoff)
    table = _core.disk_modes(disk.poisson, highest)
    return Modes(poisson=disk.poisson, cutoff=highest, **columns(table))
