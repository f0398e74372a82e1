"""Tables of measurements, as files or as columns by name."""

from __future__ import annotations

import csv
import io
import math
import os
import re
from typing import Any, Mapping, Union

import numpy as np
from numpy.typing import NDArray

from stoss._arguments import open_file, refusal
from stoss._errors import InvalidInput

Given = Union[str, "os.PathLike[str]", Mapping[str, Any]]
"""A CSV file, or columns by name."""

VALUES: Mapping[str, tuple[str, str]] = {
    "restitution": ("restitution", ""), "tangential_restitution": ("tangential restitution", ""),
    "contact_time": ("contact time", "s"), "peak_force": ("peak force", "N"),
}  # fmt: skip
"""What a row may say of an impact: words and unit."""

UNITS: Mapping[str, str] = {
    "speed": "m/s", "angle": "degrees", "drop_height": "m", "rebound_height": "m", "time": "s",
    **{name: unit for name, (_, unit) in VALUES.items()},
}  # fmt: skip
"""Columns, with their units."""

LARGEST_SIZE, MOST_ROWS = 10_000_000, 1000
UNCERTAINTY = "_uncertainty"


def columns_of(given: Given) -> dict[str, NDArray[np.float64]]:
    """Columns of numbers, of one length; an empty cell is NaN."""
    if isinstance(given, (str, os.PathLike)):
        columns = _read(os.fspath(given))
    elif isinstance(given, Mapping) or hasattr(given, "columns"):
        columns = {str(name): np.atleast_1d(_floats(str(name), given[name])) for name in given}
    else:
        raise refusal("data", given, "a CSV file, or columns by name")
    its = {_name(name): column for name, column in columns.items() if _name(name)}
    sizes = {name: column.size for name, column in its.items()}
    if not its or "speed" not in its and "drop_height" not in its and "time" not in its:
        raise InvalidInput.out_of_range(
            "data",
            ", ".join(columns) or "no columns",
            "speed, drop_height or time among the columns",
            "columns: " + ", ".join(UNITS) + f", each with its {UNCERTAINTY[1:]}",
        )
    if len(set(sizes.values())) > 1:
        raise InvalidInput.out_of_range("data", f"columns of {sizes} rows", "columns of one length")
    if not 1 <= max(sizes.values()) <= MOST_ROWS:
        raise InvalidInput.out_of_range("data", f"{max(sizes.values())} rows", f"1 to {MOST_ROWS}")
    return its


def _name(column: str) -> str:
    """Name of a column that is known, without its unit; "" of another."""
    found = re.fullmatch(r"\s*([A-Za-z_ ]+?)\s*(?:\[(.*)\])?\s*", column)
    name = found[1].lower().replace(" ", "_") if found else ""
    own = name.removesuffix(UNCERTAINTY)
    if own not in UNITS or own in ("speed", "angle") and name != own:
        return ""
    if found and found[2] is not None and found[2].strip() != UNITS[own]:
        raise InvalidInput.out_of_range("data", f"{own} in {found[2]}", f"in {UNITS[own] or 'no unit'}", "all is in SI")
    return name


def _floats(name: str, values: Any) -> NDArray[np.float64]:
    try:
        return np.array(values, dtype=np.float64)
    except (TypeError, ValueError):
        return np.full(np.size(values), np.nan) if not _name(name) else _refuse(name, values)


def _refuse(name: str, values: Any) -> NDArray[np.float64]:
    raise refusal(name, values, "numbers")


def _read(path: str) -> dict[str, NDArray[np.float64]]:
    with open_file("data", path) as file:
        content = file.read(LARGEST_SIZE + 1)
    if len(content) > LARGEST_SIZE:
        raise InvalidInput.out_of_range("data", "a larger file", f"{LARGEST_SIZE} bytes at most")
    text = content.decode("utf-8-sig")
    rows = [row for row in csv.reader(io.StringIO(text)) if row and not row[0].lstrip().startswith("#")]
    if not rows:
        raise InvalidInput.out_of_range("data", "an empty file", "a line of names, then rows of numbers")
    head, *body = rows
    found: dict[str, NDArray[np.float64]] = {}
    for k, name in enumerate(head):
        if not _name(name):
            continue
        if name in found:
            raise InvalidInput.out_of_range("data", f"two columns {name}", "each once")
        column = np.full(len(body), np.nan)
        for i, row in enumerate(body):
            cell = row[k].strip() if k < len(row) else ""
            try:
                column[i] = float(cell) if cell else math.nan
            except ValueError:
                raise InvalidInput.out_of_range(
                    _name(name), f"{cell!r} in row {i + 1}", "a number, or nothing"
                ) from None
        found[name] = column
    return found or {name: np.empty(0) for name in head}
