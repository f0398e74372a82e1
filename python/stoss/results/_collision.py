"""One impact: what it is computed from."""

from __future__ import annotations

from numpy.typing import ArrayLike

from stoss._arguments import flags, integer, number, optional_number
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body, speed_unit, speeds_in_si
from stoss.bodies._encounter import Against, choose_against, choose_body, choose_tail
from stoss.bodies._state import State
from stoss.bodies._walls import ExponentialWall, HardWall
from stoss.results._impact import Impact


@documented
def impact(
    body: Body | None = None,
    *,
    speed: float,
    against: Against | str | None = None,
    poisson: float | None = None,
    cutoff: float = 50.0,
    step: float | None = None,
    nodes: int | None = None,
    half_width: float | None = None,
    tail: str = "radiating",
    keep: ArrayLike | None = None,
    state: State = None,
) -> Impact:
    """One impact of an elastic body at a fixed resolution, with its energy ledger.

    The modes with ω ≤ `cutoff` move by m Q̈ = −m ω² Q − F·(their amplitude at the contact); all
    others answer together. For a value with an error bar use `restitution`.

    Parameters
    ----------
    against : HardWall, ExponentialWall, 'same', Disk, Sphere, Rod, HalfSpace or HalfPlane, optional
        What the body meets: a wall, an identical body, another of its kind, or, for a sphere, a
        half-space, for a disk a half-plane. Default: a rigid wall.
    step : float, optional
        Time step, R/c.
    nodes : int, optional
        Of the contact grid.
    half_width : float, optional
        Of the contact grid, R.
    keep : array_like of bool, optional
        Which of the modes with ω ≤ `cutoff` are kept, in the order of `Impact.mode_energies`; only
        with an `ExponentialWall`, because a hard contact needs the compliance of the others.
        Default: all.

    Raises
    ------
    NotConverged
        If the contact cannot be solved or does not end.

    Examples
    --------
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
    at = number("cutoff", cutoff)
    count = None if nodes is None else integer("nodes", nodes)
    resolution = optional_number("step", step), count, optional_number("half_width", half_width)
    answer, kept = choose_tail(tail), None if keep is None else flags("keep", keep)
    if kept is not None and not isinstance(met, ExponentialWall):
        hint = "elsewhere the compliance of the other modes counts"
        got = f"a selection of modes and {met!r}"
        raise InvalidInput(f"keep: got {got}, allowed only with a stoss.ExponentialWall ({hint})")
    with speeds_in_si(chosen):
        return Impact._made(chosen, met, initial, at, resolution, answer, kept, state)
