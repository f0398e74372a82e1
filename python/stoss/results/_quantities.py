"""What results hold, by the core's table of quantities: their fields, SI values, and the words for both.

Each class of `CLASSES` is the base of a result. `stubs.py` writes their types when the package is built.
"""

from __future__ import annotations

import dataclasses
import re
from types import MappingProxyType
from typing import Any, Mapping, NamedTuple, Union

import numpy as np
from numpy.typing import NDArray

from stoss import _core

Number = Union[float, NDArray[np.float64]]
Integer = Union[int, NDArray[np.int64]]
Flag = Union[bool, NDArray[np.bool_]]
Name = Union[str, NDArray[np.object_]]


class Quantity(NamedTuple):
    """A line of the table."""

    name: str
    dimension: str
    has_error: bool
    help: str
    type: str

    @property
    def columns(self) -> tuple[str, ...]:
        """Its name, and that of its error."""
        return (self.name, f"{self.name}_error") if self.has_error else (self.name,)


TABLES: Mapping[str, tuple[Quantity, ...]] = MappingProxyType(
    {kind: tuple(Quantity(*each) for each in table) for kind, table in _core.quantities.items()}
)
"""The quantities of each kind of result, in the order of the core."""

QUANTITIES: Mapping[str, Mapping[str, str]] = MappingProxyType(
    {
        kind: MappingProxyType({column: each.dimension for each in table for column in each.columns})
        for kind, table in TABLES.items()
    }
)
"""Dimension of each column of each kind of result; errors follow their values."""

UNITS = {
    "length": ("R", "m"), "inverse length": ("1/R", "1/m"), "time": ("R/c", "s"), "speed": ("c", "m/s"),
    "frequency": ("c/R", "rad/s"), "energy": ("mc²", "J, of a disk J/m"),
    "momentum": ("mc", "N s, of a disk N s/m"),
    "force": ("mc²/R: πRE of a disk, (4π/3)R²E of a sphere", "N, of a disk N/m"),
}  # fmt: skip
"""Units as docstrings have them: those of a disk or a sphere, and those in SI."""

OF_THE_COMPUTATION = ("cutoff", "step", "half_width")
"""What has no SI values: it tells how something was computed."""

FORMS = {
    "one": {"float": "float", "int": "int", "bool": "bool"},
    "many": {"float": "Number", "int": "Integer", "bool": "Flag", "str": "Name"},
    "column": {"float": "NDArray[np.float64]", "int": "NDArray[np.int64]", "bool": "NDArray[np.bool_]"},
}
"""Types of fields: one value, one or an array, an array."""


class Made(NamedTuple):
    """How a class follows from the table."""

    kind: str
    form: str
    in_si: bool = True
    left_out: tuple[str, ...] = ()
    renamed: Mapping[str, str] = {}
    optional: tuple[str, ...] = ()  # what not every such result has: None there

    def fields(self) -> list[tuple[Quantity, str]]:
        """The quantities, and the name of the field of each."""
        return [(each, self.renamed.get(each.name, each.name)) for each in TABLES[self.kind]
                if each.name not in self.left_out]  # fmt: skip

    def types(self) -> dict[str, str]:
        """The type of each field."""
        types = {}
        for each, name in self.fields():
            kind = FORMS[self.form][each.type] + (" | None" if name in self.optional else "")
            types |= {column.replace(each.name, name, 1): kind for column in each.columns}
        return types

    def si_values(self) -> dict[str, str]:
        """The SI values, and what is said of them."""
        said = {}
        for each, name in self.fields() if self.in_si else []:
            if each.dimension and name not in OF_THE_COMPUTATION:
                said[f"{name}_si"] = f"{each.help}, {UNITS[each.dimension][1]}."
                if each.has_error:
                    said[f"{name}_si_error"] = f"Estimated error of `{name}_si`."
        return said


CLASSES: Mapping[str, Made] = {
    "BounceQuantities": Made("bounce", "column"),
    "ImpactQuantities": Made("impact", "one"),
    "ModeQuantities": Made("mode", "column", in_si=False, left_out=("family",)),
    "ObliqueImpactQuantities": Made("oblique impact", "one"),
    "ObliqueLedgerQuantities": Made("oblique ledger", "many", in_si=False),
    "ObliqueQuantities": Made("oblique", "many"),
    "ObliqueSnapshotQuantities": Made("oblique snapshot", "column"),
    "PredictionQuantities": Made("prediction", "many", in_si=False, renamed={"yield": "yielding"}),
    "PulseQuantities": Made("pulse", "one"),
    "RayleighQuantities": Made("point rayleigh", "many", optional=("mean_lost_fraction", "max_radius")),
    "RecordedInstantQuantities": Made("recorded instant", "column"),
    "RestitutionQuantities": Made("restitution", "many"),
    "RowQuantities": Made("row", "many"),
    "SampleQuantities": Made("sample", "column"),
    "SlowImpactQuantities": Made("point slow impact", "many", optional=("max_radius",)),
    "SnapshotQuantities": Made("snapshot", "column"),
}


class Si(property):
    """A column of a result in SI, by its dimension: `x_si = Si("What it is, unit.")` is that of `x`."""

    def __init__(self, said: str) -> None:
        super().__init__(doc=said)

    def __set_name__(self, owner: type, name: str) -> None:
        self._column = re.sub(r"_si(?=$|_error$)", "", name)

    def __get__(self, result: Any, owner: type | None = None, /) -> Number:
        return self if result is None else result._in_si(self._column)  # type: ignore[no-any-return]


def _said(made: Made) -> str:
    """The docstring of a class."""
    lines = [f"What is computed of a kind of result, {made.kind}.", "", "Attributes:"]
    for each, name in made.fields():
        unit = UNITS[each.dimension][made.kind == "prediction"] if each.dimension else ""
        names, error = (f"{name}, {name}_error", "; and its estimated error") if each.has_error else (name, "")
        lines.append(f"    {names}: {each.help}{', ' * bool(unit)}{unit}{error}.")
    return "\n".join(lines)


def _made(name: str, made: Made) -> type:
    namespace: dict[str, Any] = {si: Si(said) for si, said in made.si_values().items()}
    namespace |= {"__doc__": _said(made), "__module__": __name__, "_kind": made.kind}
    return dataclasses.make_dataclass(
        name, list(made.types().items()), namespace=namespace, frozen=True, eq=False, repr=False, kw_only=True
    )


globals().update({name: _made(name, made) for name, made in CLASSES.items()})
