"""Walls."""

from __future__ import annotations

import dataclasses
from typing import Union

from stoss import _core
from stoss._arguments import number


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

    Parameters
    ----------
    hardness : float
        α, 1/R, 1 to 1e6.
    strength : float
        V₀, ρc²R²; it shifts the wall by ln V₀/α and changes nothing else.
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
