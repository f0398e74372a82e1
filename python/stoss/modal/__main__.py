"""`python -m stoss.modal MESH [COARSE] …`: a body file from finite elements.

Exit codes: 0 written, 1 not converged, 2 bad input, 4 input or output, 130 interrupted.
"""

from __future__ import annotations

import logging
import sys
from typing import Any, Sequence

from stoss import _starting
from stoss._commands import say
from stoss._errors import InvalidInput, NotConverged

MISSING = "needs DOLFINx, SLEPc and Gmsh for Python ({}): in the repository, make modal-tools"


def main(words: Sequence[str]) -> int:
    """Runs it on all processes. Returns the exit code."""
    comm: Any = None
    try:
        from stoss.modal._arguments import parse

        given = parse(words)
        logging.disable(logging.INFO)  # the compiler of forms reports each call
        try:
            from mpi4py import MPI

            from stoss.modal._run import run
        except ImportError as error:
            return _complain(4, MISSING.format(error))
        comm = MPI.COMM_WORLD
        _starting.heed()
        run(given)
        return 0
    except InvalidInput as error:
        return _complain(2, str(error), comm)
    except NotConverged as error:
        return _complain(1, str(error), comm)
    except OSError as error:
        text = f"cannot read or write '{error.filename}': {error.strerror}"
        return _end(_complain(4, text), comm)
    except KeyboardInterrupt:
        return _end(_complain(130, "interrupted; the same command goes on from there"), comm)
    except Exception:
        logging.exception("stoss.modal: unexpected")
        return _end(1, comm)


def _end(code: int, comm: Any) -> int:
    """Also ends the other processes, which may wait for this one."""
    if comm is not None and comm.size > 1:
        comm.Abort(code)
    return code


def _complain(code: int, text: str, comm: Any = None) -> int:
    if comm is None or comm.rank == 0:
        say(f"stoss.modal: error: {' '.join(text.split())}")
    return code


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    finally:
        _starting.ignore()
