"""What a sweep computes of each case, a body and what it meets: a curve, rules with friction, or an ensemble."""

from __future__ import annotations

import hashlib
import json
import math
from typing import Any, Callable, ClassVar, Mapping, NamedTuple, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss.bodies._bodies import Body
from stoss.bodies._encounter import Against, material_warnings_of, refinable, yield_speed_of, yield_warning_of
from stoss.bodies._kinds import Specification
from stoss.bodies._solid import Solid, own_units
from stoss.bodies._state import choose_state
from stoss.results._obliquity import choose_motion
from stoss.results._quantities import QUANTITIES
from stoss.sweeps._bodies import reference
from stoss.sweeps._specification import of_wall

Point = Sequence[float]
Accuracy = Mapping[str, Union[float, int]]
Tick = Callable[[], None]


class Range(NamedTuple):
    """Points of a case that are computed together, numbered along the axes, the last fastest."""

    begin: int
    end: int


class Computation:
    """A curve over the speed: `stoss.restitution`. What the others change is below."""

    kind: ClassVar[str] = "restitution"
    """Of the core's quantities."""
    row: ClassVar[np.dtype[Any]] = _core.restitution_row
    usual: ClassVar[Accuracy] = {"tolerance": 1e-3, "absolute": 1e-6}
    """What makes a value beside the case and the point, and its usual values."""
    most: ClassVar[int] = 128
    """Points that one task computes: so many that making the modes again costs little."""

    def __init__(self, axes: Sequence[str], accuracy: Accuracy) -> None:
        self.axes = tuple(axes)
        self.accuracy = dict(accuracy)

    @property
    def quantities(self) -> Mapping[str, str]:
        """Dimensions of all that is found."""
        return QUANTITIES[self.kind]

    @property
    def columns(self) -> tuple[str, ...]:
        """What is found at each point."""
        return tuple(name for name in self.quantities if name not in self.axes)

    def contact(self, body: Body, against: Any) -> Any:
        """What the core computes: it refuses ratios out of range."""
        return refinable(body, against)

    def empty(self, shape: tuple[int, ...]) -> NDArray[Any]:
        """Rows of which nothing is computed: NaN, 0 and False."""
        rows = np.zeros(shape, dtype=[(name, self.row[name]) for name in self.columns])
        for name in self.columns:
            if rows.dtype[name].kind == "f":
                rows[name] = np.nan
        return rows

    def together(self, shape: tuple[int, ...]) -> int:
        """How many successive points share work."""
        return 1

    def ranges(self, shape: tuple[int, ...]) -> list[Range]:
        """The tasks of each case, for axes of these lengths."""
        total, shared = int(np.prod(shape)), self.together(shape)
        begins: list[int] = []
        if shared > self.most:
            begins = [first + k for first in range(0, total, shared) for k in range(0, shared, self.most)]
        else:
            begins = list(range(0, total, self.most // shared * shared))
        return [Range(begin, end) for begin, end in zip(begins, [*begins[1:], total])]

    def check(self, body: Body, contact: _core.RefinableContact, axes: Sequence[NDArray[np.float64]]) -> None:
        """Refuse what the core refuses, before anything is computed."""
        _core.check_curve(_speeds(body, axes[0]), self.accuracy["tolerance"], self.accuracy["absolute"], 1)

    def compute(
        self, body: Body, contact: _core.RefinableContact, points: Sequence[Point], threads: int, rows: NDArray[Any],
        tick: Tick,
    ) -> None:  # fmt: skip
        """Fill the rows of the core, one for each point, in their order."""
        speeds = _speeds(body, np.array(points)[:, 0])
        tolerance, absolute = self.accuracy["tolerance"], self.accuracy["absolute"]
        _core.restitution_curve(contact, speeds, tolerance, absolute, threads, choose_state(None), rows, [], tick)


class Rules(Computation):
    """Collision rules with friction: `stoss.oblique`."""

    kind = "oblique"
    row = _core.oblique_row
    usual = {"tolerance": 1e-2}
    most = 64

    def together(self, shape: tuple[int, ...]) -> int:
        return int(np.prod(shape[1:]))  # of spheres those of one speed share an impact along the normal

    def check(self, body: Body, contact: _core.RefinableContact, axes: Sequence[NDArray[np.float64]]) -> None:
        every = np.stack([each.ravel() for each in np.meshgrid(*axes, indexing="ij")], axis=1)
        _core.check_oblique(contact, self._cases(body, every), self.accuracy["tolerance"], 1, choose_state(None))

    def compute(
        self, body: Body, contact: _core.RefinableContact, points: Sequence[Point], threads: int, rows: NDArray[Any],
        tick: Tick,
    ) -> None:  # fmt: skip
        cases, tolerance = self._cases(body, np.array(points)), self.accuracy["tolerance"]
        _core.oblique_curve(contact, cases, tolerance, threads, choose_state(None), rows, [], tick)

    def _cases(self, body: Body, points: NDArray[np.float64]) -> NDArray[np.float64]:
        return choose_motion(body, 1, **dict(zip(self.axes, points.T)))[0]


class Ensemble(Computation):
    """Samples of bodies that vibrate at random before: `stoss.restitution_distribution`."""

    kind = "sample"
    row = _core.sample_row
    usual = {"highest": 10.0, "seed": 0, "error": 1e-3}
    most = 256

    def together(self, shape: tuple[int, ...]) -> int:
        return shape[-1]

    def check(self, body: Body, contact: _core.RefinableContact, axes: Sequence[NDArray[np.float64]]) -> None:
        speeds, temperatures, samples = axes
        for temperature in temperatures.tolist():
            means = self._means(contact, temperature)
            for speed in _speeds(body, speeds).tolist():
                _core.check_distribution(contact, speed, means, samples.size, *self._drawn(), 1)

    def compute(
        self, body: Body, contact: _core.RefinableContact, points: Sequence[Point], threads: int, rows: NDArray[Any],
        tick: Tick,
    ) -> None:  # fmt: skip
        begin = 0
        while begin < len(points):  # one call for each run of successive samples
            speed, temperature, first = points[begin]
            end = begin + 1
            while end < len(points) and tuple(points[end]) == (speed, temperature, first + end - begin):
                end += 1
            means = self._means(contact, temperature)
            (its,) = _speeds(body, np.array([speed])).tolist()
            kept = rows[begin:end]
            _core.restitution_distribution(contact, its, means, *self._drawn(), threads, kept, [], tick, int(first))
            begin = end

    def _drawn(self) -> tuple[int, float]:
        return int(self.accuracy["seed"]), self.accuracy["error"]

    def _means(self, contact: _core.RefinableContact, temperature: float) -> NDArray[Any]:
        modes = _core.thermal(contact, temperature, self.accuracy["highest"])
        means = np.zeros(modes.size, dtype=_core.mean_energy)
        for name in means.dtype.names or ():
            means[name] = modes[name]
        return means


def _speeds(body: Body, given: NDArray[np.float64]) -> NDArray[np.float64]:
    return own_units(body, "restitution", speed=given)[0]


MOST_WARNINGS = 4
"""Warnings of losses in the materials of different cases, in one sweep."""


class Case(NamedTuple):
    """One body and what it meets: all points along the axes have its modes in common."""

    place: tuple[int, int]
    body: Body
    against: Any
    """What it meets; of a row all of it."""
    inputs: Specification
    key: str
    pairs: Sequence[tuple[Body, Any]]
    """Who meets whom."""


def material_warnings(cases: Sequence[Case], fastest: float) -> list[str]:
    """What the core says of the materials of the cases, m/s: of yielding the worst case, of losses the first few."""
    yields = _yield_warning(cases, fastest)
    said = [yields] if yields else []
    others: dict[str, int] = {}
    for case in cases:
        for text in dict.fromkeys(said for pair in case.pairs for said in material_warnings_of(*pair, fastest)):
            if "yields above" not in text:
                others[text] = others.get(text, 0) + 1
    said += list(others)[:MOST_WARNINGS]
    left = len(others) - MOST_WARNINGS
    return said + ([f"{left} more warnings of other cases like the last"] if left > 0 else [])


def _yield_warning(cases: Sequence[Case], fastest: float) -> str:
    onsets = [min((yield_speed_of(*pair) or math.inf, k) for k, pair in enumerate(case.pairs)) for case in cases]
    beyond = sum(onset < fastest for onset, _ in onsets)
    if beyond == 0:
        return ""
    worst = min(range(len(cases)), key=lambda place: onsets[place][0])
    said = yield_warning_of(*cases[worst].pairs[onsets[worst][1]], fastest)
    return said if len(cases) == 1 else f"{beyond} of {len(cases)} cases beyond yielding; in the worst {said}"


def case_of(place: tuple[int, int], body: Body, against: Against, accuracy: Accuracy) -> Case:
    """A case with all inputs but the point, and their hash; a body of a file by the hash of its document."""
    met = reference(against) if isinstance(against, Solid) else of_wall(against)
    inputs: Specification = {"body": reference(body), "against": met, **accuracy}
    text = json.dumps(inputs, sort_keys=True)
    return Case(place, body, against, inputs, hashlib.sha256(text.encode()).hexdigest()[:16], [(body, against)])
