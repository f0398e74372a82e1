"""When a sphere begins to yield."""

from __future__ import annotations

import math
from typing import Any, Union

from stoss import _core
from stoss._arguments import instance, refusal
from stoss._bodies import is_rigid
from stoss._contact import choose_against
from stoss._half_space import HalfSpace
from stoss._sphere import Sphere
from stoss._walls import HardWall

Solid = tuple[float, float, float, Union[float, None], float]


def yield_speed(body: Sphere, *, against: HardWall | Sphere | HalfSpace | str | None = None) -> float | None:
    """Speed of approach at which a sphere, or what it meets, begins to yield.

    There the greatest pressure of Hertz' quasi-static impact is 1.6 times the least yield strength.
    Above it ε of an elastic impact is an upper bound.

    Parameters
    ----------
    body : Sphere
        With a material.
    against : HardWall, 'same', Sphere or HalfSpace, optional
        What it meets: a rigid wall (default), its like, another sphere, or a half-space.

    Returns
    -------
    float or None
        m/s; None if no `yield_strength` is known. What has none is taken not to yield.

    Raises
    ------
    InvalidInput
        For bodies without a material.

    Notes
    -----
    v² = (16/15) (E* R³/m) (πp₀/2E*)⁵ with p₀ = 1.6 Y and 1/E* = Σ(1 − ν²)/E (K. L. Johnson, Contact
    Mechanics, section 11.5).

    Examples
    --------
    >>> hard = stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=1e9)
    >>> ball = stoss.Sphere(radius=5e-3, material=hard)
    >>> round(stoss.quasistatic.yield_speed(ball, against=stoss.HalfSpace(material=hard)), 2)
    0.14
    """
    ball: Sphere = instance("body", body, (Sphere,))
    met = choose_against(ball, against, (HardWall,))
    if ball.material is None:
        raise refusal("body", ball, "a sphere with a material (its speed is in m/s)")
    return _core.yield_speed(_solid(ball), None if isinstance(met, HardWall) else _solid(met))


def _solid(body: Any) -> Solid:
    material = body.material
    young = math.inf if is_rigid(body) else material.young
    return young, material.poisson, material.density, material.yield_strength, getattr(body, "radius", math.inf)
