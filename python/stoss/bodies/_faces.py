"""What the face of a body or a block is like: rough, coated, yielding, or bare, smooth and elastic."""

from __future__ import annotations

from types import MappingProxyType
from typing import Any, Mapping

from stoss.bodies._kinds import Specification

LENGTHS_OF_FACE = ("roughness", "u0", "coat")
FACE = (*LENGTHS_OF_FACE, "coat_young", "coat_poisson", "coat_quality", "yield_strength", "yield_hardening",
        "yield_rate")
BESIDE = (*FACE, "extra_mass")
SMOOTH: Mapping[str, Any] = MappingProxyType({**dict.fromkeys(FACE, 0.0), "coat_poisson": 0.3})
"""How rough a face is, its coat, and from which stress on it yields; those of a bare smooth elastic one."""


def face_of(solid: Any, length: float = 1.0, modulus: float = 1.0) -> Specification:
    """What its face is like; nothing of a bare smooth one. @param length,modulus units of its numbers"""
    units = {**dict.fromkeys(LENGTHS_OF_FACE, length), "coat_young": modulus, "yield_strength": modulus,
             "yield_hardening": modulus}
    its = {name: getattr(solid, name, SMOOTH[name]) for name in FACE}
    return {name: value / units.get(name, 1.0) for name, value in its.items() if value != SMOOTH[name]}


def load_of(solid: Any, unit: float = 1.0) -> Specification:
    """The mass that is fixed to it, in a unit of its own; nothing where there is none."""
    mass: float = getattr(solid, "extra_mass", 0.0)
    return {"extra_mass": mass / unit} if mass else {}


def is_rough(solid: Any) -> bool:
    """Whether it has a rough or coated face."""
    return bool(face_of(solid))


def has_rate(solid: Any) -> bool:
    """Whether its strength grows with the rate of strain, which is in 1/s."""
    return bool(getattr(solid, "yield_rate", 0.0))
