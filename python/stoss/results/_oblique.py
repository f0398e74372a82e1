"""Oblique impacts with friction: what becomes of the motion along the surface, and of the spins."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, boolean, integer, number
from stoss.bodies._bodies import Body, shown
from stoss.bodies._encounter import Against, choose_against, choose_body, refinable
from stoss.bodies._state import State, choose_state
from stoss.bodies._walls import Unbounded, Wall
from stoss.export._tables import span, with_error
from stoss.results._restitution import empty_rows
from stoss.results._obliquity import MOTION, Oblique, ObliqueLedger, choose_motion, explained
from stoss.results._progress import bar
from stoss.results._quantities import Number, ObliqueQuantities, QUANTITIES
from stoss.results._result import ArrayResult, Column, columns, picture
from stoss.results._si import finished


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ObliqueRestitution(ObliqueQuantities, ArrayResult, Oblique):
    """The collision rule of bodies that meet at an angle, with spin and friction.

    Numbers if all inputs were numbers, otherwise arrays of the shape to which they broadcast: then
    ``len()`` is the length of the first axis, and indices select as in numpy. x points along the
    normal, from the first body to what it meets, and y along the surface. The point of the first
    body that touches slides at s = v_t + Ω₁R₁ + Ω₂R₂.

    Attributes:
        restitution, restitution_error: ε_n = −v_n′/v_n, and its estimated error.
        tangential_restitution, tangential_restitution_error: ε_t = −s′/s: −1 without friction, 1 of
            a perfect superball. Where s = 0 it is 0 with an infinite error, and s′ says what
            happens.
        dundurs, coupling_restitution, coupling_tangential_restitution, coupling_sliding_after: Of
            unlike spheres, what the errors do not contain: pressure and friction are taken not to
            change each other. Dundurs' β of the bodies, without its sign, and by how much ε_n of a
            central impact, ε_t and s′ (c) change in a coarse model with that coupling; nan: unknown.
        tolerance: Asked for: error of s′ over the larger of s and μv_n in size.
        energy: Where the energy is after the finest impact.
    """

    plot = picture("ε_t and ε_n against the angle of incidence. See `stoss.plot.oblique`.")
    _name: ClassVar[str] = "oblique"
    _told = ("body", "against", "tolerance", "state")

    body: Body
    against: Against
    speed: Number
    tangential: Number
    spin: Number
    second_spin: Number
    friction: Number
    reason: str | NDArray[np.object_]
    tolerance: float
    state: NDArray[Any] | None
    energy: ObliqueLedger

    def __repr__(self) -> str:
        of = f"{shown(self.body, self.against)}, speed={span(self.speed)} c"
        friction = f"friction={span(self.friction)}"
        if isinstance(self.restitution, float):
            spin = f", spin={span(self.spin)} c/R" if self.spin else ""
            of += f", tangential={span(self.tangential)} c{spin}, {friction}"
            normal = with_error(self.restitution, float(self.restitution_error))
            along = with_error(float(self.tangential_restitution), float(self.tangential_restitution_error))
            state = "" if self.converged else ", not converged"
            return f"ObliqueRestitution({of}: restitution {normal}, tangential {along}{state})"
        doubtful = int(np.size(self.converged) - np.count_nonzero(self.converged))
        state = "all converged" if doubtful == 0 else f"{doubtful} not converged"
        found = f"tangential restitution {span(self.tangential_restitution)}, {state}"
        return f"ObliqueRestitution({np.size(self.speed)} values, {of}, {friction}: {found})"

    def _part(self, key: Any, shape: tuple[int, ...]) -> dict[str, Any]:
        return {"energy": self.energy[key], **self._selected(key, shape)}

    def _arranged_columns(self) -> tuple[dict[str, Column], tuple[str, ...]]:
        table, shape = self._columns(), np.shape(self.restitution)
        if len(shape) != 1:
            return table, tuple(f"axis_{k}" for k in range(len(shape)))
        varied = [name for name in MOTION if np.unique(table[name]).size > 1]
        return table, (varied[0] if len(varied) == 1 else "row",)


@explained
def oblique(
    body: Body,
    *,
    speed: ArrayLike,
    tangential: ArrayLike | None = None,
    angle: ArrayLike | None = None,
    friction: ArrayLike,
    spin: ArrayLike = 0.0,
    second_spin: ArrayLike = 0.0,
    against: Wall | Body | Unbounded | str | None = None,
    tolerance: float = 1e-2,
    state: State = None,
    threads: int = 0,
    progress: bool = False,
) -> ObliqueRestitution:
    """Compute oblique impacts with friction: ε_n, ε_t, and motion and spins afterwards.

    Friction acts node by node, −μp ≤ q ≤ μp: a node sticks, or slips against q = ±μp. Bodies
    turn, but what is elastic in them keeps its directions (linear kinematics). For spheres pressure
    and friction are taken not to change each other, which is exact for equal ones; one normal impact
    then serves all angles, spins and frictions at its speed, each in a millisecond or so. A value of
    a disk takes 0.1 s. All numbers of the motion broadcast.

    Parameters:
        body (Disk or Sphere): The first body, in whose units all results are.
        tolerance: Error of the sliding speed s′ afterwards, over s or, if larger, μ times
            `speed`, 1e-6 to 0.5.

    Examples:
        >>> ball = stoss.Sphere(poisson=0.3)
        >>> stoss.oblique(ball, speed=0.01, tangential=0.005, friction=0.3)
        ObliqueRestitution(Sphere(poisson=0.3), speed=0.01 c, tangential=0.005 c, friction=0.3:
        restitution 0.99860967 ± 0.00000096, tangential 0.5238 ± 0.0022)
        >>> fan = stoss.oblique(ball, speed=0.01, angle=[5, 30, 60, 85], friction=0.1)
        >>> fan.tangential_restitution.round(3)
        array([ 0.371,  0.205, -0.598, -0.939])
    """
    chosen = choose_body(body, None, rigid=True)
    met = choose_against(chosen, against)
    cases, shape = choose_motion(
        chosen, 40, speed=speed, tangential=tangential, angle=angle, spin=spin, second_spin=second_spin, friction=friction
    )
    # Those of one speed after one another share their impacts along the normal.
    order = np.argsort(cases[:, 0], kind="stable")
    limit, count, modes = number("tolerance", tolerance), integer("threads", threads), choose_state(state)
    contact = refinable(chosen, met)
    _core.check_oblique(contact, cases[order], limit, count, modes)

    rows, why, stopped = empty_rows(order.size, _core.oblique_row), list[str](), False
    with bar(order.size, boolean("progress", progress), "oblique") as seen:
        try:
            tick = None if seen is None else seen.update
            _core.oblique_curve(contact, cases[order], limit, count, modes, rows, why, tick)
        except KeyboardInterrupt:
            stopped = True
    table, reasons = np.empty_like(rows), np.full(order.size, "interrupted", dtype=object)
    table[order], reasons[order[: len(why)]] = rows, why
    found = columns(table)
    ledger = {name: found.pop(f"energy.{name}") for name in QUANTITIES["oblique ledger"]}
    values = {**dict(zip(MOTION, cases.T.copy())), "reason": reasons, **found}
    shaped, shares = ({name: arranged(each, shape) for name, each in own.items()} for own in (values, ledger))
    kept = modes if modes.size else None
    result = ObliqueRestitution(chosen, met, tolerance=limit, state=kept, energy=ObliqueLedger(**shares), **shaped)
    return finished(result, len(why) if stopped else None)
