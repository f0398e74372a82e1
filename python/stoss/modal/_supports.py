"""What holds a body, or is fixed to it, at named surfaces of its mesh: clamps, springs and masses."""

from __future__ import annotations

import argparse
import dataclasses
import math
import re
from typing import Any

from stoss._errors import InvalidInput

NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
SPRING = re.compile(rf"(?P<surface>.+)=(?P<normal>{NUMBER})(?:,(?P<tangential>{NUMBER}))?(?P<unit>N/m3?)")
MASS = re.compile(rf"(?P<surface>.+)=(?P<mass>{NUMBER})(?:kg)?")


@dataclasses.dataclass(frozen=True)
class Support:
    """What holds one surface, in SI, as given: springs, a mass, or neither, which is a clamp.

    Springs are stiff along the normal of the surface and along it, by the same amount everywhere, for the
    whole surface (N/m), or for each m² of it (N/m³).
    """

    surface: str
    normal: float = 0.0
    tangential: float = 0.0
    each: bool = False
    mass: float = 0.0

    @property
    def clamps(self) -> bool:
        """Whether the surface cannot move at all."""
        return self.mass == self.normal == self.tangential == 0.0

    def __str__(self) -> str:
        if self.clamps:
            return f"{self.surface} clamped"
        if self.mass:
            return f"{self.mass:g} kg on {self.surface}"
        return f"{self.surface} on springs, {self.normal:g} and {self.tangential:g} {'N/m3' if self.each else 'N/m'}"


def add_options(parser: argparse.ArgumentParser) -> None:
    """Those that hold a body."""
    several: dict[str, Any] = {"action": "append", "default": []}
    parser.add_argument(
        "--clamp", **several, metavar="SURFACE", help="a surface (Gmsh: Physical Surface) that cannot move"
    )
    parser.add_argument(
        "--spring", **several, metavar="SURFACE=KN[,KT]UNIT",
        help="springs on one, along its normal and along itself: N/m of all of it, or N/m3 of each m²",
    )  # fmt: skip
    parser.add_argument(
        "--extra-mass", **several, metavar="SURFACE=KG", help="a mass spread evenly on one"
    )


def supports_of(given: argparse.Namespace) -> tuple[Support, ...]:
    """Those that the arguments ask for. Raises InvalidInput."""
    all_of_them = [Support(name) for name in given.clamp]
    all_of_them += [_spring(text) for text in given.spring]
    all_of_them += [_mass(text) for text in given.extra_mass]
    held = [each.surface for each in all_of_them if not each.mass]
    for name in sorted({name for name in held if held.count(name) > 1}):
        raise InvalidInput.conflict(name, "it is held twice", "one --clamp or --spring for each surface")
    for each in all_of_them:
        if each.mass and each.surface in given.clamp:
            raise InvalidInput.conflict("extra-mass", f"'{each.surface}' is clamped, so its mass does not count")
    return tuple(all_of_them)


def holds(supports: tuple[Support, ...]) -> bool:
    """Whether they keep a body in its place, as masses do not."""
    return any(not each.mass for each in supports)


def _spring(text: str) -> Support:
    found = SPRING.fullmatch(text)
    if found is None:
        raise InvalidInput.out_of_range(
            "spring", f"'{text}'", "SURFACE=KN[,KT]UNIT with N/m (of all of it) or N/m3 (of each m²), as grip=2e4,1e4N/m"
        )
    normal = float(found["normal"])
    tangential = normal if found["tangential"] is None else float(found["tangential"])
    if not (0.0 <= normal < math.inf and 0.0 <= tangential < math.inf and normal + tangential > 0.0):
        raise InvalidInput.out_of_range("spring", f"'{text}'", "finite stiffnesses of 0 or more, one above 0")
    return Support(found["surface"], normal, tangential, found["unit"] == "N/m3")


def _mass(text: str) -> Support:
    found = MASS.fullmatch(text)
    if found is None or not 0.0 < float(found["mass"]) < math.inf:
        raise InvalidInput.out_of_range("extra-mass", f"'{text}'", "SURFACE=KG with a mass above 0, as grip=0.5")
    return Support(found["surface"], mass=float(found["mass"]))
