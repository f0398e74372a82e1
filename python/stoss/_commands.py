"""The subcommands that the command stoss hands over to this package.

Exit codes are those of the command: 0 all is there, 1 not converged, 2 usage, 3 bad input, 4 input or
output, 130 interrupted.
"""

from __future__ import annotations

import argparse
import importlib
import sys
from typing import Callable, Mapping, NoReturn, Sequence

from stoss._errors import InvalidInput, NotConverged

MODULES: Mapping[str, str] = {
    "sweep": "stoss.sweeps._command",
    "merge": "stoss.sweeps._command",
    "fit": "stoss.laws._command",
    "table": "stoss.results._command",
}


class Usage(Exception):
    """Words that are no command."""


class Parser(argparse.ArgumentParser):
    """One that leaves what is wrong to us."""

    def error(self, message: str) -> NoReturn:
        raise Usage(f"{message} (see stoss --help or {self.prog} --help)")


def main(words: Sequence[str]) -> int:
    """Run one of them. Returns the exit code."""
    return int(importlib.import_module(MODULES[words[0]]).main(words))


def guarded(run: Callable[[], int], interrupted: str) -> int:
    """What `run` returns, or the exit code of what went wrong, which one line says."""
    try:
        return run()
    except Usage as error:
        return _complain(2, str(error))
    except NotConverged as error:
        return _complain(1, str(error))
    except InvalidInput as error:
        return _complain(3, str(error))
    except (OSError, ImportError) as error:
        text = f"'{error.filename}': {error.strerror}" if isinstance(error, OSError) and error.filename else str(error)
        return _complain(4, f"output: cannot read or write {text}" if isinstance(error, OSError) else text)
    except KeyboardInterrupt:
        return _complain(130, interrupted)


def _complain(code: int, text: str) -> int:
    line = " ".join(text.split())
    print(f"stoss: error: {line if len(line) <= 500 else line[:500] + '...'}", file=sys.stderr)
    return code
