"""One impact at a fixed resolution."""

from __future__ import annotations

import dataclasses
from typing import Any

from numpy.typing import ArrayLike

from stoss._arguments import boolean, flags, integer, optional_number
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body
from stoss.bodies._encounter import Against, choose_against, choose_body, choose_cutoff, choose_tail
from stoss.bodies._solid import own_number
from stoss.bodies._state import State
from stoss.bodies._walls import WALLS
from stoss.results import _replay, _sound
from stoss.results._computed_impact import ComputedImpact
from stoss.results._progress import waiting
from stoss.results._si import warn_of_materials


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Impact(ComputedImpact):
    """One impact at a fixed resolution, with the inputs that made it.

    Energies are shares of the initial energy, that of translation and vibration: those in
    translation, vibration, dissipated and unresolved sum up to 1 but for `energy_error`.
    """

    trajectory = _replay.trajectory
    field = _replay.field
    wave = _replay.wave
    energies_at = _replay.energies_at
    state_after = _replay.state_after
    sound = _sound.sound

    def plot(self, ax: Any = None) -> Any:
        """Force against time. See `stoss.plot.force`."""
        return self.trajectory().plot(ax)


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
            order of `Impact.mode_energies`; only with ``tail="none"``, because the others would
            answer together too. Default: all.

    Examples:
        >>> hit = stoss.impact(poisson=0.33, speed=0.1)
        >>> hit
        Impact(Disk(poisson=0.33), speed=0.1 c: restitution 0.94705, contact time 5.897 R/c, 1146 modes)
        >>> round(hit.translation + hit.vibration + hit.unresolved, 3)
        1.0

        Where the others do not answer, at the paper's soft wall, the modes may be chosen, for example
        those that a first run finds to be the most energetic.

        >>> soft = stoss.ExponentialWall(hardness=500)
        >>> average = stoss.impact(poisson=0.33, speed=0.1, against=soft, tail="none").mode_energies["average"]
        >>> most = average >= np.sort(average)[-300]
        >>> stoss.impact(poisson=0.33, speed=0.1, against=soft, tail="none", keep=most).modes
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
    initial = own_number(chosen, "impact", "speed", speed)
    met = choose_against(chosen, against)
    at = choose_cutoff(cutoff, chosen, met, initial)
    count = None if nodes is None else integer("nodes", nodes)
    resolution = optional_number("step", step), count, optional_number("half_width", half_width)
    answer, kept = choose_tail(tail), None if keep is None else flags("keep", keep)
    if kept is not None and (answer != "none" or not isinstance(met, WALLS)):
        hint = "elsewhere the other modes answer together"
        got = f"a selection of modes, {met!r} and tail={answer!r}"
        raise InvalidInput.out_of_range("keep", got, "only at a wall with tail='none'", hint)
    with waiting(boolean("progress", progress), "impact"):
        result = Impact._made(chosen, met, initial, at, answer, resolution, kept, state)
    warn_of_materials(result, 2)
    return result
