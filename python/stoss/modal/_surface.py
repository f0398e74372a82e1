"""The surface near the contact point: how it bends, and how displacements vary along it."""

from __future__ import annotations

from typing import Sequence

import numpy as np
from numpy.typing import NDArray

from stoss._errors import InvalidInput
from stoss.modal._skin import SHARP, Skin

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
        point, normal: As given, the normal as a unit vector; a `guessed` one becomes that of the patch.
        tangent: A unit vector perpendicular to it, if one was given, else None.
        edge (float): Mean length of the edges near the point.
        facets: Those of the skin in the patch and around it.
        curvature: Principal curvatures of the surface at the point.
    """

    def __init__(
        self,
        skin: Skin,
        length: float,
        point: Sequence[float],
        normal: Sequence[float],
        tangent: Sequence[float] | None = None,
        guessed: bool = False,
    ) -> None:
        self.skin, self.length = skin, length
        self.point: Vector = np.asarray(point, dtype=np.float64) / length
        self.edge = self._edge()
        self._refuse_sharp()
        self._face(np.asarray(normal))
        self.tangent: Vector | None = None
        if tangent is not None:
            given: Vector = np.asarray(tangent, dtype=np.float64)
            aside: Vector = given - (given @ self.normal) * self.normal
            self.tangent = np.asarray(aside / np.linalg.norm(aside))
        for _ in range(3 if guessed else 0):
            self._face(self.normal - self._heights()[1:3] @ self.axes)
        self.curvature = self._curvature()

    def _face(self, normal: Vector) -> None:
        """Sets the normal, and what belongs to it."""
        self.normal: Vector = np.asarray(normal / np.linalg.norm(normal))
        first = np.eye(3)[np.argmin(np.abs(self.normal))]
        first = np.cross(self.normal, first) / np.linalg.norm(np.cross(self.normal, first))
        self.axes: Vector = np.array([first, np.cross(self.normal, first)])
        self.facets = self.near(PATCH * self.edge)
        if len(self.facets) == 0:
            raise InvalidInput.conflict(
                "normal", "the surface does not face that way at the point", "does it lead outward?"
            )

    def near(self, radius: float) -> NDArray[np.int64]:
        """Facets around the normal that face outward, within a radius."""
        flat, depth = self._flat(self.skin.middles)
        beside = np.linalg.norm(flat, axis=1) < radius
        return np.flatnonzero(beside & (np.abs(depth) < radius) & (self.skin.normals @ self.normal > STEEP))

    def weights(self) -> tuple[NDArray[np.int64], Vector]:
        """Rows that make of values at nodes the value at the point, and half its mean curvature.

        Returns nodes of the skin, and for each of both rows their weights.
        """
        nodes, rows, _ = self._fit(6)
        squares = [POWERS.index((2, 0)), POWERS.index((0, 2))]
        return nodes, np.array([rows[0], 0.5 * rows[squares].sum(axis=0)])

    def _fit(self, each: int) -> tuple[NDArray[np.int64], Vector, Vector]:
        """Nodes in the patch, so many of each facet, their columns of the inverse, and their heights."""
        nodes = np.unique(self.skin.facets[self.facets, :each])
        flat, height = self._flat(np.asarray(self.skin.nodes[nodes]))
        x, y = (flat / (PATCH * self.edge)).T
        if len(nodes) < 2 * len(POWERS):
            raise InvalidInput.conflict("point", f"only {len(nodes)} nodes near it, too few for a fit")
        powers = np.stack([x**i * y**j for i, j in POWERS], axis=1)
        scales = np.array([(PATCH * self.edge) ** -(i + j) for i, j in POWERS])
        rows: Vector = np.asarray(scales[:, None] * np.linalg.pinv(powers), dtype=np.float64)
        return nodes, rows, height

    def _heights(self) -> Vector:
        """Heights of the surface over the plane of the normal, by powers."""
        _, rows, height = self._fit(6 if self.skin.curved else 3)
        return np.asarray(rows @ height)

    def _curvature(self) -> tuple[float, float]:
        """Also refuses a point beside the surface, and a normal that is not the surface's."""
        fitted = dict(zip(POWERS, self._heights()))
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
        return np.asarray(arms @ self.axes.T), np.asarray(arms @ self.normal)

    def _edge(self) -> float:
        """Of the dozen facets closest to the point."""
        distances = np.linalg.norm(self.skin.middles - self.point, axis=1)
        closest = self.skin.corners[np.argsort(distances)[:12]]
        edge = float(np.mean(np.linalg.norm(closest - np.roll(closest, 1, axis=1), axis=2)))
        vertices = self.skin.corners.reshape(-1, 3)
        away = np.linalg.norm(vertices - self.point, axis=1)
        if away.min() > 1.5 * edge:
            raise self._beside(away.min(), vertices[np.argmin(away)])
        return edge

    def _refuse_sharp(self) -> None:
        """A point where facets meet at an angle has no normal and no curvature."""
        apart = self.skin.distances(self.point, 2.0 * self.edge)
        normals = self.skin.normals[apart < 0.05 * self.edge]
        if len(normals) < 2:
            return
        angle = float(np.degrees(np.arccos(np.clip(np.min(normals @ normals.T), -1.0, 1.0))))
        if angle > SHARP:
            raise InvalidInput.conflict(
                "point",
                f"it lies on a sharp edge, where faces meet at {angle:.0f} degrees: no smooth surface",
                f"a point {3.0 * self.length * self.edge:.2g} m or more beside it, or a shape with a round edge",
            )

    def _beside(self, distance: float, nearest: Vector) -> InvalidInput:
        place = ",".join(f"{self.length * x:.6g}" for x in nearest)
        hint = " (is the unit right? --unit mm)" if distance > 2.0 else ""
        return InvalidInput.conflict(
            "point",
            f"{self.length * distance:.3g} m beside the surface, nearest is {place} m; the body measures {2 * self.length:.3g} m from corner to corner{hint}",
        )
