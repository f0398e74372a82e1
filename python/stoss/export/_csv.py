"""Reads the CSV that stoss has written."""

from __future__ import annotations

import csv
import dataclasses
import math
import os
import re
import reprlib
from types import MappingProxyType
from typing import Any, Iterator, Mapping
import zlib

import numpy as np
from numpy.typing import NDArray

from stoss._errors import InvalidInput
from stoss.export import _files, _tables
from stoss.export._tables import UNKNOWN, with_error

AXES = {"restitution": "speed", "function": "speed", "quasistatic": "speed", "slow impact": "speed",
        "rayleigh": "speed", "modes": "mode", "trajectory": "time", "bounce": "number", "rod_chain": "time",
        "distribution": "sample", "atlas": "speed", "predict": "speed", "row": "number",
        "row_impact": "time", "pulse": "time", "seismogram": "time"}  # fmt: skip
"""What the rows of a kind of file run along."""

WHOLE = frozenset(
    "order index modes runs steps contacts nodes sample number collisions of cutoff_level impacts pair touching case".split()
)
"""Columns of integers, where all others have numbers with a fraction."""

COLUMN = re.compile(r"([^\[\],\"]+)(?:\[([^\]]*)\])?")


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Table(Mapping[str, NDArray[Any]]):
    """A file that stoss has written: columns with units, and what made them.

    ``table["restitution"]`` is a column, ``table[3]`` a row as a dict, and a slice or flags give
    the table of these rows. As of a dict, ``list(table)`` and ``len(table)`` are those of the
    columns.

    Attributes:
        kind (str): What wrote it: restitution, modes, impact, trajectory, …
        version (str): The version of stoss.
        inputs (mapping of str to str): What made it, as in the file.
        units (mapping of str to str): Units of the columns that have one.
        columns (mapping of str to ndarray): By name; an error that is unknown is infinite.
    """

    kind: str
    version: str
    inputs: Mapping[str, str]
    units: Mapping[str, str]
    columns: Mapping[str, NDArray[Any]]

    @property
    def size(self) -> int:
        """Number of rows."""
        return next((each.size for each in self.columns.values()), 0)

    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            return self.columns[key]
        parts = _tables.rows(self.columns, key, self.size)
        if any(np.ndim(part) == 0 for part in parts.values()):
            return {name: part.item() if isinstance(part, np.generic) else part for name, part in parts.items()}
        return dataclasses.replace(self, columns=MappingProxyType(parts))

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def __repr__(self) -> str:
        return f"Table({self.kind}, {self.size} rows: {', '.join(self.columns)})"

    def __reduce__(self) -> Any:
        return _table, (self.kind, self.version, dict(self.inputs), dict(self.units), dict(self.columns))

    def _repr_html_(self) -> str:
        return _tables.table(f"{self.kind}, {self.size} rows", self.columns, self.units, with_error)

    def to_dataframe(self) -> Any:
        """As `Result.to_dataframe`, with the inputs of the file in its attrs."""
        return _tables.dataframe(self.columns, self.units, self.inputs)

    def to_xarray(self) -> Any:
        """As `Result.to_xarray`, with the inputs of the file as attributes."""
        return _tables.dataset(self.columns, (AXES.get(self.kind, "row"),), self.units, self.inputs)


def read_csv(path: str | os.PathLike[str]) -> Table:
    """Read a CSV that `to_csv` of a result or the command has written.

    Parameters:
        path (str or path): The file; one that is damaged, or of another origin, or of a stoss
            whose version begins with a higher number, is refused.

    Examples:
        >>> stoss.restitution(poisson=0.33, speed=[0.01, 0.1]).to_csv("curve.csv")
        >>> table = stoss.read_csv("curve.csv")
        >>> table["restitution"].round(4), table.units["speed"], table.inputs["body"]
        (array([0.9842, 0.947 ]), 'c', 'Disk(poisson=0.33)')
    """
    name = os.fspath(path)
    with open(name, encoding="utf-8", newline="") as stream:
        try:
            text = stream.read()
        except UnicodeDecodeError:
            raise _foreign(name) from None
    first = re.match(rf"# stoss ({_files.VERSION}): (.+)\n", text, re.ASCII)
    if not first:
        raise _foreign(name)
    _files.require_readable("path", name, first.group(1))
    if not text.endswith("\n"):
        raise _damaged(name, "its last line is not whole")
    lines = text.splitlines()[1:]
    head = [line for line in lines if line.startswith("#")]
    parts = (line[2:].partition(":") for line in head)
    inputs = {key: value.removeprefix(" ") for key, _, value in parts}
    body = [line for line in lines if not line.startswith("#")]
    try:
        rows = list(csv.reader(body))
    except csv.Error as problem:
        raise _damaged(name, str(problem)) from None
    if not rows:
        raise _damaged(name, "it has no line of column names")
    columns, units = _named(name, rows[0])
    for number, row in enumerate(rows[1:], len(lines) - len(body) + 3):
        if len(row) != len(columns):
            raise _damaged(name, f"line {number} has {len(row)} cells, not {len(columns)}")
    if columns[-1] == CHECKSUM:
        for line, row in zip(body[1:], rows[1:]):
            if f"{zlib.crc32(line.rpartition(',')[0].encode()):08x}" != row[-1]:
                raise _damaged(name, f"the checksum of row {reprlib.repr(line)} is that of another")
        columns, rows = columns[:-1], [row[:-1] for row in rows]
    cells = zip(*rows[1:]) if len(rows) > 1 else [() for _ in columns]
    arrays = {column: _array(name, column, values) for column, values in zip(columns, cells)}
    return _table(first.group(2), first.group(1), inputs, units, arrays)


CHECKSUM = "checksum"
"""Last column of a file that a run may continue; it is compared and left out."""


def _table(
    kind: str, version: str, inputs: dict[str, str], units: dict[str, str], columns: dict[str, NDArray[Any]]
) -> Table:
    for each in columns.values():
        each.flags.writeable = False
    return Table(kind, version, MappingProxyType(inputs), MappingProxyType(units), MappingProxyType(columns))


def _named(path: str, cells: list[str]) -> tuple[list[str], dict[str, str]]:
    """Names of the columns, and units of those that have one."""
    units: dict[str, str] = {}
    names: list[str] = []
    for cell in cells:
        found = COLUMN.fullmatch(cell)
        if not found or found.group(1) in names:
            raise _damaged(path, f"{reprlib.repr(cell)} is no name of a column, or there twice")
        names.append(found.group(1))
        if found.group(2):
            units[found.group(1)] = found.group(2)
    return names, units


def _array(path: str, name: str, cells: tuple[str, ...] | list[str]) -> NDArray[Any]:
    """A column with the type of its cells."""
    if cells and set(cells) <= {"true", "false"}:
        return np.array([cell == "true" for cell in cells])
    if name in WHOLE and all(re.fullmatch(r"[-+]?\d+", cell) for cell in cells):
        if max(map(len, cells), default=0) > 18:
            raise _damaged(path, f"a number in column {name} is too large")
        return np.array(cells, dtype=np.int64)
    values = [_number(cell) for cell in cells]
    wrong = [cell for cell, value in zip(cells, values) if value is None]
    if not wrong:
        return np.array(values, dtype=np.float64)
    if len(wrong) == len(cells):  # words
        return np.array(cells, dtype=object)
    raise _damaged(path, f"{reprlib.repr(wrong[0])} in column {reprlib.repr(name)} is no number")


def _number(cell: str) -> float | None:
    if cell == UNKNOWN:
        return math.inf
    try:
        return float(cell)
    except ValueError:
        return None


def _foreign(path: str) -> InvalidInput:
    return InvalidInput.out_of_range("path", repr(path), "a CSV that stoss has written", "its first line says so")


def _damaged(path: str, what: str) -> InvalidInput:
    return InvalidInput.out_of_range(
        "path", f"{path!r}, which is damaged ({what})", "a whole CSV that stoss has written"
    )
