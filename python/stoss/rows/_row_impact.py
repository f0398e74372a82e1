"""One motion of bodies on a line, in time."""

from __future__ import annotations

import dataclasses
import functools
import os
import warnings
from typing import Any, Callable, ClassVar, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss._arguments import arranged, boolean, integer, number, refusal
from stoss._documentation import documented
from stoss._errors import InvalidInput, StossWarning
from stoss.bodies._bodies import Body
from stoss.rows._line import Standing, choose_line, choose_speeds, shown_line
from stoss.bodies._state import State
from stoss.bodies._walls import HardWall
from stoss.results._progress import waiting
from stoss.results._quantities import Si
from stoss.results._result import Column, picture
from stoss.rows._row import FEW, OfALine
from stoss.results._si import warn_of_limits

LEDGER = ("translation", "vibration", "contact", "unresolved", "dissipated", "yielded")
SMALL_STRAIN = 0.1


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class RowImpact(OfALine):
    """One motion of bodies on a line at a fixed cutoff, in time, without errors.

    Arrays have the times as first axis, then the bodies or the contacts from left to right. Energies
    are shares of that of all centres before, and their sum stays 1 if the bodies were unexcited, but
    for `energy_error`.

    Attributes:
        bodies (tuple): From left to right; the units of results are those of the first.
        before, against: What stands on the left and on the right, or None.
        gaps: As they were given, or None: all touch.
        state: How the bodies vibrated before, or None: a structured array with the fields body, order,
            index, energy (over that of all centres) and phase.
        velocities: Before, to the right, in `velocity_unit`: m/s with materials, otherwise c of the first
            body.
        velocities_after: At the end, in the same unit.
        cutoff: Modes up to this frequency are kept, c/R.
        step, steps: Time step, R/c, and their number.
        time: R/c since the first contact of the row.
        displacement: Of each centre since the start, R.
        velocity: Of each centre, to the right, c.
        force: Of each contact, mc²/R: πRE of a disk, (4π/3)R²E of a sphere.
        translation: Energy of the centres.
        vibration: Energy of the kept modes; of a half-space or a plate that which has run away.
        contact: Stored in contacts.
        unresolved: Taken by modes above the cutoff.
        dissipated: Absorbed by the materials.
        yielded: Taken by plastic flow.
        contacts: Of each contact from left to right, a structured array as that of `Row`.
        energy_error, momentum_error: Sum of all energies at the end less that at first, and momentum that
            the bodies have more than before and no wall has given.
        strain: Greatest strain near a contact, estimated.
    """

    plot = picture("Velocities, and the forces of contacts in space and time. See `stoss.plot.row_impact`.")
    _name: ClassVar[str] = "row_impact"
    _axis: ClassVar[str] = "time"
    _told = ("before", "against", "state", "cutoff")
    _given = {"time": "time", "displacement": "length", "velocity": "speed", "force": "force",
              **dict.fromkeys(LEDGER, "")}  # fmt: skip

    time_si = Si("Time since the first contact, s.")
    displacement_si = Si("Displacement of each centre, m.")
    velocity_si = Si("Velocity of each centre, m/s.")
    force_si = Si("Force of each contact, N, of a disk N/m.")

    bodies: tuple[Body, ...]
    before: HardWall | None
    against: Standing | None
    gaps: NDArray[np.float64] | None
    state: NDArray[Any] | None
    velocities: NDArray[np.float64]
    velocities_after: NDArray[np.float64]
    cutoff: float
    step: float
    steps: int
    time: NDArray[np.float64]
    displacement: NDArray[np.float64]
    velocity: NDArray[np.float64]
    force: NDArray[np.float64]
    translation: NDArray[np.float64]
    vibration: NDArray[np.float64]
    contact: NDArray[np.float64]
    unresolved: NDArray[np.float64]
    dissipated: NDArray[np.float64]
    yielded: NDArray[np.float64]
    contacts: NDArray[Any]
    energy_error: float
    momentum_error: float
    strain: float

    @property
    def beyond_small_strain(self) -> bool:
        """Whether the strain is above 0.1, where linear elasticity is no longer accurate."""
        return self.strain > SMALL_STRAIN

    def animate(self, path: str | os.PathLike[str], **options: Any) -> Any:
        """Write a film of the bodies and the forces between them. See `stoss.animate`, which has the options."""
        return self._draw(functools.partial(_written, path, options), "animate")

    def __len__(self) -> int:
        return self.time.size

    def __repr__(self) -> str:
        said = ", ".join(f"{each:.6g}" for each in self.velocities_after[:FEW].tolist())
        more = ", …" if self.velocities.size > FEW else ""
        return (
            f"RowImpact({shown_line(self._line())}: after {said}{more} {self.velocity_unit}, "
            f"{len(self)} times to {self.time[-1]:.4g} {self._unit('time')})"
        )

    def _unit(self, name: str) -> str:
        """Columns of one body or contact have its number at the end of their names."""
        return super()._unit("_".join(part for part in name.split("_") if not part.isdigit()))

    def _table(self) -> dict[str, Column]:
        return self._numbered("")

    def _derived(self) -> dict[str, Any]:
        return {} if self.material is None else self._numbered("_si")

    def _numbered(self, ending: str) -> dict[str, Column]:
        """A column for each body or contact."""
        table: dict[str, Column] = {}
        for name, dimension in self._given.items():
            if ending and not dimension:
                continue
            values = np.asarray(getattr(self, name + ending))
            if values.ndim == 1:
                table[name + ending] = values
            else:
                table |= {f"{name}_{k}{ending}": values[:, k] for k in range(values.shape[1])}
        return table


def _written(path: Any, options: Mapping[str, Any], result: RowImpact, animate: Callable[..., Any]) -> Any:
    """What pictures call with their function, as results know none."""
    return animate(result, path, **options)


@documented
def row_impact(
    bodies: Sequence[Body],
    *,
    speed: ArrayLike,
    before: HardWall | str | None = None,
    against: Standing | str | None = None,
    gaps: ArrayLike | None = None,
    vibration: State = None,
    cutoff: float = 16.0,
    until: float | None = None,
    every: int = 1,
    progress: bool = False,
) -> RowImpact:
    """One motion of bodies on a line at a fixed cutoff: forces, velocities and energies in time.

    For velocities with errors use `row`, whose arguments these are.

    Parameters:
        bodies (sequence of Sphere, Disk, Rod or ModalBody): From left to right, as for `row`, or one
            between two walls.
        speed: Velocities to the right of the bodies from the first on, c of the first body (with
            materials: m/s); those that are left out rest.
        before, against, gaps, vibration: As for `row`.
        cutoff: Highest frequency of the modes that are kept, over the fastest time scale of two
            neighbours: for equal balls in c/R. The result has it in c/R of the first body.
        until: How long the row is watched after the first contact, R/c of the first body (with materials:
            s). Default: until no bodies can meet any more, or 20 times as long as contacts last.
        every: Steps between two times. A free flight of all bodies has none but both its ends.

    Examples:
        >>> ball = stoss.Sphere(poisson=0.3)
        >>> cradle = stoss.row_impact([ball] * 3, speed=[0.1])
        >>> cradle.force.shape == (len(cradle), 2) and cradle.displacement.shape == (len(cradle), 3)
        True
        >>> total = sum(getattr(cradle, name) for name in ("translation", "vibration", "contact", "unresolved"))
        >>> bool(abs(total - 1).max() < 1e-3)
        True
    """
    line = choose_line(bodies, before, against, gaps, vibration)
    speeds = choose_speeds(line, speed)
    if speeds.ndim != 1:
        raise refusal("speed", speed, "one row of speeds")
    highest, stride = number("cutoff", cutoff), integer("every", every)
    if not 0.0 < highest <= 1000.0:
        raise refusal("cutoff", cutoff, "above 0, up to 1000 (over the fastest time scale of two neighbours)")
    if stride < 1:
        raise InvalidInput.out_of_range("every", stride, "1 or more", "steps between two rows")
    end = 0.0
    if until is not None:
        scale = 1.0 if line.bodies[0].material is None else line.bodies[0].scales.time
        end = number("until", until) / scale
        if not 0.0 < end < np.inf:
            raise refusal("until", until, "a time above 0")
    with waiting(boolean("progress", progress), "row_impact"):
        made = line.given().motion(speeds, highest, end, stride)
    energy = made.pop("energy")
    after = made.pop("velocities_after") * line.speed_unit()
    made |= {name: arranged(energy[:, k].copy(), (len(energy),)) for k, name in enumerate(LEDGER)}
    made |= {"velocities": speeds, "velocities_after": arranged(after, after.shape), **line._asdict()}
    result = RowImpact(**made)
    warn_of_limits(result, 2)
    for said in line.warnings(result.contacts):
        warnings.warn(said, StossWarning, stacklevel=2)
    return result
