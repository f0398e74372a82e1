"""Numbers and results as text and in plain types."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

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
