"""Slow contacts of disks touch along a line, those of spheres at a point: which of the two a call is about."""

from __future__ import annotations

from typing import Any, Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from stoss._arguments import arranged, broadcast, choice, instance, numbers
from stoss.bodies._bodies import Disk, Sphere
from stoss.bodies._encounter import choose_body
from stoss.results._result import Number

LAWS: Mapping[type, tuple[str, ...]] = {Disk: ("center", "diameter", "printed"), Sphere: ("center", "hertz")}
"""Laws of compression of the bodies that have some."""


def choose_law(body: Any, law: Any) -> str:
    """One of the laws of a body; without one, of disks."""
    return choice("law", law, LAWS[Sphere if isinstance(body, Sphere) else Disk])


def poissons_of(body: Any, poisson: Any) -> NDArray[np.float64]:
    """The Poisson's ratio of a disk or a sphere, or those that were given of disks."""
    if body is None and poisson is not None:
        return numbers("poisson", poisson)
    found: Disk | Sphere = instance("body", choose_body(body, poisson), (Disk, Sphere))
    return np.array(found.poisson)


def by_law(
    line: Callable[..., NDArray[np.float64]],
    point: Callable[..., NDArray[np.float64]],
    body: Any,
    poisson: Any,
    law: Any,
    **given: Any,
) -> Number:
    """One of two functions of the core of a law, a Poisson's ratio and what else is given, over arrays."""
    nu = poissons_of(body, poisson)
    chosen = choose_law(body, law)
    arrays = broadcast(poisson=nu, **{name: numbers(name, value) for name, value in given.items()})
    function = point if isinstance(body, Sphere) else line
    values = function(chosen, *(each.ravel() for each in arrays))
    return arranged(values, arrays[0].shape)  # type: ignore[no-any-return]
