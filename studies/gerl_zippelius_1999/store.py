"""The tables of an item on disk: CSV with all digits, read as they were written, bit for bit.

DIR/data/<item>/<table>.csv and, written last, DIR/data/<item>/item.json with the key of what made
them and a hash of each file. Tables count only if the key is the wanted one and every hash is
right: a run that was killed, two runs at once or an edited file lead to a new computation, never to
a wrong picture.
"""

from __future__ import annotations

import ast
import contextlib
import csv
import hashlib
import io
import itertools
import json
import os
import re
import tempfile
from pathlib import Path
from typing import Callable

import numpy as np
import stoss

from gerl_zippelius_1999.common import Table, Tables

PACKAGE = Path(__file__).parent
LIST = "item.json"
LOADED = {".py", ".so", ".pyd"}  # what Python loads of a package


def item_key(item: str, quick: bool) -> str:
    """Hash of all that the tables depend on: the item, its imports from the study, and stoss."""
    digest = hashlib.sha256(f"{stoss.__version__} {quick}\n".encode())
    package = Path(stoss.__file__).parent
    for path in (*_sources(item), *sorted(path for path in package.rglob("*") if path.suffix in LOADED)):
        digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()


def _sources(item: str) -> list[Path]:
    """Of the item, `common`, and the modules of the study that they import, directly or not."""
    found: set[str] = set()
    wanted = ["common", item]
    while wanted:
        name = wanted.pop()
        path = PACKAGE / f"{name}.py"
        if name in found or not path.is_file():
            continue
        found.add(name)
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom):
                *_, last = (node.module or "").split(".")
                wanted += [last, *(each.name for each in node.names)]
            elif isinstance(node, ast.Import):
                wanted += [each.name.split(".")[-1] for each in node.names]
    return [PACKAGE / f"{name}.py" for name in sorted(found)]


def load(folder: Path, key: str) -> Tables | None:
    """The tables in the folder, None if they are not whole or another key made them."""
    try:
        kept = json.loads((folder / LIST).read_text(encoding="utf-8"))
        if kept["key"] != key:
            return None
        tables: Tables = {}
        for name, table in kept["tables"].items():
            text = (folder / f"{name}.csv").read_bytes()
            if hashlib.sha256(text).hexdigest() != table["sha256"]:
                return None
            tables[name] = _read(text.decode(), table["types"])
        return tables
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None


def save(folder: Path, key: str, tables: Tables, head: str) -> None:
    """Writes the tables; the list, which makes them valid, last.

    Raises
    ------
    ValueError
        If they are not what an item may return.
    """
    texts = {name: _written(name, table, head) for name, table in tables.items()}
    folder.mkdir(parents=True, exist_ok=True)
    kept = {}
    for name, text in texts.items():
        write(folder / f"{name}.csv", text.encode())
        types = {column: np.asarray(values).dtype.kind for column, values in tables[name].items()}
        kept[name] = {"sha256": hashlib.sha256(text.encode()).hexdigest(), "types": types}
    write(folder / LIST, json.dumps({"key": key, "tables": kept}, indent=1, ensure_ascii=False).encode())
    for path in folder.glob("*.csv"):
        if path.stem not in texts:
            path.unlink(missing_ok=True)


def write(path: Path, content: bytes) -> None:
    """The whole file or none: a reader never sees half of it."""
    descriptor, temporary = tempfile.mkstemp(dir=path.parent, prefix=".part-")
    try:
        with open(descriptor, "wb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(temporary, 0o666 & ~mask)
        os.replace(temporary, path)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
        raise


def sweep(folder: Path) -> None:
    """Takes away what killed runs left."""
    for path in folder.rglob(".part-*"):
        path.unlink(missing_ok=True)


def _written(name: str, table: Table, head: str) -> str:
    if not re.fullmatch(r"[a-z0-9_]+", name):
        raise ValueError(f"table: got the name {name!r}, allowed a-z, 0-9 and _")
    columns = {column: np.asarray(values) for column, values in table.items()}
    for column, values in columns.items():
        if values.ndim != 1 or values.dtype.kind not in "fiubU":
            raise ValueError(f"{name}: {column}: got {values.ndim}-D {values.dtype}, allowed 1-D numbers or text")
    lengths = {column: len(values) for column, values in columns.items()}
    if len(set(lengths.values())) != 1:
        raise ValueError(f"{name}: got columns of different lengths, {lengths}")
    stream = io.StringIO()
    stream.write(head)
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(zip(*(values.tolist() for values in columns.values())))
    return stream.getvalue()


def _read(text: str, types: dict[str, str]) -> Table:
    stream = io.StringIO(text, newline="")
    names, *rows = csv.reader(itertools.dropwhile(lambda line: line.startswith("#"), stream))
    if list(types) != names:
        raise ValueError("columns are not those of the list")
    columns = zip(*rows) if rows else [()] * len(names)
    kinds: dict[str, Callable[[str], object]]
    kinds = {"f": float, "i": int, "u": int, "U": str, "b": "True".__eq__}
    dtypes = {"f": np.float64, "i": np.int64, "u": np.int64, "U": np.str_, "b": np.bool_}
    return {
        name: np.array([kinds[types[name]](cell) for cell in cells], dtype=dtypes[types[name]])
        for name, cells in zip(names, columns)
    }
