"""An impact again, bit by bit: in time, inside the bodies and below a surface. Methods of `Impact`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, integer, number, numbers, refusal, require_memory
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._bodies import BODIES, Disk, Sphere
from stoss.bodies._encounter import encounter
from stoss.bodies._solid import is_rigid
from stoss.bodies._state import choose_state
from stoss.bodies._walls import UNBOUNDED, lower_face
from stoss.results._computed_impact import ComputedImpact
from stoss.results._field import DiskField, Field, SphereField, Trajectory, Wave
from stoss.results._result import columns


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


def trajectory(self: ComputedImpact, *, every: int = 1) -> Trajectory:
    """The impact in time, by repeating it bit by bit.

    Parameters:
        every (int): Steps between two rows.

    Examples:
        >>> path = stoss.impact(poisson=0.33, speed=0.1, cutoff=25).trajectory()
        >>> energy = path.translation + path.vibration + path.unresolved
        >>> bool(abs(energy - 1).max() < 2e-3)
        True
    """
    rows = integer("every", every)
    if rows < 1:
        raise InvalidInput.out_of_range("every", rows, "1 or more", "steps between two rows")
    size = 80.0 * (self.steps // rows + 2)
    require_memory("every", f"{rows} for {self.steps} steps", size, "give a larger one")
    return Trajectory(impact=self, **columns(self._handle.trajectory(self._contact(), rows)))


@documented
def energies_at(self: ComputedImpact, *, time: ArrayLike) -> NDArray[Any]:
    """Energy of each kept mode at some times, by repeating the impact bit by bit; before and after it they stay.

    Returns:
        ndarray: Times × modes, without the first axis if `time` is one number: a structured array
            with the fields body, order, index, omega and energy, as a share of the initial one, in
            the order of `mode_energies`.

    Examples:
        >>> hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=25)
        >>> energies = hit.energies_at(time=[0, hit.contact_time / 2])
        >>> energies["energy"].sum(axis=1).round(2)
        array([0.  , 0.96])
    """
    times = numbers("time", time)
    require_replay(self, "energies", times.size, 3.0 * self.modes, 0.0, f" x {self.modes} modes")
    rising = Rising(times)
    return rising.placed(_core.energies_at(self._contact(), self._handle, rising.times))  # type: ignore[no-any-return]


def state_after(self: ComputedImpact, *, flight: float) -> NDArray[Any]:
    """How the bodies vibrate when they meet again at the speed of their parting, `restitution` × `speed`.

    Parameters:
        flight (float): Time between the two impacts, R/c: from where the bodies would part if they
            were unexcited to where they would touch.

    Returns:
        ndarray: The `state` of the next `impact`: a structured array with the fields body, order,
            index, energy (as a share of the translational one before that impact) and phase,
            radians. Bodies with a loss time vibrate less by then, and the waves of a half-space
            have run away.

    Examples:
        >>> hit = stoss.impact(stoss.Sphere(poisson=0.3), speed=0.1, cutoff=25)
        >>> state = hit.state_after(flight=20)
        >>> bool(abs(state["energy"].sum() - hit.vibration / hit.translation) < 1e-12)
        True
    """
    return self._handle.vibration_after(self._contact(), number("flight", flight))


def require_replay(impact: ComputedImpact, name: str, times: int, each: float, once: float, got: str) -> None:
    """Refuse what is too large: numbers for each time in addition to its motion, and numbers once."""
    size = 8.0 * (times * (each + 2.0 * impact.modes + impact.nodes) + once)
    require_memory(name, f"{times} times{got}", size, "give fewer times or points")


@documented
def field(
    self: ComputedImpact, *, time: ArrayLike, radius: ArrayLike | None = None, angle: ArrayLike | None = None, of: int = 0
) -> Field:
    """A deformed disk or sphere and the stress inside it at some times.

    The kept modes are as they move, freely before and after the impact; all others are in static
    equilibrium with the force of contact. Arrays, of 2 GB at most, are times × radii × angles,
    without the first axis if `time` is one number.

    Parameters:
        radius: Radii r, 0 to 1, in radii of the body; default 41 of them.
        angle: Angles φ, radians, 0 towards the contact, where the default 181 are denser. In a
            sphere polar angles θ on a plane through the axis; negative ones are its other half.

    Examples:
        >>> hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=25)
        >>> field = hit.field(time=hit.contact_time / 2)
        >>> bool(field.x.max() < 1e-3)  # nothing is beyond the wall
        True
    """
    if not isinstance(self.body, (Disk, Sphere)):
        hint = "a stoss.Disk or a stoss.Sphere (a rod has no field)"
        raise InvalidInput.out_of_range("body", repr(self.body), hint)
    number, pair = integer("of", of), isinstance(self.against, BODIES)
    if number not in ((0, 1) if pair else (0,)):
        other = getattr(self.against, "_kind", "wall")
        hint = "0 or 1" if pair else f"0 (a {other} has no field)"
        raise InvalidInput.out_of_range("of", number, hint)
    inside = self.body if number == 0 else self.against
    assert isinstance(inside, (Disk, Sphere))
    if is_rigid(inside):
        raise InvalidInput.out_of_range("body", repr(inside), "an elastic one", "a rigid one has no field")
    times = numbers("time", time)
    radii = np.linspace(0.0, 1.0, 41) if radius is None else numbers("radius", radius).ravel()
    angles = _around() if angle is None else numbers("angle", angle).ravel()
    points = radii.size * angles.size
    each = (11.0 if isinstance(inside, Disk) else 12.0) * points
    require_replay(self, "field", times.size, each, 5.0 * radii.size * self.modes, f" x {points} points")
    rising, made = Rising(times), self._contact()
    frames = _core.motion(made, self._handle, rising.times)
    meeting, now = encounter(self.body, self.against), frames.summaries()
    values = _core.fields(meeting, number, made, self._handle, frames, radii, angles)
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
    return made_of(impact=self, of=number, size=float(size), radius=radii, angle=angles, **placed)


def wave(
    self: ComputedImpact,
    *,
    time: ArrayLike | None = None,
    distance: ArrayLike | None = None,
    depth: ArrayLike | None = None,
) -> Wave:
    """How the half-space or the plate that is met moves below its surface at some times.

    The impact is repeated with one that is good for as long as the waves need to reach
    the farthest point, which has many more of them. A cutoff of 80 over the contact time in R/c
    is enough. It takes some seconds at 0.1 c, and 40 s at 2e-4 c; more than 2·10⁶ waves are refused.
    Arrays, of 2 GB at most, are times × depths × distances, without the first axis if `time` is one
    number.

    Parameters:
        time (array_like, optional): R/c from the start of the impact, any order; during the impact
            the nearest step is taken, after it the waves run freely. Default: 0.4, 0.8, 1.2 and 1.6
            contact times.
        distance, depth (array_like, optional): Distances from the axis and depths below the
            surface, R; default 121 of them, as far as the pressure wave comes, or 31 depths down to
            the lower face of a plate.

    Examples:
        >>> hit = stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.1, cutoff=4)
        >>> wave = hit.wave(time=5, distance=np.linspace(0, 8, 17), depth=np.linspace(0, 8, 17))
        >>> bool(abs(wave.normal[16]).max() < 0.01 * wave.normal.max())  # the waves are not there yet
        True
    """
    if not isinstance(self.against, UNBOUNDED):
        raise InvalidInput.out_of_range("against", repr(self.against), "a stoss.HalfSpace, HalfPlane, Plate or Strip")
    chosen = self.contact_time * np.array([0.4, 0.8, 1.2, 1.6]) if time is None else time
    times = numbers("time", chosen)
    if not np.all(np.abs(times) <= 1e4):
        raise refusal("time", time, "-1e4 to 1e4 (R/c, from the start of the impact)")
    speeds = encounter(self.body, self.against).wave_speeds()
    reach = np.linspace(0.0, speeds[0] * max(times.max(initial=0.0), self.contact_time), 121)
    across = reach if distance is None else numbers("distance", distance).ravel()
    face = lower_face(self.against, self.body)
    usual = reach.copy() if face > reach[-1] else np.linspace(0.0, face, 31)
    below = usual if depth is None else numbers("depth", depth).ravel()
    if below.size and face < np.inf and below.max() > face:
        raise refusal("depth", depth, f"0 to {face:.6g} (R, the thickness of the {self.against._kind})")
    for name, places in (("distance", across), ("depth", below)):
        if not (places.size and np.all((places >= 0.0) & (places <= 1e6))):
            raise refusal(name, places, "one or more, each 0 to 1e6 (R)")
    points = across.size * below.size
    size = 8.0 * times.size * (8.0 * points + 6.0 * self.modes)
    require_memory("wave", f"{times.size} times x {points} points", size, "give fewer times or points")
    rising, state = Rising(times), choose_state(self.state)
    made = _core.waves(encounter(self.body, self.against), self._handle, state, rising.times, across, below)
    for array in (across, below):
        array.flags.writeable = False
    fronts: dict[str, Any] = dict(zip(("pressure_speed", "shear_speed", "rayleigh_speed"), speeds))
    placed = {name: rising.placed(value) for name, value in made.items()}
    return Wave(impact=self, distance=across, depth=below, **placed, **fronts)


def _around() -> NDArray[np.float64]:
    """Angles around the body, three times as dense at the contact as opposite to it."""
    even = np.linspace(-np.pi, np.pi, 181)
    return np.asarray(even - 0.5 * np.sin(even))
