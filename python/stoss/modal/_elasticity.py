"""The elastic body in finite elements: quadratic displacements, in units with E = ρ = 1."""

from __future__ import annotations

import dataclasses
from typing import Any, Sequence

import numpy as np
import ufl
from dolfinx import fem
from dolfinx import mesh as meshes
from dolfinx.fem.petsc import assemble_matrix
from mpi4py import MPI
from numpy.typing import NDArray
from petsc4py import PETSc

DEGREE = 4
"""Degree of the polynomials that are integrated exactly: products of displacements."""


@dataclasses.dataclass(frozen=True)
class Held:
    """A surface that is held, or has a mass, in units with E = ρ = 1.

    Attributes:
        facets: Of this process.
        normal, tangential: Stiffness of springs.
        mass: What is fixed to it has.
        each: Whether a stiffness is that of each unit of its area, not that of all of it.
    """

    facets: NDArray[np.int32]
    normal: float
    tangential: float
    mass: float
    each: bool

    @property
    def holds(self) -> bool:
        """Whether the body cannot go where it likes."""
        return self.mass == 0.0

    @property
    def clamps(self) -> bool:
        """Whether the surface cannot move at all."""
        return self.holds and self.normal == self.tangential == 0.0

    def spread(self, area: float) -> tuple[float, float, float]:
        """Both stiffnesses and the mass of a unit of its area."""
        share = 1.0 if self.each else 1.0 / area
        return share * self.normal, share * self.tangential, self.mass / area


def displacements(mesh: Any) -> Any:
    """The space of the displacements of a mesh."""
    return fem.VectorFunctionSpace(mesh, ("Lagrange", 2))


class Elasticity:
    """Stiffness, mass and rigid motions of a mesh.

    Attributes:
        space: Space of the displacements.
        stiffness, mass: Matrices K and M of PETSc.
        rigid: Six vectors of rigid motions, orthonormal in M; none of a body that is held.
        volume, centre, inertia: By integration of mass, 1 each unit of volume; the inertia is about its centre.
    """

    def __init__(self, space: Any, poisson: float, supports: Sequence[Held] = ()) -> None:
        self.mesh = mesh = space.mesh
        self.space = space
        u, v = ufl.TrialFunction(self.space), ufl.TestFunction(self.space)
        lame = poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
        shear = 0.5 / (1.0 + poisson)
        first, second = (fem.Constant(mesh, PETSc.ScalarType(each)) for each in (lame, shear))
        stress = first * ufl.div(u) * ufl.Identity(3) + 2.0 * second * ufl.sym(ufl.grad(u))
        self.stiffness = self._matrix(ufl.inner(stress, ufl.sym(ufl.grad(v))))
        self.mass = self._matrix(ufl.inner(u, v))
        for each in supports:
            if not each.clamps:
                self._add(each)
        self._weigh()
        clamped = [each.facets for each in supports if each.clamps]
        self.rigid = [] if any(each.holds for each in supports) else self._rigid()
        self._fixed = self._clamp(np.concatenate(clamped)) if clamped else np.empty(0, dtype=np.int32)

    def vector(self) -> PETSc.Vec:
        """A displacement, or a load."""
        return self.mass.createVecRight()

    def nodes(self) -> NDArray[np.float64]:
        """Where the displacements of this process are, one point for three of them."""
        owned = self.space.dofmap.index_map.size_local
        return np.array(self.space.tabulate_dof_coordinates()[:owned])

    def unheld(self, loads: NDArray[np.float64]) -> None:
        """Takes from loads, as columns, what acts where the body is clamped."""
        loads[self._fixed] = 0.0

    def _add(self, support: Held) -> None:
        """The stiffness and the mass of a surface, which are spread evenly over it."""
        tags = meshes.meshtags(self.mesh, 2, support.facets, np.ones(len(support.facets), dtype=np.int32))
        ds = ufl.ds(domain=self.mesh, subdomain_data=tags, metadata={"quadrature_degree": DEGREE})(1)
        u, v, n = ufl.TrialFunction(self.space), ufl.TestFunction(self.space), ufl.FacetNormal(self.mesh)
        one = fem.Constant(self.mesh, PETSc.ScalarType(1.0))
        area = self.mesh.comm.allreduce(fem.assemble_scalar(fem.form(one * ds)), MPI.SUM)
        normal, along, mass = (fem.Constant(self.mesh, PETSc.ScalarType(x)) for x in support.spread(area))
        across = ufl.inner(u, n) * ufl.inner(v, n)
        spring = normal * across + along * (ufl.inner(u, v) - across)
        for matrix, integrand in ((self.stiffness, spring), (self.mass, mass * ufl.inner(u, v))):
            assemble_matrix(matrix, fem.form(integrand * ds))
            matrix.assemble()

    def _clamp(self, facets: NDArray[np.int32]) -> NDArray[np.int32]:
        """Takes the displacements of facets out of both matrices. Returns those of this process."""
        nodes = fem.locate_dofs_topological(self.space, 2, np.unique(facets))
        nodes = nodes[nodes < self.space.dofmap.index_map.size_local]
        fixed = (3 * nodes[:, None] + np.arange(3)).ravel().astype(np.int32)
        first = self.mass.getOwnershipRange()[0]
        self.stiffness.zeroRowsColumns(fixed + first, 1.0)
        self.mass.zeroRowsColumns(fixed + first, 0.0)
        return np.asarray(fixed, dtype=np.int32)

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
