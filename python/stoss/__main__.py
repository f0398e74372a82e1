"""`python -m stoss SUBCOMMAND …`: the command stoss, which is installed apart from this package.

Its subcommands sweep, merge and fit are in this package: the command hands them over to it.
"""

from __future__ import annotations

import os
import shutil
import sys
import sysconfig

MISSING = "stoss: the command is not part of the Python package (build it with 'make install' in the repository)"


def main() -> int:
    """Run one of these, or become the command with the same arguments; without it, say how to get it."""
    from stoss import _commands

    if sys.argv[1:2] and sys.argv[1] in _commands.NAMES:
        return _commands.run_alone(sys.argv[1:])
    places = os.pathsep.join([sysconfig.get_path("scripts"), os.environ.get("PATH", os.defpath)])
    command = shutil.which("stoss", path=places)
    if command is None:
        print(MISSING, file=sys.stderr)
        return 2
    os.execv(command, [command, *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
