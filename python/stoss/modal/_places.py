"""Points that are spread evenly over the surface of a mesh, and triangles between them."""

from __future__ import annotations

import dataclasses
from typing import Any, Mapping

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

from stoss.modal._skin import Skin

Vector = NDArray[np.float64]


@dataclasses.dataclass(frozen=True)
class Places:
    """Points of a surface in m, its outward normals there, and triangles of points, right-handed from outside."""

    points: Vector
    normals: Vector
    triangles: NDArray[np.int64]

    def to_dict(self) -> dict[str, Any]:
        """The same in plain types."""
        return {each.name: getattr(self, each.name).tolist() for each in dataclasses.fields(self)}

    @classmethod
    def of_dict(cls, given: Mapping[str, Any]) -> Places:
        """Places from what `to_dict` returns."""
        return cls(*(np.array(given[each.name]) for each in dataclasses.fields(cls)))


def places_on(skin: Skin, length: float, count: int) -> Places:
    """So many corners of facets, or all: each as far as can be from those before it, along the surface.

    Triangles are those facets whose corners are closest to three different ones. The normals are
    those of facets around them, which are only about those of the surface.
    """
    corners, around = np.unique(skin.facets[:, :3], return_inverse=True)
    facets = around.reshape(-1, 3)
    if np.any(skin.outward < 0.0):
        facets = np.where(skin.outward[:, None] < 0.0, facets[:, ::-1], facets)
    points = skin.nodes[corners]
    normals = np.zeros_like(points)
    for corner in range(3):
        np.add.at(normals, facets[:, corner], skin.normals * skin.areas[:, None])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    chosen, closest = _spread(points, facets, count)
    triangles = closest[facets]
    apart = (np.sort(triangles, axis=1)[:, 1:] != np.sort(triangles, axis=1)[:, :-1]).all(axis=1)
    triangles = triangles[apart]
    _, first = np.unique(np.sort(triangles, axis=1), axis=0, return_index=True)
    return Places(length * points[chosen], normals[chosen], triangles[np.sort(first)])


def _spread(points: Vector, facets: NDArray[np.int64], count: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Numbers of the points that are chosen, and for each point that of the closest of them among these."""
    if count >= len(points):
        return np.arange(len(points)), np.arange(len(points))
    edges = np.unique(np.sort(facets[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    lengths = np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
    graph = csr_matrix((lengths, edges.T), shape=(len(points),) * 2)
    chosen = [int(np.argmax(points @ (1.0, 0.1, 0.01)))]
    closest, away = np.zeros(len(points), dtype=np.int64), np.full(len(points), np.inf)
    for number in range(count):
        if number:
            chosen.append(int(np.argmax(away)))
        found = dijkstra(graph, directed=False, indices=chosen[-1], limit=float(away[chosen[-1]]))
        closest[found < away] = number
        away = np.minimum(away, found)
    return np.array(chosen), closest
