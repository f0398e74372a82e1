"""ε(v) as a function, of values that are computed for it or of a curve."""

from __future__ import annotations

import dataclasses
import functools
import os
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import boolean, choice, integer, number, numbers, refusal
from stoss._documentation import documented
from stoss.bodies._bodies import Body, shown
from stoss.bodies._encounter import Against, choose_against, choose_body, encounter, refinable
from stoss.bodies._solid import own_units
from stoss.bodies._walls import Unbounded, Wall
from stoss.export._files import write_lines
from stoss.export._tables import brief_range
from stoss.results._progress import waiting
from stoss.results._result import Column, picture
from stoss.results._si import Coded, told_in_c, warn_at

BEYOND = ("error", "clamp", "law")


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class RestitutionFunction(Coded):
    """ε as a function of the speed: call it with speeds, get values.

    Between computed values it is a cubic in ln v that rises and falls only as they do. Speeds are
    those of approach, in c or, of a body with a material, in m/s; their sign does not count. Made
    by `restitution_function`, or by `Restitution.function`; ``len()`` is the number of computed
    values.

    Attributes:
        speed: Speeds of the computed values, rising, c.
        interpolation_error: Error of the interpolation from each computed value to the next; one
            element less.

    Examples:
        >>> epsilon = stoss.restitution_function(stoss.Sphere(poisson=0.3), speed=(0.001, 0.3))
        >>> round(epsilon(0.1), 3), epsilon.error(0.1) < 1e-3, epsilon.range
        (0.991, True, (0.001, 0.3))
    """

    plot = picture("The curve with its error, and the computed values. See `stoss.plot.function`.")
    _name: ClassVar[str] = "function"
    _given = {"speed": "speed"}
    _axis: ClassVar[str] = "speed"
    _told = ("body", "against", "beyond", "state")

    body: Body
    against: Against
    beyond: str
    state: NDArray[Any] | None
    speed: NDArray[np.float64]
    restitution: NDArray[np.float64]
    restitution_error: NDArray[np.float64]
    interpolation_error: NDArray[np.float64]

    def __call__(self, speed: ArrayLike) -> Any:
        """ε: a float for a number, otherwise an array of the shape of `speed`."""
        return self._of(speed, self._core.values)

    def error(self, speed: ArrayLike) -> Any:
        """Error of ε, interpolation included; infinite where it is unknown."""
        return self._of(speed, self._core.errors)

    def __len__(self) -> int:
        return len(self.speed)

    def __repr__(self) -> str:
        unit, beyond = self._given_unit[0], "" if self.beyond == "error" else f", beyond={self.beyond!r}"
        return (
            f"RestitutionFunction({shown(self.body, self.against)}, speed={brief_range(*self.range)} {unit}{beyond}: "
            f"{len(self)} speeds computed, error below {self.greatest_error:.2g})"
        )

    @property
    def range(self) -> tuple[float, float]:
        """Slowest and fastest speed, in the unit in which it is called."""
        return float(self._given_speed[0]), float(self._given_speed[-1])

    @property
    def knots(self) -> NDArray[Any]:
        """The computed values: a structured array of speed (in the unit of the call), restitution and error."""
        names = ["speed", "restitution", "error"]
        table = np.zeros(len(self), dtype=[(name, np.float64) for name in names])
        table["speed"] = self._given_speed
        table["restitution"], table["error"] = self.restitution, self.restitution_error
        table.flags.writeable = False
        return table

    @property
    def greatest_error(self) -> float:
        """Error of ε at any speed of the range."""
        return self._core.greatest_error()

    @documented
    def to_c(self, path: str | os.PathLike[str], *, name: str = "stoss") -> None:
        """Write the function as a header in C, which C++ takes too.

        It defines ``static double stoss_restitution(double speed)`` and
        ``stoss_restitution_error``, in C89 and with <math.h> only, and the ends of the range,
        STOSS_SLOWEST and STOSS_FASTEST. Speeds are in the unit in which the function is called.
        Beyond the range the error is HUGE_VAL, and ε that at the nearer end (``beyond="clamp"``) or
        not a number (``"error"``). The file appears whole or not at all.

        Parameters:
            name: Prefix of the names in C.

        Examples:
            >>> stoss.restitution_function(poisson=0.33, speed=(1e-3, 0.3), beyond="clamp").to_c("restitution.h")
        """
        self._write_code("c_header", path, name)

    @documented
    def to_two_column(self, path: str | os.PathLike[str], *, error: float | None = None) -> None:
        """Write the function as lines of two numbers, speed and ε, for linear interpolation in the speed.

        There are as many lines as this takes for `error`, and there is no head. Speeds are in the
        unit in which the function is called. The file appears whole or not at all.

        Parameters:
            error: Maximum error of ε, linear interpolation included, 1.01 of `greatest_error` or
                more; by default twice that.

        Examples:
            >>> stoss.restitution_function(poisson=0.33, speed=(1e-3, 0.3)).to_two_column("disk.txt", error=2e-3)
        """
        limit = 2.0 * self.greatest_error if error is None else number("error", error)
        write_lines(path, [self._core.two_column(limit, self._given_unit[1])])

    @functools.cached_property
    def _core(self) -> _core.RestitutionFunction:
        law = slow_law(self.body, self.against) if self.beyond == "law" else _core.no_law()
        return _core.make_function(
            self.speed, self.restitution, self.restitution_error, self.interpolation_error, self.beyond, law
        )

    def _of(self, speed: ArrayLike, function: Any) -> Any:
        values = self._at(function, speed)
        return values if values.ndim else float(values)

    def _table(self) -> dict[str, Column]:
        names = ("speed", "restitution", "restitution_error")
        padded = np.append(self.interpolation_error, 0.0)  # of the interval that begins there
        return {name: getattr(self, name) for name in names} | {"interpolation_error": padded}


def slow_law(body: Body, against: Against) -> _core.SlowLaw:
    """The law of slow impacts of these bodies."""
    return encounter(body, against).slow_law()


def choose_beyond(beyond: Any, body: Body, against: Against, state: NDArray[Any] | None) -> str:
    """What a function is to do beyond its range; a law is refused before anything is computed."""
    chosen = choice("beyond", beyond, BEYOND)
    if chosen == "law":
        slow_law(body, against)
        if state is not None and state.size:
            choice("beyond", beyond, BEYOND[:2])  # the laws are those of unexcited bodies
    return chosen


@documented
def restitution_function(
    body: Body | None = None,
    *,
    speed: ArrayLike,
    against: Wall | Body | Unbounded | str | None = None,
    poisson: float | None = None,
    error: float = 1e-3,
    beyond: str = "error",
    threads: int = 0,
    progress: bool = False,
) -> RestitutionFunction:
    """Compute ε as a function of the speed, with an error that is kept at every speed of a range.

    It begins with six speeds per decade, and halves every interval until the value computed in its
    middle is the interpolated one within a quarter of the error. Most functions take 40 to 100
    values; one that needs more than 2000 has not converged.

    Parameters:
        speed (tuple of two float): Slowest and fastest speed of approach, 1e-8 to 1, c (with a
            material: m/s).
        beyond ({'error', 'clamp', 'law'}, optional): Beyond the range, refuse, or
            give the value at the nearer end with an infinite error, or follow the law of slow
            impacts with its error below the range, and refuse above. There is a law for disks and
            spheres at a wall or in equal pairs, and for elastic spheres on elastic half-spaces.

    Examples:
        >>> epsilon = stoss.restitution_function(poisson=0.33, speed=(1e-3, 0.3), beyond="law")
        >>> epsilon
        RestitutionFunction(Disk(poisson=0.33), speed=0.001 to 0.3 c, beyond='law': ... speeds computed, error below ...)
        >>> round(epsilon(0.1), 3), epsilon.error(0.1) < 1e-3, epsilon([0.01, -0.1]).round(2)
        (0.947, True, array([0.98, 0.95]))
        >>> steel = stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"])
        >>> block = stoss.HalfSpace(material=steel.material)
        >>> drop = stoss.restitution_function(steel, against=block, speed=(0.01, 0.5))  # m/s
        >>> direct = stoss.restitution(steel, against=block, speed=0.2)
        >>> bool(abs(drop(0.2) - direct.restitution) < 1e-3)
        True
    """
    chosen = choose_body(body, poisson, rigid=True)
    met = choose_against(chosen, against)
    ends = numbers("speed", speed)
    if ends.shape != (2,):
        raise refusal("speed", speed, "two numbers, the slowest and the fastest")
    slowest, fastest = own_units(chosen, "table", speed=ends)[0].tolist()
    outside = choose_beyond(beyond, chosen, met, None)
    limit, count = number("error", error), integer("threads", threads)
    with waiting(boolean("progress", progress), "restitution_function"):
        made = _core.adaptive_function(refinable(chosen, met), slowest, fastest, limit, count)
    function = function_of(chosen, met, outside, None, *made.knots(), made.interpolation_errors())
    warn_at(chosen, met, function.speed, 2)
    return function


def function_of(*given: Any) -> RestitutionFunction:
    """A function of these fields. The core has checked its knots and found the error between them."""
    made = RestitutionFunction(*given)
    for each in (made.speed, made.restitution, made.restitution_error):
        each.flags.writeable = False
    with told_in_c(made.body):
        return dataclasses.replace(made, interpolation_error=made._core.interpolation_errors())
