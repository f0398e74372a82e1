"""The whole surface of a mesh: its facets and nodes, which all processes know, and pressures on it."""

from __future__ import annotations

import math
from typing import Any

import basix
import numpy as np
from dolfinx import mesh as meshes
from numpy.typing import NDArray

DEGREE = 10
"""Degree of the polynomials that are integrated exactly over a facet: pressures end within some."""
SHARP = 35.0
"""Angle in degrees between facets from which on they meet at an edge: of round surfaces meshes have less."""

Vector = NDArray[np.float64]


class Skin:
    """Facets of the surface, each with the six nodes of a quadratic triangle, three corners first.

    Attributes:
        space: Space of the displacements.
        curved (bool): Whether the other nodes are on the curved surface too, not amid the corners.
        number: Numbers of the nodes among all of the space, rising.
        nodes: Where they are.
        facets: Six nodes of each facet.
        corners, middles, areas, normals: Three corners of each facet, their middle, its area and its
            outward normal, as if it were flat.
        outward: 1 where these corners are right-handed from outside, else −1.
    """

    def __init__(self, space: Any) -> None:
        self.space, self.mesh = space, space.mesh
        self.curved = bool(self.mesh.ufl_domain().ufl_coordinate_element().degree() > 1)
        topology = self.mesh.topology
        topology.create_connectivity(2, 3)
        topology.create_connectivity(3, 2)
        exterior = meshes.exterior_facet_indices(topology)
        self._own = exterior[exterior < topology.index_map(2).size_local]
        numbers, places, inside = self._of_facets(topology)
        self.number, first, around = np.unique(numbers, return_index=True, return_inverse=True)
        self.nodes: Vector = places.reshape(-1, 3)[first]
        self.facets: NDArray[np.int64] = around.reshape(-1, 6)
        self.corners = self.nodes[self.facets[:, :3]]
        normals = np.cross(self.corners[:, 1] - self.corners[:, 0], self.corners[:, 2] - self.corners[:, 0])
        self.outward = np.sign(np.sum(normals * (self.corners.mean(axis=1) - inside), axis=1))
        self.areas = 0.5 * np.linalg.norm(normals, axis=1)
        self.normals: Vector = normals * (self.outward / (2.0 * self.areas))[:, None]
        self.middles: Vector = self.corners.mean(axis=1)
        at, weights = basix.make_quadrature(basix.CellType.triangle, DEGREE)
        element = basix.create_element(
            basix.ElementFamily.P, basix.CellType.triangle, 2, basix.LagrangeVariant.equispaced
        )
        self._values, *slopes = element.tabulate(1, at)[:3, :, :, 0]
        x = self.nodes[self.facets]
        one, other = (slope @ x for slope in slopes)
        self._at = self._values @ x
        self._faces = np.cross(one, other) * self.outward[:, None, None] * weights[:, None]

    def marked(self, facets: NDArray[np.int32]) -> NDArray[np.bool_]:
        """Which facets of all processes are among those that this one knows by their numbers in the mesh."""
        mine = np.isin(self._own, facets)
        return np.concatenate(self.mesh.comm.allgather(mine))

    def notched(self) -> bool:
        """Whether facets meet inward at an edge: there stresses have no bound, and errors fall more slowly."""
        sides = np.sort(self.facets[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        facets = np.lexsort(sides.T) // 3
        one, other = facets[::2], facets[1::2]
        inward = np.sum((self.middles[other] - self.middles[one]) * self.normals[one], axis=1) > 0.0
        sharp = np.sum(self.normals[one] * self.normals[other], axis=1) < math.cos(math.radians(SHARP))
        return bool(np.any(inward & sharp))

    def displacements(self, vector: Any) -> Vector:
        """Displacements of all nodes, from a vector that is spread over the processes."""
        rows, here = self._mine(vector)
        moved = np.zeros((len(self.number), 3))
        moved[here] = vector.array.reshape(-1, 3)[rows]
        whole: Vector = self.mesh.comm.allreduce(moved)
        return whole

    def spread(self, loads: Vector, vector: Any) -> Vector:
        """Forces at nodes, (loads, nodes, 3), as columns of the rows of this process of a vector like this."""
        rows, here = self._mine(vector)
        own = np.zeros((vector.getLocalSize() // 3, 3, len(loads)))
        own[rows] = np.moveaxis(loads[:, here], 0, -1)
        return own.reshape(-1, len(loads))

    def distances(self, point: Vector, radius: float) -> Vector:
        """Distances of the flat facets from a point; infinite if they are not near."""
        apart = np.full(len(self.facets), np.inf)
        near = np.flatnonzero(np.linalg.norm(self.middles - point, axis=1) < radius)
        starts = self.corners[near]
        sides, arms = np.roll(starts, -1, axis=1) - starts, point - starts
        along = np.clip(np.sum(arms * sides, axis=2) / np.sum(sides**2, axis=2), 0.0, 1.0)
        apart[near] = np.linalg.norm(arms - along[:, :, None] * sides, axis=2).min(axis=1)
        depth = np.sum(arms[:, 0] * self.normals[near], axis=1)
        outward = np.cross(sides, self.normals[near, None] * self.outward[near, None, None])
        over = np.all(np.sum(arms * outward, axis=2) <= 0.0, axis=1)
        apart[near[over]] = np.abs(depth[over])
        return apart

    def pressure(self, facets: NDArray[np.int64], point: Vector, normal: Vector, axis: Vector, radius: float) -> Vector:
        """Forces at nodes of a smooth load of force one on these facets, p ∝ (1 − r²/b²)² around the normal.

        It acts against the normal, or an axis beside it.
        """
        shares = self._shares(facets, point, normal, radius)
        forces = np.zeros(len(self.nodes))
        np.add.at(forces, self.facets[facets], shares @ self._values)
        return np.asarray(-(forces / shares.sum())[:, None] * axis)

    def total(self, facets: NDArray[np.int64], point: Vector, normal: Vector, radius: float) -> float:
        """What of this pressure acts: less than 1 where the surface ends or turns away."""
        return float(self._shares(facets, point, normal, radius).sum())

    def _shares(self, facets: NDArray[np.int64], point: Vector, normal: Vector, radius: float) -> Vector:
        """Shares of the force, at each place where facets are integrated."""
        arms = self._at[facets] - point
        square = (np.sum(arms**2, axis=2) - (arms @ normal) ** 2) / radius**2
        shares = np.where(square < 1.0, (1.0 - square) ** 2, 0.0) * (self._faces[facets] @ normal)
        return np.asarray(shares * 3.0 / (math.pi * radius**2))

    def _of_facets(self, topology: Any) -> tuple[NDArray[np.int64], Vector, Vector]:
        """Numbers and places of the six nodes of facets, and a place inside the body beside each: of all processes."""
        facets = topology.connectivity(2, 3)
        cells = facets.array[facets.offsets[self._own]]
        sides = topology.connectivity(3, 2).array.reshape(-1, 4)[cells]
        side = np.argmax(sides == self._own[:, None], axis=1)
        layout, dofmap = self.space.dofmap.dof_layout, self.space.dofmap
        closure = np.array([layout.entity_closure_dofs(2, each) for each in range(4)])
        ten = dofmap.list.array.reshape(-1, 10)[cells]
        six = np.take_along_axis(ten, closure[side], axis=1)
        places = self.space.tabulate_dof_coordinates()
        inside = places[ten[:, :4]].mean(axis=1)
        numbers = dofmap.index_map.local_to_global(six.ravel().astype(np.int32)).reshape(-1, 6)
        parts = self.mesh.comm.allgather((numbers, places[six], inside))
        numbers, all_places, inside = (np.concatenate(each) for each in zip(*parts))
        return numbers, all_places, inside

    def _mine(self, vector: Any) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
        start, end = (each // 3 for each in vector.getOwnershipRange())
        here = (self.number >= start) & (self.number < end)
        return self.number[here] - start, here
