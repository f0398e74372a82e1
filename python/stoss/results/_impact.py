"""One impact at a fixed resolution."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import boolean, flags, integer, number, optional_number
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body, Rod, shown, speed_unit, speeds_in_si
from stoss.bodies._encounter import Against, choose_against, choose_body, choose_cutoff, choose_tail, contact
from stoss.bodies._state import State, choose_state
from stoss.bodies._walls import ExponentialWall, HardWall
from stoss.results import _replay, _sound
from stoss.results._progress import waiting
from stoss.results._si import ImpactsInSi, Si, warn_of_materials


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Impact(ImpactsInSi):
    """One impact at a fixed resolution, with the inputs that made it.

    Energies are shares of the initial energy, that of translation and vibration.

    Attributes:
        translation, vibration, dissipated, unresolved: Energy after the impact: of the (relative)
            translation; of the kept modes; lost to the material; of the modes above the cutoff. The
            sum is 1 but for `energy_error`.
        lost_to_first, lost_to_second: Vibration and dissipation of each body after the impact,
            `unresolved` included; what the waves of a half-space carry away.
        max_force: Maximum mean over one step of the force, mc²/R: πRE of a disk, (4π/3)R²E of a sphere.
        half_width: Of the contact grid, R.
        mode_energies: Energy of each kept mode, a structured array with the fields body (0 of the
            first, 1 of the second), order, index, omega, before and after (the impact) and average
            (during contact). Those of a half-space are samples of a continuum, and their order
            counts wave numbers.
    """

    _name: ClassVar[str] = "impact"
    _kind = "impact"
    _told = ("body", "against", "tail", "keep", "state")
    _given = {"speed": "speed"}
    max_half_width_si = Si("Maximum half-width of the contact, m.")
    impulse_time_si = Si("Time between 1 % and 99 % of the impulse, s.")

    trajectory = _replay.trajectory
    field = _replay.field
    wave = _replay.wave
    energies_at = _replay.energies_at
    state_after = _replay.state_after
    sound = _sound.sound

    body: Body
    against: Against
    speed: float
    restitution: float
    lost_fraction: float
    translation: float
    vibration: float
    dissipated: float
    unresolved: float
    lost_to_first: float
    lost_to_second: float
    contact_time: float
    impulse_time: float
    contacts: int
    max_force: float
    max_compression: float
    max_half_width: float
    cutoff: float
    modes: int
    step: float
    nodes: int
    half_width: float
    steps: int
    energy_error: float
    momentum_error: float
    stays: bool
    strain: float
    beyond_small_strain: bool
    mode_energies: NDArray[Any]
    tail: str
    keep: NDArray[np.bool_] | None
    state: NDArray[Any] | None
    _handle: _core.Impact = dataclasses.field(repr=False)

    def __repr__(self) -> str:
        return (
            f"Impact({shown(self.body, self.against)}, speed={self.speed:.6g} c: restitution {self.restitution:.5f}, "
            f"contact time {self.contact_time:.4g} {self._unit('contact_time')}, {self.modes} modes)"
        )

    def plot(self, ax: Any = None) -> Any:
        """Force against time. See `stoss.plot.force`."""
        return self.trajectory().plot(ax)

    def _contact(self) -> _core.Contact:
        return contact(self.body, self.against, self.cutoff, self.speed, self.keep)

    @classmethod
    def _made(
        cls, body: Body, against: Against, speed: float, cutoff: float, tail: str = "radiating",
        resolution: tuple[float | None, int | None, float | None] = (None, None, None),
        keep: NDArray[np.bool_] | None = None, state: Any = None,
    ) -> Impact:  # fmt: skip
        """The impact with these inputs, checked before; a resolution is step, nodes and half-width."""
        modes = choose_state(state)
        handle = _core.impact(contact(body, against, cutoff, speed, keep), tail, speed, *resolution, modes)
        return cls(
            body=body, against=against, tail=tail, keep=keep, state=modes if modes.size else None,
            mode_energies=handle.modes(), _handle=handle, **handle.numbers(),
        )  # fmt: skip

    def __reduce__(self) -> tuple[Any, ...]:
        # Repeated, which gives the same bits, rather than written.
        width = None if isinstance(self.body, Rod) else self.half_width
        resolution = (self.step, self.nodes, width)
        given = (self.body, self.against, self.speed, self.cutoff, self.tail)
        return Impact._made, (*given, resolution, self.keep, self.state)

    def _inputs(self) -> dict[str, Any]:
        kept = {} if self.keep is None else {"keep": f"{self.modes} of {self.keep.size} modes"}
        return super()._inputs() | kept


@documented
def impact(
    body: Body | None = None,
    *,
    speed: float,
    against: Against | str | None = None,
    poisson: float | None = None,
    cutoff: float | None = None,
    step: float | None = None,
    nodes: int | None = None,
    half_width: float | None = None,
    tail: str = "radiating",
    keep: ArrayLike | None = None,
    state: State = None,
    progress: bool = False,
) -> Impact:
    """One impact of an elastic body at a fixed resolution, with its energy ledger.

    The modes with ω ≤ `cutoff` move by m Q̈ = −m ω² Q − F·(their amplitude at the contact); all
    others answer together. For a value with an error bar use `restitution`.

    Parameters:
        cutoff: Highest frequency of the modes that are kept, c/R. Default: 50, or that up to which
            a `ModalBody` is known; less on a half-space or a plate, where there are many modes.
        keep (array_like of bool, optional): Which of the modes with ω ≤ `cutoff` are kept, in the
            order of `Impact.mode_energies`; only with an `ExponentialWall`, because a hard contact
            needs the compliance of the others. Default: all.

    Examples:
        >>> hit = stoss.impact(poisson=0.33, speed=0.1)
        >>> hit
        Impact(Disk(poisson=0.33), speed=0.1 c: restitution 0.94705, contact time 5.897 R/c, 1146 modes)
        >>> round(hit.translation + hit.vibration + hit.unresolved, 3)
        1.0

        With a soft wall the modes may be chosen, for example those that a first run finds to be the
        most energetic.

        >>> soft = stoss.ExponentialWall(hardness=500)
        >>> average = stoss.impact(poisson=0.33, speed=0.1, against=soft).mode_energies["average"]
        >>> stoss.impact(poisson=0.33, speed=0.1, against=soft, keep=average >= np.sort(average)[-300]).modes
        300

        Two disks of unequal size, and which absorbs more.

        >>> pair = stoss.impact(stoss.Disk(poisson=0.33), against=stoss.Disk(poisson=0.33, radius=2), speed=0.2)
        >>> round(pair.lost_to_first, 2), round(pair.lost_to_second, 2)
        (0.03, 0.33)

        What an impact leaves in the modes makes the next one faster or slower, as the phases have it.

        >>> ball = stoss.Sphere(poisson=0.3)
        >>> first = stoss.impact(ball, speed=0.1, cutoff=25)
        >>> for flight in (21.0, 22.0):
        ...     state = first.state_after(flight=flight)
        ...     again = stoss.impact(ball, speed=0.1 * first.restitution, cutoff=25, state=state)
        ...     print(round(again.restitution, 4))
        0.9917
        0.989
    """
    chosen = choose_body(body, poisson, rigid=True)
    initial = number("speed", speed) / speed_unit(chosen)
    met = choose_against(chosen, against, (HardWall, ExponentialWall))
    at = choose_cutoff(cutoff, chosen, met, initial)
    count = None if nodes is None else integer("nodes", nodes)
    resolution = optional_number("step", step), count, optional_number("half_width", half_width)
    answer, kept = choose_tail(tail), None if keep is None else flags("keep", keep)
    if kept is not None and not isinstance(met, ExponentialWall):
        hint = "elsewhere the compliance of the other modes counts"
        got = f"a selection of modes and {met!r}"
        raise InvalidInput(f"keep: got {got}, allowed only with a stoss.ExponentialWall ({hint})")
    with speeds_in_si(chosen), waiting(boolean("progress", progress), "impact"):
        result = Impact._made(chosen, met, initial, at, answer, resolution, kept, state)
    warn_of_materials(result, 2)
    return result
