"""Where the energy is after an oblique impact."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np

from stoss.export import _tables
from stoss.export._text import span
from stoss.results._quantities import Number, ObliqueLedgerQuantities
from stoss.results._result import Result


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ObliqueLedger(ObliqueLedgerQuantities, Result):
    """Where the energy is after oblique impacts, as shares of what there was before.

    That is of all motion relative to the common centre of mass, of the spins and of the vibration.
    Numbers, or arrays of the shape of the impacts.

    Attributes:
        translation, across: Of the (relative) translation along the normal, and along the surface.
        rotation, second_rotation: Of the spins of the first and of the second body.
        vibration, second_vibration: Of the kept modes of each.
        dissipated: Lost to the material.
        friction: Heat of friction.
        unresolved: Of the modes above the cutoff.
        stored: Where a lossy body relaxes.
    """

    _name: ClassVar[str] = "oblique ledger"


    @property
    def total(self) -> Number:
        """The sum: 1 but for the numerical error."""
        return sum(self.entries().values(), start=0.0)

    def entries(self) -> dict[str, Number]:
        """All shares by their names."""
        return {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}

    def __repr__(self) -> str:
        told = (f"{name} {span(share)}" for name, share in self.entries().items() if np.any(share))
        return f"ObliqueLedger({', '.join(told)})"

    def __len__(self) -> int:
        return _tables.sized(self.translation)

    def __bool__(self) -> bool:
        return True

    def __getitem__(self, key: Any) -> ObliqueLedger:
        """The shares at an index, a slice or flags, as numpy has them."""
        len(self)  # refuses a single value
        return ObliqueLedger(**self._selected(key, np.shape(self.translation)))
