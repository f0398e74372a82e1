"""The speed at which a sphere, or the body that it meets, begins to yield."""

from __future__ import annotations

import functools
import json
from typing import Any

from stoss import _core
from stoss._arguments import instance, refusal
from stoss.bodies._bodies import Sphere
from stoss.bodies._solid import describe, is_rigid
from stoss.bodies._walls import HalfSpace


def yield_speed(body: Sphere, *, against: Sphere | HalfSpace | str | None = None) -> float | None:
    """Speed of approach at which a sphere at a rigid wall, or the weaker of two bodies, begins to yield, m/s.

    The maximum pressure p₀ of Hertz' contact is then 1.6 times the yield strength Y of the
    material: v² = (16/15)(E*R³/m)(πp₀/2E*)⁵ (K. L. Johnson, Contact Mechanics, eqs. 11.31 to
    11.35). At a wall it does not depend on the radius; an equal sphere takes twice that speed. A
    material without a yield strength is taken not to yield: None where neither has one.

    Parameters
    ----------
    body : Sphere
        With a material.
    against : 'same', Sphere or HalfSpace, optional
        An equal sphere, another one, or a half-space with a material; a rigid wall if it is left out.

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
    return _encounter(first, second).yield_speed()


def yield_speed_of(body: Any, against: Any) -> float | None:
    """That of what made a result; None of what is no sphere, and without a material."""
    if not isinstance(body, Sphere) or body.material is None:
        return None
    met = body if isinstance(against, str) else against
    return _encounter(body, met if isinstance(met, (Sphere, HalfSpace)) else None).yield_speed()


@functools.lru_cache(maxsize=64)
def _encounter(first: Sphere, second: Sphere | HalfSpace | None) -> _core.Encounter:
    """With their materials."""
    met = "wall" if second is None else describe(second)
    return _core.encounter(json.dumps({"first": describe(first), "against": met}))
