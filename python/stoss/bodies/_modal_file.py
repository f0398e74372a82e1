"""Documents as JSON files and as NPZ files, in which what is nested has both names: modes_frequency."""

from __future__ import annotations

import io
import json
import os
from typing import Any, Collection, Mapping

import numpy as np

from stoss._arguments import open_file
from stoss._errors import InvalidInput
from stoss.export._files import of_json, whole_file, write_lines

Nested = Mapping[str, Collection[str]]
"""The names that are nested, by the name in which they are."""


MOST = 64 << 20
"""Bytes of a file, and of what an archive unpacks to; the command reads as much."""


def read_document(path: str | os.PathLike[str], nested: Nested) -> Any:
    """What a file holds, in plain types: an NPZ file if it is a ZIP archive, else JSON."""
    with open_file("body", path) as stream:
        content = stream.read(MOST + 1)
    if len(content) > MOST:
        raise InvalidInput.out_of_range("body", "more than 64 MiB", "a file of modes at a point")
    packed = content.startswith(b"PK")
    try:
        return _unpacked(content, nested) if packed else of_json(content.decode("utf-8"))
    except Exception as error:  # there are no names for all that zipfile and NumPy find wrong with bytes
        kind = "an NPZ file of numbers and texts" if packed else "a JSON document"
        raise InvalidInput.conflict("body", f"not {kind}", _line(error)) from None


def _line(error: Exception) -> str:
    """What is wrong, on one line that can be printed."""
    text = " ".join(str(error).split())[:200]
    return "".join(c if c.isprintable() else "?" for c in text) or type(error).__name__


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


def _unpacked(content: bytes, nested: Nested) -> dict[str, Any]:
    import zipfile  # slow to import

    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        if sum(each.file_size for each in archive.infolist()) > MOST:  # of which zipfile reads no more than that
            raise ValueError("it unpacks to more than 64 MiB")
    with np.load(io.BytesIO(content), allow_pickle=False) as file:
        if len(set(file.files)) < len(file.files):
            raise ValueError("a name is there twice")
        arrays = {key: file[key] for key in file.files}
    document: dict[str, Any] = {}
    for key, array in arrays.items():
        outer, _, inner = key.replace(".", "_", 1).partition("_")
        value = array.item() if array.ndim == 0 else array.tolist()
        if outer in nested and inner in nested[outer]:
            if inner in document.setdefault(outer, {}):  # as modes.frequency and modes_frequency
                raise ValueError(f"{outer} {inner} is there twice")
            document[outer][inner] = value
        else:
            document[key] = value
    return document
