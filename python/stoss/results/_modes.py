"""Eigenmodes of a disk or a sphere."""

from __future__ import annotations

import dataclasses
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import brief, instance, integer, number, numbers
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Disk, Sphere
from stoss.bodies._encounter import choose_body
from stoss.export._tables import span
from stoss.results._quantities import ModeQuantities
from stoss.results._result import RowResult, columns, picture


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Modes(ModeQuantities, RowResult):
    """The modes of a free disk or sphere up to a cutoff, by order, then by frequency.

    For a disk they are the symmetric ones in its plane, u = (u_r(r) cos nφ, u_φ(r) sin nφ) inside;
    of a sphere the axisymmetric spheroidal ones, u = (u_r(r) P_n(cos θ), u_θ(r) dP_n(cos θ)/dθ).
    Every mode is normalised to the mass of the body. All arrays have one element for each mode;
    ``len()`` is their number,
    an index gives one mode, a slice or flags the modes among them.

    Attributes:
        cutoff: Highest frequency, c/R.
        radial, tangential: Amplitudes at the surface: C = u_r and S = u_φ, of a sphere U = u_r and
            V = u_θ; C, U ≥ 0.
    """

    plot = picture("Spectrum, ω against n. See `stoss.plot.spectrum`.")
    _name: ClassVar[str] = "modes"
    _told = ("body", "poisson", "cutoff")
    _axis: ClassVar[str] = "mode"

    body: Disk | Sphere
    poisson: float
    cutoff: float

    def __repr__(self) -> str:
        of = f"poisson={self.poisson:g}" if isinstance(self.body, Disk) else f"Sphere(poisson={brief(self.body.poisson)})"
        return f"Modes({of}, cutoff={self.cutoff:g}: {len(self)} modes, omega {span(self.omega)})"

    @property
    def radial_family(self) -> NDArray[np.bool_]:
        """Whether the surface moves mostly along the radius, ``C > |S|``; of a sphere ``U > √(n(n+1)) |V|``."""
        along = np.abs(self.tangential)
        if isinstance(self.body, Sphere):
            along = along * np.sqrt(self.order * (self.order + 1.0))
        return np.asarray(self.radial > along)

    def find(self, order: int, index: int) -> int:
        """Position of the mode (n, l) in the arrays."""
        order, index = integer("order", order), integer("index", index)
        found = np.flatnonzero((self.order == order) & (self.index == index))
        if found.size == 0:
            raise InvalidInput.out_of_range(
                "mode", f"(n, l) = ({order}, {index})", f"those up to the cutoff {self.cutoff:g}"
            )
        return int(found[0])

    @documented
    def displacement(
        self, *, order: int, index: int, radius: ArrayLike
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Displacement of the mode (n, l) inside the body.

        Parameters:
            radius: Radii r, 0 to 1, R.

        Returns:
            u_r, u_phi : ndarray: Arrays of the shape of `radius`, to be multiplied by cos nφ and sin nφ;
                of a sphere u_r and u_θ, by P_n(cos θ) and dP_n(cos θ)/dθ.

        Examples:
            >>> u_r, u_phi = stoss.modes(poisson=0.33, cutoff=5).displacement(order=2, index=0, radius=[0.0, 1.0])
            >>> u_r.round(6)
            array([0.      , 1.388815])
        """
        k = self.find(order, index)
        radii = numbers("radius", radius)
        displacement = _core.disk_displacement if isinstance(self.body, Disk) else _core.sphere_displacement
        field = displacement(
            self.poisson, int(self.order[k]), float(self.omega[k]), float(self.radial[k]), float(self.tangential[k]),
            radii.ravel(),
        )
        return field["radial"].reshape(radii.shape), field["tangential"].reshape(radii.shape)

    def _kind_of_body(self) -> str:
        return self.body._kind


@documented
def modes(body: Disk | Sphere | None = None, *, cutoff: float, poisson: float | None = None) -> Modes:
    """All symmetric in-plane modes of a free disk, or axisymmetric spheroidal ones of a sphere, up to a cutoff.

    The frequencies are the roots of D_n(ω) = 0, the free surface's determinant. None
    is missed: they are counted exactly.

    Parameters:
        body:
        cutoff: Highest frequency, c/R, up to 1000.

    Examples:
        >>> modes = stoss.modes(poisson=0.33, cutoff=30)
        >>> modes
        Modes(poisson=0.33, cutoff=30: 421 modes, omega 1.43853 to 29.9516)
        >>> modes.omega[modes.find(2, 0)].round(5)
        1.43853
        >>> stoss.modes(stoss.Sphere(poisson=0.3), cutoff=12.5)
        Modes(Sphere(poisson=0.3), cutoff=12.5: 69 modes, omega 1.64111 to 12.4994)
    """
    free: Disk | Sphere = instance("body", choose_body(body, poisson), (Disk, Sphere))
    highest = number("cutoff", cutoff)
    all_of_them = _core.disk_modes if isinstance(free, Disk) else _core.sphere_modes
    table = all_of_them(free.poisson, highest)
    return Modes(body=free, poisson=free.poisson, cutoff=highest, **columns(table))
