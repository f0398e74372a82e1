"""What all results have in common: to_dict, to_csv and the other formats, and a line that says the
essential."""

from __future__ import annotations

import abc
import dataclasses
import importlib
import math
import os
import re
from typing import Any, Callable, ClassVar, Iterator, Mapping, Union

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss.export import _tables
from stoss.export._files import write_lines
from stoss.results._quantities import QUANTITIES, unit

Number = Union[float, NDArray[np.float64]]
Column = NDArray[Any]


UNKNOWN = "unknown"
"""What stands in texts and files for an infinite error: one that is as large as its value."""


def known(name: str, value: Any) -> Any:
    """The value, or the word for an error that is unknown."""
    if isinstance(value, list):
        return [known(name, each) for each in value]
    return UNKNOWN if name.endswith("_error") and value == math.inf else value


def plain(value: Any) -> Any:
    """Convert to types that json and pickle of any Python know."""
    if isinstance(value, np.ndarray):
        return [dict(zip(value.dtype.names, row)) for row in value.tolist()] if value.dtype.names else value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    if isinstance(value, dict):
        return {key: known(key, plain(each)) for key, each in value.items()}
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        given = {field.name: getattr(value, field.name) for field in dataclasses.fields(value) if field.repr}
        return plain({name: each for name, each in given.items() if each is not None})
    return value


pictures: dict[type, Callable[[Any, Any], Any]] = {}
"""Draws the usual picture of each kind of result: stoss.plot registers its functions here."""


class Result(abc.ABC):
    """Base of all results: frozen, with the inputs that made them."""

    _name: ClassVar[str] = ""
    _kind: ClassVar[str] = ""  # of the core's quantities, from which columns have their order and units
    _given: ClassVar[Mapping[str, str]] = {}  # dimensions of inputs that are columns too, before all others
    _units: ClassVar[Mapping[str, str]] = {}  # of columns of which the core knows nothing
    _axis: ClassVar[str] = "row"  # along which its columns run

    def to_dict(self) -> dict[str, Any]:
        """Return all that the result holds in plain Python types, ready for json.

        An error that is unknown is the word "unknown"; in the arrays it is infinite.

        Returns
        -------
        dict
        """
        values: dict[str, Any] = plain(self) | plain(self._derived())
        return values

    def to_csv(self, path: str | os.PathLike[str]) -> None:
        """Write the result as CSV with all digits.

        Column names carry the units, and lines that start with # say what made the result. An error
        that is unknown is the word "unknown". The file appears whole or not at all.

        Parameters
        ----------
        path : str or path
            Where to; an existing file is replaced.

        Raises
        ------
        OSError
            If the file cannot be written.
        """
        write_lines(path, self._lines())

    def to_dataframe(self) -> Any:
        """Return the columns of `to_csv` as a table of pandas, with units and inputs in its attrs.

        Returns
        -------
        pandas.DataFrame

        Raises
        ------
        ImportError
            Without pandas.
        """
        columns = self._columns()
        return _tables.dataframe(columns, self._units_of(columns), self._inputs())

    def to_xarray(self) -> Any:
        """Return the columns of `to_csv` as a data set of xarray, with units as attributes.

        Its dimension is what the result runs along: speed, mode, time, …; of `restitution` with
        Poisson's ratios down and speeds across there are two.

        Returns
        -------
        xarray.Dataset

        Raises
        ------
        ImportError
            Without xarray.
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
        yield f"# stoss {_core.version}: {self._name}\n"
        yield from (f"# {key}: {value}\n" for key, value in self._inputs().items())
        table = self._columns()
        yield ",".join(f"{key}[{self._unit(key)}]" if self._unit(key) else key for key in table) + "\n"
        many = 4096
        for first in range(0, min(column.size for column in table.values()), many):
            rows = slice(first, first + many)
            columns = [known(key, column.flat[rows].tolist()) for key, column in table.items()]
            yield from (",".join(_cell(value) for value in row) + "\n" for row in zip(*columns))

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

    def _picture(self, ax: Any) -> Any:
        importlib.import_module("stoss.plot")
        return pictures[type(self)](self, ax)

    @abc.abstractmethod
    def _inputs(self) -> dict[str, Any]:
        """What made the result, for the head of the CSV."""

    def _table(self) -> dict[str, Column]:
        """Columns of one length."""
        fields = {field.name for field in dataclasses.fields(self)}
        return {name: np.asarray(getattr(self, name)) for name in self._dimensions() if name in fields}


def columns(table: NDArray[Any]) -> dict[str, Column]:
    """The fields of a structured array, as views."""
    return {name: table[name] for name in table.dtype.names or ()}


def _cell(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str) and ("," in value or '"' in value):
        return '"' + value.replace('"', '""') + '"'
    return repr(value) if isinstance(value, float) else str(value)


def with_error(value: float, error: float | None = None) -> str:
    """Write a number with the digits that its error leaves it.

    Parameters
    ----------
    value : float
    error : float, optional
        Two digits of it are written; infinite if it is unknown. Without one the number has six
        digits.

    Returns
    -------
    str

    Examples
    --------
    >>> stoss.with_error(0.947041, 0.0000523)
    '0.947041 ± 0.000052'
    >>> stoss.with_error(3.35, np.inf)
    '3.35 ± unknown'
    """
    if error == math.inf and math.isfinite(value):
        return f"{value:.6g} ± {UNKNOWN}"
    if error is None or not math.isfinite(error) or error <= 0.0 or not math.isfinite(value):
        return f"{value:.6g}" if error is None or not math.isnan(error) else f"{value:.6g} ± nan"
    digits = max(0, 1 - math.floor(math.log10(error)))
    return f"{value:.{digits}f} ± {error:.{digits}f}"


def span(values: Any) -> str:
    """A number, or the least and the maximum of several."""
    array = np.asarray(values)
    finite = array[np.isfinite(array)]
    if finite.size == 0:
        return "nan" if array.size else "none"
    low, high = float(finite.min()), float(finite.max())
    return brief_range(low, high)


def brief_range(low: float, high: float) -> str:
    """Two numbers, or one if they are equal."""
    return f"{low:.6g}" if low == high else f"{low:.6g} to {high:.6g}"
