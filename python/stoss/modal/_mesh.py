"""Tetrahedra: read by Gmsh or made by it from a shape, and brought to lengths of order one."""

from __future__ import annotations

import contextlib
import dataclasses
import os
from typing import Any, Sequence

from dolfinx.io import gmshio
import gmsh
import numpy as np
from numpy.typing import NDArray

from stoss._errors import InvalidInput
from stoss.modal._arguments import SHAPES
from stoss.modal._plates import Plate, mesh_plate

QUADRATIC = 11
ORDERS = {4: 1, QUADRATIC: 2}
"""Gmsh's types of tetrahedra that are taken, and their geometric order."""
EDGES = ((0, 1), (1, 2), (2, 0), (3, 0), (2, 3), (1, 3))
"""Corners between which the further nodes of a quadratic tetrahedron are, in Gmsh's order."""

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
    plate: Plate | None = None


def is_shape(path: str) -> bool:
    """Whether a file holds a shape, not a mesh."""
    return path.lower().endswith(SHAPES)


def load(
    path: str, unit: float, point: Sequence[float] | None, sizes: Sizes | None, comm: Any, thick: bool, names: Sequence[str]
) -> tuple[Any, float, dict[str, NDArray[np.int32]], float]:
    """The mesh of a file, spread over the processes, and the length in m by which it was divided.

    And the facets of this process on each of the surfaces with these names, and the share of the volume
    in tetrahedra that touch the surface.

    `unit` is that of the file's lengths, in m. From a shape a mesh of these `sizes` is made, which is
    fine at `point`, in m, or has edges of one length if there is none. `thick` refuses meshes that are mostly
    one tetrahedron thick.
    """
    wrong: InvalidInput | None = None
    length, entities, outer = 1.0, dict[str, list[int]](), 0.0
    if comm.rank == 0:
        gmsh.initialize(["stoss.modal"], False)
        try:
            gmsh.option.setNumber("General.Terminal", 0)
            length, entities, outer = _open(path, unit, point, sizes, thick, names)
        except InvalidInput as error:
            wrong = error
        except Exception as error:  # what Gmsh raises
            wrong = InvalidInput.conflict(path, f"Gmsh cannot read or mesh it: {error}")
    wrong, length, entities, outer = comm.bcast((wrong, length, entities, outer), root=0)
    try:
        if wrong:
            raise wrong
        mesh, _, tags = gmshio.model_to_mesh(gmsh.model, comm, 0, gdim=3)
    finally:
        if comm.rank == 0:
            gmsh.finalize()
    mesh.geometry.x[:] /= length
    surfaces = {name: tags.indices[np.isin(tags.values, its)] for name, its in entities.items()}
    return mesh, length * unit, surfaces, outer


def _open(
    path: str, unit: float, point: Sequence[float] | None, sizes: Sizes | None, thick: bool, names: Sequence[str]
) -> tuple[float, dict[str, list[int]], float]:
    """Leaves in Gmsh one group of tetrahedra, and one of each part of a surface with a name.

    Returns half the diagonal of the box around them, of which parts each surface is made, and the share
    of the volume in tetrahedra that touch the surface.
    """
    if sizes is not None and sizes.plate is not None:
        mesh_plate(gmsh, sizes.plate, sizes)
    elif not os.path.isfile(path):
        raise InvalidInput.conflict(path, "no such file")
    else:
        gmsh.open(path)
    if is_shape(path):
        assert sizes is not None
        _generate(unit, point, sizes)
    types = list(gmsh.model.mesh.getElementTypes(3))
    if not types:
        raise InvalidInput.conflict(path, "the mesh has no tetrahedra", "in Gmsh: gmsh -3 -order 2")
    if len(types) > 1 or types[0] not in ORDERS:
        names = ", ".join(gmsh.model.mesh.getElementProperties(kind)[0] for kind in types)
        raise InvalidInput.out_of_range(path, names, "tetrahedra of one order, 1 or 2")
    gmsh.model.mesh.renumberNodes()
    surfaces = _surfaces(names)
    gmsh.model.removePhysicalGroups()
    gmsh.model.addPhysicalGroup(3, [tag for _, tag in gmsh.model.getEntities(3)])
    for part in sorted({part for parts in surfaces.values() for part in parts}):
        gmsh.model.addPhysicalGroup(2, [part], part)
    corners = gmsh.model.mesh.getElementsByType(types[0])[1].reshape(-1, 4 if types[0] == 4 else 10)
    inverted = int(np.sum(_inverted(types[0])))
    if inverted:
        raise InvalidInput.conflict(
            path,
            f"{inverted} of {len(corners)} tetrahedra are inside out or flat",
            "smaller edges where the surface bends, straight ones (gmsh -order 1), or in Gmsh: Tools, Reverse mesh",
        )
    tags, x, _ = gmsh.model.mesh.getNodes()
    parts = _parts(corners[:, :4].astype(np.int64))
    if parts > 1:
        raise InvalidInput.conflict(path, f"the mesh is in {parts} parts that do not hang together")
    loose = int(np.sum(~np.isin(tags, corners)))
    if loose:
        raise InvalidInput.conflict(
            path, f"{loose} nodes belong to no tetrahedron", "surfaces or points beside the volume"
        )
    x = np.reshape(x, (-1, 3))
    places = np.empty((int(tags.max()) + 1, 3))
    places[tags.astype(np.int64)] = x
    whole = corners[:, :4].astype(np.int64)
    thin = thin_share(whole, places) if thick else 0.0
    if thin > MOST:
        raise InvalidInput.conflict(
            path,
            f"{100 * thin:.0f} % of the volume is only one tetrahedron thick, allowed {100 * MOST:.0f} %: two such meshes err alike, which hides their errors",
            "two through the thickness, by a smaller --size, or one mesh with --errors-unknown",
        )
    return 0.5 * float(np.linalg.norm(x.max(axis=0) - x.min(axis=0))), surfaces, thin_share(whole, places, 1)


def _surfaces(names: Sequence[str]) -> dict[str, list[int]]:
    """The parts of which surfaces with these names are made, or these numbers."""
    groups: dict[str, list[int]] = {}
    for _, tag in gmsh.model.getPhysicalGroups(2):
        parts = [int(part) for part in gmsh.model.getEntitiesForPhysicalGroup(2, tag)]
        meshed = [part for part in parts if len(gmsh.model.mesh.getElements(2, part)[1])]
        groups[gmsh.model.getPhysicalName(2, tag) or str(tag)] = meshed
    for name in names:
        if not groups.get(name):
            allowed = ", ".join(f"'{each}'" for each, parts in sorted(groups.items()) if parts)
            raise InvalidInput.out_of_range(
                "surface", f"'{name}'", allowed or "none, as the file names none", "Physical Surface(\"grip\") = {…}; in Gmsh"
            )
    return {name: groups[name] for name in names}


def _parts(corners: NDArray[np.int64]) -> int:
    """How many parts tetrahedra form that share corners: each takes the least of their numbers."""
    labels, before = np.arange(corners.max() + 1), np.empty(0, dtype=np.int64)
    while not np.array_equal(labels, before):
        before = labels.copy()
        np.minimum.at(labels, corners, labels[corners].min(axis=1)[:, None])
        labels = labels[labels]
    return len(np.unique(labels[corners]))


def _inverted(kind: int) -> NDArray[np.bool_]:
    """Which tetrahedra have a volume element that is not positive where they are integrated."""
    places = gmsh.model.mesh.getIntegrationPoints(kind, "Gauss4")[0]
    determinants = np.asarray(gmsh.model.mesh.getJacobians(kind, places)[1])
    wrong: NDArray[np.bool_] = determinants.reshape(-1, len(places) // 3).min(axis=1) <= 0.0
    return wrong


def _generate(unit: float, point: Sequence[float] | None, sizes: Sizes) -> None:
    """Quadratic tetrahedra whose edges grow from the contact point on, or have one length."""
    gmsh.model.mesh.clear()
    far, near, even = sizes.coarser * sizes.far / unit, sizes.near / unit, EVEN * sizes.near / unit
    grown = f"{sizes.far / unit!r}"
    if point is not None:
        x, y, z = (f"({name}-({value / unit!r}))" for name, value in zip("xyz", point))
        grown = f"{near!r}+{GROWTH!r}*(Sqrt({x}^2+{y}^2+{z}^2+{even!r}^2)-{even!r})"
    field = gmsh.model.mesh.field.add("MathEval")
    gmsh.model.mesh.field.setString(field, "F", f"{sizes.coarser!r}*({grown})")
    gmsh.model.mesh.field.setAsBackgroundMesh(field)
    options = {"MeshSizeMax": far, "MeshSizeFromPoints": 0, "MeshSizeExtendFromBoundary": 0,
               "ElementOrder": 2, "HighOrderOptimize": 0, "Algorithm": 6}  # fmt: skip
    for name, value in options.items():
        gmsh.option.setNumber(f"Mesh.{name}", value)
    gmsh.model.mesh.generate(3)
    # It also complains of curved elements that are right, but not as good as it likes.
    with contextlib.suppress(Exception):
        gmsh.model.mesh.optimize("HighOrder")
    _straighten()


def _straighten() -> None:
    """Makes tetrahedra straight that are still inside out: a curved edge spoils a flat one."""
    wrong = _inverted(QUADRATIC)
    nodes = gmsh.model.mesh.getElementsByType(QUADRATIC)[1].reshape(-1, 10)[wrong]
    for element in nodes:
        places = [gmsh.model.mesh.getNode(node)[0] for node in element[:4]]
        for node, (start, end) in zip(element[4:], EDGES):
            gmsh.model.mesh.setNode(node, 0.5 * (places[start] + places[end]), [])


MOST = 0.2
"""Share of the volume that may be one tetrahedron thick where two meshes are to give errors.

At a third to a half of it, frequencies of hollow spheres erred by 1.5 times the difference of both meshes.
"""


def thin_share(corners: NDArray[np.int64], places: NDArray[Any], least: int = 4) -> float:
    """The share of the volume in tetrahedra of whose four corners so many or more lie on the surface.

    Of all four it is 1 of a wall with one layer of them, and 0 with two. Meshes with one layer have equal errors, for
    they do not differ through the thickness, however long their other edges are: what differs
    between both is no measure of their errors.

    Parameters:
        corners: Four numbers of each tetrahedron.
        places: Coordinates, by these numbers.
    """
    opposite = np.array([[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]])
    facets = np.sort(corners[:, opposite].reshape(-1, 3), axis=1)
    _, first, count = np.unique(facets, axis=0, return_index=True, return_counts=True)
    on_surface = np.zeros(len(places), dtype=bool)
    on_surface[facets[first[count == 1]]] = True
    edges = places[corners[:, 1:]] - places[corners[:, :1]]
    volumes = np.abs(np.linalg.det(edges))
    thin = on_surface[corners].sum(axis=1) >= least
    return float(volumes[thin].sum() / volumes.sum())
