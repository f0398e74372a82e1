"""An impact in time, deformation and stress inside the bodies, and the waves in a half-space or a plate."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar, Mapping

import numpy as np
from numpy.typing import NDArray

from stoss.export._tables import span
from stoss.results._computed_impact import ComputedImpact
from stoss.results._quantities import Number, SnapshotQuantities
from stoss.results._result import Column, Result, RowResult, picture
from stoss.results._si import InSi


class OfAnImpact(Result):
    """What is seen of an impact at some times, in points on a grid."""

    _instants: ClassVar[tuple[str, ...]] = ("time", "center", "force")  # the columns of each instant
    _points: ClassVar[Mapping[str, str]]  # the two columns of the points, and what these are in plural
    _values: ClassVar[tuple[str, ...]]  # the columns at the points

    impact: ComputedImpact
    time: Number

    def __repr__(self) -> str:
        points = " x ".join(f"{len(getattr(self, name))} {several}" for name, several in self._points.items())
        return f"{type(self).__name__}(time {span(self.time)} R/c, {points}, of {self.impact!r})"

    def _table(self) -> dict[str, Column]:
        values = {name: getattr(self, name) for name in self._values}
        first, second = self._points
        columns = {name: np.asarray(getattr(self, name))[..., None, None] for name in self._instants}
        columns |= {first: getattr(self, first)[:, None], second: getattr(self, second)}
        shape = values[self._values[0]].shape
        return {name: np.broadcast_to(each, shape) for name, each in columns.items()} | values

    def _kind_of_body(self) -> str:
        return self.impact._kind_of_body()

    def _inputs(self) -> dict[str, Any]:
        return self.impact._inputs() | {"speed": self.impact.speed, "cutoff": self.impact.cutoff}


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Field(OfAnImpact):
    """The deformed body and the stress inside it: what a `DiskField` and a `SphereField` have in common.

    Arrays are times × radii × angles, or radii × angles for one time.

    Attributes:
        of: Inside which body: 0 the first, 1 the second. Units are those of the first.
        size: Radius of the body, R.
        time, center, force, contact_half_width: At each instant: time in R/c, x of the body's
            centre in R, F in mc²/R (of disks πRE), and half the width of the contact in R.
        radius, angle: Places of the points in the undeformed body: in its own radius; radians, 0 towards
            the contact.
        x, y: Where the points are now, R. The wall is at x = 0 and the body at x < 0. Of two bodies
            the first is at x < 0: they first touch at x = 0, and their common centre of mass is at
            rest.
        stress_rr: σ_rr, E; tension is positive.
        von_mises, principal_difference: In E.
    """

    plot = picture("Stress inside the body. See `stoss.plot.stress`.")
    _name: ClassVar[str] = "field"
    _kind = "snapshot"
    _instants = ("time", "center", "force", "contact_half_width")
    _points = {"radius": "radii", "angle": "angles"}
    _units = {"angle": "rad", "x": "R", "y": "R", "von_mises": "E", "principal_difference": "E"} | {
        f"stress_{pair}": "E" for pair in ("rr", "tt", "pp", "rt", "rp")
    }

    impact: ComputedImpact = dataclasses.field(repr=False)
    of: int
    size: float
    time: Number
    center: Number
    force: Number
    contact_half_width: Number
    radius: NDArray[np.float64]
    angle: NDArray[np.float64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    stress_rr: NDArray[np.float64]
    von_mises: NDArray[np.float64]
    principal_difference: NDArray[np.float64]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class DiskField(Field):
    """The deformed disk and the stress inside it.

    Attributes:
        stress_rr, stress_pp, stress_rp: σ_rr, σ_φφ and σ_rφ, E; tension is positive.
        von_mises: √(σ₁² − σ₁σ₂ + σ₂²) of plane stress, E.
        principal_difference: ``|σ₁ − σ₂|``, E: what photoelastic fringes count.
    """

    _values = ("x", "y", "stress_rr", "stress_pp", "stress_rp", "von_mises", "principal_difference")

    stress_pp: NDArray[np.float64]
    stress_rp: NDArray[np.float64]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SphereField(Field):
    """The deformed sphere and the stress inside it, on a plane through the axis of the impact.

    Angles are polar angles θ from the contact; negative ones are the other half of the plane, the
    mirror image of the first.

    Attributes:
        stress_rr, stress_tt, stress_pp, stress_rt: σ_rr, σ_θθ, σ_φφ (across the plane) and σ_rθ, E;
            tension is positive.
        von_mises: √(½[(σ₁−σ₂)² + (σ₂−σ₃)² + (σ₃−σ₁)²]), E.
        principal_difference: ``|σ₁ − σ₂|`` of the principal stresses in the plane, E: what a thin
            slice would show as photoelastic fringes.
    """

    _values = ("x", "y", "stress_rr", "stress_tt", "stress_pp", "stress_rt", "von_mises", "principal_difference")

    stress_tt: NDArray[np.float64]
    stress_pp: NDArray[np.float64]
    stress_rt: NDArray[np.float64]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Trajectory(SnapshotQuantities, RowResult, InSi):
    """An impact in time. All arrays have one element for each row; an index gives one row, a slice the rows.

    Attributes:
        center: Position x₀ of the centre of mass, R; the wall is at 0 and the body at x < 0. Of two
            bodies, that of the first seen from the second.
    """

    plot = picture("Force against time. See `stoss.plot.force`.")
    _name: ClassVar[str] = "trajectory"
    _axis: ClassVar[str] = "time"

    impact: ComputedImpact = dataclasses.field(repr=False)

    @property
    def body(self) -> Any:
        """The first body."""
        return self.impact.body

    def __repr__(self) -> str:
        return f"Trajectory({len(self)} rows, time 0 to {self.time[-1]:.6g} {self._unit('time')}, of {self.impact!r})"

    def _kind_of_body(self) -> str:
        return self.impact._kind_of_body()

    def _inputs(self) -> dict[str, Any]:
        return self.impact._inputs()


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Wave(OfAnImpact):
    """How a half-space, a half-plane, a plate or a strip moves below its surface during and after an impact.

    Arrays are times × depths × distances, or depths × distances for one time. The plane goes
    through the axis of the impact; the other side is its mirror image.

    Attributes:
        time, center, force: At each instant: time in R/c, x of the first body's centre in R, where the
            undeformed surface is at x = 0 and the body at x < 0, and F in mc²/R (of disks πRE).
        depth, distance: Places of the points: below the surface, and from the axis, R.
        lateral, normal: Displacement away from the axis, and into the half-space, R.
        lateral_velocity, normal_velocity: Their rates of change, c.
        pressure_speed, shear_speed, rayleigh_speed: c_p, c_s and c_R of its material, of the first
            layer of a plate, in c of the first body.
    """

    plot = picture("Speed below the surface. See `stoss.plot.wave`.")
    _name: ClassVar[str] = "wave"
    _kind = "snapshot"
    _points = {"depth": "depths", "distance": "distances"}
    _values = ("lateral", "normal", "lateral_velocity", "normal_velocity")
    _units = dict.fromkeys((*_points, "lateral", "normal"), "R") | dict.fromkeys(_values[2:], "c")

    impact: ComputedImpact = dataclasses.field(repr=False)
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
