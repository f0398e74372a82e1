"""The subcommands that the command stoss hands over to this package.

Exit codes are those of the command: 0 all is there, 1 not converged, 2 usage, 3 bad input, 4 input or
output, 130 interrupted.
"""

from __future__ import annotations

import argparse
import contextlib
import errno
import importlib
import io
import os
import signal
import sys
import warnings
from typing import Any, Callable, NoReturn, Sequence

from stoss import _starting
from stoss._errors import InvalidInput, NotConverged, StossWarning

NAMES = ("sweep", "merge", "fit", "calibrate", "table")


class Usage(Exception):
    """Words that are no command."""


class StdoutError(Exception):
    """Stdout cannot be written; `args` are the number of the error and its words."""


class Parser(argparse.ArgumentParser):
    """One that leaves what is wrong to us."""

    def error(self, message: str) -> NoReturn:
        raise Usage(f"{message} (see stoss --help or {self.prog} --help)")


def main(words: Sequence[str]) -> int:
    """Run one of them. Returns the exit code."""
    return int(importlib.import_module("stoss._subcommands").main(words))


def run_alone(words: Sequence[str], pipe: bool = True) -> int:
    """Run one of them in a process of its own. Returns the exit code.

    Text is UTF-8, as that of the command, whatever the locale is. `pipe`: whether a stdout that nobody
    reads any more ends the process, as it ends others.
    """
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # None where the descriptor is closed
            stream.reconfigure(encoding="utf-8", errors="surrogateescape")  # bytes of arguments come out as they were
    code = 130
    try:
        code = main(words)
    except StdoutError as error:
        if error.args[0] == errno.EPIPE and pipe:
            signal.signal(signal.SIGPIPE, signal.SIG_DFL)
            os.kill(os.getpid(), signal.SIGPIPE)
        code = 4 if error.args[0] == errno.EPIPE else _complain(4, f"output: cannot write to stdout: {error.args[1]}")
    except KeyboardInterrupt:  # while something else was said
        pass
    finally:
        _starting.ignore()
    return code


def put(text: str) -> None:
    """Write a line on stdout, now. Raises StdoutError."""
    try:
        if sys.stdout is None:
            raise OSError(errno.EBADF, os.strerror(errno.EBADF))
        print(text, flush=True)
    except OSError as error:
        _forget(sys.stdout)
        raise StdoutError(error.errno, error.strerror) from None


def say(text: str, end: str = "\n") -> None:
    """Write a line on stderr. If it cannot be written, it is lost and nothing else changes."""
    if sys.stderr is None:  # print would take stdout
        return
    try:
        print(text, end=end, file=sys.stderr, flush=True)
    except (OSError, ValueError):
        _forget(sys.stderr)


def on_terminal() -> bool:
    """Whether somebody sees how far a command is."""
    return sys.stderr is not None and sys.stderr.isatty()


def _forget(stream: Any) -> None:
    """Let what a stream has not written go nowhere, where Python would complain of it at the end."""
    with contextlib.suppress(OSError, ValueError, AttributeError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)


def guarded(run: Callable[[], int], interrupted: str) -> int:
    """What `run` returns, after its warnings, or the exit code of what went wrong, which one line says."""
    try:
        _starting.heed()
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", StossWarning)
            code = run()
        for text in dict.fromkeys(str(each.message) for each in caught if issubclass(each.category, StossWarning)):
            say(f"stoss: warning: {text}")
        return code
    except Usage as error:
        return _complain(2, str(error))
    except NotConverged as error:
        return _complain(1, str(error))
    except (InvalidInput, UnicodeError) as error:
        return _complain(3, str(error))
    except (OSError, ImportError) as error:
        text = f"'{error.filename}': {error.strerror}" if isinstance(error, OSError) and error.filename else str(error)
        return _complain(4, f"output: cannot read or write {text}" if isinstance(error, OSError) else text)
    except KeyboardInterrupt:
        return _complain(130, interrupted)


def _complain(code: int, text: str) -> int:
    line = " ".join(text.split())
    say(f"stoss: error: {line if len(line) <= 500 else line[:500] + '...'}")
    return code
