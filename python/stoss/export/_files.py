"""Files that appear whole or not at all, their formats (docs/developer/versions.md), and JSON documents as they are read."""

from __future__ import annotations

import contextlib
import errno
import json
import os
import re
import tempfile
from typing import Any, Iterable, Iterator

from stoss import _core
from stoss._errors import InvalidInput


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


GRID = "stoss grid 1"
SWEEP = "stoss sweep 1"
RULE = "stoss collision rule 1"

VERSION = r"\d{1,9}[\w.+~-]{0,40}"
"""How the version of the stoss that has written a file looks, in ASCII."""


def require(name: str, given: object, own: str) -> None:
    """Refuse another format than our own, and say so if it is of a later version."""
    if given == own:
        return
    title, _, version = own.rpartition(" ")
    found = re.fullmatch(rf"{re.escape(title)} ([1-9]\d{{0,8}})", given) if isinstance(given, str) else None
    hint = " (written by a later stoss)" if found and int(found[1]) > int(version) else ""
    raise InvalidInput.out_of_range(name, repr(str(given)[:60]), f"{own!r}{hint}")


def require_readable(name: str, path: str, version: str) -> None:
    """Refuse a file of stoss of a later first number, with which its columns may mean something else."""
    own = _core.version.split(".")[0]
    found = re.match(r"\d+", version)
    if found and int(found[0]) > int(own):
        raise InvalidInput.out_of_range(
            name,
            f"{path!r} of stoss {version}",
            f"one of stoss {own} or earlier",
            f"stoss {found[0]} can read it",
        )
