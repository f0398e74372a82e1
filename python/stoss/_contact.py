"""Who meets whom."""

from __future__ import annotations

import functools
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import instance, refusal
from stoss._bodies import BODIES, Body, Disk, Sphere
from stoss._errors import InvalidInput
from stoss._walls import HardWall, Wall

Against = Union[Wall, Body]


def choose_body(body: Any, poisson: Any) -> Body:
    """The body that was meant: exactly one of the two must be given."""
    if (body is None) == (poisson is None):
        got = "neither" if body is None else "body and poisson"
        raise InvalidInput(f"body: got {got}, allowed one of body and poisson")
    return Disk(poisson=poisson) if body is None else instance("body", body, BODIES)


def choose_bodies(given: Any) -> tuple[list[Body], NDArray[np.float64]]:
    """Each of several bodies once, and an array of the shape in which they were given of their numbers among these."""
    try:
        array = np.array(given, dtype=object)
    except Exception:  # whatever a foreign object raises when it is asked for its elements
        array = np.empty(0, dtype=object)
    found: dict[Body, int] = {}
    for each in array.flat:
        instance("body", each, (Disk, Sphere))
        if found and type(each) is not type(next(iter(found))):
            raise refusal("body", each, "one kind of bodies in a list")
        if each.material is not None:
            raise refusal("body", each, "bodies without a material in a list (their units would differ)")
        found.setdefault(each, len(found))
    if not found:
        raise refusal("body", given, "one body, or a list or an array of them")
    return list(found), np.array([found[each] for each in array.flat], dtype=np.float64).reshape(array.shape)


def choose_against(body: Body, against: Any, walls: tuple[type, ...]) -> Against:
    """What the body meets: one of these walls, its like, or another body."""
    if against is None:
        return HardWall()
    if isinstance(against, str) and against == "same":
        return body
    if not isinstance(against, (*walls, *BODIES)):
        kinds = ", ".join(f"a stoss.{wall.__name__}" for wall in walls)
        raise refusal("against", against, f"None, 'same', {kinds}, a stoss.Disk, a stoss.Rod or a stoss.Sphere")
    if isinstance(against, BODIES):
        if type(against) is not type(body):
            hint = "a disk meets disks, a rod rods, a sphere spheres"
            raise refusal("against", against, f"a stoss.{type(body).__name__} ({hint})")
        if (against.material is None) != (body.material is None):
            raise refusal("against", against, "two bodies with a material, or two without")
        plane = getattr(body, "plane", None)
        if getattr(against, "plane", None) != plane:
            raise refusal("against", against, f"the same plane as that of the first, {plane!r}")
    return against  # type: ignore[no-any-return]


# Contacts are made once for each resolution. One with 1000 modes takes 0.1 MB, a refined one 10 MB.
@functools.lru_cache(maxsize=32)
def _resolved(shape: Body, cutoff: float) -> _core.Body:
    return shape._maker().at(cutoff)


@functools.lru_cache(maxsize=16)
def _pair(first: Body, second: Body, cutoff: float) -> _core.Contact:
    return _core.pair(first._maker(), second._maker(), cutoff)


@functools.lru_cache(maxsize=8)
def _refinable(shape: Body) -> _core.RefinableContact:
    return _core.refinable(shape._maker())


@functools.lru_cache(maxsize=8)
def _refinable_pair(first: Body, second: Body) -> _core.RefinableContact:
    return _core.refinable_pair(first._maker(), second._maker())


def contact(body: Body, against: Against, cutoff: float, keep: NDArray[np.bool_] | None) -> _core.Contact:
    """A body with its modes up to the cutoff, or with some of them, at what it meets."""
    if isinstance(against, BODIES):
        return _pair(body, against, cutoff)
    every = resolved(body, cutoff)
    return _core.at_wall(every if keep is None else _core.with_modes(every, keep), against._made())


def radiates(against: Against) -> bool:
    """Whether the modes above the cutoff carry waves away: not with a static tail."""
    return not (isinstance(against, HardWall) and against.tail == "static")


def refinable(body: Body, against: Against) -> _core.RefinableContact:
    """The same at any cutoff, at a rigid wall or at a body."""
    return _refinable_pair(body, against) if isinstance(against, BODIES) else _refinable(body._shape())


def resolved(body: Body, cutoff: float) -> _core.Body:
    """A body by itself, with its modes up to the cutoff."""
    return _resolved(body._shape(), cutoff)
