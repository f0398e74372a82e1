"""The compliances c0 and c_t: what is static at points beside 1/r and its logarithm."""

from __future__ import annotations

import dataclasses
import math
from typing import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

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
TOGETHER = 10
"""Points whose pressures are solved for together, which takes less time each, until Ctrl-C is heard."""

Vector = NDArray[np.float64]


@dataclasses.dataclass(frozen=True)
class Pressures:
    """Where the pressures of a point act, in half the body's diagonal; `along` the tangent, or the normal."""

    surface: Surface
    facets: NDArray[np.int64]
    widest: float
    curvature: float
    along: bool = False

    @property
    def radii(self) -> Vector:
        """The radii of all pressures, the widest last."""
        return self.widest * np.array(SHARES)

    def loads(self) -> Vector:
        """Forces at the nodes of the skin."""
        its, axis = self.surface, self.surface.normal
        if self.along:
            assert its.tangent is not None
            axis = its.tangent
        return np.array([its.skin.pressure(self.facets, its.point, its.normal, axis, b) for b in self.radii])

    def constant(self, poisson: float, energies: Vector) -> tuple[float, float]:
        """c0 in units with E = 1 from twice the elastic energies, extrapolated to no radius, and how far this reaches."""
        front = (1.0 - poisson**2) / math.pi
        share = (1.0 - 2.0 * poisson) ** 2 / (2.0 * (1.0 - poisson))
        if self.along:
            front = (1.0 + poisson) * (2.0 - poisson) / (2.0 * math.pi)
            share = (3.0 - 2.0 * poisson + 4.0 * poisson**2) / (2.0 * (2.0 - poisson))
        known = INVERSE / self.radii
        if self.curvature > 0.0:
            known = known - share * self.curvature * (np.log(self.curvature * self.radii) + LOGARITHM)
        values = energies - front * known
        # Even in the radius but for weak terms; beside a wall thinner than the pressures curves part.
        even = float(np.polyfit(self.radii**2, values, 2)[-1])
        parabola = float(np.polyfit(self.radii, values, 2)[-1])
        return even, (2.0 if self.along else 1.0) * abs(even - parabola)


def pressures(surface: Surface, curvature: float, widest: float | None, along: bool = False) -> Pressures:
    """Those from which the compliance follows. `widest` is that of a finer mesh. Raises InvalidInput."""
    least, most = (edges * surface.edge for edges in EDGES)
    if widest is None:
        widest = min(most, BEND / curvature) if curvature > 0.0 else most
    else:
        least *= COARSER
    if widest < least:
        allowed = _metres(surface, surface.edge * widest / least)
        raise _too_coarse(surface, f"allowed {allowed}, better a fourth of that")
    facets = surface.near(widest + 2.0 * surface.edge)
    while abs(surface.skin.total(facets, surface.point, surface.normal, widest) - 1.0) > 0.01:
        widest *= 0.9
        if widest < least:
            near = _metres(surface, least)
            raise _too_coarse(surface, f"the surface ends or turns away within {near} of it")
    return Pressures(surface, facets, widest, curvature, along)


def compliances(spectrum: Spectrum, poisson: float, each: Sequence[Pressures]) -> Iterator[tuple[float, float]]:
    """c0 or c_t of each, in units with E = 1, and how far the extrapolation to it reaches."""
    for start in range(0, len(each), TOGETHER):
        some = each[start : start + TOGETHER]
        energies = spectrum.energies(some[0].surface.skin, np.concatenate([one.loads() for one in some]))
        for one, its in zip(some, energies.reshape(-1, len(SHARES))):
            yield one.constant(poisson, its)


def _too_coarse(surface: Surface, why: str) -> InvalidInput:
    edge = _metres(surface, surface.edge)
    return InvalidInput.conflict("mesh", f"too coarse at the point: edges of {edge}, {why}", "--size-at-point")


def _metres(surface: Surface, length: float) -> str:
    return f"{length * surface.length:.3g} m"
