"""The coefficient of restitution with its error."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, boolean, broadcast, integer, number, numbers
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._bodies import PARTNERS, Body, Disk, shown
from stoss.bodies._encounter import Against, choose_against, choose_bodies, choose_body, refinable
from stoss.bodies._solid import own_units
from stoss.bodies._state import State, choose_state
from stoss.bodies._walls import UNBOUNDED, Unbounded, Wall
from stoss.export._tables import span, with_error
from stoss.results._function import RestitutionFunction, choose_beyond, function_of
from stoss.results._progress import bar
from stoss.results._quantities import Number, RestitutionQuantities
from stoss.results._result import ArrayResult, Column, columns, picture
from stoss.results._si import MayYield, finished


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Restitution(RestitutionQuantities, ArrayResult, MayYield):
    """The coefficient of restitution of a body at a wall or a half-space, or of two bodies.

    Numbers if all inputs were numbers, otherwise arrays of the shape to which `poisson` and `speed`
    broadcast: then ``len()`` is the length of the first axis, and indices select as in numpy. The
    estimated errors are bounds: in the validation 97 % or more of the true errors are within them,
    for fast disks (0.1 to 0.6 c) 92 % at the tolerance 10⁻³ and 91 % at 10⁻⁴.

    Attributes:
        body (Disk, Sphere, Rod, ModalBody or None): The first; all units are its own. None if there are
            several.
        bodies: All first bodies, each once.
        against (HardWall, ExponentialWall, Disk, Sphere, Rod, ModalBody, HalfSpace, HalfPlane, Plate, Strip or 'same'):
            What it meets; 'same'
            for several Poisson's ratios, each meeting an identical disk.
        lost_to_first, lost_to_second: Vibration of each body after the impact and what its material
            absorbed, as shares of the initial energy. For a half-space it is the energy of its
            waves, for a wall 0. Their sum is `lost_fraction` if the bodies were unexcited.
    """

    plot = picture("ε against v with error bars. See `stoss.plot.restitution`.")
    _name: ClassVar[str] = "restitution"
    _told = ("body", "bodies", "against", "tolerance", "absolute", "state")
    _axis: ClassVar[str] = "speed"
    _given = {"poisson": "", "speed": "speed"}

    body: Body | None
    bodies: tuple[Body, ...] = dataclasses.field(repr=False)
    against: Against | str
    poisson: Number
    speed: Number
    reason: str | NDArray[np.object_]
    tolerance: float
    absolute: float
    state: NDArray[Any] | None

    def __repr__(self) -> str:
        against = self.against if isinstance(self.against, (*PARTNERS, str)) else None  # else at a wall
        named = self.body is not None and (against is not None or not isinstance(self.body, Disk))
        of = shown(self.body) if named and self.body else f"poisson={span(self.poisson)}"
        if self.body is None and self._kind_of_body() != "disk":
            of = f"{len(self.bodies)} {self._kind_of_body()}s, {of}"
        if against is not None:
            of += f" against {against!r}" if isinstance(against, str) else f" against {shown(against)}"
        of += f", speed={span(self.speed)} c"
        if isinstance(self.restitution, float):
            value = f"restitution {with_error(self.restitution, float(self.restitution_error))}"
            return f"Restitution({of}: {value}{'' if self.converged else ', not converged'})"
        doubtful = int(np.size(self.converged) - np.count_nonzero(self.converged))
        state = "all converged" if doubtful == 0 else f"{doubtful} not converged"
        return f"Restitution({np.size(self.speed)} values, {of}: restitution {span(self.restitution)}, {state})"

    def _kind_of_body(self) -> str:
        return self.bodies[0]._kind if self.bodies else "disk"

    def _part(self, key: Any, shape: tuple[int, ...]) -> dict[str, Any]:
        values = self._selected(key, shape)
        if self.body is None:  # bodies that are none of these leave
            left = tuple(each for each in self.bodies if np.any(values["poisson"] == getattr(each, "poisson")))
            values |= {"bodies": left, "body": left[0] if len(left) == 1 else None}
            if len(left) == 1 and isinstance(self.against, (str, *UNBOUNDED)):
                values["against"] = choose_against(left[0], self.against, ())
        return values

    def function(self, beyond: str = "error") -> RestitutionFunction:
        """ε(v) as a function, from the values of one body at five speeds or more.

        The error of the interpolation is estimated from how well values are met by their
        neighbours; `stoss.restitution_function` keeps to an error that is asked for.

        Parameters:
            beyond ({'error', 'clamp', 'law'}, optional): What the function does beyond these
                speeds, as of `stoss.restitution_function`.

        Examples:
            >>> curve = stoss.restitution(poisson=0.33, speed=np.geomspace(1e-3, 0.3, 50))
            >>> epsilon = curve.function(beyond="clamp")
            >>> round(epsilon(0.1), 3), epsilon.error(0.1) < 1e-3
            (0.947, True)
        """
        body, against = self.body, self.against
        if body is None and np.unique(self.poisson).size == 1 and len(self.bodies) == 1:
            body = self.bodies[0]
        if body is None or isinstance(against, str):
            raise InvalidInput.out_of_range(
                "function", f"{len(self.bodies)} bodies", "one", "take a part of the result, [0]"
            )
        doubtful = int(np.size(self.converged) - np.count_nonzero(self.converged))
        if doubtful:
            got = f"{doubtful} of {np.size(self.speed)} values that have not converged"
            hint = "see .converged, .reason; or take a part, curve[curve.converged]"
            raise InvalidInput.out_of_range("function", got, "those that have", hint)
        order = np.argsort(np.ravel(self.speed), kind="stable")
        curve = (np.ravel(each)[order] for each in (self.speed, self.restitution, self.restitution_error))
        outside = choose_beyond(beyond, body, against, self.state)
        return function_of(body, against, outside, self.state, *curve, np.empty(0))

    def _arranged_columns(self) -> tuple[dict[str, Column], tuple[str, ...]]:
        table, shape = self._columns(), np.shape(self.restitution)
        speed, poisson = table["speed"], table["poisson"]
        if len(shape) == 2 and np.all(speed == speed[:1]) and np.array_equal(poisson, poisson[:, :1] + 0 * poisson):
            return table, ("poisson", "speed")
        if len(shape) == 1 and np.unique(poisson).size <= 1:
            return table, ("speed",)
        if len(shape) == 1 and np.unique(speed).size == 1:
            return table, ("poisson",)
        return table, tuple(f"axis_{k}" for k in range(len(shape)))

    def _inputs(self) -> dict[str, Any]:
        # Several disks without sizes are told by their Poisson's ratios.
        plain = [isinstance(each, Disk) and each == Disk(poisson=each.poisson) for each in self.bodies]
        left_out = "bodies" if self.body is not None or all(plain) else ""
        return {name: value for name, value in super()._inputs().items() if name != left_out}


def empty_rows(shape: int | tuple[int, ...], kind_of_row: np.dtype[Any] = _core.restitution_row) -> NDArray[Any]:
    """Rows of curves that nothing has been computed of: NaN, 0 and False."""
    rows = np.zeros(shape, dtype=kind_of_row)
    for name, (kind, *_) in (rows.dtype.fields or {}).items():
        if kind.kind == "f":
            rows[name] = np.nan
    return rows


@documented
def restitution(
    body: Body | Sequence[Body] | NDArray[np.object_] | None = None,
    *,
    speed: ArrayLike,
    against: Wall | Body | Unbounded | str | None = None,
    poisson: ArrayLike | None = None,
    tolerance: float = 1e-3,
    absolute: float = 1e-6,
    state: State = None,
    threads: int = 0,
    progress: bool = False,
) -> Restitution:
    """Compute the coefficient of restitution ε = −v_f/v_i of a body at a wall or of two bodies.

    Cutoff, time step and contact grid are refined together until the estimated error of 1 − ε² is
    below ``tolerance * (1 − ε²)`` or below ``absolute``. If that cannot be met, a single value raises
    `NotConverged`; in arrays such values are marked, and a `StossWarning` says how many there are.
    A value of a disk takes 1.5 ms in the median, 21 ms or more in one case of a hundred.

    Parameters:
        body (Disk, Sphere, Rod or ModalBody, or a list or an array of disks or of spheres): The first
            body, in whose units all results are. Several broadcast with `speed`, and have no material.
        state (Oscillation, sequence of them or ndarray, optional): How the bodies vibrate before
            the impact, with the same shares of energy and phases at every speed; ε may then exceed
            1. Default: they are unexcited.

    Examples:
        >>> stoss.restitution(poisson=0.33, speed=0.1)
        Restitution(poisson=0.33, speed=0.1 c: restitution 0.947042 ± 0.000038)
        >>> curve = stoss.restitution(poisson=0.33, speed=np.geomspace(1e-4, 0.3, 50))
        >>> curve.restitution.max().round(4)
        0.9974
        >>> balls = [[stoss.Sphere(poisson=nu)] for nu in (0.0, 0.3)]
        >>> stoss.restitution(balls, speed=[0.01, 0.1]).lost_fraction.round(4)
        array([[0.0014, 0.0234],
               [0.0028, 0.0173]])
        >>> disk = stoss.Disk(poisson=0.33)
        >>> stoss.restitution(disk, against=stoss.Disk(poisson=0.33, radius=2), speed=0.2)
        Restitution(Disk(poisson=0.33) against Disk(poisson=0.33, radius=2), speed=0.2 c: restitution 0.79480 ± 0.00016)
        >>> ringing = stoss.Oscillation(order=2, index=0, energy=0.1, phase=2.0)
        >>> stoss.restitution(stoss.Sphere(poisson=0.3), speed=0.01, state=ringing).restitution > 1
        True
    """
    speeds = numbers("speed", speed)
    if body is None and poisson is not None:
        poissons, speeds = broadcast(22, poisson=numbers("poisson", poisson), speed=speeds)
        bodies: list[Body] = [Disk(poisson=value) for value in np.unique(poissons)]
        places = [np.flatnonzero(poissons == each.poisson) for each in bodies if isinstance(each, Disk)]
    elif isinstance(body, (list, tuple, np.ndarray)) and poisson is None:
        bodies, which = choose_bodies(body)
        which, speeds = broadcast(22, body=which, speed=speeds)
        poissons = np.array([getattr(each, "poisson") for each in bodies])[which.astype(np.intp)]
        places = [np.flatnonzero(which == k) for k in range(len(bodies))]
    else:
        bodies = [choose_body(body, poisson, rigid=True)]
        nu = np.full((), getattr(bodies[0], "poisson", np.nan))
        poissons, speeds = broadcast(22, poisson=nu, speed=speeds)
        places = [np.arange(speeds.size)]
    met = [choose_against(each, against) for each in bodies or [Disk(poisson=0.0)]]
    limit, enough, count = number("tolerance", tolerance), number("absolute", absolute), integer("threads", threads)
    modes = choose_state(state)
    if bodies:
        (speeds,) = own_units(bodies[0], "restitution", speed=speeds)
    _core.check_curve(speeds.ravel(), limit, enough, count)

    table, reasons, done = empty_rows(speeds.size), np.full(speeds.size, "interrupted", dtype=object), 0
    stopped = False
    with bar(speeds.size, boolean("progress", progress)) as seen:
        tick = None if seen is None else seen.update
        try:
            for each, partner, where in zip(bodies, met, places):
                own, rows, why = speeds.ravel()[where], empty_rows(where.size), list[str]()
                try:
                    contact = refinable(each, partner)
                    _core.restitution_curve(contact, own, limit, enough, count, modes, rows, why, tick)
                finally:
                    table[where], reasons[where[: len(why)]] = rows, why
                    done += len(why)
        except KeyboardInterrupt:
            stopped = True
    one = bodies[0] if len(bodies) == 1 else None
    # Each of several bodies meets these in its own form.
    shared = against if one is None and isinstance(against, (str, *UNBOUNDED)) else met[0]
    values = {"poisson": poissons, "speed": speeds, "reason": reasons, **columns(table)}
    shaped = {name: arranged(column, speeds.shape) for name, column in values.items()}
    state_before = modes if modes.size else None
    result = Restitution(one, tuple(bodies), shared, tolerance=limit, absolute=enough, state=state_before, **shaped)
    return finished(result, done if stopped else None)
