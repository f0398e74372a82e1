"""The work of a sweep in pieces: what is missing, what one worker computes in one go."""

from __future__ import annotations

from pathlib import Path
from typing import Iterable, Iterator, NamedTuple, Sequence

import numpy as np

from stoss._errors import InvalidInput
from stoss.bodies._encounter import choose_against, refinable
from stoss.bodies._solid import Specification
from stoss.bodies._walls import HardWall
from stoss.sweeps import _store
from stoss.sweeps._bodies import resolved
from stoss.sweeps._computation import Accuracy, Case, Computation, Range, Tick, case_of, kind_of
from stoss.sweeps._grid import Grid
from stoss.sweeps._rows import Layout
from stoss.sweeps._specification import beside, make
from stoss.sweeps._worker import Worker

MOST_TASKS = 20_000
"""That an executor is given: more keep it busy with handing them out."""


class Part(NamedTuple):
    """A case, and which of its points are computed together."""

    case: Case
    range: Range


class Piece(NamedTuple):
    """What is missing of a part, in types that can be pickled."""

    inputs: Specification
    key: str
    points: list[tuple[float, ...]]


class Task(NamedTuple):
    """What a worker computes in one go, in types that can be pickled."""

    store: str
    axes: tuple[str, ...]
    accuracy: Accuracy
    pieces: list[Piece]


def parts_of(grid: Grid) -> list[Part]:
    """All cases in parts of moderate size, in the order of the grid."""
    ranges = grid.computation.ranges(grid.shape[2:])
    return [Part(case, each) for case in grid.cases() for each in ranges]


def missing(grid: Grid, path: Path, parts: Sequence[Part]) -> Iterator[Piece]:
    """What is still to be computed of these parts."""
    there = _store.read(path, grid).version >= 0
    axes, shape = [each.tolist() for each in grid.axes.values()], grid.shape[2:]
    for case, (begin, end) in parts:
        absent = begin + np.flatnonzero(~there[case.place].ravel()[begin:end])
        if absent.size:
            places = zip(*(each.tolist() for each in np.unravel_index(absent, shape)))
            points = [tuple(axis[k] for axis, k in zip(axes, place)) for place in places]
            yield Piece(case.inputs, case.key, points)


def tasks_of(grid: Grid, path: Path, pieces: Sequence[Piece], most: int = MOST_TASKS) -> list[Task]:
    """Several pieces make a task where there would be too many of them."""
    size = max(1, -(-len(pieces) // most))
    several = (list(pieces[begin : begin + size]) for begin in range(0, len(pieces), size))
    return [Task(str(path), grid.computation.axes, grid.computation.accuracy, each) for each in several]


def compute(task: Task, threads: int = 1, tick: Tick | None = None) -> int:
    """Compute a task and append the values to the file of this worker. Returns how many."""
    path = Path(task.store)
    computation = kind_of(task.axes)(task.axes, task.accuracy)
    with Worker(path, Layout(computation)) as worker:
        return fill(worker, computation, path, task.pieces, threads, tick)


def fill(
    worker: Worker, computation: Computation, path: Path, pieces: Iterable[Piece], threads: int, tick: Tick | None = None
) -> int:
    """Compute pieces and append their values, with a tick after each. Returns how many."""
    return sum(_fill(worker, computation, path, piece, threads, tick) for piece in pieces)


def _fill(worker: Worker, computation: Computation, path: Path, piece: Piece, threads: int, tick: Tick | None) -> int:
    inputs, key, points = piece
    body = make("body", resolved(inputs["body"], path))
    against = choose_against(body, beside(resolved(inputs["against"], path), body), (HardWall,))
    if case_of((0, 0), body, against, computation.accuracy).key != key:
        raise InvalidInput.out_of_range(
            "grid", f"another case {key} of a worker", "the same", "all must have the same stoss"
        )
    rows = np.zeros(len(points), dtype=computation.row)
    names = computation.row.names or ()
    picked, done = [names.index(name) for name in computation.columns], 0

    def keep() -> None:
        nonlocal done
        row = rows[done].item()
        worker.append(key, inputs, points[done], tuple(row[k] for k in picked))
        done += 1
        if tick is not None:
            tick()

    computation.compute(body, refinable(body, against), points, threads, rows, keep)
    return done
