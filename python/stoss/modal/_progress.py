"""What a run says, and the file that it writes."""

from __future__ import annotations

import contextlib
import json
import os
import sys
import time
from typing import Any, Mapping

import numpy as np

from stoss._commands import say
from stoss.export._files import of_json, write_lines


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


FORMAT = "stoss modal body 1"
DIGITS = 12


def write(path: str, body: Mapping[str, Any]) -> None:
    """JSON, one line for each key, that appears whole or not at all."""
    keys = {"format": FORMAT, **body}
    text = {name: json.dumps(plain(value), ensure_ascii=False) for name, value in keys.items()}
    lines = [f" {json.dumps(name)}: {value}" for name, value in text.items()]
    write_lines(path, ["{\n", ",\n".join(lines), "\n}\n"])


def plain(value: Any) -> Any:
    """Numbers with as many digits as mean something, in lists and dictionaries."""
    if isinstance(value, Mapping):
        return {name: plain(each) for name, each in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [plain(each) for each in value]
    return value if isinstance(value, (str, int, bool)) else float(f"{float(value):.{DIGITS}g}")
