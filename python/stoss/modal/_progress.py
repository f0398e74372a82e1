"""A line on stderr that says what is being done, and a file of what is done already."""

from __future__ import annotations

import contextlib
import json
import os
import sys
import time
from typing import Any

from stoss._commands import say
from stoss.export._documents import of_json
from stoss.export._files import write_lines


class Progress:
    """Shows steps of process 0 and keeps their results, so that a run that was killed goes on.

    Parameters:
        path: The file of results.
        key: What made them; those of other inputs are not used.
        first: Whether this is process 0, the only one that writes.
    """

    def __init__(self, path: str, key: str, first: bool) -> None:
        self.path, self.key, self.first = path, key, first
        self.results: dict[str, Any] = {}
        self._start, self._wide = time.monotonic(), 0
        with contextlib.suppress(OSError, ValueError, KeyError, TypeError):
            with open(path, encoding="utf-8") as stream:
                stored = of_json(stream.read())
            if stored["key"] == key:
                self.results = dict(stored["results"])

    def say(self, text: str, lasting: bool = True) -> None:
        """One line. One that does not last is overwritten by the next, or left out in a file."""
        terminal = sys.stderr is not None and sys.stderr.isatty()
        if not self.first or not (lasting or terminal):
            return
        line = f"stoss.modal: {time.monotonic() - self._start:5.0f} s  {text}"
        text = "\r" * terminal + line.ljust(self._wide) + "\n" * lasting
        say(text, end="")
        self._wide = 0 if lasting else len(line)

    def keep(self, name: str, result: Any) -> None:
        """Adds a result to the file."""
        self.results[name] = result
        if self.first:
            write_lines(self.path, [json.dumps({"key": self.key, "results": self.results})])

    def done(self) -> None:
        """All is in the output: the file of results is no longer needed."""
        if self.first:
            with contextlib.suppress(FileNotFoundError):
                os.unlink(self.path)
