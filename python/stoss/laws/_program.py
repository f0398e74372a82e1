"""What a simulation program needs to know of a law: how it integrates it, and how it wants it written."""

from __future__ import annotations

from typing import Any, Callable, Mapping, NamedTuple

from stoss.laws._collision import Spring
from stoss.laws._law import KAPPA


class Wording(NamedTuple):
    """A law in the words of a program.

    `ratios` are the stiffnesses along the surface over that along the normal that it can have; None if its friction
    has no spring.
    """

    write: Callable[[Any], list[str]]
    spring: Spring
    ratios: tuple[float, float] | None = KAPPA


class Program(NamedTuple):
    """The laws that a program has, and how its comments begin and end: `comment` is None of a file without any."""

    laws: Mapping[str, Wording]
    comment: str | None = "# "
    end: str = ""
    walls: bool = True


def digits(value: float) -> str:
    """A number for an input file: the shortest of ten digits."""
    return f"{value:.10g}"
