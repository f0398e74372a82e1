"""The cases of a sweep: which bodies meet what, how, and what is computed of them."""

from __future__ import annotations

import itertools
import math
import os
from types import MappingProxyType
from typing import Any, Iterator, Mapping, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import integer, numbers, open_file, refusal
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body
from stoss.bodies._encounter import choose_against, choose_body, refinable
from stoss.bodies._kinds import KINDS, Specification
from stoss.bodies._solid import describe
from stoss.bodies._walls import Unbounded, Wall
from stoss.export import _files
from stoss.sweeps._computation import Case, Computation, case_of, choose_computation
from stoss.sweeps._specification import Choices, beside, choices, expanded, make, with_folder

MOST_CASES = 100_000  # bodies times partners
MOST_VALUES = 1_000_000

Given = Union[Body, Unbounded, Wall, str, Mapping[str, Any]]


class Grid:
    """The cases of a sweep: each of the bodies meets each of the partners at each of the speeds.

    With `friction` they meet at an angle, as in `stoss.oblique`: at each speed, angle, spin and
    coefficient. With `temperature` they are the samples of ensembles, as in
    `stoss.restitution_distribution`: so many at each speed and temperature. Numbers that may be
    several are arrays, or series as ``'log:1e-4:0.1:30'``.

    Parameters:
        bodies (Disk, Sphere, Rod or ModalBody, mapping, or a sequence of them): The first bodies, all
            with a material or all without. A mapping has the `kind` ``'disk'``, ``'sphere'`` or
            ``'rod'`` and the arguments of that class, or the `kind` ``'modal'`` and a `file`; where
            an argument is a list or a series as ``'lin:0:0.4:5'``, it stands for a body of each
            number.
        against (like bodies, optional): What they meet: 'wall', 'same', a HardWall, a body, a HalfSpace
            or HalfPlane, a mapping, or a sequence of them. A mapping that names no Poisson's ratio takes
            that of the first body.
        speed (array_like): Speed of approach, c of the first body (with materials: m/s).
        tolerance, absolute (float, optional): As of `stoss.restitution`, or of `stoss.oblique`.
        friction, angle, tangential, spin, second_spin (array_like, optional): As of `stoss.oblique`.
        temperature (array_like, optional): As of `stoss.restitution_distribution`.
        samples, highest, seed, error (float or int, optional): As there.

    Raises:
        InvalidInput: For an empty grid, one of more than 100 000 cases or 1 000 000 values, for
            bodies that cannot meet, for a case or a number that comes twice, and for numbers out of
            range.

    Examples:
        >>> grid = stoss.Grid(
        ...     bodies={"kind": "sphere", "poisson": [0.2, 0.3]},
        ...     against=["wall", {"kind": "sphere", "radius": [1, 2]}],
        ...     speed="log:1e-3:1e-1:5",
        ... )
        >>> grid.shape
        (2, 3, 5)
        >>> stoss.Grid(bodies=stoss.Sphere(poisson=0.3), speed=0.01, friction=[0.1, 0.3], angle="lin:0:80:9")
        Grid(1 bodies, 1 partners, 1 speeds, 9 angles, 2 frictions)
    """

    def __init__(
        self,
        *,
        bodies: Given | Any,
        against: Given | Any = "wall",
        speed: ArrayLike | str,
        tolerance: float | None = None,
        absolute: float | None = None,
        friction: ArrayLike | str | None = None,
        angle: ArrayLike | str | None = None,
        tangential: ArrayLike | str | None = None,
        spin: ArrayLike | str | None = None,
        second_spin: ArrayLike | str | None = None,
        temperature: ArrayLike | str | None = None,
        samples: int | None = None,
        highest: float | None = None,
        seed: int | None = None,
        error: float | None = None,
    ) -> None:
        given: dict[str, Any] = {
            "speed": speed, "tolerance": tolerance, "absolute": absolute, "friction": friction, "angle": angle,
            "tangential": tangential, "spin": spin, "second_spin": second_spin, "temperature": temperature,
            "samples": samples, "highest": highest, "seed": seed, "error": error,
        }  # fmt: skip
        first, second = _several("bodies", bodies), _several("against", against)
        self.computation: Computation = choose_computation(given)
        self.tolerance, self.absolute = map(self.computation.accuracy.get, ("tolerance", "absolute"))
        count = 1000 if samples is None else integer("samples", samples)
        axes = {name: _axis(name, given[name]) for name in self.computation.axes if name != "sample"}
        lengths = {name: each.size for name, each in axes.items()}
        if "sample" in self.computation.axes:
            lengths["sample"] = count
        _require_moderate(_count(first), _count(second), lengths)
        if "sample" in lengths:
            axes["sample"] = np.arange(count, dtype=np.float64)
        self.axes: Mapping[str, NDArray[np.float64]] = MappingProxyType(axes)
        self.bodies: tuple[Body, ...] = tuple(_first(each) for each in _specifications("bodies", first))
        self.against: tuple[Specification, ...] = tuple(_specifications("against", second))
        if len({body.material is None for body in self.bodies}) > 1:
            raise InvalidInput.out_of_range(
                "bodies", "some with a material", "all or none", "speeds are in m/s or in c"
            )
        self._cases = tuple(self._found())
        self._check()

    def __repr__(self) -> str:
        bodies, partners, *lengths = self.shape
        along = "".join(f", {length} {name}s" for name, length in zip(self.axes, lengths))
        return f"Grid({bodies} bodies, {partners} partners{along})"

    def __reduce__(self) -> tuple[Any, ...]:
        return Grid.from_dict, (self.to_dict(),)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Grid) and self.to_dict() == other.to_dict()

    __hash__ = None  # type: ignore[assignment]

    @property
    def shape(self) -> tuple[int, ...]:
        """Numbers of bodies, partners and speeds, and of the other axes."""
        return len(self.bodies), len(self.against), *(each.size for each in self.axes.values())

    @property
    def dimensions(self) -> tuple[str, ...]:
        """What these are: body, against, speed and the other axes."""
        return "body", "against", *self.axes

    @property
    def speed(self) -> NDArray[np.float64]:
        """The speeds of approach, as they were given."""
        return self.axes["speed"]

    @property
    def in_si(self) -> bool:
        """Whether the bodies have materials, so that speeds are in m/s."""
        return self.bodies[0].material is not None

    def cases(self) -> tuple[Case, ...]:
        """Each body with each partner, bodies first."""
        return self._cases

    def to_dict(self) -> dict[str, Any]:
        """Return all inputs in plain Python types, from which `from_dict` makes an equal grid."""
        along = {name: each.tolist() for name, each in self.axes.items() if name != "sample"}
        samples = {"samples": self.axes["sample"].size} if "sample" in self.axes else {}
        bodies = {"bodies": [describe(body) for body in self.bodies], "against": list(self.against)}
        return {**bodies, **along, **samples, **self.computation.accuracy}

    @classmethod
    def from_dict(cls, given: Mapping[str, Any]) -> Grid:
        """Make a grid of the inputs as `to_dict` returns them, or as a file has them, with its `format`."""
        known = set(cls.__init__.__kwdefaults__ or {}) | {"format", "bodies", "speed"}
        if isinstance(given, Mapping) and "format" in given:
            _files.require("format", given["format"], _files.GRID)
        if not isinstance(given, Mapping) or not {"bodies", "speed"} <= set(given) <= known:
            got = sorted(map(str, given)) if isinstance(given, Mapping) else given
            besides = ", ".join(sorted(known - {"format", "bodies", "speed"}))
            raise refusal("grid", got, f"bodies and speed, and besides {besides}")
        return cls(**{name: value for name, value in given.items() if name != "format"})

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Grid:
        """Read a grid from a TOML file, whose keys are the arguments of this class (docs/howto/sweeps.md).

        The file of a body is sought from the folder of this one.
        """
        import tomllib  # Python 3.11

        with open_file("grid", path) as stream:
            try:
                given = tomllib.load(stream)
            except (ValueError, RecursionError) as error:  # also of integers with thousands of digits
                raise InvalidInput.out_of_range("grid", f"'{os.fspath(path)}'", "TOML", error) from None
        folder = os.path.dirname(os.fspath(path))
        beside = {name: with_folder(given[name], folder) for name in ("bodies", "against") if name in given}
        return cls.from_dict({**given, **beside})

    def _found(self) -> Iterator[Case]:
        accuracy = self.computation.accuracy
        of_files = [make("against", each) if _of_file(each) else None for each in self.against]
        for (i, body), (j, partner) in itertools.product(enumerate(self.bodies), enumerate(self.against)):
            against = choose_against(body, of_files[j] or beside(partner, body))
            yield case_of((i, j), body, against, accuracy)

    def _check(self) -> None:
        seen: set[str] = set()
        for case in self._cases:
            if case.key in seen:
                raise InvalidInput.out_of_range("grid", f"{case.body!r} against {case.against!r} twice", "once")
            seen.add(case.key)
            # `refinable` refuses ratios out of range.
            self.computation.check(case.body, refinable(case.body, case.against), tuple(self.axes.values()))


def _of_file(given: Specification) -> bool:
    return given["kind"] in KINDS and KINDS[given["kind"]].from_file


def _first(given: Specification) -> Body:
    return choose_body(make("bodies", given), None, rigid=True)


def _several(name: str, given: Any) -> list[tuple[Any, Choices]]:
    """One body or partner or several, given as objects, words or mappings, each with what is left to choose."""
    several = given if isinstance(given, (list, tuple, np.ndarray)) else [given]
    return [(each, choices(name, each)) for each in several]


def _count(several: list[tuple[Any, Choices]]) -> int:
    return sum(math.prod(map(len, left)) for _, left in several)


def _require_moderate(bodies: int, partners: int, lengths: Mapping[str, int]) -> None:
    """Refuse a grid that is too large before its cases are made."""
    cases, values = bodies * partners, bodies * partners * math.prod(lengths.values())
    for got, name, most in ((cases, "cases", MOST_CASES), (values, "values", MOST_VALUES)):
        if got > most:
            of = ", ".join([f"{bodies} bodies, {partners} partners", *(f"{n} {each}s" for each, n in lengths.items())])
            raise InvalidInput.out_of_range("grid", f"{got} {name} ({of})", most, "make several grids of it")


def _specifications(name: str, several: list[tuple[Any, Choices]]) -> Iterator[Specification]:
    if _count(several) == 0:
        raise InvalidInput.out_of_range(name, "none", "at least one", "the grid is empty")
    for each, left in several:
        yield from expanded(name, each, left)


def _axis(name: str, given: Any) -> NDArray[np.float64]:
    """The numbers along an axis, each once."""
    values = numbers(name, _core.series(name, given) if isinstance(given, str) else given).ravel()
    if values.size == 0:
        raise InvalidInput.out_of_range(name, "none", "at least one", "the grid is empty")
    each, count = np.unique(values[~np.isnan(values)], return_counts=True)
    if np.any(count > 1):
        raise InvalidInput.out_of_range(name, f"{each[count > 1].tolist()[0]!r} twice", "once")
    values.flags.writeable = False
    return values
