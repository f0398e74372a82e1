"""The compliances c0 and c_t: what is static at the point beside 1/r and its logarithm."""

from __future__ import annotations

import math
import numpy as np
import ufl
from dolfinx import fem
from dolfinx import mesh as meshes
from mpi4py import MPI
from numpy.typing import NDArray
from petsc4py import PETSc

from stoss._errors import InvalidInput
from stoss.modal._modes import Spectrum
from stoss.modal._surface import Surface

EDGES = (3.0, 16.0)
"""Least and most radius of the widest pressure, in edges of the mesh at the point."""
BEND = 0.45
"""Its greatest radius, in radii of curvature of the surface."""
COARSER = 0.6
"""Share of the least radius that is enough on a coarser mesh, which takes that of the finer."""
SHARES = (0.5, 0.75, 1.0)
"""The radii of the pressures, as shares of the widest one."""
INVERSE = 36.0 * math.gamma(6.0) * math.gamma(0.5) / (math.gamma(3.5) ** 2 * math.gamma(6.5))
"""Mean of 1/r between points under the pressure (1 − r²)², by its transform 48 J₃(k)/k³."""
LOGARITHM = -73.0 / 120.0
"""Mean of ln r between two such points: of ln max(r, r′), the mean over the angle."""


Vector = NDArray[np.float64]


class Pressure:
    """A smooth load of total force one, p ∝ (1 − r²/b²)² around the normal: along it, or the tangent."""

    def __init__(self, spectrum: Spectrum, surface: Surface, widest: float, axis: Vector) -> None:
        self.spectrum, self.surface = spectrum, surface
        mesh = surface.mesh
        facets = surface.near(widest + 2.0 * surface.edge)
        tags = meshes.meshtags(mesh, 2, facets, np.ones(len(facets), dtype=np.int32))
        ds = ufl.ds(domain=mesh, subdomain_data=tags, metadata={"quadrature_degree": 10})(1)
        self.radius = fem.Constant(mesh, PETSc.ScalarType(1.0))
        point = fem.Constant(mesh, PETSc.ScalarType(surface.point))
        normal = fem.Constant(mesh, PETSc.ScalarType(surface.normal))
        arm = ufl.SpatialCoordinate(mesh) - point
        square = (ufl.inner(arm, arm) - ufl.inner(arm, normal) ** 2) / self.radius**2
        share = ufl.conditional(ufl.lt(square, 1.0), (1.0 - square) ** 2, 0.0)
        share = share * 3.0 / (math.pi * self.radius**2) * ufl.inner(ufl.FacetNormal(mesh), normal)
        moved = ufl.TestFunction(spectrum.body.space)
        along = fem.Constant(mesh, PETSc.ScalarType(axis))
        self._load = fem.form(-share * ufl.inner(moved, along) * ds)
        self._total = fem.form(share * ds)

    def total(self, radius: float) -> float:
        """What of the force acts: less than 1 where the surface ends or turns away."""
        self.radius.value = radius
        return float(self.surface.mesh.comm.allreduce(fem.assemble_scalar(self._total), MPI.SUM))

    def compliance(self, radius: float) -> float:
        """Twice its elastic energy in the body, which its inertia balances, or what holds it."""
        total = self.total(radius)
        load = fem.petsc.assemble_vector(self._load)
        load.ghostUpdate(addv=PETSc.InsertMode.ADD, mode=PETSc.ScatterMode.REVERSE)
        load.scale(1.0 / total)
        self.spectrum.body.unheld(load)
        self.spectrum.body.balance(load)
        return float(load.dot(self.spectrum.solve(load)))


def compliance(
    spectrum: Spectrum,
    surface: Surface,
    poisson: float,
    curvature: float,
    widest: float | None,
    along: bool = False,
) -> dict[str, float]:
    """c0 in units with E = 1, extrapolated to no radius, how far this reaches, and the widest radius.

    `widest` is that of a finer mesh. `along`: c_t, by a load along the tangent.
    """
    least, most = (edges * surface.edge for edges in EDGES)
    if widest is None:
        widest = min(most, BEND / curvature) if curvature > 0.0 else most
    else:
        least *= COARSER
    axis = surface.normal
    front = (1.0 - poisson**2) / math.pi
    share = (1.0 - 2.0 * poisson) ** 2 / (2.0 * (1.0 - poisson))
    if along:
        assert surface.tangent is not None
        axis = surface.tangent
        front = (1.0 + poisson) * (2.0 - poisson) / (2.0 * math.pi)
        share = (3.0 - 2.0 * poisson + 4.0 * poisson**2) / (2.0 * (2.0 - poisson))
    bend = share * curvature
    if widest < least:
        allowed = _metres(surface, surface.edge * widest / least)
        raise _too_coarse(surface, f"allowed {allowed}, better a fourth of that")
    pressure = Pressure(spectrum, surface, widest, axis)
    while abs(pressure.total(widest) - 1.0) > 0.01:
        widest *= 0.9
        if widest < least:
            near = _metres(surface, least)
            raise _too_coarse(surface, f"the surface ends or turns away within {near} of it")
    radii = widest * np.array(SHARES)
    values = []
    for b in radii:
        known = INVERSE / b
        if curvature > 0.0:
            known -= bend * (math.log(curvature * b) + LOGARITHM)
        values.append(pressure.compliance(b) - front * known)
    # Even in the radius but for weak terms; beside a wall thinner than the pressures curves part.
    even = float(np.polyfit(radii**2, values, 2)[-1])
    parabola = float(np.polyfit(radii, values, 2)[-1])
    return {"c0": even, "reach": 2.0 * abs(even - parabola), "widest": widest}


def _too_coarse(surface: Surface, why: str) -> InvalidInput:
    edge = _metres(surface, surface.edge)
    return InvalidInput.conflict("mesh", f"too coarse at the point: edges of {edge}, {why}", "--size-at-point")


def _metres(surface: Surface, length: float) -> str:
    return f"{length * surface.length:.3g} m"
