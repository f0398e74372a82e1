"""The work of a sweep in pieces, and the file of a worker, to which it appends each value when it is done."""

from __future__ import annotations

import contextlib
import errno
import fcntl
import json
import os
import re
import threading
import time
from pathlib import Path
from typing import Any, Iterable, Iterator, NamedTuple, Sequence

import numpy as np

from stoss import _core
from stoss._errors import InvalidInput
from stoss.bodies._kinds import Specification
from stoss.export._tables import cell, known
from stoss.sweeps import _store
from stoss.sweeps._choice import case_of_inputs, kind_of
from stoss.sweeps._computation import Accuracy, Case, Computation, Range, Tick
from stoss.sweeps._grid import Grid
from stoss.sweeps._rows import Layout, Row, with_checksum

OFTEN = 1.0
"""Seconds after which this process sends rows to the disk itself: after each row or task it would wait too often."""

_sent = time.monotonic()


class Worker:
    """The file of one worker, locked against others while it is open."""

    def __init__(self, path: Path, layout: Layout, name: str | None = None) -> None:
        """Open `name`.csv, or a file of this thread of this machine.

        Raises BlockingIOError while another process writes it, InvalidInput if it is of another
        version, OSError if it cannot be written.
        """
        self._layout = layout
        own = f"worker-{re.sub(r'[^A-Za-z0-9]', '-', os.uname().nodename)}-{threading.get_native_id()}"
        for number in range(1, 1000):
            self.file = path / f"{name or own}{f'-{number}' if number > 1 else ''}.csv"
            self._descriptor = os.open(self.file, os.O_RDWR | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o666)
            try:
                self._lock()
                break
            except BlockingIOError:
                os.close(self._descriptor)
                if name is not None:
                    raise
        self._cases: set[str] = set()
        try:
            self._mend()
        except BaseException:
            os.close(self._descriptor)
            raise

    def __enter__(self) -> Worker:
        return self

    def __exit__(self, *_: object) -> None:
        os.close(self._descriptor)

    def _lock(self) -> None:
        try:
            fcntl.flock(self._descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise BlockingIOError(errno.EAGAIN, "another process is writing it", str(self.file)) from None
        except OSError:
            pass  # where files cannot be locked

    def _mend(self) -> None:
        """Cut off an incomplete last line; begin an empty file. Of a long one only its ends are read."""
        size = os.fstat(self._descriptor).st_size
        self._size = self._last_line_end(size)
        if self._size < size:
            os.ftruncate(self._descriptor, self._size)
        origin = f"# stoss {_core.version}: sweep\n".encode("ascii")
        if self._size == 0:
            self._write(f"{origin.decode('ascii')}{self._layout.header}\n")
        elif os.pread(self._descriptor, len(origin), 0) != origin:
            raise InvalidInput.out_of_range(
                "store", f"'{self.file}'", f"a file of stoss {_core.version}", "use another store"
            )
        elif self._size == len(origin):  # killed between two lines of the header
            self._write(f"{self._layout.header}\n")
        elif (
            os.pread(self._descriptor, len(self._layout.unchecked) + 1, len(origin)).decode("ascii", "replace")
            == f"{self._layout.unchecked}\n"
        ):
            hint = "it can be merged; to go on, use another store"
            raise InvalidInput.out_of_range("store", f"'{self.file}' without checksums", "one with them", hint)

    def _last_line_end(self, size: int) -> int:
        """Where the last whole line ends."""
        while size:
            begin = max(0, size - (1 << 16))
            piece = os.pread(self._descriptor, size - begin, begin)
            if b"\n" in piece:
                return begin + piece.rindex(b"\n") + 1
            size = begin
        return 0

    def _write(self, text: str) -> None:
        """One write; what the disk does not take whole is taken back."""
        data = text.encode("ascii")
        self._require_unchanged()
        try:
            if os.write(self._descriptor, data) != len(data):
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        except OSError as error:
            with contextlib.suppress(OSError):
                os.ftruncate(self._descriptor, self._size)
            raise type(error)(error.errno, error.strerror, str(self.file)) from None
        self._size += len(data)

    def _require_unchanged(self) -> None:
        """Raise OSError where what is written would be in no file, or behind what another process has written."""
        own = os.fstat(self._descriptor)
        try:
            there = os.path.samestat(own, os.stat(self.file)) and own.st_size == self._size
        except FileNotFoundError:
            there = False
        if not there:
            raise OSError(errno.ESTALE, "another process has removed, replaced or changed it", str(self.file))

    def append(self, key: str, inputs: Any, point: Sequence[float], row: Row) -> None:
        """Add a row, before the first of a case also what the case is."""
        cells = [cell(known(name, value)) for name, value in zip(self._layout.columns, row)]
        comment = "" if key in self._cases else f"# case {key}: {json.dumps(inputs, sort_keys=True)}\n"
        self._write(f"{comment}{with_checksum(','.join((key, *map(repr, point), *cells)))}\n")
        self._cases.add(key)
        self.flush()

    def flush(self) -> None:
        """Let all rows so far survive a failure of the machine, not only of the process, if it is time again."""
        global _sent
        if time.monotonic() > _sent + OFTEN:
            os.fsync(self._descriptor)
            _sent = time.monotonic()


def flush(path: Path) -> None:
    """The same for all files of a store, now."""
    for file in path.glob("*.csv"):
        with open(file, "rb") as stream:
            os.fsync(stream.fileno())


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
    worker: Worker, computation: Computation, path: Path, pieces: Iterable[Piece], threads: int, tick: Tick | None
) -> int:
    """Compute pieces and append their values, with a tick after each. Returns how many."""
    return sum(_fill(worker, computation, path, piece, threads, tick) for piece in pieces)


def _fill(worker: Worker, computation: Computation, path: Path, piece: Piece, threads: int, tick: Tick | None) -> int:
    inputs, key, points = piece
    case = case_of_inputs(inputs, computation.accuracy, path)
    if case.key != key:
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

    computation.compute(case.body, computation.contact(case.body, case.against), points, threads, rows, keep)
    return done
