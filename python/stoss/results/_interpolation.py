"""Makes ε(v) a function."""

from __future__ import annotations

import dataclasses
import warnings
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from stoss import _core
from stoss._arguments import integer, number, numbers, refusal
from stoss._documentation import documented
from stoss._errors import InvalidInput, StossWarning
from stoss.bodies._bodies import Body, speed_unit, speeds_in_si
from stoss.bodies._encounter import choose_against, choose_body, refinable, yield_speed_of
from stoss.bodies._walls import HardWall, Unbounded
from stoss.results._function import RestitutionFunction, choose_beyond


@documented
def restitution_function(
    body: Body | None = None,
    *,
    speed: ArrayLike,
    against: HardWall | Body | Unbounded | str | None = None,
    poisson: float | None = None,
    error: float = 1e-3,
    beyond: str = "error",
    threads: int = 0,
) -> RestitutionFunction:
    """Compute ε as a function of the speed, with an error that is kept at every speed of a range.

    It begins with six speeds per decade, and halves every interval until the value computed in its
    middle is the interpolated one within a quarter of the error. Most functions take 40 to 100
    values; one that needs more than 2000 has not converged.

    Parameters
    ----------
    speed : tuple of two float
        Slowest and fastest speed of approach, 1e-8 to 1, c (with a material: m/s).
    beyond : {'error', 'clamp', 'law'}, optional
        What the function does beyond the range: refuse; give the value at the nearer end, with an
        infinite error; below it, follow the law of slow impacts with its error, and refuse above.
        There is a law for disks and spheres at a wall or in equal pairs, and for elastic spheres on
        elastic half-spaces.

    Examples
    --------
    >>> epsilon = stoss.restitution_function(poisson=0.33, speed=(1e-3, 0.3), beyond="law")
    >>> epsilon
    RestitutionFunction(Disk(poisson=0.33), speed=0.001 to 0.3 c, beyond='law': ... speeds computed, error below ...)
    >>> round(epsilon(0.1), 3), epsilon.error(0.1) < 1e-3, epsilon([0.01, -0.1]).round(2)
    (0.947, True, array([0.98, 0.95]))
    >>> steel = stoss.Sphere(radius=5e-3, material=stoss.materials["steel"])
    >>> block = stoss.HalfSpace(material=steel.material)
    >>> drop = stoss.restitution_function(steel, against=block, speed=(0.01, 0.5))  # m/s
    >>> direct = stoss.restitution(steel, against=block, speed=0.2)
    >>> bool(abs(drop(0.2) - direct.restitution) < 1e-3)
    True
    """
    chosen = choose_body(body, poisson, rigid=True)
    met = choose_against(chosen, against, (HardWall,))
    ends = numbers("speed", speed)
    if ends.shape != (2,):
        raise refusal("speed", speed, "two numbers, the slowest and the fastest")
    slowest, fastest = (float(each) for each in ends / speed_unit(chosen))
    outside = choose_beyond(beyond, chosen, met, None)
    limit, count = number("error", error), integer("threads", threads)
    with speeds_in_si(chosen):
        made = _core.adaptive_function(refinable(chosen, met), slowest, fastest, limit, count)
    function = _made(chosen, met, outside, None, *made.knots(), made.interpolation_errors())
    _warn_of_yielding(function)
    return function


def of_curve(curve: Any, beyond: str) -> RestitutionFunction:
    """Restitution.function."""
    body, against = curve.body, curve.against
    if body is None and np.unique(curve.poisson).size == 1 and len(curve.bodies) == 1:
        body = curve.bodies[0]
    if body is None or isinstance(against, str):
        raise InvalidInput(f"function: got {len(curve.bodies)} bodies, allowed one (take a part of the result, [0])")
    speed = np.ravel(curve.speed)
    doubtful = int(np.size(curve.converged) - np.count_nonzero(curve.converged))
    if doubtful:
        hint = "allowed those that have (see .converged, .reason; or take a part, curve[curve.converged])"
        raise InvalidInput(f"function: got {doubtful} of {speed.size} values that have not converged, {hint}")
    order = np.argsort(speed, kind="stable")
    value, error = np.ravel(curve.restitution)[order], np.ravel(curve.restitution_error)[order]
    outside = choose_beyond(beyond, body, against, curve.state)
    return _made(body, against, outside, curve.state, speed[order], value, error, np.empty(0))


def _made(*given: Any) -> RestitutionFunction:
    """A function of these fields, of which the core has checked the knots and found the error between them."""
    made = RestitutionFunction(*given)
    for each in (made.speed, made.restitution, made.restitution_error):
        each.flags.writeable = False
    with speeds_in_si(made.body):
        return dataclasses.replace(made, interpolation_error=made._core.interpolation_errors())


def _warn_of_yielding(function: RestitutionFunction) -> None:
    found = yield_speed_of(function.body, function.against)
    if found is not None and function.range[1] > found:
        text = f"speed above {found:.4g} m/s, where yielding begins (elastic values are bounds there)"
        warnings.warn(text, StossWarning, stacklevel=3)
