"""Ctrl-C while a command is being imported, which takes most of its first second: one line, no traceback."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from typing import Any


def end_quietly() -> None:
    """Let Ctrl-C end `python -m stoss` and `python -m stoss.modal` until they run: nothing is begun that could be lost."""
    words = sys.orig_argv
    own = any(words[k : k + 2] in (["-m", "stoss"], ["-m", "stoss.modal"]) for k in range(len(words)))
    with contextlib.suppress(ValueError):  # in another thread
        if own and sys.argv[:1] == ["-m"] and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            signal.signal(signal.SIGINT, _end)


def heed() -> None:
    """From now on Ctrl-C raises KeyboardInterrupt, unless it is ignored."""
    if signal.getsignal(signal.SIGINT) not in (signal.SIG_IGN, None):
        signal.signal(signal.SIGINT, signal.default_int_handler)


def ignore() -> None:
    """All is done: Ctrl-C would only interrupt the end."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _end(*_: Any) -> None:
    with contextlib.suppress(OSError):
        os.write(2, b"stoss: error: interrupted\n")
    os._exit(130)
