"""A body of any shape as an impact sees it: modes and one compliance at a point.

They come from finite elements; `python -m stoss.modal MESH` writes them as a file
(examples/any_body). Needs DOLFINx, SLEPc and Gmsh, which the rest of the package does without.
"""

import contextlib
import os
import signal

# A library leaves the signals of a program alone. PETSc makes a crash of them; Gmsh takes Ctrl-C
# away from Python as it is loaded, so that it waits till then, and cannot be loaded by another
# thread than the main one.
os.environ.setdefault("PETSC_OPTIONS", "-no_signal_handler")
_before = signal.getsignal(signal.SIGINT)
_blocked = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
try:
    with contextlib.suppress(ImportError, ValueError):
        import gmsh as gmsh
    if signal.getsignal(signal.SIGINT) is not _before and _before is not None:
        signal.signal(signal.SIGINT, _before)
finally:
    signal.pthread_sigmask(signal.SIG_SETMASK, _blocked)
