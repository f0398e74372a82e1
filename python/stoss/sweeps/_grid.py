"""The cases of a sweep: which bodies meet what, and how fast."""

from __future__ import annotations

import hashlib
import itertools
import json
import math
import os
from typing import Any, Iterator, Mapping, NamedTuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import number, numbers, refusal
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body, speed_unit, speeds_in_si
from stoss.bodies._encounter import Against, choose_against, choose_body, refinable
from stoss.bodies._solid import Solid, Specification, describe
from stoss.bodies._walls import HardWall, Unbounded
from stoss.export import _formats
from stoss.sweeps._specification import Choices, beside, choices, expanded, make

MOST_CASES = 100_000  # bodies times partners
MOST_VALUES = 1_000_000

Given = Union[Body, Unbounded, HardWall, str, Mapping[str, Any]]


class Case(NamedTuple):
    """One body and what it meets: the speeds have its modes in common."""

    place: tuple[int, int]
    body: Body
    against: Against
    inputs: Specification
    key: str


class Grid:
    """The cases of a sweep: each of the bodies meets each of the partners at each of the speeds.

    Parameters:
        bodies (Disk, Sphere or Rod, mapping, or a sequence of them): The first bodies, all with a
            material or all without. A mapping has the `kind` ``'disk'``, ``'sphere'`` or ``'rod'``
            and the arguments of that class; where an argument is a list or a series as
            ``'lin:0:0.4:5'``, it stands for a body of each number.
        against (like bodies, optional): What they meet: 'wall', 'same', a HardWall, a body, a HalfSpace
            or HalfPlane, a mapping, or a sequence of them. A mapping that names no Poisson's ratio takes
            that of the first body.
        speed (array_like): Of approach, c of the first body (with materials: m/s); or a series as
            ``'log:1e-4:0.1:30'``.
        tolerance, absolute (float, optional): As of `stoss.restitution`.

    Raises:
        InvalidInput: For an empty grid, one of more than 100 000 cases or 1 000 000 values, for
            bodies that cannot meet, for a case or a speed that comes twice, and for numbers out of
            range.

    Examples:
        >>> grid = stoss.Grid(
        ...     bodies={"kind": "sphere", "poisson": [0.2, 0.3]},
        ...     against=["wall", {"kind": "sphere", "radius": [1, 2]}],
        ...     speed="log:1e-3:1e-1:5",
        ... )
        >>> grid.shape
        (2, 3, 5)
    """

    def __init__(
        self,
        *,
        bodies: Given | Any,
        against: Given | Any = "wall",
        speed: ArrayLike | str,
        tolerance: float = 1e-3,
        absolute: float = 1e-6,
    ) -> None:
        first, second = _several("bodies", bodies), _several("against", against)
        self.speed = _speeds(speed)
        _require_moderate(_count(first), _count(second), self.speed.size)
        self.bodies: tuple[Body, ...] = tuple(_first(each) for each in _specifications("bodies", first))
        self.against: tuple[Specification, ...] = tuple(_specifications("against", second))
        self.tolerance = number("tolerance", tolerance)
        self.absolute = number("absolute", absolute)
        _core.check_curve(np.empty(0), self.tolerance, self.absolute, 1)
        if len({body.material is None for body in self.bodies}) > 1:
            raise InvalidInput("bodies: got some with a material, allowed all or none (speeds are in m/s or in c)")
        self._cases = tuple(self._found())
        self._check()

    def __repr__(self) -> str:
        bodies, partners, speeds = self.shape
        return f"Grid({bodies} bodies, {partners} partners, {speeds} speeds)"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Grid) and self.to_dict() == other.to_dict()

    __hash__ = None  # type: ignore[assignment]

    @property
    def shape(self) -> tuple[int, int, int]:
        """Numbers of bodies, partners and speeds."""
        return len(self.bodies), len(self.against), self.speed.size

    @property
    def in_si(self) -> bool:
        """Whether the bodies have materials, so that speeds are in m/s."""
        return self.bodies[0].material is not None

    def cases(self) -> tuple[Case, ...]:
        """Each body with each partner, bodies first."""
        return self._cases

    def to_dict(self) -> dict[str, Any]:
        """Return all inputs in plain Python types, from which `from_dict` makes an equal grid."""
        return {
            "bodies": [describe(body) for body in self.bodies],
            "against": list(self.against),
            "speed": self.speed.tolist(),
            "tolerance": self.tolerance,
            "absolute": self.absolute,
        }

    @classmethod
    def from_dict(cls, given: Mapping[str, Any]) -> Grid:
        """Make a grid of the inputs as `to_dict` returns them, or as a file has them, with its `format`."""
        known = {"format", "bodies", "against", "speed", "tolerance", "absolute"}
        if isinstance(given, Mapping) and "format" in given:
            _formats.require("format", given["format"], _formats.GRID)
        if not isinstance(given, Mapping) or not {"bodies", "speed"} <= set(given) <= known:
            got = sorted(map(str, given)) if isinstance(given, Mapping) else given
            raise refusal("grid", got, "bodies and speed, and besides against, tolerance, absolute")
        return cls(**{name: value for name, value in given.items() if name != "format"})

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Grid:
        """Read a grid from a TOML file, whose keys are the arguments of this class (docs/sweeps.md).
        """
        import tomllib  # Python 3.11

        with open(path, "rb") as stream:
            try:
                given = tomllib.load(stream)
            except (ValueError, RecursionError) as error:  # also of integers with thousands of digits
                raise InvalidInput(f"grid: got '{os.fspath(path)}', allowed TOML ({error})") from None
        return cls.from_dict(given)

    def _found(self) -> Iterator[Case]:
        for (i, body), (j, partner) in itertools.product(enumerate(self.bodies), enumerate(self.against)):
            against = choose_against(body, beside(partner, body), (HardWall,))
            met = describe(against) if isinstance(against, Solid) else {"kind": "wall"}
            accuracy = {"tolerance": self.tolerance, "absolute": self.absolute}
            inputs: Specification = {"body": describe(body), "against": met, **accuracy}
            text = json.dumps(inputs, sort_keys=True, allow_nan=False)
            yield Case((i, j), body, against, inputs, hashlib.sha256(text.encode()).hexdigest()[:16])

    def _check(self) -> None:
        seen: dict[str, Case] = {}
        for case in self._cases:
            if case.key in seen:
                raise InvalidInput(f"grid: got {case.body!r} against {case.against!r} twice, allowed once")
            seen[case.key] = case
            with speeds_in_si(case.body):
                _core.check_curve(self.speed / speed_unit(case.body), self.tolerance, self.absolute, 1)
            refinable(case.body, case.against)  # refuses ratios out of range


def _first(given: Specification) -> Body:
    return choose_body(make("bodies", given), None, rigid=True)


def _several(name: str, given: Any) -> list[tuple[Any, Choices]]:
    """One body or partner or several, given as objects, words or mappings, each with what is left to choose."""
    several = given if isinstance(given, (list, tuple, np.ndarray)) else [given]
    return [(each, choices(name, each)) for each in several]


def _count(several: list[tuple[Any, Choices]]) -> int:
    return sum(math.prod(map(len, left)) for _, left in several)


def _require_moderate(bodies: int, partners: int, speeds: int) -> None:
    """Refuse a grid that is too large before its cases are made."""
    cases, values = bodies * partners, bodies * partners * speeds
    for got, name, most in ((cases, "cases", MOST_CASES), (values, "values", MOST_VALUES)):
        if got > most:
            of = f"{bodies} bodies, {partners} partners, {speeds} speeds"
            raise InvalidInput(f"grid: got {got} {name} ({of}), allowed {most} (make several grids of it)")


def _specifications(name: str, several: list[tuple[Any, Choices]]) -> Iterator[Specification]:
    if _count(several) == 0:
        raise InvalidInput(f"{name}: got none, allowed at least one (the grid is empty)")
    for each, left in several:
        yield from expanded(name, each, left)


def _speeds(given: Any) -> NDArray[np.float64]:
    values = numbers("speed", _core.series("speed", given) if isinstance(given, str) else given).ravel()
    if values.size == 0:
        raise InvalidInput("speed: got none, allowed at least one (the grid is empty)")
    each, count = np.unique(values[~np.isnan(values)], return_counts=True)
    if np.any(count > 1):
        raise InvalidInput(f"speed: got {each[count > 1].tolist()[0]!r} twice, allowed once")
    values.flags.writeable = False
    return values
