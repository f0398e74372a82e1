"""The elastic body in finite elements: quadratic displacements, in units with E = ρ = 1."""

from __future__ import annotations

from typing import Any

import numpy as np
import ufl
from dolfinx import fem
from dolfinx.fem.petsc import assemble_matrix
from numpy.typing import NDArray
from petsc4py import PETSc

DEGREE = 4
"""Degree of the polynomials that are integrated exactly: products of displacements."""


class Elasticity:
    """Stiffness, mass and rigid motions of a mesh.

    Attributes:
        space: Space of the displacements.
        stiffness, mass: Matrices K and M of PETSc.
        rigid: Six vectors of rigid motions, orthonormal in M.
        volume, centre, inertia: By integration; the inertia is about the centre of mass.
    """

    def __init__(self, mesh: Any, poisson: float) -> None:
        self.mesh = mesh
        self.space = fem.VectorFunctionSpace(mesh, ("Lagrange", 2))
        u, v = ufl.TrialFunction(self.space), ufl.TestFunction(self.space)
        lame = poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
        shear = 0.5 / (1.0 + poisson)
        first, second = (fem.Constant(mesh, PETSc.ScalarType(each)) for each in (lame, shear))
        stress = first * ufl.div(u) * ufl.Identity(3) + 2.0 * second * ufl.sym(ufl.grad(u))
        self.stiffness = self._matrix(ufl.inner(stress, ufl.sym(ufl.grad(v))))
        self.mass = self._matrix(ufl.inner(u, v))
        self._weigh()
        self.rigid = self._rigid()

    def vector(self) -> PETSc.Vec:
        """A displacement, or a load."""
        return self.mass.createVecRight()

    def nodes(self) -> NDArray[np.float64]:
        """Where the displacements of this process are, one point for three of them."""
        owned = self.space.dofmap.index_map.size_local
        return np.array(self.space.tabulate_dof_coordinates()[:owned])

    def without_rigid(self, displacement: PETSc.Vec) -> None:
        """Takes from a displacement the rigid motions that it holds, measured by mass."""
        weighted = self.mass * displacement
        for each in self.rigid:
            displacement.axpy(-each.dot(weighted), each)

    def balance(self, load: PETSc.Vec) -> None:
        """Adds to a load the forces of inertia of the rigid motion that it causes."""
        shares = [each.dot(load) for each in self.rigid]
        motion = self.vector()
        for share, each in zip(shares, self.rigid):
            motion.axpy(share, each)
        load.axpy(-1.0, self.mass * motion)

    def _matrix(self, integrand: Any) -> PETSc.Mat:
        dx = ufl.dx(metadata={"quadrature_degree": DEGREE})
        matrix = assemble_matrix(fem.form(integrand * dx))
        matrix.assemble()
        matrix.setOption(PETSc.Mat.Option.SYMMETRIC, True)
        return matrix

    def _weigh(self) -> None:
        nodes = self.nodes()
        vectors = []
        for values in (np.ones(len(nodes)), *nodes.T):  # 1, x, y, z as displacements along one axis
            vectors.append(self.vector())
            vectors[-1].array.reshape(-1, 3)[:, 0] = values
        moments = np.array([[one.dot(self.mass * other) for one in vectors] for other in vectors])
        self.volume = float(moments[0, 0])
        self.centre = moments[0, 1:] / self.volume
        second = moments[1:, 1:] - self.volume * np.outer(self.centre, self.centre)
        self.inertia = np.trace(second) * np.eye(3) - second

    def _rigid(self) -> list[PETSc.Vec]:
        arms = self.nodes() - self.centre
        axes = np.eye(3)
        motions = [np.tile(axis, (len(arms), 1)) for axis in axes]
        motions += [np.cross(axis, arms) for axis in axes]
        kept: list[PETSc.Vec] = []
        for motion in motions:
            vector = self.vector()
            vector.array[:] = motion.ravel()
            for _ in range(2):  # twice is enough
                weighted = self.mass * vector
                for each in kept:
                    vector.axpy(-each.dot(weighted), each)
            vector.scale(1.0 / np.sqrt(vector.dot(self.mass * vector)))
            kept.append(vector)
        return kept
