"""How a material loses energy: by a loss time, by a quality, or by its relaxation."""

from __future__ import annotations

from types import MappingProxyType
from typing import Any, Mapping

from stoss.bodies._kinds import Specification
from stoss.bodies._material import Material

LOSSES = ("loss_time", "quality", "relaxation")
NO_LOSSES: Mapping[str, Any] = MappingProxyType({"loss_time": 0.0, "quality": 0.0, "relaxation": None})
"""How a material loses energy: in one of these ways."""


def losses_of(material: Material) -> dict[str, Any]:
    """Those of a material."""
    numbers = {name: getattr(material, name) or 0.0 for name in ("loss_time", "quality")}
    return {**numbers, "relaxation": material.relaxation}


def relaxes(solid: Any) -> bool:
    """Whether it loses energy otherwise than by a loss time."""
    return bool(getattr(solid, "quality", 0.0) or getattr(solid, "relaxation", None))


def losses_in(solid: Any) -> Specification:
    """How it loses energy; a loss time of 0 only where it does not relax, nothing where each layer does so by itself."""
    its = {name: getattr(solid, name) for name in LOSSES if getattr(solid, name, None)}
    loss_time = getattr(solid, "loss_time", None)
    return its or ({"loss_time": loss_time} if loss_time is not None else {})
