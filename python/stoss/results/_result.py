"""What all results have in common: to_dict, to_csv and the other formats, and a line that says the essential."""

from __future__ import annotations

import dataclasses
import importlib
import os
import re
from typing import Any, Callable, ClassVar, Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import arranged
from stoss._documentation import documented, with_fields
from stoss.bodies._state import shown_state
from stoss.export import _tables
from stoss.export._files import write_lines
from stoss.export._tables import cell, known, plain, with_error
from stoss.results._quantities import QUANTITIES

Column = NDArray[Any]


def unit(dimension: str, *, body: str, si: bool) -> str:
    """Name of the unit of a dimension: of a disk, a rod or a sphere, or in SI."""
    return _core.units(body, si)[dimension]


def picture(said: str, name: str = "plot") -> Callable[..., Any]:
    """The method of that name, which draws the result in `ax`, matplotlib Axes (None: a new figure)."""

    def drawn(self: Result, ax: Any = None) -> Any:
        return self._draw(ax, name)

    drawn.__name__, drawn.__doc__ = name, said
    return drawn


class Result:
    """Base of all results: frozen, with the inputs that made them."""

    _name: ClassVar[str] = ""
    _kind: ClassVar[str] = ""  # of the core's quantities, from which columns have their order and units
    _given: ClassVar[Mapping[str, str]] = {}  # dimensions of inputs that are columns too, before all others
    _units: ClassVar[Mapping[str, str]] = {}  # of columns of which the core knows nothing
    _axis: ClassVar[str] = "row"  # along which its columns run
    _told: ClassVar[tuple[str, ...]] = ()  # what made it, for the head of the CSV; what is None is left out

    def __init_subclass__(cls) -> None:
        with_fields(cls)

    def _draw(self, ax: Any, name: str) -> Any:
        """Matplotlib is only loaded when a picture is asked for."""
        pictures = importlib.import_module("stoss.plot").PICTURES
        return next(pictures[kind, name] for kind in type(self).__mro__ if (kind, name) in pictures)(self, ax)

    def to_dict(self) -> dict[str, Any]:
        """Return all that the result holds in plain Python types, ready for json.

        An error that is unknown is the word "unknown"; in the arrays it is infinite.
        """
        told, computed = plain(self), self._dimensions().keys() - self._given.keys()
        made_it = {name: each for name, each in told.items() if name not in computed}
        return {**made_it, **told, **plain(self._derived())}

    @documented
    def to_csv(self, path: str | os.PathLike[str]) -> None:
        """Write the result as CSV with all digits.

        Column names carry the units, and lines that start with # say what made the result. An error
        that is unknown is the word "unknown". The file appears whole or not at all.
        """
        write_lines(path, self._lines())

    def to_dataframe(self) -> Any:
        """Return the columns of `to_csv` as a table of pandas, with units and inputs in its attrs."""
        columns = self._columns()
        return _tables.dataframe(columns, self._units_of(columns), self._inputs())

    def to_xarray(self) -> Any:
        """Return the columns of `to_csv` as a data set of xarray, with units as attributes.

        Its dimension is what the result runs along: speed, mode, time, …; of `restitution` with
        Poisson's ratios down and speeds across there are two.
        """
        columns, dimensions = self._arranged_columns()
        return _tables.dataset(columns, dimensions, self._units_of(columns), self._inputs())

    def _repr_html_(self) -> str:
        columns = self._columns()
        return _tables.table(repr(self), columns, self._units_of(columns), with_error)

    def _columns(self) -> dict[str, Column]:
        """All columns, of one length."""
        return {key: np.asarray(column) for key, column in (self._table() | self._derived()).items()}

    def _arranged_columns(self) -> tuple[dict[str, Column], tuple[str, ...]]:
        """The columns, and the names of their dimensions."""
        return {key: column.ravel() for key, column in self._columns().items()}, (self._axis,)

    def _units_of(self, columns: Mapping[str, Any]) -> dict[str, str]:
        return {key: self._unit(key) for key in columns if self._unit(key)}

    def _lines(self) -> Iterator[str]:
        """The lines of the CSV, some thousand rows at a time."""
        yield from (f"# {line}\n" for line in self._made_by())
        table = self._columns()
        yield ",".join(f"{key}[{self._unit(key)}]" if self._unit(key) else key for key in table) + "\n"
        many = 4096
        for first in range(0, min(column.size for column in table.values()), many):
            rows = slice(first, first + many)
            columns = [known(key, column.flat[rows].tolist()) for key, column in table.items()]
            yield from (",".join(cell(value) for value in row) + "\n" for row in zip(*columns))

    def _made_by(self) -> list[str]:
        """What says in a file where it comes from."""
        return [f"stoss {_core.version}: {self._name}", *(f"{key}: {value}" for key, value in self._inputs().items())]

    @classmethod
    def _dimensions(cls) -> dict[str, str]:
        """Dimensions of all that the result may show, in order."""
        return {**cls._given, **QUANTITIES.get(cls._kind, {})}

    def _kind_of_body(self) -> str:
        """Whose units they are."""
        return "disk"

    def _kinds_of_bodies(self) -> set[str]:
        """The same where they may be of several kinds."""
        return {self._kind_of_body()}

    def _unit(self, name: str) -> str:
        """Unit of a column; "" of a pure number."""
        if name in self._units:
            return self._units[name]
        own = re.sub(r"_si(?=$|_error$)", "", name)
        dimension = self._dimensions().get(own, "")
        return " or ".join(sorted({unit(dimension, body=each, si=own != name) for each in self._kinds_of_bodies()}))

    def _derived(self) -> dict[str, Any]:
        """Further quantities that follow from the fields."""
        return {}

    def _inputs(self) -> dict[str, Any]:
        """What made the result, for the head of the CSV."""
        told = {name: getattr(self, name) for name in self._told}
        if told.get("state") is not None:
            told["state"] = shown_state(told["state"])
        return {name: value for name, value in told.items() if value is not None}

    def _selected(self, key: Any, shape: tuple[int, ...]) -> dict[str, Any]:
        """The fields that are arrays of this shape, at an index, a slice or flags."""
        fields = {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}
        arrays = {name: each for name, each in fields.items() if isinstance(each, np.ndarray) and name != "state"}
        parts = {name: np.array(np.broadcast_to(each, shape)[key]) for name, each in arrays.items()}
        return {name: arranged(part, part.shape) for name, part in parts.items()}

    def _table(self) -> dict[str, Column]:
        """Columns of one length."""
        fields = {field.name for field in dataclasses.fields(self)}
        held = {name: getattr(self, name) for name in self._dimensions() if name in fields}
        return {name: np.asarray(each) for name, each in held.items() if each is not None}


class ArrayResult(Result):
    """A result of numbers, or of arrays of one shape: `len()` is that of the first axis, indices select as in numpy."""

    _first: ClassVar[str] = "restitution"  # a field of that shape

    def __len__(self) -> int:
        return _tables.sized(getattr(self, self._first))

    def __bool__(self) -> bool:
        return True

    def __getitem__(self, key: Any) -> Any:
        """The values at an index, a slice or flags, as numpy has them."""
        len(self)  # refuses a single value
        return dataclasses.replace(self, **self._part(key, np.shape(getattr(self, self._first))))

    def _part(self, key: Any, shape: tuple[int, ...]) -> dict[str, Any]:
        """The fields that are another for the values at an index."""
        return self._selected(key, shape)


class RowResult(Result):
    """A result whose fields are columns of one length: `len()` is their number, an index one row."""

    def __len__(self) -> int:
        return len(getattr(self, self._axis_column()))

    def __getitem__(self, key: Any) -> Any:
        """A row as a dict, or for a slice, an array of indices or of flags, the result with these rows alone."""
        names = [field.name for field in dataclasses.fields(self) if self._is_column(getattr(self, field.name))]
        parts = _tables.rows({name: getattr(self, name) for name in names}, key, len(self))
        if any(np.ndim(part) == 0 for part in parts.values()):
            return plain(parts)
        return dataclasses.replace(self, **parts)

    def _axis_column(self) -> str:
        return next(name for name in self._dimensions() if hasattr(self, name))

    def _is_column(self, value: Any) -> bool:
        return isinstance(value, np.ndarray) and value.ndim == 1 and not value.dtype.names and len(value) == len(self)


def columns(table: NDArray[Any]) -> dict[str, Column]:
    """The fields of a structured array, as views."""
    return {name: table[name] for name in table.dtype.names or ()}
