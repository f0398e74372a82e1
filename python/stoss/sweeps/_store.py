"""The store of a sweep: a directory with the grid, a CSV file of each worker, and the bodies of files.

A CSV file begins with the version of stoss and the names of the columns. Before its first row of a case
comes a comment with the key of the case, a hash of all inputs but the point, and these inputs; each
row begins with this key and the point, the speed and the other axes, and ends with a checksum. A row
is appended by one write, so that a worker that is killed leaves whole lines and at most one incomplete
last one, which does not count. Files are never rewritten: only the incomplete line is cut off before its
worker appends again.
"""

from __future__ import annotations

import contextlib
import json
import os
import tempfile
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._errors import InvalidInput
from stoss.export import _files
from stoss.export._files import of_json, usual_mode
from stoss.sweeps._bodies import changed, keep, with_documents, without_documents
from stoss.sweeps._grid import Grid
from stoss.sweeps._rows import Layout, Stored, stored

GRID = "grid.json"


class Found(NamedTuple):
    """What a store has of a grid: arrays of its shape. A version is a number among the versions, or −1."""

    rows: NDArray[Any]
    version: NDArray[np.int16]
    versions: list[str]


def create(store: str | os.PathLike[str], grid: Grid) -> Path:
    """The directory of the store of this grid, made where it is not there yet.

    Raises InvalidInput if it is the store of another grid, OSError if it cannot be written.
    """
    path = Path(store)
    path.mkdir(parents=True, exist_ok=True)
    short, documents = without_documents(grid.to_dict())
    if not (path / GRID).exists():
        if any(path.glob("*.csv")):
            raise InvalidInput.out_of_range(
                "store", f"'{path}', which has CSV files but no {GRID}", "a store or a new name"
            )
        keep(documents, path)
        descriptor, temporary = tempfile.mkstemp(dir=path, prefix=".grid-", text=True)
        try:
            with open(descriptor, "w", encoding="utf-8") as stream:
                stream.write(json.dumps({"format": _files.GRID, **short}, indent=1) + "\n")
                stream.flush()
                os.fsync(stream.fileno())
            os.chmod(temporary, usual_mode())
            with contextlib.suppress(FileExistsError):  # another worker was faster
                os.link(temporary, path / GRID)
        finally:
            os.unlink(temporary)
    _require_same(path, short)
    return path


def _require_same(path: Path, short: dict[str, Any]) -> None:
    there = _inputs(path)
    if there == short:
        return
    if names := list(changed(short, there)):
        hint = "its file has changed; another body needs another store"
        raise InvalidInput.out_of_range("store", f"'{path}' of other numbers of body '{names[0]}'", "the same", hint)
    raise InvalidInput.out_of_range(
        "store", f"'{path}' of another grid", "one of this grid", "another needs another store"
    )


def read_grid(path: Path) -> Grid:
    """The grid of a store. Raises InvalidInput if there is none, OSError if it cannot be read."""
    given = with_documents(_inputs(path), path)
    try:
        return Grid.from_dict(given)
    except (ValueError, TypeError, RecursionError) as error:
        raise _damaged(path, error) from None


def _inputs(path: Path) -> dict[str, Any]:
    """Those of the grid, as its file has them. Refuses what would be waited for: a FIFO among the files."""
    for file in (path / GRID, *sorted(path.glob("*.csv"))):
        if file.exists() and not file.is_file():
            raise InvalidInput.out_of_range("store", f"'{file}', which is no regular file", "the files of a sweep")
    try:
        found = of_json((path / GRID).read_text(encoding="utf-8"))
    except (FileNotFoundError, NotADirectoryError):
        raise InvalidInput.out_of_range("store", f"'{path}'", f"the directory of a sweep, with its {GRID}") from None
    except (ValueError, RecursionError) as error:
        raise _damaged(path, error) from None
    if not isinstance(found, dict):
        raise _damaged(path, "no mapping")
    if "format" in found:
        _files.require("format", found.pop("format"), _files.GRID)
    return found


def _damaged(path: Path, error: object) -> InvalidInput:
    return InvalidInput.out_of_range("store", f"a damaged '{path / GRID}'", "that of a sweep", error)


def read(path: Path, grid: Grid, mix: bool = False) -> Found:
    """All rows of a store.

    Raises InvalidInput for a damaged line, for rows of another version or of inputs that are not in
    the grid, and where two rows of one value differ by more than their errors or, of what has none,
    by more than rounding. With `mix` rows of
    other versions count too, where this one has none, and rows of other inputs are left out.
    """
    layout = Layout(grid.computation)
    found = Found(grid.computation.empty(grid.shape), np.full(grid.shape, -1, dtype=np.int16), [])
    cases = {case.key: case.place for case in grid.cases()}
    along = [{value: k for k, value in enumerate(axis.tolist())} for axis in grid.axes.values()]
    for file in sorted(path.glob("*.csv")):
        for each in stored(file, layout, mix):
            try:
                place = (*cases[each.key], *(axis[value] for axis, value in zip(along, each.point)))
            except KeyError:
                if mix:
                    continue
                raise InvalidInput.out_of_range(
                    "store", f"inputs in '{file}' that are not in its grid", "those of the grid"
                ) from None
            _put(found, place, each, file)
    return found


def _put(found: Found, place: tuple[int, ...], new: Stored, file: Path) -> None:
    """Keep a row where there is none; one of this version also instead of one of another."""
    if new.version not in found.versions:
        found.versions.append(new.version)
    number = found.versions.index(new.version)
    before = int(found.version[place])
    if before < 0 or before != number and new.version == _core.version:
        found.rows[place], found.version[place] = new.row, number
    elif before == number and not _agree(found.rows[place], new.row, found.rows.dtype.names or ()):
        point = ", ".join(map(repr, new.point))
        raise InvalidInput.out_of_range("store", f"another value of case {new.key}, at {point} in '{file}'", "one")


def _agree(one: Any, row: tuple[Any, ...], names: tuple[str, ...]) -> bool:
    """Whether two rows are of one value: equal, but for last digits, which machines of two kinds may differ in."""
    if one.item() == row:
        return True
    other = dict(zip(names, row))
    for name in names:
        mine, its = one[name], other[name]
        if not isinstance(its, float):
            same = mine == its
        elif name.endswith("_error") and name.removesuffix("_error") in names:
            continue
        elif np.isnan(mine) or np.isnan(its):
            same = np.isnan(mine) and np.isnan(its)
        else:
            error, tiny = f"{name}_error", 1e-9 * max(abs(mine), abs(its))
            same = mine == its or abs(mine - its) <= (one[error] + other[error] if error in names else tiny)
        if not same:
            return False
    return True
