"""The cases of a sweep: which bodies meet what, how, and what is computed of them."""

from __future__ import annotations

import itertools
import os
from types import MappingProxyType
from typing import Any, Iterator, Mapping, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss._arguments import integer, open_file, refusal
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body
from stoss.bodies._encounter import choose_against, choose_body
from stoss.bodies._kinds import KINDS, Specification
from stoss.bodies._solid import describe
from stoss.bodies._walls import Unbounded, Wall
from stoss.export import _files
from stoss.sweeps._choice import choose_computation
from stoss.sweeps._computation import Case, Computation, case_of
from stoss.sweeps._given import axis, count, require_moderate, several, specifications
from stoss.sweeps._row_cases import count_of, documents_of, row_case, row_of
from stoss.sweeps._specification import beside, make, with_folder

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
        row (mapping, path, or a list of these): In place of both, bodies on a line, as in `stoss.row`: a
            document of a row, whose `bodies` may have lists and series as above, or the name of its
            file. ``count`` repeats them to so many, and ``moving`` (1) of them have the speed, from the
            left. Values are those of each body: `velocity_after` and the quantities of a `Row`.
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
        >>> stoss.Grid(row={"bodies": [{"kind": "sphere", "poisson": [0.2, 0.3]}], "count": 5}, speed=[0.01, 0.1])
        Grid(2 rows, 2 speeds, 5 bodies in each)
    """

    def __init__(
        self,
        *,
        bodies: Given | Any = None,
        against: Given | Any = None,
        row: Mapping[str, Any] | str | os.PathLike[str] | Any = None,
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
            "bodies": bodies, "against": against, "row": row,
            "speed": speed, "tolerance": tolerance, "absolute": absolute, "friction": friction, "angle": angle,
            "tangential": tangential, "spin": spin, "second_spin": second_spin, "temperature": temperature,
            "samples": samples, "highest": highest, "seed": seed, "error": error,
        }  # fmt: skip
        self.computation: Computation = choose_computation(given)
        self.tolerance, self.absolute = map(self.computation.accuracy.get, ("tolerance", "absolute"))
        axes = {name: axis(name, given[name]) for name in self.computation.axes if given.get(name) is not None}
        if "sample" in self.computation.axes:
            axes["sample"] = np.arange(1000 if samples is None else integer("samples", samples), dtype=np.float64)
        self._cases: tuple[Case, ...]
        self.axes: Mapping[str, NDArray[np.float64]]
        self.against: tuple[Specification, ...]
        if row is None:
            self._take_pairs(bodies, "wall" if against is None else against, axes)
        else:
            self._take_rows(row, axes)
        self._check()

    def _take_pairs(self, bodies: Any, against: Any, axes: dict[str, NDArray[np.float64]]) -> None:
        first, second = several("bodies", bodies), several("against", against)
        require_moderate(count(first), count(second), {name: each.size for name, each in axes.items()})
        self.axes = MappingProxyType(axes)
        self.bodies: tuple[Body, ...] = tuple(_first(each) for each in specifications("bodies", first))
        self.against = tuple(specifications("against", second))
        self._require_units()
        self._cases = tuple(self._found())

    def _take_rows(self, row: Any, axes: dict[str, NDArray[np.float64]]) -> None:
        documents = documents_of(row)
        axes["number"] = np.arange(count_of(documents), dtype=np.float64)
        require_moderate(len(documents), 1, {name: each.size for name, each in axes.items()})
        self.axes = MappingProxyType(axes)
        accuracy, rows = self.computation.accuracy, [row_of(each) for each in documents]
        self._cases = tuple(row_case((i, 0), each, accuracy) for i, each in enumerate(rows))
        self.bodies = tuple(case.body for case in self._cases)
        self.against = ({"kind": "row"},)
        self._require_units()

    def _require_units(self) -> None:
        if len({body.material is None for body in self.bodies}) > 1:
            raise InvalidInput.out_of_range(
                "bodies", "some with a material", "all or none", "speeds are in m/s or in c"
            )

    def __repr__(self) -> str:
        bodies, partners, *lengths = self.shape
        if "number" in self.axes:
            return f"Grid({bodies} rows, {lengths[0]} speeds, {lengths[1]} bodies in each)"
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
        along = {name: each.tolist() for name, each in self.axes.items() if name not in ("sample", "number")}
        samples = {"samples": self.axes["sample"].size} if "sample" in self.axes else {}
        bodies = {"bodies": [describe(body) for body in self.bodies], "against": list(self.against)}
        if "number" in self.axes:
            bodies = {"row": [case.inputs["row"] for case in self._cases]}
        return {**bodies, **along, **samples, **self.computation.accuracy}

    @classmethod
    def from_dict(cls, given: Mapping[str, Any]) -> Grid:
        """Make a grid of the inputs as `to_dict` returns them, or as a file has them, with its `format`."""
        known = set(cls.__init__.__kwdefaults__ or {}) | {"format", "speed"}
        if isinstance(given, Mapping) and "format" in given:
            _files.require("format", given["format"], _files.GRID)
        there = set(given) if isinstance(given, Mapping) else set()
        if not ("speed" in there and {"bodies", "row"} & there and there <= known):
            got = sorted(map(str, given)) if isinstance(given, Mapping) else given
            besides = ", ".join(sorted(known - {"format", "bodies", "row", "speed"}))
            raise refusal("grid", got, f"bodies or row, and speed, and besides {besides}")
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
        if isinstance(given.get("row"), str):
            beside["row"] = os.path.join(folder, given["row"])
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
            contact = self.computation.contact(case.body, case.against)
            self.computation.check(case.body, contact, tuple(self.axes.values()))


def _of_file(given: Specification) -> bool:
    return given["kind"] in KINDS and KINDS[given["kind"]].from_file


def _first(given: Specification) -> Body:
    return choose_body(make("bodies", given), None, rigid=True)
