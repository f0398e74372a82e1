"""What a drop test of a real ball shows, channel by channel."""

from __future__ import annotations

import dataclasses
import math
import warnings
from typing import Any, ClassVar, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, boolean, instance, integer, number, numbers, optional_number, refusal
from stoss._documentation import documented
from stoss._errors import InvalidInput, StossWarning
from stoss.bodies._bodies import BODIES, PARTNERS, Sphere, shown
from stoss.bodies._encounter import Against, drop_encounter
from stoss.bodies._solid import own_units
from stoss.bodies._walls import ExponentialWall, HardWall, Unbounded
from stoss.export._tables import plain, span
from stoss.results._progress import waiting
from stoss.results._quantities import QUANTITIES, PredictionQuantities
from stoss.results._result import ArrayResult, Column, picture, unit

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
        constant (str): As "young" of the ball, "against.young" of what it meets.
        uncertainty (float): u: the constant is known within a factor of 1 + u.
        change (float): Change of ε where the constant is larger by this factor.
    """

    constant: str
    uncertainty: float
    change: float


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Prediction(PredictionQuantities, ArrayResult):
    """What a drop test of a real ball shows, and where the energy goes, in SI.

    Numbers if the speed was one, otherwise arrays of its shape: then ``len()`` is the length of the
    first axis, and indices select as in numpy. Ringing, radiation and material follow from
    elasticity, with a numerical error. Yielding and adhesion are models, which differ. What is not
    known of the constants is the third uncertainty. The three stand side by side, and none contains
    another.

    Attributes:
        body (Sphere): The ball.
        against: What it meets.
        by_constants: Uncertainty of ε from the constants: root of the sum of the squares of all changes
            in `influences`; 0 where none is uncertain.
        yielding, adhesion: Channels that are models, as shares of it. In files the first is `yield`.
        dominant (str or ndarray): Which channel is the largest; 'yield' is that of `yielding`.
        influences (tuple of Influence or ndarray): What each uncertain constant changes, the largest
            change first.
        warnings (tuple of str or ndarray): Limits of models within the computed range, with the
            speeds.
        yield_speed (float or None): The ball, or the weaker of two, begins to yield above it, m/s.
        impression_speed (float or None): The impression is no longer small beside the radius above
            it: the model of yield ends, m/s.
        sticking_speed, adhesion_speed (float): Bodies stick below the first, and adhesion takes more
            than a hundredth of the energy below the second, m/s.
        rough_speed (float): Below it asperities count: u₀ is more than a hundredth of the compression, m/s. Of
            faces without a roughness as if they had that of a bearing ball, 24 nm rms.
        work_of_adhesion (float or None): As it was given, J/m².
        uncertainties (mapping or None): As they were given.
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
    rough_speed: float
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
        value = f"restitution {_rounded(self.restitution, max(parts))}, {uncertain}, most to {self.dominant}"
        return f"Prediction({of}: {value})"

    def _part(self, key: Any, shape: tuple[int, ...]) -> dict[str, Any]:
        where = np.arange(np.prod(shape)).reshape(shape)[key]
        fields = {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}
        return {name: _taken(each.ravel(), where) for name, each in fields.items() if isinstance(each, np.ndarray)}

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


@documented
def predict(
    body: Sphere,
    *,
    against: HardWall | Sphere | Unbounded | str | None = None,
    speed: ArrayLike | None = None,
    height: ArrayLike | None = None,
    adhesion: float | None = None,
    uncertainties: Mapping[str, float] | None = None,
    tolerance: float = 1e-3,
    threads: int = 0,
    progress: bool = False,
) -> Prediction:
    """Predict ε of a real ball, with all that takes energy, channel by channel.

    Ringing, radiation and loss in the material are computed from elasticity, with a numerical error.
    Yield and adhesion are models, with a spread of their own. All are in one motion, so that they
    take of each other. Materials of `stoss.materials` bring how well their constants are known. All is in SI. What
    ends within the range of what was computed is in `warnings`, and a `StossWarning` says it once.

    Parameters:
        body: The ball: with a material.
        against: What it meets, with a material: a rigid wall (default), an identical ball ('same'),
            another one, a half-space or a plate.
        speed: Speed of approach, m/s, 1e-8 to 1 c of the ball.
        height: In its place, that from which the ball falls without air, m.
        adhesion: Work of adhesion of both surfaces, J/m², 0 to 1e6; default: 2√(γ₁γ₂) of the
            `surface_energy` of both materials, 0 where one has none.
        uncertainties (mapping of str to float, optional): Constants by name, as ``{"young": 0.05,
            "against.loss": 2}``: each is known within a factor of 1 + u, u from 0 to 10.
            Default: those of `stoss.materials`.
        tolerance: For the computed channels, relative error of 1 − ε², 1e-15 to 0.5.

    Examples:
        >>> ball = stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"])
        >>> block = stoss.HalfSpace(material=stoss.materials["bearing steel"])
        >>> gentle = stoss.predict(ball, against=block, speed=0.1)
        >>> round(gentle.restitution, 4), gentle.dominant
        (0.9988, 'radiation')
        >>> fall = stoss.predict(ball, against=block, height=[1e-4, 1e-3])
        >>> fall.speed.round(4)
        array([0.0443, 0.14  ])
    """
    ball: Any = instance("body", body, BODIES)
    met = _choose_met(against)
    if (speed is None) == (height is None):
        raise InvalidInput.out_of_range("speed", "neither" if speed is None else "speed and height", "one of them")
    speeds = numbers("height" if speed is None else "speed", height if speed is None else speed)
    if height is not None:
        (heights,) = own_units(ball, "predict", height=speeds)
        speeds = _core.speed_of_drop(heights.ravel()).reshape(heights.shape)
    work, known = optional_number("adhesion", adhesion), choose_uncertainties(uncertainties)
    limit, count = number("tolerance", tolerance), integer("threads", threads)
    meeting = drop_encounter(ball, met)
    with waiting(boolean("progress", progress), "predict"):
        rows = _core.predict(meeting, speeds.ravel(), work, known, limit, count)
    for row in rows:
        row["influences"] = tuple(Influence(*each) for each in row["influences"])
        row["warnings"] = tuple(row["warnings"])
    kinds: dict[str, Any] = dict.fromkeys(QUANTITIES["prediction"], np.float64)
    kinds |= dict.fromkeys(("dominant", "influences", "warnings"), object)
    columns = {CHANNELS.get(name, name): _column(rows, name, kind, speeds.shape) for name, kind in kinds.items()}
    begins, ends, sticks, adheres, rough = _core.thresholds(meeting, work)
    for said in dict.fromkeys(each for row in rows for each in row["warnings"]):
        warnings.warn(said, StossWarning, stacklevel=2)
    return Prediction(
        ball, met, **columns, yield_speed=begins, impression_speed=ends, sticking_speed=sticks, adhesion_speed=adheres,
        rough_speed=rough,
        work_of_adhesion=work, uncertainties=known or None, tolerance=limit,
    )  # fmt: skip


def _column(rows: list[dict[str, Any]], name: str, kind: Any, shape: tuple[int, ...]) -> Any:
    column = np.empty(len(rows), dtype=kind)
    for k, row in enumerate(rows):  # one by one, as some are tuples
        column[k] = row[name]
    return arranged(column, shape)


def _choose_met(against: Any) -> Against | str:
    if isinstance(against, str):
        if against == "same":
            return against
        if against == "wall":
            return HardWall()
        raise refusal("against", against, "None, 'wall', 'same', a stoss.Sphere, a stoss.HalfSpace or a stoss.Plate")
    kinds = (HardWall, ExponentialWall, *PARTNERS)
    return HardWall() if against is None else instance("against", against, kinds)


def choose_uncertainties(given: Any) -> dict[str, float]:
    """How well constants are known, by name."""
    if given is None:
        return {}
    if not isinstance(given, Mapping) or not all(isinstance(name, str) for name in given):
        raise refusal("uncertainties", given, "a mapping of names to numbers, as {'young': 0.05}")
    return {name: number(f"uncertainties {name}", each) for name, each in given.items()}
