"""One impact at a fixed resolution."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss.bodies._bodies import Body, Rod, shown
from stoss.bodies._encounter import Against, contact
from stoss.bodies._state import choose_state
from stoss.bodies._walls import ExponentialWall, HardWall
from stoss.results import _inside, _replay
from stoss.results._si import ImpactsInSi, Si


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Impact(ImpactsInSi):
    """One impact at a fixed resolution, with the inputs that made it.

    Energies are shares of the initial energy, that of translation and vibration.

    Attributes
    ----------
    translation, vibration, dissipated, unresolved : float
        Energy after the impact: of the (relative) translation; of the kept modes; lost to the
        material; of the modes above the cutoff. The sum is 1 but for `energy_error`.
    lost_to_first, lost_to_second : float
        Vibration and dissipation of each body after the impact, `unresolved` included; what the
        waves of a half-space carry away.
    modes, steps : int
        Numbers of kept modes and of time steps.
    nodes, half_width : int, float
        Of the contact grid; R.
    mode_energies : ndarray
        Energy of each kept mode, a structured array with the fields body (0 of the first, 1 of
        the second), order, index, omega, before and after (the impact) and average (during
        contact). Those of a half-space are samples of a continuum, and their order counts wave
        numbers.
    """

    _name: ClassVar[str] = "impact"
    _kind = "impact"
    _told = ("body", "against", "tail", "keep", "state")
    _given = {"speed": "speed"}
    max_half_width_si = Si("Maximum half-width of the contact, m.")
    impulse_time_si = Si("Time between 1 % and 99 % of the impulse, s.")

    trajectory = _replay.trajectory
    field = _inside.field
    wave = _inside.wave
    energies_at = _replay.energies_at
    state_after = _replay.state_after

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
        cls,
        body: Body,
        against: Against,
        speed: float,
        cutoff: float,
        resolution: tuple[float | None, int | None, float | None] = (None, None, None),
        tail: str = "radiating",
        keep: NDArray[np.bool_] | None = None,
        state: Any = None,
    ) -> Impact:
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
        made_with = (self.body, self.against, self.speed, self.cutoff, resolution, self.tail, self.keep, self.state)
        return Impact._made, made_with

    def _inputs(self) -> dict[str, Any]:
        kept = {} if self.keep is None else {"keep": f"{self.modes} of {self.keep.size} modes"}
        return super()._inputs() | kept
