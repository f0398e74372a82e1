"""The speed at which a sphere begins to yield."""

from __future__ import annotations

from typing import Any

from stoss import _core
from stoss._arguments import instance, refusal
from stoss._sphere import Sphere

InSi = tuple[float, float, float, "float | None", float]


def yield_speed(body: Sphere, *, against: Sphere | None = None) -> float | None:
    """Speed of approach at which a sphere at a rigid wall, or the weaker of two, begins to yield, m/s.

    The greatest pressure p₀ of Hertz' contact is then 1.6 times the yield strength Y of the
    material: v² = (16/15)(E*R³/m)(πp₀/2E*)⁵ (K. L. Johnson, Contact Mechanics, eqs. 11.31 to
    11.35). At a wall it does not depend on the radius.

    Parameters
    ----------
    body : Sphere
        With a material.
    against : Sphere, optional
        Another one; a rigid wall if it is left out.

    Returns
    -------
    float or None
        None where no material has a yield strength; one that has none is taken not to yield.

    Raises
    ------
    InvalidInput
        For a sphere without a material.

    Examples
    --------
    >>> hard = stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=1e9)
    >>> round(stoss.quasistatic.yield_speed(stoss.Sphere(radius=0.01, material=hard)), 4)
    0.0339
    """
    first: Sphere = instance("body", body, (Sphere,))
    second: Sphere | None = None if against is None else instance("against", against, (Sphere,))
    for name, sphere in (("body", first), ("against", second)):
        if sphere is not None and sphere.material is None:
            raise refusal(name, sphere, "a stoss.Sphere with a material")
    return _core.yield_speed(_in_si(first), None if second is None else _in_si(second))


def yield_speed_of(body: Any, against: Any) -> float | None:
    """That of what made a result; None of what is no sphere, and without a material."""
    if not isinstance(body, Sphere) or body.material is None:
        return None
    met = body if isinstance(against, str) else against
    return yield_speed(body, against=met if isinstance(met, Sphere) else None)


def _in_si(sphere: Sphere) -> InSi:
    strength = None if sphere.material is None else sphere.material.yield_strength
    return sphere.young, sphere.poisson, sphere.density, strength, sphere.radius
