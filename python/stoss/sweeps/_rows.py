"""The lines of a store's files: what a row holds, and how it is read."""

from __future__ import annotations

import math
import re
import zlib
from pathlib import Path
from typing import Any, Iterable, Iterator, NamedTuple

import numpy as np

from stoss import _core
from stoss._errors import InvalidInput
from stoss.export import _files
from stoss.export._files import of_json
from stoss.export._tables import UNKNOWN
from stoss.sweeps._computation import Computation

ORIGIN = re.compile(rf"# stoss ({_files.VERSION}): sweep", re.ASCII)

CHECKSUM = "checksum"
"""The last column: of what stands before it in its line. Files of stoss 1.0 have none."""

Row = tuple[Any, ...]


def with_checksum(text: str) -> str:
    """A row with its last cell, by which a changed one is found: CRC-32 of all before it, hexadecimal."""
    return f"{text},{zlib.crc32(text.encode('ascii')):08x}"


class Layout:
    """What a row of a computation holds: the key of its case, its point along the axes, what was found."""

    def __init__(self, computation: Computation) -> None:
        self.axes, self.columns = computation.axes, computation.columns
        self.types = [computation.row[name] for name in self.columns]
        self.unchecked = ",".join(("case", *self.axes, *self.columns))
        self.header = f"{self.unchecked},{CHECKSUM}"


class Stored(NamedTuple):
    """A row, where it belongs, and which version of stoss computed it."""

    key: str
    point: tuple[float, ...]
    row: Row
    version: str


def stored(file: Path, layout: Layout, mix: bool) -> Iterator[Stored]:
    """The rows of a file, but for an incomplete last line.

    Raises InvalidInput for a damaged line, and without `mix` for a file of another version.
    """
    with open(file, "rb") as stream:
        yield from _stored(file, stream, layout, mix)


def _stored(file: Path, lines: Iterable[bytes], layout: Layout, mix: bool) -> Iterator[Stored]:
    version, names = "", list[str]()
    cases = set[str]()
    for number, line in enumerate(lines, start=1):
        if not line.endswith(b"\n"):
            return  # the worker was killed amid a write
        line = line[:-1]
        if number == 1:
            version = _version(file, line, mix)
            continue
        try:
            text = line.decode("ascii")
            if text.startswith("# case "):
                key, _, inputs = text.removeprefix("# case ").partition(": ")
                of_json(inputs)
                cases.add(key)
            elif text.startswith("# "):
                continue
            elif not names:
                names = text.split(",")
                needed = {"case", *layout.axes, *layout.columns}
                if version == _core.version and text not in (layout.header, layout.unchecked) or not needed <= set(names):
                    raise ValueError
                take = [names.index(name) for name in ("case", *layout.axes, *layout.columns)]
            else:
                cells = text.split(",")
                if len(cells) != len(names):
                    raise ValueError
                if names[-1] == CHECKSUM and text != with_checksum(text.rpartition(",")[0]):
                    raise _damaged(file, number, line, "its checksum is that of another row")
                key, *others = [cells[k] for k in take]
                if key not in cases:
                    raise ValueError
                point = tuple(map(float, others[: len(layout.axes)]))
                yield Stored(key, point, tuple(map(_value, layout.types, others[len(layout.axes) :])), version)
        except InvalidInput:
            raise
        except (ValueError, KeyError, RecursionError):
            raise _damaged(file, number, line) from None


def _version(file: Path, line: bytes, mix: bool) -> str:
    origin = ORIGIN.fullmatch(line.decode("utf-8", "replace"))
    if origin is None:
        raise _damaged(file, 1, line)
    _files.require_readable("store", str(file), origin[1])
    if origin[1] != _core.version and not mix:
        hint = "another version needs another store"
        raise InvalidInput.out_of_range("store", f"'{file}' of stoss {origin[1]}", _core.version, hint)
    return origin[1]


def _damaged(file: Path, number: int, line: bytes, why: str = "") -> InvalidInput:
    got = "".join(c if c.isprintable() else "?" for c in line[:40].decode("ascii", "replace"))
    hint = f"{why}: delete it, and it is computed again" if why else "mend or delete it"
    return InvalidInput.out_of_range("store", f"'{got}' as line {number} of '{file}'", "a row of a sweep", hint)


def _value(of: np.dtype[Any], cell: str) -> Any:
    if of.kind == "b":
        return {"true": True, "false": False}[cell]
    if of.kind in "iu":
        number, range_ = int(cell), np.iinfo(of)
        if not range_.min <= number <= range_.max:
            raise ValueError
        return number
    return math.inf if cell == UNKNOWN else float(cell)
