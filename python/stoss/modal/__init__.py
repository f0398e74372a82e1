"""A body of any shape as an impact sees it: modes and one compliance at a point.

They come from finite elements; `python -m stoss.modal MESH` writes them as a file
(examples/any_body). Needs DOLFINx, SLEPc and Gmsh, which the rest of the package does without.
"""
