"""Results for pandas, xarray, notebooks and lines of text."""

from __future__ import annotations

import dataclasses
import html
import math
from typing import Any, Callable, Mapping

import numpy as np

from stoss._errors import InvalidInput

UNKNOWN = "unknown"
"""What stands in texts and files for an infinite error: one that is as large as its value."""


def known(name: str, value: Any) -> Any:
    """The value, or the word for an error that is unknown."""
    if isinstance(value, list):
        return [known(name, each) for each in value]
    return UNKNOWN if name.endswith("_error") and value == math.inf else value


def plain(value: Any) -> Any:
    """Convert to types that json and pickle of any Python know."""
    if isinstance(value, np.ndarray) and value.dtype.names and value.ndim > 1:
        return [plain(each) for each in value]
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


def cell(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str) and ("," in value or '"' in value):
        return '"' + value.replace('"', '""') + '"'
    return repr(value) if isinstance(value, float) else str(value)


def with_error(value: float, error: float | None = None) -> str:
    """Write a number with the digits that its error leaves it.

    Parameters:
        value (float):
        error (float, optional): Two digits of it are written; infinite if it is unknown. Without
            one the number has six digits.

    Examples:
        >>> stoss.with_error(0.947041, 0.0000523)
        '0.947041 ± 0.000052'
        >>> stoss.with_error(3.35, np.inf)
        '3.35 ± unknown'
    """
    if error == math.inf and math.isfinite(value):
        return f"{value:.6g} ± {UNKNOWN}"
    if error is None or not math.isfinite(error) or error <= 0.0 or not math.isfinite(value):
        return f"{value:.6g}" if error is None or not math.isnan(error) else f"{value:.6g} ± nan"
    if max(abs(value), error) >= 1e9:  # where digits before the point would go on and on
        return f"{value:.6g} ± {error:.2g}"
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


SHOWN = 10  # rows of a table in a notebook


def dataframe(columns: Mapping[str, Any], units: Mapping[str, str], inputs: Mapping[str, Any]) -> Any:
    """A pandas.DataFrame with units and inputs in its attrs."""
    try:
        import pandas
    except ImportError:
        raise ImportError("to_dataframe needs pandas: pip install pandas, or apt install python3-pandas") from None
    frame = pandas.DataFrame({name: np.asarray(column).ravel() for name, column in columns.items()})
    frame.attrs.update(units=dict(units), inputs={key: str(value) for key, value in inputs.items()})
    return frame


def dataset(
    columns: Mapping[str, Any], dimensions: tuple[str, ...], units: Mapping[str, str], inputs: Mapping[str, Any]
) -> Any:
    """An xarray.Dataset with units as attributes of its variables and inputs as its own.

    A column along which a dimension of its name runs is the coordinate of that dimension.
    """
    try:
        import xarray
    except ImportError:
        raise ImportError("to_xarray needs xarray: pip install xarray, or apt install python3-xarray") from None
    variables, coordinates = {}, {}
    for name, column in columns.items():
        array = np.asarray(column)
        attributes = {"units": units[name]} if units.get(name) else {}
        if name in dimensions:
            axis = dimensions.index(name)
            others = tuple(k for k in range(array.ndim) if k != axis)
            along = np.moveaxis(array, axis, 0).reshape(array.shape[axis], -1)[:, :1].ravel() if others else array
            coordinates[name] = ((name,), along, attributes)
        else:
            variables[name] = (dimensions[: array.ndim], array, attributes)
    own = {key: str(value) for key, value in inputs.items()}
    return xarray.Dataset(variables, coordinates, own)


def table(
    title: str, columns: Mapping[str, Any], units: Mapping[str, str], written: Callable[[float, float | None], str]
) -> str:
    """A compact table in HTML: a title, columns with units, errors next to their values, at most some rows."""
    arrays = {name: np.asarray(column).ravel() for name, column in columns.items()}
    names = [name for name in arrays if name.removesuffix("_error") not in set(arrays) - {name}]
    size = min((array.size for array in arrays.values()), default=0)
    half = SHOWN // 2
    rows: list[int | None] = [*range(size)] if size <= SHOWN else [*range(half), None, *range(size - half, size)]
    head = "".join(f"<th>{_escaped(f'{name} [{units[name]}]' if units.get(name) else name)}</th>" for name in names)
    lines = []
    for row in rows:
        cells = ["…" if row is None else _cell(arrays, name, row, written) for name in names]
        lines.append("<tr>" + "".join(f"<td>{_escaped(cell)}</td>" for cell in cells) + "</tr>")
    return (
        f'<div><p>{_escaped(title)}</p><table style="font-size: 85%"><thead><tr>{head}</tr></thead>'
        f"<tbody>{''.join(lines)}</tbody></table></div>"
    )


def sized(result: Any) -> int:
    """Number of elements along the axis of a result. TypeError of a single value."""
    shape = np.shape(result)
    if not shape:
        raise TypeError("a result of a single value has no len()")
    return int(shape[0])


def rows(columns: Mapping[str, Any], key: Any, count: int) -> dict[str, Any]:
    """The parts of columns of one length that an index, a slice, an array of indices or flags selects."""
    try:
        parts = {name: np.asarray(column)[key] for name, column in columns.items()}
    except IndexError:
        if isinstance(key, (int, np.integer)):
            raise IndexError(f"index {key} of a result with {count} elements") from None
        raise
    for name, part in parts.items():
        if isinstance(part, np.ndarray):
            if part.ndim > np.ndim(columns[name]):
                raise InvalidInput.out_of_range(
                    "index", repr(key), "an integer, a slice, or an array of integers or flags"
                )
            part.flags.writeable = False
    return parts


def _cell(arrays: Mapping[str, Any], name: str, row: int, written: Callable[[float, float | None], str]) -> str:
    value, error = arrays[name][row], arrays.get(f"{name}_error")
    if isinstance(value, (float, np.floating)):
        return written(float(value), None if error is None or math.isnan(error[row]) else float(error[row]))
    return str(value)


def _escaped(text: str) -> str:
    return html.escape(" ".join(text.split()))
