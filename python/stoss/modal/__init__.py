"""A body of any shape as an impact sees it: modes and one compliance at a point, from finite elements.

`python -m stoss.modal MESH` writes them as a file (docs/any_body.md). Needs DOLFINx, SLEPc and Gmsh,
which the rest of the package does without.
"""
