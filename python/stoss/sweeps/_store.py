"""The store of a sweep: a directory with the grid, and a CSV file of each worker.

A file begins with the version of stoss and the names of the columns. Before its first row of a case
comes a comment with the key of the case, a hash of all inputs but the speed, and these inputs; each
row begins with this key and the speed. A row is appended by one write, so that a worker that is
killed leaves whole lines and at most one incomplete last one, which does not count. Files are never
rewritten: only the incomplete line is cut off before its worker appends again.
"""

from __future__ import annotations

import contextlib
import errno
import fcntl
import json
import math
import os
import re
import socket
import tempfile
import threading
from pathlib import Path
from typing import Any, Dict, Iterator, NamedTuple, Tuple

from stoss import _core
from stoss._errors import InvalidInput
from stoss.export import _formats
from stoss.export._files import usual_mode
from stoss.export._text import UNKNOWN, cell, known
from stoss.sweeps._grid import Grid


GRID = "grid.json"
COLUMNS: tuple[str, ...] = _core.restitution_row.names or ()
HEADER = ",".join(("case", "speed", *COLUMNS))
KINDS = {name: kind.kind for name, (kind, *_) in (_core.restitution_row.fields or {}).items()}
ORIGIN = re.compile(r"# stoss (\S+): sweep")

Row = Tuple[Any, ...]


class Stored(NamedTuple):
    """A row, and which version of stoss computed it."""

    row: Row
    version: str


def create(store: str | os.PathLike[str], grid: Grid) -> Path:
    """The directory of the store of this grid, made where it is not there yet.

    Raises InvalidInput if it is the store of another grid, OSError if it cannot be written.
    """
    path = Path(store)
    path.mkdir(parents=True, exist_ok=True)
    if not (path / GRID).exists():
        if any(path.glob("*.csv")):
            raise InvalidInput(f"store: got '{path}', which has CSV files but no {GRID}, allowed a store or a new name")
        descriptor, temporary = tempfile.mkstemp(dir=path, prefix=".grid-", text=True)
        try:
            with open(descriptor, "w", encoding="utf-8") as stream:
                stream.write(json.dumps({"format": _formats.GRID, **grid.to_dict()}, indent=1) + "\n")
                stream.flush()
                os.fsync(stream.fileno())
            os.chmod(temporary, usual_mode())
            with contextlib.suppress(FileExistsError):  # another worker was faster
                os.link(temporary, path / GRID)
        finally:
            os.unlink(temporary)
    if read_grid(path) != grid:
        raise InvalidInput(f"store: got '{path}' of another grid, allowed one of this grid (another needs another store)")
    return path


def read_grid(path: Path) -> Grid:
    """The grid of a store. Raises InvalidInput if there is none, OSError if it cannot be read."""
    try:
        return Grid.from_dict(json.loads((path / GRID).read_text(encoding="utf-8")))
    except (FileNotFoundError, NotADirectoryError):
        raise InvalidInput(f"store: got '{path}', allowed the directory of a sweep, with its {GRID}") from None
    except (ValueError, TypeError, RecursionError) as error:
        raise InvalidInput(f"store: got a damaged '{path / GRID}', allowed that of a sweep ({error})") from None


def read(path: Path, keys: set[str], mix: bool = False) -> dict[tuple[str, float], Stored]:
    """All rows of a store by key and speed.

    Raises InvalidInput for a damaged line, for rows of another version or of inputs that are not in
    `keys`, and where two rows of one value differ by more than their errors. With `mix` rows of
    other versions count too, where this one has none, and rows of other inputs are left out.
    """
    found: Dict[tuple[str, float], Stored] = {}
    for file in sorted(path.glob("*.csv")):
        for key, speed, stored in _rows(file, mix):
            if key not in keys:
                if mix:
                    continue
                raise InvalidInput(f"store: got inputs in '{file}' that are not in its grid, allowed those of the grid")
            before = found.setdefault((key, speed), stored)
            if before.version != stored.version:
                if stored.version == _core.version:
                    found[key, speed] = stored
            elif not _agree(before.row, stored.row):
                raise InvalidInput(f"store: got another value of case {key}, speed {speed!r} in '{file}', allowed one")
    return found


def _agree(one: Row, other: Row) -> bool:
    if one == other:
        return True
    value, error = COLUMNS.index("restitution"), COLUMNS.index("restitution_error")
    both_nan = math.isnan(one[value]) and math.isnan(other[value])
    return both_nan or abs(one[value] - other[value]) <= one[error] + other[error]


def _rows(file: Path, mix: bool) -> Iterator[tuple[str, float, Stored]]:
    with open(file, "rb") as stream:
        *lines, _ = stream.read().split(b"\n")  # behind the last line end is nothing, or an incomplete line
    if not lines:
        return
    origin = ORIGIN.fullmatch(lines[0].decode("utf-8", "replace"))
    if origin is None:
        raise _damaged(file, 1, lines[0])
    version = origin[1]
    _formats.require_readable("store", str(file), version)
    if version != _core.version and not mix:
        raise InvalidInput(
            f"store: got '{file}' of stoss {version}, allowed {_core.version} (another version needs another store)"
        )
    cases, names = set[str](), list[str]()
    for number, line in enumerate(lines[1:], start=2):
        try:
            text = line.decode("ascii")
            if text.startswith("# case "):
                key, _, inputs = text.removeprefix("# case ").partition(": ")
                json.loads(inputs)
                cases.add(key)
            elif text.startswith("# "):
                continue
            elif not names:
                names = text.split(",")
                if version == _core.version and text != HEADER or not set(COLUMNS) <= set(names):
                    raise ValueError
            else:
                key, speed, row = _parse(text, names)
                if key not in cases:
                    raise ValueError
                yield key, speed, Stored(row, version)
        except (ValueError, KeyError):
            raise _damaged(file, number, line) from None


def _damaged(file: Path, number: int, line: bytes) -> InvalidInput:
    got = "".join(c if c.isprintable() else "?" for c in line[:40].decode("ascii", "replace"))
    return InvalidInput(f"store: got '{got}' as line {number} of '{file}', allowed a row of a sweep (mend or delete it)")


def _parse(line: str, names: list[str]) -> tuple[str, float, Row]:
    cells = line.split(",")
    if len(cells) != len(names):
        raise ValueError
    by_name = dict(zip(names, cells))
    return by_name["case"], float(by_name["speed"]), tuple(_value(KINDS[name], by_name[name]) for name in COLUMNS)


def _value(kind: str, cell: str) -> Any:
    if kind == "b":
        return {"true": True, "false": False}[cell]
    if kind in "iu":
        return int(cell)
    return math.inf if cell == UNKNOWN else float(cell)


class Worker:
    """The file of one worker, locked against others while it is open."""

    def __init__(self, path: Path, name: str | None = None) -> None:
        """Open `name`.csv, or a file of this thread of this machine.

        Raises BlockingIOError while another process writes it, InvalidInput if it is of another
        version, OSError if it cannot be written.
        """
        own = f"worker-{re.sub(r'[^A-Za-z0-9]', '-', socket.gethostname())}-{threading.get_native_id()}"
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
        """Cut off an incomplete last line; begin an empty file."""
        content = b""
        while piece := os.pread(self._descriptor, 1 << 20, len(content)):
            content += piece
        whole = content.rfind(b"\n") + 1
        if whole < len(content):
            os.ftruncate(self._descriptor, whole)
        self._size = whole
        if whole == 0:
            self._write(f"# stoss {_core.version}: sweep\n{HEADER}\n")
        elif content[:whole].split(b"\n", 1)[0] != f"# stoss {_core.version}: sweep".encode():
            raise InvalidInput(f"store: got '{self.file}', allowed a file of stoss {_core.version} (use another store)")
        elif content.count(b"\n", 0, whole) == 1:  # killed between two lines of the header
            self._write(f"{HEADER}\n")

    def _write(self, text: str) -> None:
        """One write; what the disk does not take whole is taken back."""
        data = text.encode("ascii")
        try:
            if os.write(self._descriptor, data) != len(data):
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        except OSError as error:
            with contextlib.suppress(OSError):
                os.ftruncate(self._descriptor, self._size)
            raise type(error)(error.errno, error.strerror, str(self.file)) from None
        self._size += len(data)

    def append(self, key: str, inputs: Any, speed: float, row: Row) -> None:
        """Add a row, before the first of a case also what the case is."""
        cells = [cell(known(name, value)) for name, value in zip(COLUMNS, row)]
        comment = "" if key in self._cases else f"# case {key}: {json.dumps(inputs, sort_keys=True)}\n"
        self._write(f"{comment}{','.join((key, repr(speed), *cells))}\n")
        self._cases.add(key)

    def flush(self) -> None:
        """Let all rows so far survive a failure of the machine, not only of the process."""
        os.fsync(self._descriptor)
