"""Names of the files that the package writes, with their versions (docs/versions.md)."""

from __future__ import annotations

import re

from stoss import _core
from stoss._errors import InvalidInput

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
