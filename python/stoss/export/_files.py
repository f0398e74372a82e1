"""Files that appear whole or not at all."""

from __future__ import annotations

import contextlib
import errno
import os
import tempfile
from typing import Iterable, Iterator


@contextlib.contextmanager
def whole_file(path: str, suffix: str = "") -> Iterator[str]:
    """A temporary name next to `path`, moved there at the end: what fails leaves no half file.

    Raises OSError that says `path`, also for what is no regular file.
    """
    given, path = path, os.path.realpath(path)
    temporary = ""
    try:
        if os.path.isdir(given):
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        if os.path.exists(given) and not os.path.isfile(given):
            raise OSError(errno.EINVAL, "it is not a regular file")
        if os.path.exists(path) and not os.access(path, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        descriptor, temporary = tempfile.mkstemp(dir=os.path.dirname(path), prefix=".stoss-", suffix=suffix)
        os.close(descriptor)
        yield temporary
        os.chmod(temporary, os.stat(path).st_mode & 0o777 if os.path.exists(path) else usual_mode())
        os.replace(temporary, path)
    except BaseException as error:
        if temporary:
            with contextlib.suppress(OSError):
                os.unlink(temporary)
        ours = not temporary or isinstance(error, OSError) and error.filename in (None, temporary)
        if isinstance(error, OSError) and error.errno and ours:
            raise type(error)(error.errno, error.strerror, given) from None  # the name that the user knows
        raise


def require_writable(path: str | os.PathLike[str]) -> None:
    """Refuse, before anything is computed for it, a file that cannot be written. Raises OSError as `whole_file`."""
    with contextlib.suppress(_Enough), whole_file(os.fspath(path)):
        raise _Enough


class _Enough(Exception):
    """That a file could be made."""


def usual_mode() -> int:
    """Who may do what with a new file."""
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask


def write_lines(path: str | os.PathLike[str], lines: Iterable[str]) -> None:
    """A text file that appears whole or not at all; what is a pipe or a device is written directly."""
    path = os.fspath(path)
    if os.path.exists(path) and not os.path.isfile(path):
        with open(path, "w", encoding="utf-8") as stream:
            stream.writelines(lines)
        return
    with whole_file(path) as temporary, open(temporary, "w", encoding="utf-8") as stream:
        stream.writelines(lines)
