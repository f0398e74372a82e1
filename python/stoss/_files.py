"""Files that appear whole or not at all."""

from __future__ import annotations

import contextlib
import os
import tempfile
from typing import Iterable, Iterator


@contextlib.contextmanager
def whole_file(path: str, suffix: str = "") -> Iterator[str]:
    """A temporary name next to `path`, moved there at the end: what fails leaves no half file."""
    path = os.path.realpath(path)
    try:
        if os.path.isdir(path):
            raise IsADirectoryError(21, os.strerror(21), path)
        if os.path.exists(path) and not os.access(path, os.W_OK):
            raise PermissionError(13, os.strerror(13), path)
        descriptor, temporary = tempfile.mkstemp(dir=os.path.dirname(path), prefix=".stoss-", suffix=suffix)
    except OSError as error:
        raise type(error)(error.errno, error.strerror, path) from None  # the name that the user knows
    os.close(descriptor)
    try:
        yield temporary
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(temporary, os.stat(path).st_mode & 0o777 if os.path.exists(path) else 0o666 & ~mask)
        os.replace(temporary, path)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
        raise


def write_lines(path: str | os.PathLike[str], lines: Iterable[str]) -> None:
    """A text file that appears whole or not at all; what is a pipe or a device is written
    directly."""
    path = os.fspath(path)
    if os.path.exists(path) and not os.path.isfile(path):
        with open(path, "w", encoding="utf-8") as stream:
            stream.writelines(lines)
        return
    with whole_file(path) as temporary, open(temporary, "w", encoding="utf-8") as stream:
        stream.writelines(lines)
