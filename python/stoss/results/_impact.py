"""One impact at a fixed resolution."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import flags, integer, number, optional_number
from stoss._errors import InvalidInput
from stoss.bodies._bodies import PARTNERS, Body, Rod, shown, speed_unit, speeds_in_si
from stoss.bodies._encounter import Against, choose_against, choose_body, choose_tail, contact
from stoss.bodies._state import State, choose_state, shown_state
from stoss.bodies._walls import ExponentialWall, HardWall
from stoss.results._impact_views import ImpactViews
from stoss.results._result import Number

@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Impact(ImpactViews):
    """One impact at a fixed resolution, with the inputs that made it.

    Energies are shares of the initial energy, that of translation and vibration.

    Attributes
    ----------
    body : Disk, Sphere or Rod
        The first; all units are its own.
    against : HardWall, ExponentialWall, Disk, Sphere, Rod, HalfSpace or HalfPlane
    speed : float
        Of approach of the centres of mass, or towards the wall, c.
    restitution : float
        ε = −v_f/v_i of the relative motion; above 1 where vibration is given back.
    lost_fraction : float
        1 − ε², negative where ε > 1.
    translation, vibration, dissipated, unresolved : float
        Energy after the impact: of the (relative) translation; of the kept modes; lost to the
        material; of the modes above the cutoff. The sum is 1 but for `energy_error`.
    lost_to_first, lost_to_second : float
        Vibration and dissipation of each body after the impact, `unresolved` included; what the
        waves of a half-space carry away.
    contact_time : float
        From first to last contact, R/c.
    impulse_time : float
        From 1 % to 99 % of the impulse, R/c.
    contacts : int
        Separate periods of contact.
    max_force : float
        Maximum mean over one step of the force, mc²/R: πRE of a disk, (4π/3)R²E of a sphere.
    max_compression : float
        In R.
    max_half_width : float
        Maximum half-width of the contact, R; of spheres its radius.
    cutoff : float
        Modes up to this frequency are kept, c/R.
    modes, steps : int
        Numbers of kept modes and of time steps.
    step : float
        Time step, R/c.
    nodes, half_width : int, float
        Of the contact grid; R.
    tail : {'radiating', 'static'}
        How the modes above the cutoff answered.
    energy_error, momentum_error : float
        What is missing, as shares of the initial energy and momentum.
    beyond_small_strain : bool
        Speed, also of the vibration before, above 0.5 c or compression above 0.5 R, where linear
        elasticity has lost its meaning.
    mode_energies : ndarray
        Energy of each kept mode, a structured array with the fields body (0 of the first, 1 of
        the second), order, index, omega, before and after (the impact) and average (during
        contact). Those of a half-space are samples of a continuum, and their order counts wave
        numbers.
    keep : ndarray or None
        Which modes up to the cutoff were kept, if not all: those of `mode_energies`.
    state : ndarray or None
        How the bodies vibrated before, if they did: a structured array with the fields body, order,
        index, energy (as a share of the translational one) and phase.
    material : Material or None
        Of the body. If there is one, `speed_si`, `contact_time_si`, `max_force_si`,
        `max_compression_si` and `max_half_width_si` are the SI values. If a sphere has a yield
        strength, `yield_speed` and `yield_speed_si` say where yielding begins, and `beyond_yield`
        whether the impact is faster.
    """

    _name: ClassVar[str] = "impact"
    _kind = "impact"
    _given = {"speed": "speed"}

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
    beyond_small_strain: bool
    mode_energies: NDArray[Any]
    tail: str
    keep: NDArray[np.bool_] | None
    state: NDArray[Any] | None
    _handle: _core.Impact = dataclasses.field(repr=False)

    @property
    def max_half_width_si(self) -> Number:
        """Maximum half-width of the contact, m."""
        return self._in_si("max_half_width")

    def __repr__(self) -> str:
        return (
            f"Impact({self._who()}, speed={self.speed:.6g} c: restitution {self.restitution:.5f}, "
            f"contact time {self.contact_time:.4g} {self._unit('contact_time')}, {self.modes} modes)"
        )

    def _who(self) -> str:
        return shown(self.body) + (f" against {shown(self.against)}" if isinstance(self.against, PARTNERS) else "")

    def _contact(self) -> _core.Contact:
        return contact(self.body, self.against, self.cutoff, self.speed, self.keep)

    @classmethod
    def _made(
        cls,
        body: Body,
        against: Against,
        speed: float,
        cutoff: float,
        step: float | None,
        nodes: int | None,
        half_width: float | None,
        tail: str,
        keep: NDArray[np.bool_] | None,
        state: Any,
    ) -> Impact:
        """The impact with these inputs, checked before."""
        met = contact(body, against, cutoff, speed, keep)
        modes = choose_state(state)
        handle = _core.impact(met, tail, speed, step, nodes, half_width, modes)
        return cls(
            body=body, against=against, tail=tail, keep=keep, state=modes if modes.size else None,
            mode_energies=handle.modes(), _handle=handle, **handle.numbers(),
        )  # fmt: skip

    def __reduce__(self) -> tuple[Any, ...]:
        # Repeated, which gives the same bits, rather than written.
        width = None if isinstance(self.body, Rod) else self.half_width
        resolution = (self.cutoff, self.step, self.nodes, width, self.tail, self.keep)
        return Impact._made, (self.body, self.against, self.speed, *resolution, self.state)

    def _inputs(self) -> dict[str, Any]:
        inputs: dict[str, Any] = {"body": self.body, "against": self.against, "tail": self.tail}
        if self.keep is not None:
            inputs["keep"] = f"{self.modes} of {self.keep.size} modes"
        if self.state is not None:
            inputs["state"] = shown_state(self.state)
        return inputs


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
    body : Disk, Sphere or Rod
        The first body, in whose units all results are.
    speed : float
        Of approach of the centres of mass, or towards the wall, 1e-8 to 1, c (with a material:
        m/s). Two equal bodies at twice the speed are one of them at a rigid wall.
    against : HardWall, ExponentialWall, 'same', Disk, Sphere, Rod, HalfSpace or HalfPlane, optional
        What the body meets: a wall, an identical body, another of its kind, or, for a sphere, a
        half-space, for a disk a half-plane. Default: a rigid wall.
    poisson : float
        In place of `body`: ``Disk(poisson=poisson)``.
    cutoff : float, optional
        Highest frequency of the modes that are kept, c/R.
    step : float, optional
        Time step, R/c.
    nodes : int, optional
        Of the contact grid.
    half_width : float, optional
        Of the contact grid, R.
    tail : {'radiating', 'static'}, optional
        How the modes above the cutoff answer a hard contact: with static compliance at low and
        plane-wave impedance at high frequency, or with static compliance only.
    keep : array_like of bool, optional
        Which of the modes with ω ≤ `cutoff` are kept, in the order of `Impact.mode_energies`; only
        with an `ExponentialWall`, because a hard contact needs the compliance of the others.
        Default: all.
    state : Oscillation, sequence of them or ndarray, optional
        How the bodies vibrate before the impact: modes up to `cutoff`, or an array as
        `Impact.state_after` gives it. Default: they are unexcited. Then ε cannot exceed 1;
        with a state it may.

    Returns
    -------
    Impact

    Raises
    ------
    InvalidInput
        For arguments out of range.
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
    duration, width = optional_number("step", step), optional_number("half_width", half_width)
    answer = choose_tail(tail)
    kept = None if keep is None else flags("keep", keep)
    if kept is not None and not isinstance(met, ExponentialWall):
        hint = "elsewhere the compliance of the other modes counts"
        raise InvalidInput(
            f"keep: got a selection of modes and {met!r}, allowed only with a stoss.ExponentialWall ({hint})"
        )
    with speeds_in_si(chosen):
        return Impact._made(chosen, met, initial, at, duration, count, width, answer, kept, state)
