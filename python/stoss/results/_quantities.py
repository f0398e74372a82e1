"""The quantities of each kind of result, as the core lists them: names, order, units."""

from __future__ import annotations

from types import MappingProxyType
from typing import Mapping

from stoss import _core

QUANTITIES: Mapping[str, Mapping[str, str]] = MappingProxyType(
    {
        kind: MappingProxyType(
            {
                column: dimension
                for name, dimension, has_error in table
                for column in ((name, f"{name}_error") if has_error else (name,))
            }
        )
        for kind, table in _core.quantities.items()
    }
)
"""Dimension of each column of each kind of result, in the order of the core; errors follow their values."""


def unit(dimension: str, *, body: str, si: bool) -> str:
    """Name of the unit of a dimension: of a disk, a rod or a sphere, or in SI."""
    return _core.units(body, si)[dimension]
