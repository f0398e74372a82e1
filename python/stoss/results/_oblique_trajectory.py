"""An oblique impact in time: the motion of both bodies, and what every contact point does."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss._arguments import integer, require_memory
from stoss._errors import InvalidInput
from stoss.results._result import RowResult, columns, picture
from stoss.results._si import InSi, Si

if TYPE_CHECKING:
    from stoss.results._oblique_impact import ObliqueImpact

Array = NDArray[np.float64]
POINTS = ("place", "measure")  # arrays of the contact points; all others are of the rows


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ObliqueTrajectory(RowResult, InSi):
    """An oblique impact in time.

    All arrays have one element for each row, those of the contact points one row for each; an index
    gives one row, a slice the rows. x points along the normal, from the first body to what it meets,
    and y along the surface. Of disks there are points on both sides of the axis, of spheres rings
    that move in one direction.

    Attributes:
        center: Position x₀ of the centre of mass along x, R; the wall is at 0 and the body at
            x < 0. Of two bodies, that of the first seen from the second.
        shift: Way of the first centre along y since the start, of two bodies relative to the
            second, R.
        velocity, tangential: Of the (relative) motion along x and along y, c.
        angle, second_angle: By which each body has turned since the start, radians.
        spin, second_spin: Of each body, c/R of the first.
        friction: Q, sum of the friction at all points, mc²/R; positive where it acts against +y on
            the first body.
        touching: Number of points with pressure.
        translation, across, rotation, second_rotation: Shares of the initial energy: in the motion
            along x and along y, and in the spins.
        elastic: What went into the bodies: they vibrate with it, hold it, or have lost it to the
            material and to the modes above the cutoff.
        friction_loss: Share that became heat of friction, and what points hold that land.
        x, y, second_x, second_y: Of each centre, R, seen by who moves with the centre of mass of
            both, at a wall or a half-space with that: None where there is no second body. At rest
            the bodies would first touch at x = 0.
        place: Of the points along the surface from the axis, R; of spheres the radii of the rings.
        measure: What each point stands for: length of edge, R; of spheres area of the ring, R².
        point_pressure, point_friction: Share of each point in F and in Q, rows × points.
        slip: Velocity at which the first surface moves along y over the second at each point, c,
            mean of the step before; rows × points.
        grip: What each point does: 0 sticks, 1 and −1 slips along +y and −y, 2 carries no pressure;
            rows × points.
    """

    plot = picture("Velocities, forces, and where points stick. See `stoss.plot.oblique_impact`.")
    _name: ClassVar[str] = "oblique trajectory"
    _kind = "oblique snapshot"
    _axis: ClassVar[str] = "time"
    _units = {"angle": "rad", "second_angle": "rad"}
    time_si = Si("Time, s.")
    center_si = Si("Position along x, m.")
    shift_si = Si("Way along y, m.")
    velocity_si = Si("Velocity along x, m/s.")
    tangential_si = Si("Velocity along y, m/s.")
    spin_si = Si("Spin of the first body, rad/s.")
    second_spin_si = Si("Spin of the second body, rad/s.")
    force_si = Si("Force: of a disk per thickness, N/m; of a sphere, N.")
    friction_si = Si("Friction: of a disk per thickness, N/m; of a sphere, N.")

    impact: ObliqueImpact = dataclasses.field(repr=False)
    time: Array
    center: Array
    shift: Array
    velocity: Array
    tangential: Array
    angle: Array
    second_angle: Array
    spin: Array
    second_spin: Array
    force: Array
    friction: Array
    touching: NDArray[np.int64]
    translation: Array
    across: Array
    rotation: Array
    second_rotation: Array
    elastic: Array
    friction_loss: Array
    x: Array
    y: Array
    second_x: Array | None
    second_y: Array | None
    place: Array
    measure: Array
    point_pressure: Array
    point_friction: Array
    slip: Array
    grip: NDArray[np.int8]

    @property
    def body(self) -> Any:
        """The first body."""
        return self.impact.body

    def __repr__(self) -> str:
        points = f"{self.place.size} points"
        end = f"time 0 to {self.time[-1]:.6g} {self._unit('time')}"
        return f"ObliqueTrajectory({len(self)} rows, {points}, {end}, of {self.impact!r})"

    def _is_column(self, value: Any) -> bool:
        own = isinstance(value, np.ndarray) and not any(value is getattr(self, name) for name in POINTS)
        return own and len(value) == len(self)

    def _inputs(self) -> dict[str, Any]:
        return self.impact._inputs()


def trajectory(self: ObliqueImpact, *, every: int = 1) -> ObliqueTrajectory:
    """The impact in time, by repeating it bit by bit.

    Parameters:
        every (int): Steps between two rows.

    Examples:
        >>> path = stoss.oblique_impact(stoss.Sphere(poisson=0.3), speed=0.05, angle=40, friction=0.3).trajectory()
        >>> bool(abs(path.point_friction.sum(axis=1) - path.friction).max() < 1e-12)
        True
        >>> sticks = (path.grip == 0).sum(axis=1)
        >>> bool(sticks.max() > 0.5 * path.touching.max())
        True
    """
    rows = integer("every", every)
    if rows < 1:
        raise InvalidInput(f"every: got {rows}, allowed 1 or more (steps between two rows)")
    size = (200.0 + 50.0 * self.nodes) * (self.steps // rows + 2)
    require_memory("every", f"{rows} for {self.steps} steps", size, "give a larger one")
    table, others = self._handle.trajectory(self._contact(), rows)
    values: dict[str, Any] = {"second_x": None, "second_y": None} | columns(table) | others
    return ObliqueTrajectory(impact=self, **values)
