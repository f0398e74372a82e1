"""Velocities of bodies on a line after all their contacts."""

from __future__ import annotations

import dataclasses
import warnings
from typing import Any, ClassVar, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, boolean, integer, number
from stoss._documentation import documented
from stoss._errors import Interrupted, NotConverged, StossWarning
from stoss.bodies._bodies import Body
from stoss.rows._line import Line, Standing, choose_line, choose_speeds, shown_line
from stoss.bodies._state import State
from stoss.bodies._walls import HardWall
from stoss.export._tables import with_error
from stoss.results._progress import bar, waiting
from stoss.results._quantities import QUANTITIES, RowQuantities
from stoss.results._restitution import empty_rows
from stoss.results._result import ArrayResult, Column, columns, picture
from stoss.results._si import InSi, si_name, warn_of_doubt, warn_of_limits

FEW = 6  # velocities that a line can name


class OfALine(InSi):
    """What results of rows have in common: who is in it, and contacts in SI."""

    bodies: tuple[Body, ...]
    before: HardWall | None
    against: Standing | None
    gaps: NDArray[np.float64] | None
    state: NDArray[Any] | None
    contacts: NDArray[Any]

    @property
    def body(self) -> Body:
        """The first body, of whose units results are."""
        return self.bodies[0]

    @property
    def velocity_unit(self) -> str:
        """Unit of `velocities` and `velocities_after`, as of the speeds: m/s with materials, or c of the first body."""
        return "c" if self.material is None else "m/s"

    @property
    def contacts_si(self) -> NDArray[Any]:
        """The `contacts` in SI."""
        if self.material is None:
            raise AttributeError("contacts_si: this result has no material (make its bodies with one)")
        found = self.contacts.copy()
        for name, dimension in QUANTITIES["row contact"].items():
            if dimension:
                found[name] *= getattr(self.body.scales, dimension)
        found.flags.writeable = False
        return found

    def _line(self) -> Line:
        return Line(self.bodies, self.before, self.against, self.gaps, self.state)

    def _inputs(self) -> dict[str, Any]:
        gaps = {} if self.gaps is None else {"gaps": " ".join(repr(each) for each in self.gaps.tolist())}
        return {"bodies": shown_line(self._line())} | super()._inputs() | gaps


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Row(RowQuantities, ArrayResult, OfALine):
    """Velocities of bodies on a line after all their contacts, with errors.

    For one row of speeds arrays have an element for each body, and quantities of the whole row are
    numbers. For several rows, the cases, all have them as first axis: ``len()`` is their number, and
    indices select cases. Energies are shares of that of all centres before.

    Attributes:
        bodies (tuple): From left to right; the units of results are those of the first.
        before, against: What stands on the left and on the right, or None.
        gaps: As they were given, or None: all touch.
        state: How the bodies vibrated before, or None: a structured array with the fields body, order,
            index, energy (over that of all centres) and phase.
        velocities: Before, to the right, in `velocity_unit`: m/s with materials, otherwise c of the first
            body.
        velocities_after, velocities_after_error: After the last contact, in the same unit, and their
            estimated errors.
        contacts: Of each contact from left to right, a structured array with the fields left (the number
            of the body on its left from 0, -1 for a wall), first_touch, last_touch (R/c after the
            first contact of the row), touches (how many times its bodies come together), max_force
            (mc²/R), impulse (mc) and max_compression (R), in units of the first body; `contacts_si`
            has them in SI.
        tolerance: Asked for: error of each velocity over the greatest difference of speeds before.
    """

    plot = picture("Velocities before and after, with error bars. See `stoss.plot.row`.")
    _name: ClassVar[str] = "row"
    _axis: ClassVar[str] = "number"
    _first: ClassVar[str] = "converged"
    _told = ("before", "against", "state", "tolerance")
    _given = {"case": "", **QUANTITIES["row body"]}

    bodies: tuple[Body, ...]
    before: HardWall | None
    against: Standing | None
    gaps: NDArray[np.float64] | None
    state: NDArray[Any] | None
    velocities: NDArray[np.float64]
    velocities_after: NDArray[np.float64]
    velocities_after_error: NDArray[np.float64]
    contacts: NDArray[Any]
    reason: str | NDArray[np.object_]
    tolerance: float

    def __repr__(self) -> str:
        of = shown_line(self._line())
        if self.velocities.ndim > 1:
            doubtful = int(np.size(self.converged) - np.count_nonzero(self.converged))
            return f"Row({len(self)} cases, {of}: {f'{doubtful} not' if doubtful else 'all'} converged)"
        after, error = self.velocities_after[:FEW].tolist(), self.velocities_after_error[:FEW].tolist()
        said = ", ".join(with_error(*each) for each in zip(after, error))
        more = ", …" if self.velocities.size > FEW else ""
        return f"Row({of}: after {said}{more} {self.velocity_unit}{'' if self.converged else ', not converged'})"

    def _part(self, key: Any, shape: tuple[int, ...]) -> dict[str, Any]:
        varying = {"velocities", "velocities_after", "velocities_after_error", "contacts", "reason",
                   *QUANTITIES["row"]}  # fmt: skip
        parts = {name: np.asarray(getattr(self, name))[key] for name in varying}
        return {name: arranged(np.array(part), np.shape(part)) for name, part in parts.items()}

    def _table(self) -> dict[str, Column]:
        """A row for each body of each case, with the quantities of the case."""
        shape, unit = self.velocities.shape, self._line().speed_unit()
        cases = {"case": np.arange(shape[0])[:, None]} if len(shape) > 1 else {}
        own = {"velocity": self.velocities, "velocity_after": self.velocities_after,
               "velocity_after_error": self.velocities_after_error}  # fmt: skip
        table: dict[str, Any] = {**cases, "number": np.arange(shape[-1])}
        table |= {name: each / unit for name, each in own.items()}
        table |= {name: np.asarray(getattr(self, name))[..., None] for name in QUANTITIES["row"]}
        if self.material is not None:
            table |= {si_name(name): each for name, each in own.items()}
        return {name: np.broadcast_to(each, shape) for name, each in table.items()}

    def _columns(self) -> dict[str, Column]:
        shape = self.velocities.shape
        derived = {name: np.broadcast_to(np.asarray(each)[..., None], shape) for name, each in self._derived().items()}
        return self._table() | derived

    def _arranged_columns(self) -> tuple[dict[str, Column], tuple[str, ...]]:
        return self._columns(), ("case", "number") if self.velocities.ndim > 1 else ("number",)


@documented
def row(
    bodies: Sequence[Body],
    *,
    speed: ArrayLike,
    before: HardWall | str | None = None,
    against: Standing | str | None = None,
    gaps: ArrayLike | None = None,
    vibration: State = None,
    tolerance: float = 1e-3,
    threads: int = 0,
    progress: bool = False,
) -> Row:
    """Velocities of bodies on a line after all their contacts, as in a cradle, with errors.

    All may touch at once: each body carries waves and forces from one contact to the next, and ends
    with the vibration that they leave. The cutoff rises until the errors of all velocities are below
    `tolerance` times the greatest difference of speeds before. If that cannot be met, a single row
    raises `NotConverged`; of several such rows are marked, and a `StossWarning` says how many there are.
    Three equal balls take some 4 ms at 0.1 c, and longer the slower they are; a half-space or a plate
    takes a minute and more.

    Parameters:
        bodies (sequence of Sphere, Disk, Rod or ModalBody): From left to right, 2 to 100, or one and a
            block; ``[ball] * 5`` are five equal ones. All are of one kind, with a material or all
            without; a body known by its modes stands at an end.
        speed: Velocities to the right of the bodies from the first on, -1 to 1, c of the first body (with
            materials: m/s); those that are left out rest. An array of cases × bodies computes each
            case.
        before: What stands on the left: nothing (default) or a rigid 'wall'.
        against: What stands on the right: nothing (default), a rigid 'wall', or a half-space or a plate.
        gaps: Between neighbours, what stands at an end included, from left to right, in the unit of the
            sizes, 0 to 1000 R; one number is for all. Default: all touch.
        vibration: How the bodies vibrate before: modes whose `of` is the number of the body from 0, with
            energies over that of all centres. Default: they are unexcited.
        tolerance: Error of each velocity after, over the greatest difference of speeds before, 1e-6 to 1.

    Examples:
        >>> ball = stoss.Sphere(poisson=0.3)
        >>> cradle = stoss.row([ball] * 3, speed=[0.1])
        >>> (cradle.velocities_after / 0.1).round(3)
        array([-0.027,  0.032,  0.995])
        >>> fast = stoss.row([ball] * 3, speed=[[0.02], [0.1]], tolerance=1e-2)
        >>> fast.velocities_after.shape, bool(fast.converged.all())
        ((2, 3), True)
    """
    line = choose_line(bodies, before, against, gaps, vibration)
    speeds, limit, count = choose_speeds(line, speed), number("tolerance", tolerance), integer("threads", threads)
    cases = speeds.reshape(-1, len(line.bodies))
    rows, after = empty_rows(len(cases), _core.row_row), np.full((*cases.shape, 2), np.nan)
    contacts, reasons = list[NDArray[Any]](), list[str]()
    shows, several, stopped = boolean("progress", progress), speeds.ndim > 1, False
    with bar(len(cases), shows, "row") if several else waiting(shows, "row") as seen:
        tick = None if seen is None else seen.update
        try:
            line.given().curve(cases, limit, count, rows, after, contacts, reasons, tick)
        except KeyboardInterrupt:
            stopped = True
    after *= line.speed_unit()
    done = len(reasons)
    if stopped and not several:
        raise KeyboardInterrupt("row: interrupted")
    met = np.zeros((len(cases), _joints(line)), dtype=_core.row_contact)
    for k, each in enumerate(contacts):
        met[k] = each
    shape = speeds.shape[:-1]
    reason = np.array([*reasons, *["interrupted"] * (len(cases) - done)], dtype=object)
    result = Row(
        *line, velocities=speeds, tolerance=limit, reason=arranged(reason, shape),
        velocities_after=arranged(after[..., 0].copy(), speeds.shape),
        velocities_after_error=arranged(after[..., 1].copy(), speeds.shape),
        contacts=arranged(met, (*shape, met.shape[-1])),
        **{name: arranged(column.copy(), shape) for name, column in columns(rows).items()},
    )  # fmt: skip
    if stopped:
        raise Interrupted(f"row: interrupted after {done} of {len(cases)} cases (they are in .best)", result)
    if isinstance(result.reason, str):
        if not result.converged:
            raise NotConverged(f"row: {result.reason}", result)
    else:
        warn_of_doubt(result.converged, "rows", 2)
    warn_of_limits(result, 2)
    for said in line.warnings(result.contacts):
        warnings.warn(said, StossWarning, stacklevel=2)
    return result


def _joints(line: Line) -> int:
    return len(line.bodies) - 1 + (line.before is not None) + (line.against is not None)
