"""An impact in time, and the waves below the surface of a half-space."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss.export._text import span
from stoss.results._field import OfAnImpact
from stoss.results._result import Column, Number, RowResult

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

    _name: ClassVar[str] = "wave"
    _kind = "snapshot"
    _units = {"depth": "R", "distance": "R", "lateral": "R", "normal": "R"} | {
        "lateral_velocity": "c",
        "normal_velocity": "c",
    }

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

    def __repr__(self) -> str:
        points = f"{len(self.depth)} depths x {len(self.distance)} distances"
        return f"Wave(time {span(self.time)} R/c, {points}, of {self.impact!r})"

    def plot(self, ax: Any = None) -> Any:
        """Speed below the surface. See `stoss.plot.wave`."""
        return self._picture(ax)

    def _table(self) -> dict[str, Column]:
        shape = self.normal.shape
        instants = {name: np.asarray(getattr(self, name)) for name in ("time", "center", "force")}
        columns = {name: np.broadcast_to(value[..., None, None], shape) for name, value in instants.items()}
        columns["depth"] = np.broadcast_to(self.depth[:, None], shape)
        columns["distance"] = np.broadcast_to(self.distance, shape)
        for name in ("lateral", "normal", "lateral_velocity", "normal_velocity"):
            columns[name] = getattr(self, name)
        return columns
