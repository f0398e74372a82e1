"""Walls."""

from __future__ import annotations

import dataclasses
from typing import Union

from stoss import _core
from stoss._arguments import number, refusal


@dataclasses.dataclass(frozen=True, kw_only=True)
class HardWall:
    """A rigid wall: no point of the body passes it, and pressure is never negative (Signorini).

    Parameters
    ----------
    tail : {'radiating', 'static'}
        How the modes above the cutoff answer: with static compliance at low and plane-wave
        impedance at high frequency, or with static compliance only.
    """

    tail: str = "radiating"

    def __post_init__(self) -> None:
        if not isinstance(self.tail, str) or self.tail not in ("radiating", "static"):
            raise refusal("tail", self.tail, "'radiating' or 'static'")

    def _made(self) -> _core.AnyWall:
        return _core.hard_wall()


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
        self._made()

    def _made(self) -> _core.AnyWall:
        return _core.exponential_wall(self.hardness, self.strength)


Wall = Union[HardWall, ExponentialWall]
"""Any wall: a hard or an exponential one."""
