"""The lowest elastic modes, and elastic energies under static loads."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray
from petsc4py import PETSc
from slepc4py import SLEPc

from stoss._errors import InvalidInput, NotConverged
from stoss.modal._elasticity import Elasticity
from stoss.modal._skin import Skin

SHIFT = 1e-3
"""K + SHIFT M is factored: K has no inverse, because of the rigid motions."""
RESIDUAL = 1e-4
"""Of static loads, as a share: rounding leaves 1e-11 of thin bodies; energies err by its square."""
DEFLATED = 40
"""Modes that static loads are freed of, so that the few steps of their solution are fewer."""
APART = 6
"""Lowest modes of a body that is held which static compliances leave out."""
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

    def modes(self, count: int, skin: Skin, progress: Callable[[int], None]) -> tuple[Vector, Vector]:
        """At least `count` elastic modes, up to a gap: ω, and displacements of nodes of the skin, with E = ρ = 1."""
        free = len(self.body.rigid)
        wanted = count + free + max(4, count // 10)
        self.solver.setDimensions(wanted, PETSc.DECIDE, PETSc.DECIDE)
        self.solver.setMonitor(lambda eps, step, done, *_: progress(min(max(done - free, 0), count)))
        self.solver.solve()
        self.solver.cancelMonitor()
        found = self.solver.getConverged()
        if found < wanted:
            raise NotConverged(f"modes: only {found} of {wanted} converged")
        return self._elastic(found, count, skin)

    def energies(self, skin: Skin, loads: Vector) -> Vector:
        """Twice the elastic energy under forces at nodes of the skin, (loads, nodes, 3), which inertia balances.

        What holds the body balances them too, if anything does; the modes that are apart then take no
        part, as they have nearly all of the compliance, in which that of a point would drown.
        """
        body = self.body
        forces = skin.spread(loads, body.vector())
        body.unheld(forces)
        shares = self._sums(self._shapes.T @ forces)
        forces -= self._weighted @ shares
        taken = shares[-len(self._omega) :] / self._omega[:, None]
        energies: Vector = np.sum(taken[self.apart :] ** 2, axis=0) + self._deflated(forces)
        return energies

    def _deflated(self, forces: Vector) -> Vector:
        """The same of loads that move no known mode, by conjugate gradients for all loads at once."""
        found, residual = np.zeros_like(forces), forces.copy()
        direction, slope = np.zeros_like(forces), np.ones(forces.shape[1])
        bound = RESIDUAL * np.sqrt(self._sums(np.sum(forces**2, axis=0)))
        for step in range(100):
            improved = self._inverse(residual)
            improved -= self._shapes @ self._sums(self._weighted.T @ improved)
            before, slope = slope, self._sums(np.sum(residual * improved, axis=0))
            direction = improved + direction * (slope / before if step else 0.0)
            image = self._times(self.body.stiffness, direction)
            length = slope / self._sums(np.sum(direction * image, axis=0))
            found += length * direction
            residual -= length * image
            if np.all(np.sqrt(self._sums(np.sum(residual**2, axis=0))) < bound):
                return np.asarray(self._sums(np.sum(found * forces, axis=0)))
        raise NotConverged("compliance: the static displacement did not converge")

    def _inverse(self, columns: Vector) -> Vector:
        """(K + SHIFT M)⁻¹ of columns."""
        factor = self.solver.getST().getKSP().getPC().getFactorMatrix()
        right, left = self._dense(columns), self._dense(np.zeros_like(columns))
        factor.matSolve(right, left)
        solved = np.array(left.getDenseArray())
        right.destroy()
        left.destroy()
        return solved

    def _times(self, matrix: PETSc.Mat, columns: Vector) -> Vector:
        right = self._dense(columns)
        product = matrix.matMult(right)
        result = np.array(product.getDenseArray())
        right.destroy()
        product.destroy()
        return result

    def _dense(self, columns: Vector) -> PETSc.Mat:
        rows, wide = self.body.mass.getSizes()[0], columns.shape[1]
        array = np.asfortranarray(columns)
        made = PETSc.Mat().createDense((rows, (None, wide)), array=array, comm=self.body.mesh.comm)
        made.assemble()
        return made

    def _sums(self, values: Vector) -> Vector:
        """Over all processes."""
        total: Vector = self.body.mesh.comm.allreduce(values)
        return total

    def _elastic(self, found: int, count: int, skin: Skin) -> tuple[Vector, Vector]:
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
        omega, moved, vector = np.sqrt(values[free:end]), [], self.body.vector()
        kept = [each.array for each in self.body.rigid]
        for i in order[free:end]:
            self.solver.getEigenvector(int(i), vector)
            vector.scale(1.0 / np.sqrt(vector.dot(self.body.mass * vector)))
            moved.append(skin.displacements(vector))
            if len(kept) < free + DEFLATED:
                kept.append(vector.array.copy())
        self.apart = 0 if free else min(APART, len(omega))
        self._omega, self._shapes = omega[: len(kept) - free], np.array(kept).T
        self._weighted = self._times(self.body.mass, self._shapes)
        return omega, np.array(moved)

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
