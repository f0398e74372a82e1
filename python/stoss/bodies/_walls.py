"""Walls, half-spaces and half-planes."""

from __future__ import annotations

import dataclasses
from typing import Union

from stoss import _core
from stoss._arguments import number
from stoss.bodies._material import Material
from stoss.bodies._plates import Plate, Strip
from stoss.bodies._solid import LEFT_OUT, Endless


@dataclasses.dataclass(frozen=True, init=False)
class HardWall:
    """A rigid wall: no point of the body passes it, and pressure is never negative (Signorini)."""

    def __init__(self, *, tail: None = None) -> None:
        if tail is not None:
            raise TypeError("HardWall: got tail, which is an argument of the call: stoss.impact(..., tail='static')")

    def _document(self) -> str:
        return "wall"


@dataclasses.dataclass(frozen=True, kw_only=True)
class ExponentialWall:
    """The soft wall of Gerl and Zippelius, with the potential V₀ ∫ dφ e^{αx(φ)}.

    Modes above the cutoff are left out.

    Parameters:
        hardness (float): α, 1/R, 1 to 1e6.
        strength (float): V₀, ρc²R²; it shifts the wall by ln V₀/α and changes nothing else.
    """

    hardness: float = 500.0
    strength: float = 1.0

    def __post_init__(self) -> None:
        for name in ("hardness", "strength"):
            object.__setattr__(self, name, number(name, getattr(self, name)))
        _core.check_wall(self.hardness, self.strength)

    def _document(self) -> dict[str, str | float]:
        return {"kind": "exponential", "hardness": self.hardness, "strength": self.strength}


Wall = Union[HardWall, ExponentialWall]
"""Any wall: a hard or an exponential one."""


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class HalfSpace(Endless):
    """An elastic half-space, which spheres meet: a block so large that no wave comes back in time.

    Waves carry energy away in it: see `Impact.lost_to_second`. The block is thick enough
    if a wave to its other side and back takes longer than the contact. Without a material its
    numbers are ratios to those of the sphere, or in the same units.

    Parameters:
        poisson: Poisson's ratio ν, −0.95 to 0.4999; default: that of the sphere.
        young, density: Young's modulus E and density ρ, 1e-3 to 1e6 of those of the sphere; default
            1.

    Examples:
        >>> stoss.restitution(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.01)
        Restitution(Sphere(poisson=0.3) against HalfSpace(poisson=0.3), speed=0.01 c: restitution 0.9598515 ± 0.0000044)
        >>> steel, glass = stoss.materials["structural steel"], stoss.materials["glass"]
        >>> ball = stoss.Sphere(radius=5e-3, material=steel)
        >>> drop = stoss.restitution(ball, against=stoss.HalfSpace(material=glass), speed=1)
        >>> round(drop.restitution, 3), round(drop.dissipated, 4), f"{drop.contact_time_si:.2g} s"
        (0.994, 0.0033, '4.6e-05 s')
    """

    _kind = "half-space"

    poisson: float | None = LEFT_OUT
    young: float = LEFT_OUT
    density: float = LEFT_OUT
    loss_time: float = LEFT_OUT
    material: Material | None = None


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class HalfPlane(Endless):
    """An elastic half-plane, which disks meet: a half-space in two dimensions.

    Parameters:
        poisson: 2-D Poisson's ratio ν, −0.95 to 0.995; default: that of the disk.
        young, density: 2-D Young's modulus E and density ρ, 1e-3 to 1e6 of those of the disk;
            default 1.
        plane ({'stress', 'strain'}): With a material: that of the disk.

    Examples:
        >>> stoss.restitution(poisson=0.33, against=stoss.HalfPlane(), speed=0.1)
        Restitution(Disk(poisson=0.33) against HalfPlane(poisson=0.33), speed=0.1 c: restitution 0.56990 ± 0.00032)
    """

    _kind = "half-plane"

    poisson: float | None = LEFT_OUT
    young: float = LEFT_OUT
    density: float = LEFT_OUT
    loss_time: float = LEFT_OUT
    material: Material | None = None
    plane: str | None = None


Unbounded = Union[HalfSpace, HalfPlane, Plate, Strip]
UNBOUNDED = (HalfSpace, HalfPlane, Plate, Strip)
"""The classes of what extends to infinity, for isinstance."""
