"""The lowest elastic modes, and how they move the contact point."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray
from petsc4py import PETSc
from slepc4py import SLEPc

from stoss._errors import InvalidInput, NotConverged
from stoss.modal._elasticity import Elasticity
from stoss.modal._surface import Surface

SHIFT = 1e-3
"""K + SHIFT M is factored: K has no inverse, because of the rigid motions."""
RESIDUAL = 1e-9
"""Of static loads, as a share: rounding leaves 1e-11 of thin bodies; energies err by its square."""
RIGID = 1e-8
"""Modes with ω² below it are rigid, in units of the bar speed over half the body's diagonal."""

Vector = NDArray[np.float64]


class Spectrum:
    """The eigenproblem K u = ω² M u, whose factored matrix also serves static loads."""

    def __init__(self, body: Elasticity) -> None:
        self.body = body
        self.solver = SLEPc.EPS().create(body.mesh.comm)
        self.solver.setOperators(body.stiffness, body.mass)
        self.solver.setProblemType(SLEPc.EPS.ProblemType.GHEP)
        self.solver.setType(SLEPc.EPS.Type.KRYLOVSCHUR)
        self.solver.setWhichEigenpairs(SLEPc.EPS.Which.TARGET_MAGNITUDE)
        self.solver.setTarget(-SHIFT)
        self.solver.setTolerances(1e-10, 200)
        transform = self.solver.getST()
        transform.setType(SLEPc.ST.Type.SINVERT)
        _factor(transform.getKSP())
        self.solver.setDimensions(16)
        self.solver.setUp()

    def solve(self, load: PETSc.Vec) -> PETSc.Vec:
        """The static displacement under a load in balance, by conjugate gradients."""
        inverse = self.solver.getST().getKSP()
        found, residual = self.body.vector(), load.copy()
        improved, direction = self.body.vector(), self.body.vector()
        bound, slope = RESIDUAL * load.norm(), 0.0
        for _ in range(100):
            inverse.solve(residual, improved)
            self.body.without_rigid(improved)
            before, slope = slope, residual.dot(improved)
            direction.aypx(slope / before if before else 0.0, improved)
            image = self.body.stiffness * direction
            step = slope / direction.dot(image)
            found.axpy(step, direction)
            residual.axpy(-step, image)
            if residual.norm() < bound:
                self.body.without_rigid(found)
                return found
        raise NotConverged("compliance: the static displacement did not converge")

    def modes(self, count: int, surface: Surface, progress: Callable[[int], None]) -> dict[str, Vector]:
        """At least `count` elastic modes, up to a gap, in units with E = ρ = 1.

        Returns ω, the displacement along the normal at the point, and half its mean curvature; and
        both along the tangent, if there is one.
        """
        free = len(self.body.rigid)
        wanted = count + free + max(4, count // 10)
        self.solver.setDimensions(wanted, PETSc.DECIDE, PETSc.DECIDE)
        self.solver.setMonitor(lambda eps, step, done, *_: progress(min(max(done - free, 0), count)))
        self.solver.solve()
        self.solver.cancelMonitor()
        found = self.solver.getConverged()
        if found < wanted:
            raise NotConverged(f"modes: only {found} of {wanted} converged")
        return self._at_point(found, count, surface)

    def set_apart(self, count: int) -> None:
        """Takes the lowest modes of a body that is held from static loads, as rigid motions are from those of others.

        They have nearly all of its compliance, in which that of the point would drown.
        """
        values = np.array([self.solver.getEigenvalue(i).real for i in range(self.solver.getConverged())])
        for i in np.argsort(values)[:count]:
            vector = self.body.vector()
            self.solver.getEigenvector(int(i), vector)
            vector.scale(1.0 / np.sqrt(vector.dot(self.body.mass * vector)))
            self.body.rigid.append(vector)

    def _at_point(self, found: int, count: int, surface: Surface) -> dict[str, Vector]:
        values = np.array([self.solver.getEigenvalue(i).real for i in range(found)])
        order = np.argsort(values)
        values = values[order]
        free, rigid = len(self.body.rigid), int(np.sum(np.abs(values) < RIGID))
        if free and rigid != free:
            raise InvalidInput.conflict("mesh", f"{rigid} rigid motions, must be 6: does it hang together?")
        if rigid > free:
            raise InvalidInput.conflict(
                "held", f"the body can still move as a whole in {rigid} way{'s' * (rigid > 1)}, or springs are too soft",
                "springs along both directions, SURFACE=KN,KT, stiffer ones, or a second surface",
            )  # fmt: skip
        # The last ones may have others of the same frequency behind them.
        gaps = np.diff(np.sqrt(values[free:]))[count - 1 :]
        end = free + count + int(np.argmax(gaps))
        below = self.below(0.5 * (values[end - 1] + values[end]))
        if below != end:
            raise NotConverged(f"modes: found {end} of {below} below a frequency")
        nodes, weights = surface.weights(self.body.space)
        axes = {"": surface.normal}
        if surface.tangent is not None:
            axes["tangential_"] = surface.tangent
        rows, vector = np.empty((len(axes), end - free, len(nodes))), self.body.vector()
        for k, i in enumerate(order[free:end]):
            self.solver.getEigenvector(i, vector)
            norm = np.sqrt(vector.dot(self.body.mass * vector))
            for row, axis in zip(rows, axes.values()):
                row[k] = vector.array.reshape(-1, 3)[nodes] @ axis / norm
        result = {"omega": np.sqrt(values[free:end])}
        for prefix, moved in zip(axes, self.body.mesh.comm.allreduce(rows @ weights.T)):
            result[f"{prefix}displacement"] = moved[:, 0]
            result[f"{prefix}displacement_curvature"] = moved[:, 1]
        return result

    def below(self, value: float) -> int:
        """How many modes lie below ω² = value, rigid ones too: so many pivots are negative."""
        shifted = self.body.stiffness.copy()
        shifted.axpy(-value, self.body.mass, PETSc.Mat.Structure.SAME_NONZERO_PATTERN)
        solver = PETSc.KSP().create(self.body.mesh.comm)
        solver.setOperators(shifted)
        _factor(solver)
        solver.getPC().setFactorSetUpSolverType()
        factor = solver.getPC().getFactorMatrix()
        factor.setMumpsIcntl(13, 1)  # else pivots of the root, which processes share, are not counted
        factor.setMumpsIcntl(24, 1)  # without which PETSc tells no inertia
        solver.setUp()
        below = int(factor.getInertia()[0])
        solver.destroy()
        shifted.destroy()
        return below


def _factor(solver: Any) -> None:
    """MUMPS, for symmetric matrices."""
    solver.setType(PETSc.KSP.Type.PREONLY)
    solver.getPC().setType(PETSc.PC.Type.CHOLESKY)
    solver.getPC().setFactorSolverType(PETSc.Mat.SolverType.MUMPS)
    # What several processes need is not foreseen well: twice as much memory, in %.
    PETSc.Options()[f"{solver.getOptionsPrefix() or ''}mat_mumps_icntl_14"] = 100
