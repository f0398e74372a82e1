"""An impact again, bit by bit, to look at it in time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import arranged, integer, numbers, refusal, require_memory
from stoss._errors import InvalidInput
from stoss.bodies._blocks import UNBOUNDED
from stoss.bodies._bodies import BODIES, Disk, Sphere
from stoss.bodies._encounter import encounter
from stoss.bodies._solid import is_rigid
from stoss.bodies._state import choose_state
from stoss.results._field import DiskField, Field, SphereField
from stoss.results._motion import Trajectory, Wave
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


def trajectory(impact: Impact, every: Any) -> Trajectory:
    """See `Impact.trajectory`."""
    rows = integer("every", every)
    if rows < 1:
        raise InvalidInput(f"every: got {rows}, allowed 1 or more (steps between two rows)")
    size = 72.0 * (impact.steps // rows + 2)
    require_memory("every", f"{rows} for {impact.steps} steps", size, "give a larger one")
    return Trajectory(impact=impact, **columns(impact._handle.trajectory(impact._contact(), rows)))


def field(impact: Impact, time: Any, radius: Any, angle: Any, of: Any) -> Field:
    """See `Impact.field`."""
    if not isinstance(impact.body, (Disk, Sphere)):
        hint = "a stoss.Disk or a stoss.Sphere (a rod has no field)"
        raise InvalidInput(f"body: got {impact.body!r}, allowed {hint}")
    number, pair = integer("of", of), isinstance(impact.against, BODIES)
    if number not in ((0, 1) if pair else (0,)):
        other = "half-space" if isinstance(impact.against, UNBOUNDED) else "wall"
        hint = "0 or 1" if pair else f"0 (a {other} has no field)"
        raise InvalidInput(f"of: got {number}, allowed {hint}")
    inside = impact.body if number == 0 else impact.against
    assert isinstance(inside, (Disk, Sphere))
    if is_rigid(inside):
        raise InvalidInput(f"body: got {inside!r}, allowed an elastic one (a rigid one has no field)")
    times = numbers("time", time)
    radii = np.linspace(0.0, 1.0, 41) if radius is None else numbers("radius", radius).ravel()
    angles = _around() if angle is None else numbers("angle", angle).ravel()
    points = radii.size * angles.size
    each = (11.0 if isinstance(inside, Disk) else 12.0) * points
    _require_memory(impact, "field", times.size, each, 5.0 * radii.size * impact.modes, f" x {points} points")
    rising, made = Rising(times), impact._contact()
    frames = _core.motion(made, impact._handle, rising.times)
    meeting, now = encounter(impact.body, impact.against), frames.summaries()
    values = _core.fields(meeting, number, made, impact._handle, frames, radii, angles)
    center, size, outwards, around = (values.pop(name) for name in ("center", "size", "radial", "tangential"))
    reach = size * radii[:, None] + outwards
    out = reach * np.cos(angles)
    out -= around * np.sin(angles)
    up = reach * np.sin(angles)
    up += around * np.cos(angles)
    if number == 1:  # the second body looks the other way
        out *= -1.0
    values |= {"center": center, "x": out + center[:, None, None], "y": up}
    values |= {name: now[name] for name in ("time", "force", "contact_half_width")}
    for array in (radii, angles):
        array.flags.writeable = False
    made_of: type[Field] = DiskField if isinstance(inside, Disk) else SphereField
    placed = {name: rising.placed(each) for name, each in values.items()}
    return made_of(impact=impact, of=number, size=float(size), radius=radii, angle=angles, **placed)


def wave(impact: Impact, time: Any, distance: Any, depth: Any) -> Wave:
    """See `Impact.wave`."""
    if not isinstance(impact.against, UNBOUNDED):
        raise InvalidInput(f"against: got {impact.against!r}, allowed a stoss.HalfSpace or a stoss.HalfPlane")
    chosen = impact.contact_time * np.array([0.4, 0.8, 1.2, 1.6]) if time is None else time
    times = numbers("time", chosen)
    if not np.all(np.abs(times) <= 1e4):
        raise refusal("time", time, "-1e4 to 1e4 (R/c, from the start of the impact)")
    speeds = encounter(impact.body, impact.against).wave_speeds()
    reach = np.linspace(0.0, speeds[0] * max(times.max(initial=0.0), impact.contact_time), 121)
    across = reach if distance is None else numbers("distance", distance).ravel()
    below = reach.copy() if depth is None else numbers("depth", depth).ravel()
    for name, places in (("distance", across), ("depth", below)):
        if not (places.size and np.all((places >= 0.0) & (places <= 1e6))):
            raise refusal(name, places, "one or more, each 0 to 1e6 (R)")
    points = across.size * below.size
    size = 8.0 * times.size * (8.0 * points + 6.0 * impact.modes)
    require_memory("wave", f"{times.size} times x {points} points", size, "give fewer times or points")
    rising, state = Rising(times), choose_state(impact.state)
    made = _core.waves(encounter(impact.body, impact.against), impact._handle, state, rising.times, across, below)
    for array in (across, below):
        array.flags.writeable = False
    fronts: dict[str, Any] = dict(zip(("pressure_speed", "shear_speed", "rayleigh_speed"), speeds))
    placed = {name: rising.placed(value) for name, value in made.items()}
    return Wave(impact=impact, distance=across, depth=below, **placed, **fronts)


def surface(impact: Impact, time: Any, reach: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Where the surface of a half-space is at some times: places y, −reach to reach, and times ×
    places x, in R.

    It is moved by the kept modes alone.
    """
    rising, made = Rising(numbers("time", time).ravel()), impact._contact()
    frames = _core.motion(made, impact._handle, rising.times)
    lateral, place = _core.surfaces(made, impact._handle, frames, reach, 256)
    x = rising.placed(place)
    return np.concatenate((-lateral[::-1], lateral)), np.concatenate((x[:, ::-1], x), axis=1)


def energies_at(impact: Impact, time: Any) -> NDArray[Any]:
    """See `Impact.energies_at`."""
    times = numbers("time", time)
    _require_memory(impact, "energies", times.size, 3.0 * impact.modes, 0.0, f" x {impact.modes} modes")
    rising = Rising(times)
    energies: NDArray[Any] = rising.placed(_core.energies_at(impact._contact(), impact._handle, rising.times))
    return energies


def state_after(impact: Impact, flight: float) -> NDArray[Any]:
    """See `Impact.state_after`."""
    return impact._handle.vibration_after(impact._contact(), flight)


def _require_memory(impact: Impact, name: str, times: int, each: float, once: float, got: str) -> None:
    """Refuse what is too large: numbers for each time, besides its motion, and numbers once."""
    size = 8.0 * (times * (each + 2.0 * impact.modes + impact.nodes) + once)
    require_memory(name, f"{times} times{got}", size, "give fewer times or points")


def _around() -> NDArray[np.float64]:
    """Angles around the body, three times as dense at the contact as opposite to it."""
    even = np.linspace(-np.pi, np.pi, 181)
    return np.asarray(even - 0.5 * np.sin(even))
