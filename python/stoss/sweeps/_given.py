"""What a grid is given: bodies and partners with what is left to choose, numbers along its axes."""

from __future__ import annotations

import math
from typing import Any, Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import numbers
from stoss._errors import InvalidInput
from stoss.bodies._kinds import Specification
from stoss.sweeps._specification import Choices, choices, expanded

MOST_CASES = 100_000  # bodies times partners
MOST_VALUES = 1_000_000


def several(name: str, given: Any) -> list[tuple[Any, Choices]]:
    """One body or partner or several, given as objects, words or mappings, each with what is left to choose."""
    all_ = given if isinstance(given, (list, tuple, np.ndarray)) else [given]
    return [(each, choices(name, each)) for each in all_]


def count(given: list[tuple[Any, Choices]]) -> int:
    """How many specifications they make."""
    return sum(math.prod(map(len, left)) for _, left in given)


def require_moderate(bodies: int, partners: int, lengths: Mapping[str, int]) -> None:
    """Refuse a grid that is too large before its cases are made."""
    cases, values = bodies * partners, bodies * partners * math.prod(lengths.values())
    for got, name, most in ((cases, "cases", MOST_CASES), (values, "values", MOST_VALUES)):
        if got > most:
            of = ", ".join([f"{bodies} bodies, {partners} partners", *(f"{n} {each}s" for each, n in lengths.items())])
            raise InvalidInput.out_of_range("grid", f"{got} {name} ({of})", most, "make several grids of it")


def specifications(name: str, given: list[tuple[Any, Choices]]) -> Iterator[Specification]:
    """All of them, in order."""
    if count(given) == 0:
        raise InvalidInput.out_of_range(name, "none", "at least one", "the grid is empty")
    for each, left in given:
        yield from expanded(name, each, left)


def axis(name: str, given: Any) -> NDArray[np.float64]:
    """The numbers along an axis, each once."""
    values = numbers(name, _core.series(name, given) if isinstance(given, str) else given).ravel()
    if values.size == 0:
        raise InvalidInput.out_of_range(name, "none", "at least one", "the grid is empty")
    each, count = np.unique(values[~np.isnan(values)], return_counts=True)
    if np.any(count > 1):
        raise InvalidInput.out_of_range(name, f"{each[count > 1].tolist()[0]!r} twice", "once")
    values.flags.writeable = False
    return values
