"""The file of one worker of a sweep: rows are appended, and nothing else."""

from __future__ import annotations

import contextlib
import errno
import fcntl
import json
import os
import re
import socket
import threading
from pathlib import Path
from typing import Any

from stoss import _core
from stoss._errors import InvalidInput
from stoss.export._text import cell as _cell, known
from stoss.sweeps._store import COLUMNS, HEADER, Row


class Worker:
    """The file of one worker, locked against others while it is open."""

    def __init__(self, path: Path, name: str | None = None) -> None:
        """Open `name`.csv, or a file of this thread of this machine.

        Raises BlockingIOError while another process writes it, InvalidInput if it is of another
        version, OSError if it cannot be written.
        """
        own = f"worker-{re.sub(r'[^A-Za-z0-9]', '-', socket.gethostname())}-{threading.get_native_id()}"
        for number in range(1, 1000):
            self.file = path / f"{name or own}{f'-{number}' if number > 1 else ''}.csv"
            self._descriptor = os.open(self.file, os.O_RDWR | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o666)
            try:
                self._lock()
                break
            except BlockingIOError:
                os.close(self._descriptor)
                if name is not None:
                    raise
        self._cases: set[str] = set()
        try:
            self._mend()
        except BaseException:
            os.close(self._descriptor)
            raise

    def __enter__(self) -> Worker:
        return self

    def __exit__(self, *_: object) -> None:
        os.close(self._descriptor)

    def _lock(self) -> None:
        try:
            fcntl.flock(self._descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            text = "another process is writing it"
            raise BlockingIOError(errno.EAGAIN, text, str(self.file)) from None
        except OSError:
            pass  # where files cannot be locked

    def _mend(self) -> None:
        """Cut off an incomplete last line; begin an empty file."""
        content = b""
        while piece := os.pread(self._descriptor, 1 << 20, len(content)):
            content += piece
        whole = content.rfind(b"\n") + 1
        if whole < len(content):
            os.ftruncate(self._descriptor, whole)
        self._size = whole
        if whole == 0:
            self._write(f"# stoss {_core.version}: sweep\n{HEADER}\n")
        elif content[:whole].split(b"\n", 1)[0] != f"# stoss {_core.version}: sweep".encode():
            raise InvalidInput(f"store: got '{self.file}', allowed a file of stoss {_core.version} (use another store)")
        elif content.count(b"\n", 0, whole) == 1:  # killed between two lines of the header
            self._write(f"{HEADER}\n")

    def _write(self, text: str) -> None:
        """One write; what the disk does not take whole is taken back."""
        data = text.encode("ascii")
        try:
            if os.write(self._descriptor, data) != len(data):
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        except OSError as error:
            with contextlib.suppress(OSError):
                os.ftruncate(self._descriptor, self._size)
            raise type(error)(error.errno, error.strerror, str(self.file)) from None
        self._size += len(data)

    def append(self, key: str, inputs: Any, speed: float, row: Row) -> None:
        """Add a row, before the first of a case also what the case is."""
        cells = [_cell(known(name, value)) for name, value in zip(COLUMNS, row)]
        comment = "" if key in self._cases else f"# case {key}: {json.dumps(inputs, sort_keys=True)}\n"
        self._write(f"{comment}{','.join((key, repr(speed), *cells))}\n")
        self._cases.add(key)

    def flush(self) -> None:
        """Let all rows so far survive a failure of the machine, not only of the process."""
        os.fsync(self._descriptor)
