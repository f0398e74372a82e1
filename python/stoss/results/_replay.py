"""An impact again, bit by bit, to look at it in time: methods of `Impact`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, integer, number, numbers, require_memory
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.results._field import Trajectory
from stoss.results._result import columns

if TYPE_CHECKING:
    from stoss.results._impact import Impact


class Rising:
    """Times in rising order, in which the core takes them."""

    def __init__(self, given: NDArray[np.float64]) -> None:
        order = np.argsort(given.ravel(), kind="stable")
        self.times = given.ravel()[order]
        self._shape = given.shape
        self._back = None if np.all(order == np.arange(order.size)) else np.argsort(order, kind="stable")

    def placed(self, values: NDArray[Any]) -> Any:
        """Values at these times, in the order and the shape in which the times were given."""
        array = values if self._back is None else values[self._back]
        return arranged(array, self._shape + array.shape[1:])


def trajectory(self: Impact, *, every: int = 1) -> Trajectory:
    """The impact in time, by repeating it bit by bit.

    Parameters
    ----------
    every : int
        Steps between two rows.

    Examples
    --------
    >>> path = stoss.impact(poisson=0.33, speed=0.1, cutoff=25).trajectory()
    >>> energy = path.translation + path.vibration + path.unresolved
    >>> bool(abs(energy - 1).max() < 2e-3)
    True
    """
    rows = integer("every", every)
    if rows < 1:
        raise InvalidInput(f"every: got {rows}, allowed 1 or more (steps between two rows)")
    size = 72.0 * (self.steps // rows + 2)
    require_memory("every", f"{rows} for {self.steps} steps", size, "give a larger one")
    return Trajectory(impact=self, **columns(self._handle.trajectory(self._contact(), rows)))


@documented
def energies_at(self: Impact, *, time: ArrayLike) -> NDArray[Any]:
    """Energy of each kept mode at some times, by repeating the impact bit by bit; before and after it they stay.

    Returns
    -------
    ndarray
        Times × modes, without the first axis if `time` is one number: a structured array with
        the fields body, order, index, omega and energy, as a share of the initial one, in the
        order of `mode_energies`.

    Examples
    --------
    >>> hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=25)
    >>> energies = hit.energies_at(time=[0, hit.contact_time / 2])
    >>> energies["energy"].sum(axis=1).round(2)
    array([0.  , 0.96])
    """
    times = numbers("time", time)
    require_replay(self, "energies", times.size, 3.0 * self.modes, 0.0, f" x {self.modes} modes")
    rising = Rising(times)
    return rising.placed(_core.energies_at(self._contact(), self._handle, rising.times))  # type: ignore[no-any-return]


def state_after(self: Impact, *, flight: float) -> NDArray[Any]:
    """How the bodies vibrate when they meet again at the speed of their parting, `restitution` × `speed`.

    Parameters
    ----------
    flight : float
        Time between the two impacts, R/c: from where the bodies would part if they were unexcited
        to where they would touch.

    Returns
    -------
    ndarray
        The `state` of the next `impact`: a structured array with the fields body, order, index,
        energy (as a share of the translational one before that impact) and phase, radians.
        Bodies with a loss time vibrate less by then, and the waves of a half-space have run
        away.

    Examples
    --------
    >>> hit = stoss.impact(stoss.Sphere(poisson=0.3), speed=0.1, cutoff=25)
    >>> state = hit.state_after(flight=20)
    >>> bool(abs(state["energy"].sum() - hit.vibration / hit.translation) < 1e-12)
    True
    """
    return self._handle.vibration_after(self._contact(), number("flight", flight))


def surface(impact: Impact, time: Any, reach: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Where the surface of a half-space is at some times: places y, −reach to reach, and times × places x, in R.

    It is moved by the kept modes alone.
    """
    rising, made = Rising(numbers("time", time).ravel()), impact._contact()
    frames = _core.motion(made, impact._handle, rising.times)
    lateral, place = _core.surfaces(made, impact._handle, frames, reach, 256)
    x = rising.placed(place)
    return np.concatenate((-lateral[::-1], lateral)), np.concatenate((x[:, ::-1], x), axis=1)


def require_replay(impact: Impact, name: str, times: int, each: float, once: float, got: str) -> None:
    """Refuse what is too large: numbers for each time, besides its motion, and numbers once."""
    size = 8.0 * (times * (each + 2.0 * impact.modes + impact.nodes) + once)
    require_memory(name, f"{times} times{got}", size, "give fewer times or points")
