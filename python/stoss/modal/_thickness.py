"""How much of a mesh is only one tetrahedron thick."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

MOST = 0.5
"""Share of the volume that may be one tetrahedron thick where two meshes are to give errors."""


def thin_share(corners: NDArray[np.int64], places: NDArray[Any]) -> float:
    """The share of the volume in tetrahedra whose four corners all lie on the surface.

    It is 1 of a wall with one layer of them, and 0 with two. Meshes with one layer err alike, for
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
    thin = on_surface[corners].all(axis=1)
    return float(volumes[thin].sum() / volumes.sum())
