"""An impact in time."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss.results._rows import RowResult

if TYPE_CHECKING:
    from stoss.results._impact import Impact


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Trajectory(RowResult):
    """An impact in time. All arrays have one element for each row; an index gives one row, a slice
    the rows.

    Attributes
    ----------
    time : ndarray
        From the start of the impact, R/c.
    center : ndarray
        Position x₀ of the centre of mass, R; the wall is at 0 and the body at x < 0. Of two bodies,
        that of the first seen from the second.
    velocity : ndarray
        Of the centre of mass, towards what it meets, c.
    force : ndarray
        Force F of the contact, mc²/R (of a disk πRE).
    translation, vibration, stored, dissipated, unresolved : ndarray
        Shares of the initial energy: in the motion of the centre of mass; in the kept modes; in the
        wall's potential or the static tail; lost to the material; taken by the modes above the
        cutoff.
    contact_half_width : ndarray
        R, in steps of the nodes' spacing; of spheres the radius of the contact.
    """

    _name: ClassVar[str] = "trajectory"
    _kind = "snapshot"
    _axis: ClassVar[str] = "time"

    impact: Impact = dataclasses.field(repr=False)
    time: NDArray[np.float64]
    center: NDArray[np.float64]
    velocity: NDArray[np.float64]
    force: NDArray[np.float64]
    translation: NDArray[np.float64]
    vibration: NDArray[np.float64]
    stored: NDArray[np.float64]
    dissipated: NDArray[np.float64]
    unresolved: NDArray[np.float64]
    contact_half_width: NDArray[np.float64]

    def __repr__(self) -> str:
        return f"Trajectory({len(self)} rows, time 0 to {self.time[-1]:.6g} {self._unit('time')}, of {self.impact!r})"

    def _kind_of_body(self) -> str:
        return self.impact._kind_of_body()

    def plot(self, ax: Any = None) -> Any:
        """Force against time. See `stoss.plot.force`."""
        return self._picture(ax)

    def _inputs(self) -> dict[str, Any]:
        return self.impact._inputs()
