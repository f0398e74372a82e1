"""An impact in time, and the waves below the surface of a half-space."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss.results._field import OfAnImpact
from stoss.results._result import Number, RowResult, picture

if TYPE_CHECKING:
    from stoss.results._impact import Impact


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Trajectory(RowResult):
    """An impact in time. All arrays have one element for each row; an index gives one row, a slice
    the rows.

    Attributes
    ----------
    center : ndarray
        Position x₀ of the centre of mass, R; the wall is at 0 and the body at x < 0. Of two bodies,
        that of the first seen from the second.
    velocity : ndarray
        Of the centre of mass, towards what it meets, c.
    translation, vibration, stored, dissipated, unresolved : ndarray
        Shares of the initial energy: in the motion of the centre of mass; in the kept modes; in the
        wall's potential or the static tail; lost to the material; taken by the modes above the
        cutoff.
    """

    plot = picture("Force against time. See `stoss.plot.force`.")
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

    def _inputs(self) -> dict[str, Any]:
        return self.impact._inputs()


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Wave(OfAnImpact):
    """How a half-space, or a half-plane, moves below its surface during and after an impact.

    Arrays are times × depths × distances, or depths × distances for one time. The plane goes
    through the axis of the impact; the other side is its mirror image.

    Attributes
    ----------
    time, center, force : float or ndarray
        Of each instant: R/c; x of the first body's centre in R, where the undeformed surface is at
        x = 0 and the body at x < 0; F in mc²/R (of disks πRE).
    depth, distance : ndarray
        Of the points: below the surface, and from the axis, R.
    lateral, normal : ndarray
        Displacement away from the axis, and into the half-space, R.
    lateral_velocity, normal_velocity : ndarray
        Their rates of change, c.
    pressure_speed, shear_speed, rayleigh_speed : float
        c_p, c_s and c_R of the half-space, in c of the first body.
    """

    plot = picture("Speed below the surface. See `stoss.plot.wave`.")
    _name: ClassVar[str] = "wave"
    _kind = "snapshot"
    _points = {"depth": "depths", "distance": "distances"}
    _values = ("lateral", "normal", "lateral_velocity", "normal_velocity")
    _units = dict.fromkeys((*_points, "lateral", "normal"), "R") | dict.fromkeys(_values[2:], "c")

    impact: Impact = dataclasses.field(repr=False)
    time: Number
    center: Number
    force: Number
    depth: NDArray[np.float64]
    distance: NDArray[np.float64]
    lateral: NDArray[np.float64]
    normal: NDArray[np.float64]
    lateral_velocity: NDArray[np.float64]
    normal_velocity: NDArray[np.float64]
    pressure_speed: float
    shear_speed: float
    rayleigh_speed: float
