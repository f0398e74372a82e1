"""What stderr shows while something is computed: a bar where values can be counted, else for how long it has gone on."""

from __future__ import annotations

import contextlib
import sys
import threading
import time
from typing import Any, Iterator

PATIENCE, PAUSE = 1.0, 0.5
"""Seconds before the first line of `waiting`, and to the next."""


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

    def update(self, done: int = 1) -> None:
        self._done += done
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


@contextlib.contextmanager
def waiting(wanted: bool, name: str) -> Iterator[None]:
    """A context that says for how long a call has gone on which cannot count what it does, if that is wanted.

    The core lets other threads run meanwhile: one of them writes the line.
    """
    if not wanted or sys.stderr is None:
        yield
        return
    ended, begun = threading.Event(), time.monotonic()

    def tell() -> None:
        pause, shown = PATIENCE, False
        while not ended.wait(pause):
            print(f"\r{name}: {time.monotonic() - begun:.1f} s", end="", file=sys.stderr, flush=True)
            pause, shown = PAUSE, True
        if shown:
            print(file=sys.stderr, flush=True)

    teller = threading.Thread(target=tell, name="stoss progress", daemon=True)
    teller.start()
    try:
        yield
    finally:
        ended.set()
        teller.join()
