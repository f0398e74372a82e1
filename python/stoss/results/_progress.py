"""A bar on stderr while a curve is computed."""

from __future__ import annotations

import contextlib
import sys
from typing import Any


class PlainBar:
    """What tqdm would show, without tqdm."""

    def __init__(self, total: int) -> None:
        self._total = total
        self._done = 0

    def __enter__(self) -> PlainBar:
        self._show()
        return self

    def __exit__(self, *_: object) -> None:
        print(file=sys.stderr)

    def update(self) -> None:
        self._done += 1
        self._show()

    def _show(self) -> None:
        full = 30 * self._done // max(self._total, 1)
        print(f"\r[{'#' * full}{'.' * (30 - full)}] {self._done}/{self._total}", end="", file=sys.stderr, flush=True)


def bar(total: int, wanted: bool, name: str = "restitution") -> Any:
    """A context with a bar, tqdm's if it is there; with None unless wanted."""
    if not wanted or sys.stderr is None:  # as under pythonw, or with a closed stderr
        return contextlib.nullcontext()
    try:
        from tqdm import tqdm
    except ImportError:
        return PlainBar(total)
    return tqdm(total=total, desc=name, unit="value")
