"""What a drop test of a real ball shows, channel by channel."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, ClassVar, Mapping

import numpy as np
from numpy.typing import NDArray

from stoss._arguments import arranged
from stoss.bodies._bodies import Sphere, shown
from stoss.bodies._encounter import Against
from stoss.export import _tables
from stoss.export._text import plain, span
from stoss.results._quantities import PredictionQuantities, QUANTITIES
from stoss.results._result import Column, Result, picture, unit

CHANNELS: Mapping[str, str] = {
    "ringing": "ringing", "radiation": "radiation", "material": "material", "yield": "yielding", "adhesion": "adhesion",
}  # fmt: skip
"""The field of each channel."""

MODELS = ("yield", "adhesion")
"""The channels that are models; the others are computed."""


@dataclasses.dataclass(frozen=True)
class Influence:
    """How ε answers to a constant that is known within a factor.

    Attributes:
        constant (str): As "young" of the ball, "against young" of what it meets.
        uncertainty (float): u: the constant is known within a factor of 1 + u.
        change (float): Of ε, where the constant is larger by this factor.
    """

    constant: str
    uncertainty: float
    change: float


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Prediction(PredictionQuantities, Result):
    """What a drop test of a real ball shows, and where the energy goes, in SI.

    Numbers if the speed was one, otherwise arrays of its shape: then ``len()`` is the length of the
    first axis, and indices select as in numpy. Ringing, radiation and material follow from
    elasticity, with a numerical error. Yielding and adhesion are models, which differ. What is not
    known of the constants is the third uncertainty: the three stand side by side, and none holds
    another.

    Attributes:
        body (Sphere): The ball.
        against: What it meets.
        by_constants: What uncertain constants do to ε: root of the sum of the squares of all changes
            in `influences`; 0 where none is uncertain.
        yielding, adhesion: Channels that are models, as shares of it. In files the first is `yield`.
        dominant (str or ndarray): Which channel is the largest; 'yield' is that of `yielding`.
        influences (tuple of Influence or ndarray): What each uncertain constant changes, the largest
            change first.
        warnings (tuple of str or ndarray): What ends within the range of what was computed, with the
            speeds.
        yield_speed (float or None): The ball, or the weaker of two, begins to yield above it, m/s.
        impression_speed (float or None): The impression is no longer small beside the radius above
            it: the model of yield ends, m/s.
        sticking_speed, adhesion_speed (float): Bodies stick below the first, and adhesion takes more
            than a hundredth of the energy below the second, m/s.
        work_of_adhesion (float or None): As it was given, J/m².
        uncertainties (mapping or None): As they were given.
        tolerance: Asked for, of the computed channels: error of 1 − ε² over 1 − ε².
    """

    plot = picture("ε with its uncertainties, and where the energy goes, against speed. See `stoss.plot.prediction`.")
    _name: ClassVar[str] = "predict"
    _axis: ClassVar[str] = "speed"
    _told = ("body", "against", "work_of_adhesion", "uncertainties", "tolerance")

    body: Sphere
    against: Against | str
    influences: tuple[Influence, ...] | NDArray[np.object_]
    warnings: tuple[str, ...] | NDArray[np.object_]
    yield_speed: float | None
    impression_speed: float | None
    sticking_speed: float
    adhesion_speed: float
    work_of_adhesion: float | None
    uncertainties: Mapping[str, float] | None
    tolerance: float

    def __repr__(self) -> str:
        met = f" against {self.against!r}" if isinstance(self.against, str) else ""
        of = f"{shown(self.body, self.against)}{met}, speed={span(self.speed)} m/s"
        if np.ndim(self.restitution):
            return f"Prediction({np.size(self.speed)} values, {of}: restitution {span(self.restitution)})"
        parts = [float(each) for each in (self.restitution_error, self.by_models, self.by_constants)]
        numerical, models, constants = (f"{each:.1g}" for each in parts)
        uncertain = f"± {numerical} numerical, ± {models} models, ± {constants} constants"
        return f"Prediction({of}: restitution {_rounded(self.restitution, max(parts))}, {uncertain}, most to {self.dominant})"

    def __len__(self) -> int:
        return _tables.sized(self.restitution)

    def __bool__(self) -> bool:
        return True

    def __getitem__(self, key: Any) -> Prediction:
        """The values at an index, a slice or flags, as numpy has them."""
        len(self)  # refuses a single value
        shape = np.shape(self.restitution)
        where = np.arange(np.size(self.restitution)).reshape(shape)[key]
        fields = {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}
        arrays = {name: each.ravel() for name, each in fields.items() if isinstance(each, np.ndarray)}
        return dataclasses.replace(self, **{name: _taken(each, where) for name, each in arrays.items()})

    def to_dict(self) -> dict[str, Any]:
        """As of all results; `contact_time` is None where the bodies stick."""
        told = {"yield" if name == "yielding" else name: each for name, each in super().to_dict().items()}
        told |= {name: plain(told[name]) for name in ("influences", "warnings")}
        return told | {"contact_time": _finite(told["contact_time"])}

    def _table(self) -> dict[str, Column]:
        return {name: np.asarray(getattr(self, CHANNELS.get(name, name))) for name in QUANTITIES[self._kind]}

    def _unit(self, name: str) -> str:
        return unit(QUANTITIES[self._kind].get(name, ""), body=self.body._kind, si=True)


def _taken(column: NDArray[Any], where: Any) -> Any:
    """Some values of a column, or one; it may be of tuples."""
    part = column[where]
    if np.ndim(where):
        return arranged(part, np.shape(where))
    return part.item() if isinstance(part, np.generic) else part


def _finite(times: Any) -> Any:
    if isinstance(times, list):
        return [_finite(each) for each in times]
    return times if math.isfinite(times) else None


def _rounded(value: Any, uncertainty: Any) -> str:
    """With two digits of its uncertainty."""
    digits = max(2, 1 - math.floor(math.log10(uncertainty))) if 0.0 < uncertainty < math.inf else 6
    return f"{value:.{digits}f}"
