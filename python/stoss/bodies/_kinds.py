"""What can meet, and the numbers that make it, as the core's table of kinds has them."""

from __future__ import annotations

from types import MappingProxyType
from typing import Any, Mapping, NamedTuple

from stoss import _core

Specification = dict[str, Any]
"""A body, a block or a wall in plain types, as an encounter's JSON document has it."""


class Parameter(NamedTuple):
    """A number that makes something of a kind, as the core has it."""

    name: str
    unit: str
    otherwise: float | None
    low: float
    high: float
    low_included: bool
    of_material: bool


class Kind(NamedTuple):
    """What can meet, as the core has it."""

    name: str
    wall: bool
    bounded: bool
    can_be_rigid: bool
    has_plane: bool
    from_file: bool
    parameters: tuple[Parameter, ...]


KINDS: Mapping[str, Kind] = MappingProxyType(
    {each[0]: Kind._make([*each[:-1], tuple(map(Parameter._make, each[-1]))]) for each in _core.kinds()}
)


def fields_of(kind: Kind) -> dict[str, str]:
    """Fields of the class of a kind, with their types."""
    fields = {each.name: "float" for each in kind.parameters}
    if not kind.bounded and "poisson" in fields:
        fields["poisson"] = "float | None"  # it may be that of what a block meets
    fields |= {"relaxation": "Relaxation | None"} if not kind.wall else {}
    fields["material"] = "Material | None"
    fields |= {"plane": "str | None"} if kind.has_plane else {}
    return fields | ({"rigid": "bool"} if kind.can_be_rigid else {})
