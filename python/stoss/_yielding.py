"""The speed at which a sphere, or the body that it meets, begins to yield."""

from __future__ import annotations

import math
from typing import Any

from stoss import _core
from stoss._arguments import instance, refusal
from stoss._bodies import is_rigid
from stoss._half_space import HalfSpace
from stoss._sphere import Sphere

InSi = tuple[float, float, float, "float | None", float]


def yield_speed(body: Sphere, *, against: Sphere | HalfSpace | str | None = None) -> float | None:
    """Speed of approach at which a sphere at a rigid wall, or the weaker of two bodies, begins to yield, m/s.

    The maximum pressure p₀ of Hertz' contact is then 1.6 times the yield strength Y of the
    material: v² = (16/15)(E*R³/m)(πp₀/2E*)⁵ (K. L. Johnson, Contact Mechanics, eqs. 11.31 to
    11.35). At a wall it does not depend on the radius; an equal sphere takes twice that speed.

    Parameters
    ----------
    body : Sphere
        With a material.
    against : 'same', Sphere or HalfSpace, optional
        An equal sphere, another one, or a half-space with a material; a rigid wall if it is left out.

    Returns
    -------
    float or None
        None where no material has a yield strength; one that has none is taken not to yield.

    Raises
    ------
    InvalidInput
        For a body without a material, and where none deforms.

    Examples
    --------
    >>> hard = stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=1e9)
    >>> round(stoss.quasistatic.yield_speed(stoss.Sphere(radius=0.01, material=hard)), 4)
    0.0339
    >>> ball, block = stoss.Sphere(radius=0.01, material=hard), stoss.HalfSpace(material=hard)
    >>> round(stoss.quasistatic.yield_speed(ball, against=block), 4)
    0.1355
    """
    first: Sphere = instance("body", body, (Sphere,))
    second: Sphere | HalfSpace | None = None
    if isinstance(against, str) and against == "same":
        second = first
    elif isinstance(against, (Sphere, HalfSpace)):
        second = against
    elif against is not None:
        raise refusal("against", against, "None, 'same', a stoss.Sphere or a stoss.HalfSpace")
    for name, solid in (("body", first), ("against", second)):
        if solid is not None and solid.material is None:
            raise refusal(name, solid, f"a stoss.{type(solid).__name__} with a material")
    if is_rigid(first) and second in (None, first):
        raise refusal("body", first, "an elastic sphere at a wall or an equal one")
    return _core.yield_speed(_in_si(first), None if second is None else _in_si(second))


def yield_speed_of(body: Any, against: Any) -> float | None:
    """That of what made a result; None of what is no sphere, and without a material."""
    if not isinstance(body, Sphere) or body.material is None:
        return None
    met = body if isinstance(against, str) else against
    return yield_speed(body, against=met if isinstance(met, (Sphere, HalfSpace)) else None)


def _in_si(solid: Sphere | HalfSpace) -> InSi:
    """A half-space has an infinite radius, a rigid sphere an infinite modulus."""
    assert solid.material is not None
    young = math.inf if is_rigid(solid) else solid.young
    radius = solid.radius if isinstance(solid, Sphere) else math.inf
    return young, solid.material.poisson, solid.density, solid.material.yield_strength, radius
