"""Bodies and walls."""

from __future__ import annotations

import dataclasses
import functools
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import instance, number, refusal
from stoss._errors import InvalidInput
from stoss._material import Material


@dataclasses.dataclass(frozen=True, kw_only=True)
class Disk:
    """An elastic disk, in units of its radius R, bar speed c and mass m.

    Its modes are computed when they are needed and kept for the next call.

    Parameters
    ----------
    poisson : float
        2-D Poisson number ν, −0.95 to 0.995 (plane strain: see `Material`).

    Examples
    --------
    >>> stoss.impact(body=stoss.Disk(poisson=0.33), speed=0.1, cutoff=25).contacts
    1
    """

    poisson: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "poisson", number("poisson", self.poisson))
        _core.refinable_disk(self.poisson)  # refuses what is out of range

    def _at(self, cutoff: float) -> _core.Body:
        return _disk(self.poisson, cutoff)

    def _refinable(self) -> _core.RefinableContact:
        return _refinable_disk(self.poisson)


@dataclasses.dataclass(frozen=True)
class Rod:
    """A thin elastic rod that meets the wall with one end.

    Units are its length L, bar speed c and mass. It has an exact answer, restitution 1 and contact
    time 2L/c: a check of everything else.

    Examples
    --------
    >>> bounce = stoss.impact(body=stoss.Rod(), speed=0.1, cutoff=1000)
    >>> round(bounce.restitution, 2), round(bounce.contact_time, 2)
    (1.0, 2.0)
    """

    def _at(self, cutoff: float) -> _core.Body:
        return _rod(cutoff)

    def _refinable(self) -> _core.RefinableContact:
        return _refinable_rod()


Body = Union[Disk, Rod]


# Bodies are made once for each resolution. A body with 1000 modes takes 0.1 MB, a refined one 10 MB.
_disk = functools.lru_cache(maxsize=32)(_core.disk)
_rod = functools.lru_cache(maxsize=32)(_core.rod)
_refinable_disk = functools.lru_cache(maxsize=8)(_core.refinable_disk)
_refinable_rod = functools.lru_cache(maxsize=1)(_core.refinable_rod)


def choose_body(poisson: Any, material: Material | None, body: Body | None) -> Body:
    """The body that was meant: exactly one of the three must be given."""
    given = [
        name for name, value in (("poisson", poisson), ("material", material), ("body", body)) if value is not None
    ]
    if len(given) != 1:
        raise InvalidInput(f"body: got {' and '.join(given) or 'none'}, allowed one of poisson, material and body")
    if body is not None:
        return instance("body", body, (Disk, Rod))  # type: ignore[no-any-return]
    if material is not None:
        return Disk(poisson=instance("material", material, (Material,)).plane_poisson)
    return Disk(poisson=poisson)


def contact_with(body: Body, wall: Wall, cutoff: float, keep: NDArray[np.bool_] | None) -> _core.Contact:
    """A body with its modes up to the cutoff, or with some of them, at a wall."""
    every = body._at(cutoff)
    return _core.at_wall(every if keep is None else _core.with_modes(every, keep), wall._made())


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
        return _core.hard_wall(self.tail == "radiating")


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
