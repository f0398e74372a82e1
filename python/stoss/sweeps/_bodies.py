"""Bodies of files in a store: once, in a file named by its content, to which all else there refers.

A store needs no other file then, workers read what they need from it, and a file that has changed since is noticed.
"""

from __future__ import annotations

import functools
import hashlib
import json
import re
from pathlib import Path
from typing import Any, Iterator, Mapping

from stoss._arguments import refusal
from stoss._errors import InvalidInput
from stoss.bodies._modal import ModalBody
from stoss.bodies._faces import FACE, face_of
from stoss.bodies._kinds import KINDS, Specification
from stoss.bodies._solid import Solid, describe
from stoss.export._files import of_json, write_lines

DIGEST = "sha256"


def reference(solid: Solid) -> Specification:
    """What describes it; a body of a file by its name and the hash of its document."""
    if not isinstance(solid, ModalBody):
        return describe(solid)
    return {**_named(solid._kind, solid.name, _text(solid.to_dict())), **face_of(solid)}


def without_documents(grid: Specification) -> tuple[Specification, dict[str, str]]:
    """The inputs of a grid with references for the bodies of files, and the documents by their hashes."""
    documents: dict[str, str] = {}

    def short(given: Specification) -> Specification:
        if not _of_file(given):
            return given
        text = _text(given["body"])
        named = _named(given["kind"], given["body"].get("name", ""), text)
        documents[named[DIGEST]] = text
        return {**named, **_face(given)}

    bodies = {name: [short(each) for each in grid[name]] for name in ("bodies", "against") if name in grid}
    return {**grid, **bodies}, documents


def with_documents(grid: Mapping[str, Any], store: Path) -> dict[str, Any]:
    """The inputs of a grid with the bodies to which they refer."""
    found = dict(grid)
    for name in ("bodies", "against"):
        if isinstance(found.get(name), list):
            found[name] = [resolved(each, store) for each in found[name]]
    return found


def resolved(given: Any, store: Path) -> Any:
    """What describes a body, where it may be a reference.

    Raises InvalidInput for a file in the store that is missing or damaged.
    """
    if not isinstance(given, Mapping) or DIGEST not in given:
        return given
    return {"kind": given.get("kind"), "body": _read(str(store), given[DIGEST]), **_face(given)}


def _face(given: Mapping[str, Any]) -> Specification:
    """How rough its face is, which is not of the file."""
    return {name: given[name] for name in FACE if name in given}


def keep(documents: Mapping[str, str], store: Path) -> None:
    """Write the documents that the store does not have. Each file appears whole or not at all."""
    for digest, text in documents.items():
        if not _path(store, digest).exists():
            write_lines(_path(store, digest), [text, "\n"])


def changed(one: Specification, other: Specification) -> Iterator[str]:
    """Names of bodies of files in the inputs of a grid of which other inputs have another document."""
    for name in ("bodies", "against"):
        for mine, its in zip(one.get(name, []), other.get(name, [])):
            if isinstance(mine, Mapping) and isinstance(its, Mapping) and DIGEST in mine and DIGEST in its:
                if mine[DIGEST] != its[DIGEST] and mine.get("name") == its.get("name"):
                    yield str(mine.get("name"))


@functools.lru_cache(maxsize=64)
def _read(store: str, digest: str) -> ModalBody:
    if not re.fullmatch(r"[0-9a-f]{16}", str(digest), re.ASCII):
        raise refusal(f"store: {DIGEST}", digest, "16 hexadecimal digits")
    path = _path(Path(store), digest)
    try:
        text = path.read_text(encoding="ascii").strip()
    except (FileNotFoundError, UnicodeDecodeError):
        text = ""
    if _hash(text) != digest:
        raise InvalidInput.out_of_range("store", f"a missing or damaged '{path}'", "the body that the grid names")
    return ModalBody.from_dict(of_json(text))


def _path(store: Path, digest: Any) -> Path:
    return store / f"body-{digest}.json"


def _of_file(given: Mapping[str, Any]) -> bool:
    return given["kind"] in KINDS and KINDS[given["kind"]].from_file


def _named(kind: str, name: str, text: str) -> Specification:
    return {"kind": kind, "name": name, DIGEST: _hash(text)}


def _text(document: Mapping[str, Any]) -> str:
    return json.dumps(document, sort_keys=True)


def _hash(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:16]
