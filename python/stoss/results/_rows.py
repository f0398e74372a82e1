"""Results that are rows of columns."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from stoss.export import _tables
from stoss.results._result import Result, plain


class RowResult(Result):
    """A result whose fields are columns of one length: `len()` is their number, an index one
    row."""

    def __len__(self) -> int:
        return len(getattr(self, self._axis_column()))

    def __getitem__(self, key: Any) -> Any:
        """A row as a dict, or for a slice, an array of indices or of flags, the result with these
        rows alone."""
        names = [field.name for field in dataclasses.fields(self) if self._is_column(getattr(self, field.name))]
        parts = _tables.rows({name: getattr(self, name) for name in names}, key, len(self))
        if any(np.ndim(part) == 0 for part in parts.values()):
            return plain(parts)
        return dataclasses.replace(self, **parts)

    def _axis_column(self) -> str:
        return next(name for name in self._dimensions() if hasattr(self, name))

    def _is_column(self, value: Any) -> bool:
        return isinstance(value, np.ndarray) and value.ndim == 1 and not value.dtype.names and len(value) == len(self)
