"""One oblique impact with friction at a fixed resolution, and its course in time: motion, and what contact points do."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import boolean, integer, optional_number, require_memory
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body, shown
from stoss.bodies._encounter import Against, choose_against, choose_body, choose_cutoff, contact
from stoss.bodies._state import State, choose_state
from stoss.bodies._walls import Unbounded, Wall
from stoss.results._obliquity import MOTION, Oblique, ObliqueLedger, choose_motion, explained
from stoss.results._progress import waiting
from stoss.results._quantities import ObliqueImpactQuantities, ObliqueSnapshotQuantities
from stoss.results._result import RowResult, columns, picture
from stoss.results._si import InSi, warn_of_materials


POINTS = ("place", "measure")  # arrays of the contact points; all others are of the rows


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ObliqueTrajectory(ObliqueSnapshotQuantities, RowResult, InSi):
    """An oblique impact in time.

    All arrays have one element for each row, those of the contact points one row for each; an index
    gives one row, a slice the rows. x points along the normal, from the first body to what it meets,
    and y along the surface. Disks have points on both sides of the axis, spheres rings
    that move in one direction.

    Attributes:
        center: Position x₀ of the centre of mass along x, R; the wall is at 0 and the body at
            x < 0. With two bodies it is that of the first, seen from the second.
        friction_loss: Share that became heat of friction, and what points hold that land.
        x, y, second_x, second_y: Places of the centres, R, seen by who moves with the centre of mass of
            both, at a wall or a half-space with that: None where there is no second body. At rest
            the bodies would first touch at x = 0.
        place: Places of the points along the surface from the axis, R; of spheres the radii of the rings.
        measure: What each point stands for: length of edge, R; of spheres area of the ring, R².
        point_pressure, point_friction: Share of each point in F and in Q, rows × points.
        slip: Velocity at which the first surface moves along y over the second at each point, c,
            mean of the step before; rows × points.
        grip: What each point does: 0 sticks, 1 and −1 slips along +y and −y, 2 carries no pressure;
            rows × points.
    """

    plot = picture("Velocities, forces, and where points stick. See `stoss.plot.oblique_impact`.")
    _name: ClassVar[str] = "oblique trajectory"
    _axis: ClassVar[str] = "time"
    _units = {"angle": "rad", "second_angle": "rad"}

    impact: ObliqueImpact = dataclasses.field(repr=False)
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    second_x: NDArray[np.float64] | None
    second_y: NDArray[np.float64] | None
    place: NDArray[np.float64]
    measure: NDArray[np.float64]
    point_pressure: NDArray[np.float64]
    point_friction: NDArray[np.float64]
    slip: NDArray[np.float64]
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


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ObliqueImpact(ObliqueImpactQuantities, Oblique):
    """One oblique impact at a fixed resolution, with the inputs that made it.

    x points along the normal, from the first body to what it meets, and y along the surface. The
    point of the first body that touches slides at s = v_t + Ω₁R₁ + Ω₂R₂.

    Attributes:
        restitution: ε_n = −v_n′/v_n.
        tangential_restitution: ε_t = −s′/s: −1 without friction, 1 of a perfect superball; NaN
            where s = 0.
    """

    _name: ClassVar[str] = "oblique impact"
    _told = ("body", "against", "state")

    body: Body
    against: Against
    speed: float
    tangential: float
    spin: float
    second_spin: float
    friction: float
    energy: ObliqueLedger
    state: NDArray[Any] | None
    _handle: _core.ObliqueImpact = dataclasses.field(repr=False)

    def __repr__(self) -> str:
        spin = f", spin={self.spin:.6g} c/R" if self.spin else ""
        motion = f"speed={self.speed:.6g} c, tangential={self.tangential:.6g} c{spin}, friction={self.friction:.6g}"
        found = f"restitution {self.restitution:.5f}, tangential {self.tangential_restitution:.4f}"
        return f"ObliqueImpact({shown(self.body, self.against)}, {motion}: {found})"

    def trajectory(self, *, every: int = 1) -> ObliqueTrajectory:
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
            raise InvalidInput.out_of_range("every", rows, "1 or more", "steps between two rows")
        size = (200.0 + 50.0 * self.nodes) * (self.steps // rows + 2)
        require_memory("every", f"{rows} for {self.steps} steps", size, "give a larger one")
        table, others = self._handle.trajectory(self._contact(), rows)
        values: dict[str, Any] = {"second_x": None, "second_y": None} | columns(table) | others
        return ObliqueTrajectory(impact=self, **values)

    def plot(self, ax: Any = None) -> Any:
        """Velocities, forces, and where points stick. See `stoss.plot.oblique_impact`."""
        return self.trajectory().plot(ax)

    def _contact(self) -> _core.Contact:
        return contact(self.body, self.against, self.cutoff, self.speed)

    @classmethod
    def _made(
        cls, body: Body, against: Against, motion: tuple[float, ...], cutoff: float,
        resolution: tuple[float | None, int | None, float | None], state: Any,
    ) -> ObliqueImpact:  # fmt: skip
        """The impact with these inputs, checked before; a resolution is step, nodes and half-width."""
        modes, (speed, *along) = choose_state(state), motion
        met = contact(body, against, cutoff, speed)
        handle = _core.oblique_impact(met, speed, np.array(along), *resolution, modes)
        values: dict[str, Any] = {**dict(zip(MOTION, motion)), **handle.numbers()}
        return cls(
            body=body, against=against, energy=ObliqueLedger(**handle.ledger()), state=modes if modes.size else None,
            _handle=handle, **values,
        )  # fmt: skip

    def __reduce__(self) -> tuple[Any, ...]:
        # Repeated, which gives the same bits, rather than written.
        motion = tuple(getattr(self, name) for name in MOTION)
        resolution = (self.step, self.nodes, self.half_width)
        return ObliqueImpact._made, (self.body, self.against, motion, self.cutoff, resolution, self.state)


@explained
def oblique_impact(
    body: Body,
    *,
    speed: float,
    tangential: float | None = None,
    angle: float | None = None,
    friction: float,
    spin: float = 0.0,
    second_spin: float = 0.0,
    against: Wall | Body | Unbounded | str | None = None,
    cutoff: float | None = None,
    step: float | None = None,
    nodes: int | None = None,
    half_width: float | None = None,
    state: State = None,
    progress: bool = False,
) -> ObliqueImpact:
    """One oblique impact with friction at a fixed resolution, with its ledger and its course in time.

    For values with errors, and for many angles, use `oblique`.

    Parameters:
        body (Disk or Sphere): The first body, in whose units all results are.
        cutoff: Highest frequency of the modes that are kept, c/R. Default: that of `impact`.

    Examples:
        >>> hit = stoss.oblique_impact(stoss.Sphere(poisson=0.3), speed=0.05, angle=40, friction=0.3)
        >>> hit
        ObliqueImpact(Sphere(poisson=0.3), speed=0.05 c, tangential=0.041955 c, friction=0.3: ...
        >>> hit.energy
        ObliqueLedger(...
        >>> hit.trajectory().grip.shape[1] == hit.nodes
        True
    """
    chosen = choose_body(body, None, rigid=True)
    met = choose_against(chosen, against)
    given: dict[str, Any] = {
        "speed": speed, "tangential": tangential, "angle": angle, "spin": spin, "second_spin": second_spin,
        "friction": friction,
    }  # fmt: skip
    cases, shape = choose_motion(chosen, 1, **given)
    if shape:
        name, several = next((each, np.size(value)) for each, value in given.items() if np.shape(value))
        raise InvalidInput.out_of_range(name, f"{several} of them", "one impact", "use stoss.oblique for several")
    motion = tuple(cases[0].tolist())
    highest = choose_cutoff(cutoff, chosen, met, motion[0])
    count = None if nodes is None else integer("nodes", nodes)
    resolution = optional_number("step", step), count, optional_number("half_width", half_width)
    with waiting(boolean("progress", progress), "oblique_impact"):
        result = ObliqueImpact._made(chosen, met, motion, highest, resolution, state)
    warn_of_materials(result, 2)
    return result
