"""Rows of bodies as cases of a sweep: their documents, and what is computed of them."""

from __future__ import annotations

import functools
import hashlib
import itertools
import json
import os
from typing import Any, Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import integer, open_file, refusal
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body
from stoss.bodies._kinds import KINDS, Specification
from stoss.bodies._solid import describe
from stoss.bodies._state import Oscillation
from stoss.export import _files
from stoss.export._files import of_json
from stoss.results._quantities import QUANTITIES
from stoss.rows._line import Line, choose_line
from stoss.sweeps._computation import Accuracy, Case, Computation, Point, Tick
from stoss.sweeps._specification import Choices, beside, choices, expanded, label, make

KEYS = ("format", "count", "moving", "before", "after", "gaps", "vibration")
MOST_BODIES = 100
BODY = {name: of for name, of in QUANTITIES["row body"].items() if name != "number"}
WHOLE = QUANTITIES["row"]


class Rows(Computation):
    """Velocities after all contacts of rows of bodies: `stoss.row`. Points are the bodies at each speed."""

    kind = "row"
    row = np.dtype([*((name, np.float64) for name in BODY), *((name, _core.row_row[name]) for name in WHOLE)])
    usual = {"tolerance": 1e-3}

    @property
    def quantities(self) -> Mapping[str, str]:
        return {**BODY, **WHOLE}

    def together(self, shape: tuple[int, ...]) -> int:
        return shape[-1]

    def contact(self, body: Body, against: Any) -> Any:
        return against

    def check(self, body: Body, contact: Any, axes: Sequence[NDArray[np.float64]]) -> None:
        contact.line.given().check(contact.speeds(axes[0]), self.accuracy["tolerance"])

    def compute(
        self, body: Body, contact: Any, points: Sequence[Point], threads: int, rows: NDArray[Any], tick: Tick
    ) -> None:
        groups = [(speed, [int(each[1]) for each in its]) for speed, its in itertools.groupby(points, lambda at: at[0])]
        speeds = contact.speeds(np.array([speed for speed, _ in groups]))
        whole, after = np.zeros(len(groups), dtype=_core.row_row), np.full((*speeds.shape, 2), np.nan)
        before = speeds / contact.line.speed_unit()
        done = begin = 0

        def keep(count: int = 1) -> None:
            nonlocal done, begin
            for numbers in [each for _, each in groups[done : done + count]]:
                its = rows[begin : begin + len(numbers)]
                its["velocity"] = before[done, numbers]
                its["velocity_after"], its["velocity_after_error"] = after[done, numbers].T
                for name in WHOLE:
                    its[name] = whole[name][done]
                done, begin = done + 1, begin + len(numbers)
                for _ in numbers:
                    tick()

        contact.line.given().curve(speeds, self.accuracy["tolerance"], threads, whole, after, [], [], keep)


class RowOfSweep:
    """One row of bodies, and how many of them move at the speed of a sweep."""

    def __init__(self, line: Line, moving: int, document: Specification) -> None:
        self.line, self.moving, self.document = line, moving, document

    def __repr__(self) -> str:
        return self.label()

    def speeds(self, of: NDArray[np.float64]) -> NDArray[np.float64]:
        """Those of all bodies, as they are given: a case for each speed."""
        all_ = np.zeros((of.size, len(self.line.bodies)))
        all_[:, : self.moving] = of[:, None]
        return all_

    def pairs(self) -> list[tuple[Body, Any]]:
        """Neighbours, each two once."""
        line = self.line
        met: list[tuple[Body, Any]] = [*zip(line.bodies, line.bodies[1:])]
        met += [(line.bodies[0], line.before)] if line.before is not None else []
        met += [(line.bodies[-1], line.against)] if line.against is not None else []
        return [pair for k, pair in enumerate(met) if pair not in met[:k]]

    def label(self) -> str:
        """All bodies in the manner of --against, equal neighbours together."""
        names = [label(each) for each in self.document["bodies"]]
        groups = [(name, len(list(its))) for name, its in itertools.groupby(names)]
        said = [f"{count} * {name}" if count > 1 else name for name, count in groups]
        return " | ".join([*(["wall"] if self.line.before is not None else []), *said])


def documents_of(given: Any) -> list[Specification]:
    """The documents of all rows: of a mapping each combination of what its bodies leave to choose."""
    return [each for one in (given if isinstance(given, list) else [given]) for each in _expanded(one)]


def count_of(given: Any) -> int:
    """How many bodies each has, and refuses rows of different lengths."""
    counts = {len(each["bodies"]) for each in given}
    if len(counts) > 1:
        raise InvalidInput.out_of_range("row", f"rows of {sorted(counts)} bodies", "all of one number of bodies")
    return counts.pop()


def _expanded(given: Any) -> Iterator[Specification]:
    if isinstance(given, (str, os.PathLike)):
        with open_file("row", given) as stream:
            given = of_json(stream.read().decode())
    if not isinstance(given, Mapping) or "bodies" not in given or set(given) - {"bodies", *KEYS}:
        got = sorted(map(str, given)) if isinstance(given, Mapping) else given
        raise refusal("row", got, f"a document of a row: bodies, and besides {', '.join(KEYS)}")
    if "format" in given:
        _files.require("format", given["format"], "stoss row 1")
    bodies = given["bodies"] if isinstance(given["bodies"], (list, tuple)) else [given["bodies"]]
    count = integer("count", given.get("count", len(bodies)))
    if not 1 <= count <= MOST_BODIES or not bodies:
        raise refusal("count", count, f"1 to {MOST_BODIES} bodies")
    left = [choices("row", each) for each in bodies]
    after = given.get("after")
    ends = [None] if after is None else list(_ends(after))
    rest = {name: given[name] for name in ("moving", "before", "gaps", "vibration") if name in given}
    for chosen, end in itertools.product(itertools.product(*map(_several, bodies, left)), ends):
        repeated = [chosen[k % len(chosen)] for k in range(count)]
        yield {"bodies": repeated, **rest, **({} if end is None else {"after": end})}


def _several(body: Any, left: Choices) -> list[Specification]:
    found = list(expanded("row", body, left))
    for each in found:
        if KINDS[each["kind"]].from_file:
            raise refusal("row", each["kind"], "sphere, disk or rod in a sweep of rows")
    return found


def _ends(after: Any) -> Iterator[Any]:
    for each in after if isinstance(after, list) else [after]:
        if isinstance(each, str):
            yield each
        else:
            yield from expanded("against", each, choices("row", each))


def row_of(document: Specification) -> RowOfSweep:
    """The row of a document."""
    bodies = [make("row", each) for each in document["bodies"]]
    after = document.get("after")
    standing = after if after is None or isinstance(after, str) else beside(after, bodies[-1])
    vibration = [Oscillation(of=each["body"], **{key: each[key] for key in each if key != "body"})
                 for each in document.get("vibration", [])]  # fmt: skip
    line = choose_line(bodies, document.get("before"), standing, document.get("gaps"), vibration or None)
    moving = integer("moving", document.get("moving", 1))
    if not 1 <= moving <= len(bodies):
        raise refusal("moving", moving, f"1 to {len(bodies)} bodies from the left")
    described = {**document, "bodies": [describe(each) for each in bodies]}
    return RowOfSweep(line, moving, described)


@functools.lru_cache(maxsize=16)
def row_of_text(text: str) -> RowOfSweep:
    """The same of its JSON text, which workers have."""
    return row_of(json.loads(text))


def row_case(place: tuple[int, int], made: RowOfSweep, accuracy: Accuracy) -> Case:
    """A case with all inputs but the point, and their hash."""
    inputs: Specification = {"row": made.document, **accuracy}
    text = json.dumps(inputs, sort_keys=True)
    key = hashlib.sha256(text.encode()).hexdigest()[:16]
    return Case(place, made.line.bodies[0], made, inputs, key, made.pairs())
