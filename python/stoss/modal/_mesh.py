"""Tetrahedra: read by Gmsh or made by it from a shape, and brought to lengths of order one."""

from __future__ import annotations

import dataclasses
import os
from typing import Any, Sequence

import gmsh
import numpy as np
from dolfinx.io import gmshio
from numpy.typing import NDArray

from stoss._errors import InvalidInput
from stoss.modal._arguments import SHAPES

ORDERS = {4: 1, 11: 2}
"""Gmsh's types of tetrahedra that are taken, and their geometric order."""

EVEN = 12.0
"""Radius around the contact point in which edges hardly grow, in edges at the point."""
GROWTH = 0.25
"""How much longer edges are with each unit of distance from there on."""


@dataclasses.dataclass(frozen=True)
class Sizes:
    """Edge lengths of a mesh to be made, in m: far from the contact point, and at it.

    All edges are `coarser` times as long as they would be, so that meshes differ by that alone.
    """

    far: float
    near: float
    coarser: float = 1.0


def is_shape(path: str) -> bool:
    """Whether a file holds a shape, not a mesh."""
    return path.lower().endswith(SHAPES)


def load(
    path: str, unit: float, point: Sequence[float], sizes: Sizes | None, comm: Any
) -> tuple[Any, float]:
    """The mesh of a file, spread over the processes, and the length in m by which it was divided.

    `unit` is that of the file's lengths, in m. Of a shape a mesh of these `sizes` is made, which is
    fine at `point`, in m.
    """
    wrong, length = "", 1.0
    if comm.rank == 0:
        gmsh.initialize(["stoss.modal"], False)
        try:
            gmsh.option.setNumber("General.Terminal", 0)
            length = _open(path, unit, point, sizes)
        except InvalidInput as error:
            wrong = str(error)
        except Exception as error:  # what Gmsh raises
            wrong = f"{path}: Gmsh cannot read or mesh it: {error}"
    wrong, length = comm.bcast((wrong, length), root=0)
    try:
        if wrong:
            raise InvalidInput(wrong)
        mesh, _, _ = gmshio.model_to_mesh(gmsh.model, comm, 0, gdim=3)
    finally:
        if comm.rank == 0:
            gmsh.finalize()
    mesh.geometry.x[:] /= length
    return mesh, length * unit


def _open(path: str, unit: float, point: Sequence[float], sizes: Sizes | None) -> float:
    """Leaves in Gmsh one group of tetrahedra. Returns half the diagonal of the box around them."""
    if not os.path.isfile(path):
        raise InvalidInput(f"{path}: no such file")
    gmsh.open(path)
    if is_shape(path):
        assert sizes is not None
        _generate(unit, point, sizes)
    types = [kind for kind in gmsh.model.mesh.getElementTypes(3)]
    if not types:
        raise InvalidInput(f"{path}: the mesh has no tetrahedra (in Gmsh: gmsh -3 -order 2)")
    if len(types) > 1 or types[0] not in ORDERS:
        names = ", ".join(gmsh.model.mesh.getElementProperties(kind)[0] for kind in types)
        raise InvalidInput(f"{path}: got {names}, allowed tetrahedra of one order, 1 or 2")
    gmsh.model.mesh.renumberNodes()
    gmsh.model.removePhysicalGroups()
    gmsh.model.addPhysicalGroup(3, [tag for _, tag in gmsh.model.getEntities(3)])
    corners = gmsh.model.mesh.getElementsByType(types[0])[1].reshape(-1, 4 if types[0] == 4 else 10)
    _, determinants, _ = gmsh.model.mesh.getJacobians(types[0], *_quadrature(types[0]))
    inverted = int(np.sum(np.reshape(determinants, (len(corners), -1)).min(axis=1) <= 0.0))
    if inverted:
        raise InvalidInput(f"{path}: {inverted} tetrahedra are inside out or flat")
    tags, x, _ = gmsh.model.mesh.getNodes()
    parts = _parts(corners[:, :4].astype(np.int64))
    if parts > 1:
        raise InvalidInput(f"{path}: the mesh is in {parts} parts that do not hang together")
    loose = int(np.sum(~np.isin(tags, corners)))
    if loose:
        raise InvalidInput(
            f"{path}: {loose} nodes belong to no tetrahedron (surfaces or points beside the volume)"
        )
    x = np.reshape(x, (-1, 3))
    return 0.5 * float(np.linalg.norm(x.max(axis=0) - x.min(axis=0)))


def _parts(corners: NDArray[np.int64]) -> int:
    """How many parts tetrahedra form that share corners: each takes the least of their numbers."""
    labels, before = np.arange(corners.max() + 1), np.empty(0, dtype=np.int64)
    while not np.array_equal(labels, before):
        before = labels.copy()
        np.minimum.at(labels, corners, labels[corners].min(axis=1)[:, None])
        labels = labels[labels]
    return len(np.unique(labels[corners]))


def _quadrature(kind: int) -> tuple[Any]:
    """Where the volume elements must be positive."""
    return (gmsh.model.mesh.getIntegrationPoints(kind, "Gauss4")[0],)


def _generate(unit: float, point: Sequence[float], sizes: Sizes) -> None:
    """Quadratic tetrahedra whose edges grow from the contact point on."""
    gmsh.model.mesh.clear()
    far, near, even = sizes.coarser * sizes.far / unit, sizes.near / unit, EVEN * sizes.near / unit
    x, y, z = (f"({name}-({value / unit!r}))" for name, value in zip("xyz", point))
    grown = f"{near!r}+{GROWTH!r}*(Sqrt({x}^2+{y}^2+{z}^2+{even!r}^2)-{even!r})"
    field = gmsh.model.mesh.field.add("MathEval")
    gmsh.model.mesh.field.setString(field, "F", f"{sizes.coarser!r}*({grown})")
    gmsh.model.mesh.field.setAsBackgroundMesh(field)
    options = {"MeshSizeMax": far, "MeshSizeFromPoints": 0, "MeshSizeExtendFromBoundary": 0,
               "ElementOrder": 2, "HighOrderOptimize": 1, "Algorithm": 6}  # fmt: skip
    for name, value in options.items():
        gmsh.option.setNumber(f"Mesh.{name}", value)
    gmsh.model.mesh.generate(3)
