"""Who meets whom, and from which speed on a sphere yields then."""

from __future__ import annotations

import functools
import json
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import choice, instance, number, refusal
from stoss._errors import InvalidInput
from stoss.bodies._bodies import BODIES, PARTNERS, Body, Disk, HollowSphere, Sphere
from stoss.bodies._material import NAMES
from stoss.bodies._faces import has_rate
from stoss.bodies._kinds import KINDS, Specification
from stoss.bodies._losses import LOSSES, losses_of
from stoss.bodies._solid import Solid, describe, is_rigid
from stoss.bodies._walls import UNBOUNDED, WALLS, HardWall, Unbounded, Wall


Against = Union[Wall, Body, Unbounded]


def choose_body(body: Any, poisson: Any, *, rigid: bool = False) -> Body:
    """The body that was meant: exactly one of the two must be given. Only where that may be, it is a `rigid` one."""
    if (body is None) == (poisson is None):
        got = "neither" if body is None else "body and poisson"
        raise InvalidInput.out_of_range("body", got, "one of body and poisson")
    chosen: Body = Disk(poisson=poisson) if body is None else instance("body", body, BODIES)
    if is_rigid(chosen) and not rigid:
        raise refusal("body", chosen, "an elastic body (a rigid one only meets others)")
    return chosen


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


def choose_against(body: Body, against: Any, walls: tuple[type, ...] = WALLS) -> Against:
    """What the body meets: one of these walls, an identical body, or another body."""
    named: dict[str, Any] = {"same": body, **({"wall": HardWall()} if HardWall in walls else {})}
    if against is None:
        against = HardWall()
    if isinstance(against, str) and against in named:
        against = named[against]
    if not isinstance(against, (*walls, *PARTNERS)):
        kinds = ", ".join(f"a stoss.{kind.__name__}" for kind in (*walls, *PARTNERS[:-1]))
        names = ", ".join(map(repr, sorted(named, reverse=True)))
        raise refusal("against", against, f"None, {names}, {kinds} or a stoss.{PARTNERS[-1].__name__}")
    if is_rigid(body) and (not isinstance(against, PARTNERS) or is_rigid(against)):
        raise refusal("against", against, "a body that deforms, as this one is rigid")
    if isinstance(against, PARTNERS):
        if not _core.meets(body._kind, against._kind):
            solids: tuple[type[Solid], ...] = (*BODIES, *UNBOUNDED)
            allowed = (each.__name__ for each in solids if _core.meets(body._kind, each._kind))
            raise refusal("against", against, f"a stoss.{', '.join(allowed)} ({_core.who_meets_whom()})")
        if (against.material is None) != (body.material is None):
            raise refusal("against", against, "two bodies with a material, or two without")
        plane = getattr(body, "plane", None)
        if getattr(against, "plane", None) != plane:
            raise refusal("against", against, f"the same plane as that of the first, {plane!r}")
        if isinstance(against, UNBOUNDED):
            return against._beside(body)
    return against  # type: ignore[no-any-return]


def choose_tail(tail: Any) -> str:
    """How the modes above the cutoff answer a contact."""
    return choice("tail", tail, ("radiating", "static", "none"))


def choose_cutoff(cutoff: Any, body: Body, against: Against, speed: float, most: float = 50.0) -> float:
    """The highest frequency that was meant, c/R: by itself the usual one down to this speed in c."""
    return encounter(body, against).usual_cutoff(speed, most) if cutoff is None else number("cutoff", cutoff)


def encounter(body: Body, against: Against) -> _core.Encounter:
    """Both by their numbers, in the units in which they are given; in SI where one is of a file."""
    return _encounter(_document(body, against))


def _document(body: Body, against: Against) -> str:
    if isinstance(against, PARTNERS):
        # What a file holds is in SI, and so are losses of layers by themselves, the frequency of a quality and rates.
        in_si = any(KINDS[each._kind].from_file or has_rate(each) or (each.material and (each.quality or each.loss_time is None))
                    for each in (body, against))
        first, second = (describe(each) if in_si else each._numbers() for each in (body, against))
        return json.dumps({"first": first, "against": second})
    # A body by itself is in its own units, one of a file in SI, and one whose strength knows rates of strain.
    if has_rate(body):
        return json.dumps({"first": describe(body), "against": against._document(1.0)})
    per = 1.0 if KINDS[body._kind].from_file else getattr(body, "radius", None) or getattr(body, "length")
    return json.dumps({"first": body._numbers_at_wall(), "against": against._document(per)})


# Contacts are made once for each resolution. One with 1000 modes takes 0.1 MB, a refined one 10 MB.
@functools.lru_cache(maxsize=64)
def _encounter(document: str) -> _core.Encounter:
    return _core.encounter(document)


@functools.lru_cache(maxsize=32)
def _contact(document: str, cutoff: float, slowest: float) -> _core.Contact:
    return _encounter(document).contact(cutoff, slowest)


@functools.lru_cache(maxsize=16)
def _refinable(document: str) -> _core.RefinableContact:
    return _encounter(document).refinable()


def contact(
    body: Body, against: Against, cutoff: float, speed: float, keep: NDArray[np.bool_] | None = None
) -> _core.Contact:
    """A body with its modes up to the cutoff, or with some of them, at what it meets at this speed."""
    # Only a half-space is made for contacts that last so long.
    slowest = speed if isinstance(against, UNBOUNDED) else 1.0
    every = _contact(_document(body, against), cutoff, slowest)
    return every if keep is None else every.with_modes(keep)


def refinable(body: Body, against: Against) -> _core.RefinableContact:
    """The same at any cutoff, at a rigid wall or at a body."""
    return _refinable(_document(body, against))


def yield_speed(body: Sphere, *, against: Sphere | Unbounded | str | None = None) -> float | None:
    """Speed of approach at which a sphere at a rigid wall, or the weaker of two bodies, begins to yield, m/s.

    The maximum pressure p₀ of Hertz' contact is then 1.6 times the yield strength Y of the
    material: v² = (16/15)(E*R³/m)(πp₀/2E*)⁵ (K. L. Johnson, Contact Mechanics, eqs. 11.31 to
    11.35). At a wall it does not depend on the radius; an equal sphere takes twice that speed. A
    material without a yield strength is taken not to yield: None where neither has one.

    Parameters:
        body (Sphere): With a material.
        against (Sphere, HalfSpace, 'same' or 'wall', optional): Another sphere, a block with a material,
            an equal sphere or a rigid wall (default).

    Examples:
        >>> hard = stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=1e9)
        >>> round(stoss.quasistatic.yield_speed(stoss.Sphere(radius=0.01, material=hard)), 4)
        0.0339
        >>> ball, block = stoss.Sphere(radius=0.01, material=hard), stoss.HalfSpace(material=hard)
        >>> round(stoss.quasistatic.yield_speed(ball, against=block), 4)
        0.1355
    """
    first: Sphere = instance("body", body, (Sphere,))
    second: Sphere | Unbounded | None = None
    if isinstance(against, str) and against == "same":
        second = first
    elif isinstance(against, PARTNERS) and _core.meets(first._kind, against._kind):
        second = against
    elif against is not None and not (isinstance(against, str) and against == "wall"):
        solids: tuple[type[Solid], ...] = PARTNERS
        allowed = " or ".join(f"a stoss.{each.__name__}" for each in solids if _core.meets(first._kind, each._kind))
        raise refusal("against", against, f"None, 'wall', 'same', {allowed}")
    for name, solid in (("body", first), ("against", second)):
        if solid is not None and solid.material is None:
            raise refusal(name, solid, f"a stoss.{type(solid).__name__} with a material")
    if is_rigid(first) and second in (None, first):
        raise refusal("body", first, "an elastic sphere at a wall or an equal one")
    return _with_materials(first, second).yield_speed()


def yield_speed_of(body: Any, against: Any) -> float | None:
    """That of what made a result; None of what is no sphere, and without a material."""
    found = _that_may_yield(body, against)
    return None if found is None else found.yield_speed()


def yield_warning_of(body: Any, against: Any, speed: float) -> str:
    """What the core says of elastic results at that speed, m/s: nothing below the speed of yielding."""
    found = _that_may_yield(body, against)
    return "" if found is None else found.yield_warning(speed)


def material_warnings_of(body: Any, against: Any, fastest: float) -> list[str]:
    """All that the core says of the materials of results up to this speed, m/s."""
    yields = yield_warning_of(body, against, fastest)
    said = [yields] if yields else []
    if body.material is None or not isinstance(against, (str, type(None), *PARTNERS, *WALLS)):
        return said
    met = "same" if isinstance(against, str) or against is body else HardWall() if against is None else against
    both = drop_encounter(body, met)
    return said + both.shell_warnings(fastest) + both.sound_warnings()


def _that_may_yield(body: Any, against: Any) -> _core.Encounter | None:
    if not isinstance(body, (Sphere, HollowSphere)) or body.material is None:
        return None
    met = body if isinstance(against, str) else against
    return _with_materials(body, met if isinstance(met, PARTNERS) else None)


def _with_materials(first: Sphere | HollowSphere, second: Body | Unbounded | None) -> _core.Encounter:
    """Both in SI."""
    met = "wall" if second is None else describe(second)
    return _encounter(json.dumps({"first": describe(first), "against": met}))


def drop_encounter(body: Body, against: Against | str) -> _core.Encounter:
    """Both in SI, and materials by the names that they have: the core knows how well constants of these are known."""
    met: Any = against if isinstance(against, str) else None
    if isinstance(against, PARTNERS):
        met = named(against)
    elif met is None:
        met = against._document()  # type: ignore[union-attr]
    return _encounter(json.dumps({"first": named(body), "against": met}))


def named(solid: Solid) -> Specification:
    """What describes it, without the losses that its material has: those of a named one the core knows."""
    words = describe(solid)
    if solid.material is None or "material" not in words:  # without a material, of layers or of a file
        return words
    if {name: getattr(solid, name) for name in LOSSES} == losses_of(solid.material):
        words = {name: value for name, value in words.items() if name not in LOSSES}
    return {**words, "material": NAMES.get(solid.material, words["material"])}
