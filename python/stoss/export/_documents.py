"""JSON documents as they are read."""

from __future__ import annotations

import json
from typing import Any


def of_json(text: str) -> Any:
    """What a document holds. Raises ValueError for none, and where a key is twice in an object."""
    return json.loads(text, object_pairs_hook=_without_twins)


def _without_twins(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        names = [name for name, _ in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise ValueError(f"the key {twice!r} is there twice")
    return found
