"""A body of any shape as an impact sees it: modes and one compliance at a point.

They come from finite elements; `python -m stoss.modal MESH` writes them as a file
(examples/any_body). Needs DOLFINx, SLEPc and Gmsh, which the rest of the package does without.
"""

import os

# A library leaves the signals of a program alone, of which PETSc makes a crash.
os.environ.setdefault("PETSC_OPTIONS", "-no_signal_handler")
