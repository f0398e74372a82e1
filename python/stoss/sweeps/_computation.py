"""What a sweep computes of each case, a body and what it meets: a curve, rules with friction, or an ensemble."""

from __future__ import annotations

import hashlib
import json
import math
from typing import Any, Callable, ClassVar, Mapping, NamedTuple, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import integer, number, refusal
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body
from stoss.bodies._encounter import Against, material_warnings_of, yield_speed_of, yield_warning_of
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
    def columns(self) -> tuple[str, ...]:
        """What is found at each point."""
        return tuple(name for name in QUANTITIES[self.kind] if name not in self.axes)

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


ALONG = ("angle", "tangential", "spin", "second_spin", "friction")
AXES = ("speed", *ALONG, "temperature", "sample")
"""In their order."""


def kind_of(axes: Sequence[str]) -> type[Computation]:
    """What has these axes."""
    return Rules if "friction" in axes else Ensemble if "sample" in axes else Computation


def choose_computation(given: Mapping[str, Any]) -> Computation:
    """What these arguments of a grid ask for; those that were left out are None."""
    said = {name for name, value in given.items() if value is not None}
    if {"friction", "temperature"} <= said:
        raise InvalidInput.out_of_range("friction", "friction and temperature", "one of them")
    if {"angle", "tangential"} <= said:
        raise InvalidInput.out_of_range("angle", "angle and tangential", "one of them")
    chosen = kind_of(["sample" if name == "temperature" else name for name in said])
    needs = dict.fromkeys(ALONG, "friction") | dict.fromkeys(("samples", *Ensemble.usual), "temperature")
    for name in sorted(said):
        key, of = needs.get(name), "friction" if chosen is Rules else "temperature"
        if key is not None and key not in said:
            raise refusal(name, given[name], f"only together with {key}")
        if name in Computation.usual and name not in chosen.usual:
            raise refusal(name, given[name], f"none together with {of}, whose accuracy is {list(chosen.usual)[-1]}")
    accuracy: dict[str, float | int] = {}
    for name, usual in chosen.usual.items():
        value = usual if given[name] is None else given[name]
        accuracy[name] = integer(name, value) if name == "seed" else number(name, value)
    if accuracy.get("seed", 0) < 0:
        raise refusal("seed", given["seed"], "0 to 2147483647")
    axes = [name for name in AXES if name in said or name == "sample" and chosen is Ensemble]
    return chosen(axes, accuracy)


MOST_WARNINGS = 4
"""Of losses in the materials of different cases, in one sweep."""


class Case(NamedTuple):
    """One body and what it meets: all points along the axes have its modes in common."""

    place: tuple[int, int]
    body: Body
    against: Against
    inputs: Specification
    key: str


def material_warnings(cases: Sequence[Case], fastest: float) -> list[str]:
    """What the core says of the materials of the cases, m/s: of yielding the worst case, of losses the first few."""
    yields = _yield_warning(cases, fastest)
    said = [yields] if yields else []
    others: dict[str, int] = {}
    for case in cases:
        for text in material_warnings_of(case.body, case.against, fastest):
            if "yields above" not in text:
                others[text] = others.get(text, 0) + 1
    said += list(others)[:MOST_WARNINGS]
    left = len(others) - MOST_WARNINGS
    return said + ([f"{left} more warnings of other cases like the last"] if left > 0 else [])


def _yield_warning(cases: Sequence[Case], fastest: float) -> str:
    onsets = [(yield_speed_of(case.body, case.against) or math.inf, place) for place, case in enumerate(cases)]
    beyond = sum(onset < fastest for onset, _ in onsets)
    if beyond == 0:
        return ""
    first = cases[min(onsets)[1]]
    said = yield_warning_of(first.body, first.against, fastest)
    return said if len(cases) == 1 else f"{beyond} of {len(cases)} cases beyond yielding; in the worst {said}"


def case_of(place: tuple[int, int], body: Body, against: Against, accuracy: Accuracy) -> Case:
    """A case with all inputs but the point, and their hash; a body of a file by the hash of its document."""
    met = reference(against) if isinstance(against, Solid) else of_wall(against)
    inputs: Specification = {"body": reference(body), "against": met, **accuracy}
    text = json.dumps(inputs, sort_keys=True)
    return Case(place, body, against, inputs, hashlib.sha256(text.encode()).hexdigest()[:16])
