"""What `python -m stoss.modal --map` takes, and how it says why a point has no value."""

from __future__ import annotations

import argparse
import dataclasses
import math
import os
import re
from typing import Any, Callable

from stoss._errors import InvalidInput

POINTS = 400
OF_ONE_POINT = ("point", "normal", "tangent", "curvature", "radius", "size_at_point", "output", "plate", "disc")
SHORT = (
    ("sharp edge", "not smooth: a sharp edge"),
    ("off that of the surface", "not smooth: an edge, or a mesh too coarse to tell"),
    ("beside the surface", "not smooth: an edge, or a mesh too coarse to tell"),
    ("does not face", "not smooth: an edge, or a mesh too coarse to tell"),
    ("too few for a fit", "not smooth: an edge, or a mesh too coarse to tell"),
    ("ends or turns away", "an edge is closer than the mesh can tell: smaller edges reach further"),
    ("too coarse", "the mesh is too coarse for how the surface bends"),
    ("a hollow", "a hollow"),
    ("it lies on", "held there, or beside it"),
)
"""A part of a refusal, and what is said of all points with it."""


def add_options(parser: argparse.ArgumentParser, numbers: Callable[[str], Any]) -> None:
    """Those of a map."""
    add = parser.add_argument
    add(
        "--map",
        metavar="OUT.vtu",
        help="ε all over the surface, with errors, in place of one point: also OUT.csv, OUT.png",
    )
    add("--speed", type=numbers, metavar="V,…", help="of a map: speeds of impact, m/s")
    add(
        "--against", metavar="KIND[,KEY=VALUE]…",
        help="of a map: what it meets, wall (default), half-space,material=NAME or sphere,radius=R,material=NAME, in m",
    )  # fmt: skip
    add("--points", type=int, metavar="N", help=f"of a map: so many points, spread evenly (default {POINTS})")


def take_map(given: argparse.Namespace) -> None:
    """Checks what is asked of a map, and sets what one point would have. Raises InvalidInput."""
    if given.map is None:
        for name in ("speed", "against", "points"):
            if getattr(given, name) is not None:
                raise InvalidInput.conflict(name, "is of a map", "--map OUT.vtu")
        if given.output is None:
            raise InvalidInput.missing("output", ": -o FILE, or --map OUT.vtu")
        return
    for name in OF_ONE_POINT:
        if getattr(given, name) is not None:
            raise InvalidInput.conflict(
                name.replace("_", "-"), "is of one point, not of a map", "without it, or without --map"
            )
    if not given.map.lower().endswith(".vtu"):
        raise InvalidInput.out_of_range(
            "map", f"'{given.map}'", "a name that ends in .vtu", "CSV and PNG are beside it"
        )
    if given.speed is None:
        raise InvalidInput.missing("speed", ": --speed V,… in m/s")
    if not all(0.0 < each < math.inf for each in given.speed):
        raise InvalidInput.out_of_range("speed", min(given.speed), "above 0")
    given.points = POINTS if given.points is None else given.points
    if given.points < 4:
        raise InvalidInput.out_of_range("points", given.points, "4 or more")
    given.output = given.map
    given.against = _partner(given.against or "wall")
    from stoss.bodies._solids import Sphere

    held = any((given.clamp, given.spring))
    if held and not isinstance(given.against, Sphere):
        raise InvalidInput.conflict(
            "against", "a body that is held does not move", "--against sphere,radius=R,material=NAME"
        )


def _partner(text: str) -> Any:
    """A wall, a half-space or a sphere."""
    import stoss

    kinds: dict[str, Any] = {"wall": stoss.HardWall, "half-space": stoss.HalfSpace, "sphere": stoss.Sphere}
    name, *pairs = text.split(",")
    if name not in kinds:
        raise InvalidInput.out_of_range(
            "against", f"'{name}'", ", ".join(kinds), "as sphere,radius=0.005,material=glass"
        )
    kind, words = kinds[name], dict[str, Any]()
    allowed = [] if name == "wall" else [each.name for each in dataclasses.fields(kind) if each.init]
    for pair in pairs:
        key, equals, value = pair.partition("=")
        key = key.strip().replace("-", "_")
        if not equals or key not in allowed:
            raise InvalidInput.out_of_range(
                f"against {name}", f"'{pair}'", "KEY=VALUE with " + (", ".join(allowed) or "no key")
            )
        if key == "material":
            words[key] = stoss.materials[value]
            continue
        try:
            words[key] = float(value)
        except ValueError:
            raise InvalidInput.out_of_range(f"against {name} {key}", f"'{value}'", "a number") from None
    if name != "wall" and "material" not in words:
        raise InvalidInput.missing(f"against {name} material", ": one of stoss.materials")
    if name == "sphere" and "radius" not in words:
        raise InvalidInput.missing("against sphere radius", ": in m")
    return kind(**words)


def in_short(refusal: str) -> str:
    """Why a point has no value, in the same words for all that have none for this reason."""
    for part, said in SHORT:
        if part in refusal:
            return said
    return re.sub(r"'[^']*'", "the body", refusal)


def beside(path: str, ending: str) -> str:
    """The name of a file beside the map."""
    return os.path.splitext(path)[0] + ending
