"""The surface near the contact point: how it bends, and how displacements vary along it."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np
from dolfinx import cpp, fem
from dolfinx import mesh as meshes
from numpy.typing import NDArray

from stoss._errors import InvalidInput

PATCH = 4.0
"""Radius of the surface to which polynomials are fitted, in edges of the mesh."""
STEEP = 0.8
"""Least cosine between the normal of a facet of the patch and that at the point."""
POWERS = [(i, k - i) for k in range(5) for i in range(k, -1, -1)]
"""Degree of the polynomials x^i y^j that are fitted, up to the fourth degree."""

Vector = NDArray[np.float64]


class Surface:
    """What lies near a point of a mesh's surface.

    Attributes:
        point, normal: As given, the normal as a unit vector.
        tangent: A unit vector perpendicular to it, if one was given, else None.
        edge (float): Mean length of the edges near the point.
        facets: Facets of this process, in the patch and around it.
        curvature: Principal curvatures of the surface at the point.
    """

    def __init__(
        self,
        mesh: Any,
        length: float,
        point: Sequence[float],
        normal: Sequence[float],
        tangent: Sequence[float] | None = None,
    ) -> None:
        self.mesh, self.length = mesh, length
        self.point = np.asarray(point) / length
        self.normal = np.asarray(normal) / np.linalg.norm(normal)
        self.tangent: Vector | None = None
        if tangent is not None:
            aside = np.asarray(tangent) - (np.asarray(tangent) @ self.normal) * self.normal
            self.tangent = aside / np.linalg.norm(aside)
        first = np.eye(3)[np.argmin(np.abs(self.normal))]
        first = np.cross(self.normal, first) / np.linalg.norm(np.cross(self.normal, first))
        self.axes = np.array([first, np.cross(self.normal, first)])
        self._all = self._facets()
        self.edge = self._edge()
        self.facets = self.near(PATCH * self.edge)
        if mesh.comm.allreduce(len(self.facets)) == 0:
            raise InvalidInput.conflict(
                "normal", "the surface does not face that way at the point", "does it lead outward?"
            )
        self.curvature = self._curvature()

    def near(self, radius: float) -> NDArray[np.int32]:
        """This process's facets around the normal that face outward, within a radius."""
        facets, corners, normals = self._all
        flat, depth = self._flat(corners.mean(axis=1))
        beside = np.linalg.norm(flat, axis=1) < radius
        return np.sort(facets[beside & (np.abs(depth) < radius) & (normals @ self.normal > STEEP)])

    def weights(self, space: Any) -> tuple[NDArray[np.int32], Vector]:
        """Rows that make of values at nodes the value at the point, and half its mean curvature.

        Returns the nodes of this process, and for each of both rows the weights of these nodes.
        """
        nodes, rows, _ = self._fit(space)
        squares = [POWERS.index((2, 0)), POWERS.index((0, 2))]
        return nodes, np.array([rows[0], 0.5 * rows[squares].sum(axis=0)])

    def _fit(self, space: Any) -> tuple[NDArray[np.int32], Vector, Vector]:
        """Nodes of this process in the patch, their columns of the inverse, their heights."""
        nodes = fem.locate_dofs_topological(space, 2, self.facets)
        nodes = nodes[nodes < space.dofmap.index_map.size_local]
        flat, height = self._flat(space.tabulate_dof_coordinates()[nodes])
        flat = flat / (PATCH * self.edge)
        parts = self.mesh.comm.allgather(flat)
        everywhere = np.concatenate(parts)
        if len(everywhere) < 2 * len(POWERS):
            raise InvalidInput.conflict("point", f"only {len(everywhere)} nodes near it, too few for a fit")
        x, y = everywhere.T
        powers = np.stack([x**i * y**j for i, j in POWERS], axis=1)
        rows = np.linalg.pinv(powers)
        scales = np.array([(PATCH * self.edge) ** -(i + j) for i, j in POWERS])
        start = sum(len(part) for part in parts[: self.mesh.comm.rank])
        return nodes, scales[:, None] * rows[:, start : start + len(nodes)], height

    def _curvature(self) -> tuple[float, float]:
        """Also refuses a point beside the surface, and a normal that is not the surface's."""
        order = self.mesh.ufl_domain().ufl_coordinate_element().degree()
        _, rows, height = self._fit(fem.FunctionSpace(self.mesh, ("Lagrange", order)))
        fitted = dict(zip(POWERS, sum(self.mesh.comm.allgather(rows @ height))))
        offset = abs(fitted[0, 0])
        if offset > 0.02 * self.edge:
            raise self._beside(offset, self.point + fitted[0, 0] * self.normal)
        tilt = np.degrees(np.arctan(np.hypot(fitted[1, 0], fitted[0, 1])))
        if tilt > 2.0:
            raise InvalidInput.conflict("normal", f"{tilt:.1f} degrees off that of the surface at the point")
        second = [[2 * fitted[2, 0], fitted[1, 1]], [fitted[1, 1], 2 * fitted[0, 2]]]
        bends = np.linalg.eigvalsh(-np.array(second))
        bends = np.where(np.abs(bends) * self.edge < 1e-4, 0.0, bends)
        return float(bends[0]), float(bends[1])

    def _flat(self, places: Vector) -> tuple[Vector, Vector]:
        """Coordinates perpendicular to the normal, and along it."""
        arms = places - self.point
        return arms @ self.axes.T, arms @ self.normal

    def _facets(self) -> tuple[NDArray[np.int32], Vector, Vector]:
        """This process's facets of the whole surface, their corners and outward normals."""
        topology = self.mesh.topology
        topology.create_connectivity(2, 3)
        facets = meshes.exterior_facet_indices(topology)
        facets = facets[facets < topology.index_map(2).size_local]
        x = self.mesh.geometry.x
        vertices = cpp.mesh.entities_to_geometry(self.mesh._mesh, 2, facets, False)
        corners = x[vertices].reshape(-1, 3, 3)
        cells = [topology.connectivity(2, 3).links(facet)[0] for facet in facets]
        nodes = self.mesh.geometry.dofmap
        inside = np.array([x[nodes.links(cell)[:4]].mean(axis=0) for cell in cells])
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        outward = np.sign(np.sum(normals * (corners.mean(axis=1) - inside.reshape(-1, 3)), axis=1))
        return facets, corners, normals * (outward / np.linalg.norm(normals, axis=1))[:, None]

    def _edge(self) -> float:
        """Of the dozen facets closest to the point."""
        corners = np.concatenate(self.mesh.comm.allgather(self._all[1]))
        distances = np.linalg.norm(corners.mean(axis=1) - self.point, axis=1)
        closest = corners[np.argsort(distances)[:12]]
        edge = float(np.mean(np.linalg.norm(closest - np.roll(closest, 1, axis=1), axis=2)))
        vertices = corners.reshape(-1, 3)
        away = np.linalg.norm(vertices - self.point, axis=1)
        if away.min() > 1.5 * edge:
            raise self._beside(away.min(), vertices[np.argmin(away)])
        return edge

    def _beside(self, distance: float, nearest: Vector) -> InvalidInput:
        place = ",".join(f"{self.length * x:.6g}" for x in nearest)
        hint = " (is the unit right? --unit mm)" if distance > 2.0 else ""
        return InvalidInput.conflict(
            "point",
            f"{self.length * distance:.3g} m beside the surface, nearest is {place} m; the body measures {2 * self.length:.3g} m from corner to corner{hint}",
        )
