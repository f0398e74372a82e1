"""A sequence of impacts of one body."""

from __future__ import annotations

import dataclasses
import warnings
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import boolean, integer
from stoss._documentation import documented
from stoss._errors import Interrupted, NotConverged, StossWarning
from stoss.bodies._bodies import Body, shown
from stoss.bodies._encounter import Against, choose_against, choose_body, choose_cutoff, choose_tail, contact
from stoss.bodies._solid import own_number
from stoss.bodies._state import State, choose_state
from stoss.bodies._walls import UNBOUNDED
from stoss.export._tables import span
from stoss.results._progress import waiting
from stoss.results._quantities import BounceQuantities
from stoss.results._result import RowResult, columns, picture
from stoss.results._si import MayYield, warn_of_limits, warn_of_materials


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Bounces(BounceQuantities, MayYield, RowResult):
    """A sequence of impacts of a body that comes back. All arrays have one element for each impact;
    an index gives one of them, a slice the impacts among them.

    Energies are shares of the initial energy of the first impact.

    Attributes:
        gravity, decay_time: As they were given, c²/R and R/c.
        short_flight: Whether the flight before the impact was too short for the vibration to keep
            clear of the wall. The body then comes as from afar, with the phases of the nominal
            time.
    """

    plot = picture("ε of each impact, and where the energy is. See `stoss.plot.bounces`.")
    _name: ClassVar[str] = "bounce"
    _told = ("body", "against", "cutoff", "tail", "gravity", "decay_time", "state")
    _axis: ClassVar[str] = "number"

    body: Body
    against: Against
    cutoff: float
    tail: str
    gravity: float | None
    decay_time: float | None
    state: NDArray[Any] | None

    def __repr__(self) -> str:
        who = shown(self.body, self.against)
        if len(self) == 0:
            return f"Bounces(no impacts, {who})"
        return (
            f"Bounces({len(self)} impacts, {who}, speed={self.speed[0]:.6g} c: "
            f"restitution {span(self.restitution)}, translation {self.translation[-1]:.4g} in the end)"
        )


@documented
def bounce(
    body: Body | None = None,
    *,
    speed: float,
    against: Against | str | None = None,
    poisson: float | None = None,
    count: int = 100,
    flight_time: float | None = None,
    gravity: float | None = None,
    decay_time: float | None = None,
    cutoff: float | None = None,
    tail: str = "radiating",
    state: State = None,
    progress: bool = False,
) -> Bounces:
    """Impacts of a body that comes back to a wall or a half-space with the vibration it has kept.

    In flight the phase of a mode of frequency ω advances by ω T and its energy falls by
    exp(−T/`decay_time`). All impacts have the same cutoff and no error bar: without damping
    small differences grow, and of a long sequence only means converge. With
    ``tail="static"`` all energy is kept, and translation has in the mean as
    much before an impact as each of the modes; otherwise the modes above the cutoff absorb energy for
    good. A sequence whose speed leaves 1e-8 to 1 c has not converged.

    Parameters:
        speed: Speed of the first impact, 1e-8 to 1, c (with a material: m/s).
        against (HardWall, ExponentialWall, HalfSpace or HalfPlane, optional): What the body meets.
            Default: a rigid wall. The waves of a half-space have left before the next impact.
            Another body, which does not come back, is refused.
        count: Impacts.
        flight_time: From leaving the wall to touching it again, of an unexcited body, R/c (with a
            material: s).
        gravity: In place of `flight_time`: g, c²/R (with a material: m/s²); a flight lasts 2v/g.
        decay_time: Time in which vibrational energies fall in flight, R/c (with a material: s); 0: they are gone at
            once, and every impact is that of `impact`. Default: no decay but that of a lossy
            material.
        cutoff: Highest frequency of the modes that are kept, c/R. Default: 20, or that up to which
            a `ModalBody` is known; less on a half-space or a plate.
        state (Oscillation, sequence of them or ndarray, optional): How the body vibrates before the
            first impact, as for `impact`. Default: it is unexcited.

    Examples:
        >>> ball = stoss.Sphere(poisson=0.3)
        >>> stoss.bounce(ball, speed=0.05, count=50, flight_time=30)
        Bounces(50 impacts, Sphere(poisson=0.3), speed=0.05 c: restitution 0.942245 to 1.0263, translation 0.4069 in the end)
        >>> forgetful = stoss.bounce(ball, speed=0.05, count=3, flight_time=30, decay_time=0)
        >>> float(forgetful.restitution[1]) == stoss.impact(ball, speed=forgetful.speed[1], cutoff=20).restitution
        True
    """
    chosen = choose_body(body, poisson, rigid=True)
    first = own_number(chosen, "bounce", "speed", speed)
    given = {"flight_time": flight_time, "gravity": gravity, "decay_time": decay_time}
    own = {name: own_number(chosen, "bounce", name, each) for name, each in given.items() if each is not None}
    flight, weight, decay = map(own.get, given)
    met = choose_against(chosen, against)
    slowest = _core.slowest_bounce(first) if isinstance(met, UNBOUNDED) else first
    at, times = choose_cutoff(cutoff, chosen, met, slowest, most=20.0), integer("count", count)
    answer, modes = choose_tail(tail), choose_state(state)
    done: list[NDArray[Any]] = []
    stopped, reason = False, ""
    with waiting(boolean("progress", progress), "bounce"):
        resolved = contact(chosen, met, at, slowest)
        try:
            reason = _core.bounce(resolved, answer, first, times, flight, weight, decay, modes, done)
        except KeyboardInterrupt:
            stopped = True
    table = columns(done[0])
    result = Bounces(
        body=chosen, against=met, cutoff=at, tail=answer, gravity=weight, decay_time=decay,
        state=modes if modes.size else None, **table,
    )  # fmt: skip
    if stopped:
        raise Interrupted(f"bounce: interrupted after {len(result)} of {times} impacts (they are in .best)", result)
    if reason:
        raise NotConverged(reason, result)
    warn_of_limits(result, 2)
    if short := int(np.count_nonzero(result.short_flight)):
        text = f"{short} flights too short for the vibration to keep clear of the wall (see .short_flight)"
        warnings.warn(text, StossWarning, stacklevel=2)
    warn_of_materials(result, 2)
    return result
