"""Documents as JSON files and as NPZ files, in which what is nested has both names: modes_frequency."""

from __future__ import annotations

import json
import os
import zipfile
from typing import Any, Collection, Mapping

import numpy as np

from stoss._errors import InvalidInput
from stoss.export._files import whole_file, write_lines

Nested = Mapping[str, Collection[str]]
"""The names that are nested, by the name in which they are."""


def read_document(path: str | os.PathLike[str], nested: Nested) -> Any:
    """What a file holds, in plain types: an NPZ file if it is a ZIP archive, else JSON."""
    name = os.fspath(path)
    with open(name, "rb") as stream:
        packed = stream.read(2) == b"PK"
    try:
        if packed:
            return _unpacked(name, nested)
        with open(name, encoding="utf-8") as stream:
            return json.load(stream)
    except (ValueError, RecursionError, EOFError, zipfile.BadZipFile) as error:
        kind = "an NPZ file of numbers and texts" if packed else "a JSON document"
        raise InvalidInput(f"body: got none, allowed {kind} ({' '.join(str(error).split())})") from None


def write_document(path: str | os.PathLike[str], document: Mapping[str, Any], nested: Nested) -> None:
    """An NPZ file if its name ends in .npz, else JSON; it appears whole or not at all."""
    name = os.fspath(path)
    if not name.endswith(".npz"):
        write_lines(name, [json.dumps(document, ensure_ascii=False), "\n"])
        return
    flat = {key: each for key, each in document.items() if key not in nested}
    for key in nested:
        flat |= {f"{key}_{inner}": each for inner, each in document.get(key, {}).items()}
    with whole_file(name, ".npz") as temporary:
        np.savez_compressed(temporary, **{key: np.asarray(each) for key, each in flat.items()})


def _unpacked(name: str, nested: Nested) -> dict[str, Any]:
    document: dict[str, Any] = {}
    with np.load(name, allow_pickle=False) as file:
        arrays = {key: file[key] for key in file.files}
    for key, array in arrays.items():
        outer, _, inner = key.replace(".", "_", 1).partition("_")
        value = array.item() if array.ndim == 0 else array.tolist()
        if outer in nested and inner in nested[outer]:
            document.setdefault(outer, {})[inner] = value
        else:
            document[key] = value
    return document
