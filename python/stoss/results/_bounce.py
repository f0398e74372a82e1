"""What a sequence of impacts of one body gives."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss.bodies._bodies import PARTNERS, Body, shown
from stoss.bodies._encounter import Against
from stoss.results._result import Number, span
from stoss.results._rows import RowResult
from stoss.results._si import InSi
from stoss.bodies._state import shown_state


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Bounces(InSi, RowResult):
    """A sequence of impacts of a body that comes back. All arrays have one element for each impact;
    an index gives one of them, a slice the impacts among them.

    Energies are shares of the initial energy of the first impact.

    Attributes
    ----------
    body : Disk, Sphere or Rod
        All units are its own.
    against : HardWall, ExponentialWall, HalfSpace or HalfPlane
    cutoff : float
        Modes up to this frequency are kept, c/R.
    tail : {'radiating', 'static'}
        How the modes above the cutoff answered.
    gravity, decay_time : float or None
        As they were given, c²/R and R/c.
    state : ndarray or None
        How the body vibrated before the first impact, as `impact` has it.
    number : ndarray
        1, 2, …
    speed : ndarray
        Before the impact, c.
    restitution : ndarray
        ε = −v_f/v_i.
    translation_before, vibration_before, dissipated_before, unresolved_before : ndarray
        Energy when the impact begins: of the translation; of the kept modes; lost to the material
        and in flight so far; taken so far by the modes above the cutoff, and by the waves of a
        half-space.
    translation, vibration, dissipated, unresolved : ndarray
        The same when it is over. The sum is 1 but for `energy_error`.
    energy_error : ndarray
        What is missing, of all impacts so far.
    contact_time : ndarray
        R/c.
    flight_time : ndarray
        After the impact, R/c.
    short_flight : ndarray
        Whether the flight before the impact was too short for the vibration to keep clear of the
        wall. The body then comes as from afar, with the phases of the nominal time.
    beyond_small_strain : ndarray
        Speed above 0.5 c or compression above 0.5 R, where linear elasticity has lost its meaning.
    material : Material or None
        Of the body. If there is one, `speed_si`, `contact_time_si` and `flight_time_si` are the SI
        values. If a sphere has a yield strength, `yield_speed` and `yield_speed_si` say where
        yielding begins, and `beyond_yield` which impacts are faster.
    """

    _name: ClassVar[str] = "bounce"
    _kind = "bounce"
    _axis: ClassVar[str] = "number"

    body: Body
    against: Against
    cutoff: float
    tail: str
    gravity: float | None
    decay_time: float | None
    state: NDArray[Any] | None
    number: NDArray[np.int64]
    speed: NDArray[np.float64]
    restitution: NDArray[np.float64]
    translation_before: NDArray[np.float64]
    vibration_before: NDArray[np.float64]
    dissipated_before: NDArray[np.float64]
    unresolved_before: NDArray[np.float64]
    translation: NDArray[np.float64]
    vibration: NDArray[np.float64]
    dissipated: NDArray[np.float64]
    unresolved: NDArray[np.float64]
    energy_error: NDArray[np.float64]
    contact_time: NDArray[np.float64]
    flight_time: NDArray[np.float64]
    short_flight: NDArray[np.bool_]
    beyond_small_strain: NDArray[np.bool_]

    @property
    def flight_time_si(self) -> Number:
        """Time of the flight after each impact, s."""
        return self._in_si("flight_time")

    def __repr__(self) -> str:
        who = shown(self.body) + (f" against {shown(self.against)}" if isinstance(self.against, PARTNERS) else "")
        if len(self) == 0:
            return f"Bounces(no impacts, {who})"
        return (
            f"Bounces({len(self)} impacts, {who}, speed={self.speed[0]:.6g} c: "
            f"restitution {span(self.restitution)}, translation {self.translation[-1]:.4g} in the end)"
        )

    def plot(self, ax: Any = None) -> Any:
        """ε of each impact, and where the energy is. See `stoss.plot.bounces`."""
        return self._picture(ax)

    def _inputs(self) -> dict[str, Any]:
        named: dict[str, Any] = {"body": self.body, "against": self.against, "cutoff": self.cutoff, "tail": self.tail}
        named |= {"gravity": self.gravity, "decay_time": self.decay_time}
        if self.state is not None:
            named["state"] = shown_state(self.state)
        return {key: value for key, value in named.items() if value is not None}
