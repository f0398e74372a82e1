"""The paper's static calculation (section V): the modes of a disk held in front of an exponential wall take the
coordinates of least energy.

    U = Σ ½mω²Q² + V₀ ∫ e^{αx(φ)} dφ,   x(φ) = x₀ + cos φ + Σ Q (C cos nφ cos φ − S sin nφ sin φ)

over the front half of the edge. Modes above a cutoff are left out. The compression counts from the plane V₀e^{αx} = 1
(an energy ρc²R² per radian), δ = R + x₀ + ln V₀/α, so that V₀ has no effect.

The modes answer node forces g by −Wg at the nodes, W = Σ (shape shapeᵀ)/(mω²), so that the energy is a function of g
alone, and convex. With f = ∂V/∂x and D = diag(αf) a Newton step solves (W + WDW) s = W(f − g). W is singular where
there are more nodes than modes can move; s = f − g − √D z with (1 + √D W √D) z = √D W (f − g) is the same and needs
no inverse of W.
"""

from __future__ import annotations

import functools

import numpy as np
import stoss
from numpy.typing import NDArray

Column = NDArray[np.float64]


@functools.lru_cache(maxsize=8)
def _orders(poisson: float, cutoff: float) -> Column:
    """For each order n of the modes Σ C²/(mω²), Σ CS/(mω²) and Σ S²/(mω²)."""
    modes = stoss.modes(poisson=poisson, cutoff=cutoff)
    upper, lower = modes.radial, modes.tangential
    stiffness = np.pi * modes.omega**2
    return np.array([np.bincount(modes.order, each / stiffness) for each in (upper**2, upper * lower, lower**2)])


class _Disk:
    """Held at rest at a wall, with the node forces found last."""

    def __init__(self, poisson: float, cutoff: float, compression: float, half_width: float, nodes: int) -> None:
        spacing = half_width / nodes
        angle = (np.arange(nodes) + 0.5) * spacing
        upper, mixed, lower = _orders(poisson, cutoff)
        waves = np.arange(len(upper))[:, None] * angle
        above, below = np.cos(waves) * np.cos(angle), -np.sin(waves) * np.sin(angle)
        crossed = (mixed[:, None] * above).T @ below
        self.compliance = (upper[:, None] * above).T @ above + crossed + crossed.T + (lower[:, None] * below).T @ below
        self.position = compression - 2.0 * np.sin(0.5 * angle) ** 2
        self.measure = 2.0 * spacing  # a node stands for its mirror image too
        self.force, self.displacement = np.zeros(nodes), np.zeros(nodes)

    def potential(self, hardness: float, pressure: float, place: float, displacement: Column) -> Column:
        """α times it, at a wall whose pressure at the place is given: the forces of the wall."""
        with np.errstate(over="ignore"):
            return self.measure * pressure * np.exp(hardness * (self.position - displacement - place))

    def relax(self, hardness: float, pressure: float, place: float, tolerance: float) -> None:
        """Newton's method from the forces of the last hardness."""
        for _ in range(200):
            wall = self.potential(hardness, pressure, place, self.displacement)
            excess = wall - self.force
            if np.abs(excess).sum() <= tolerance * wall.sum():
                return
            root, pull = np.sqrt(hardness * wall), self.compliance @ excess
            matrix = root[:, None] * self.compliance * root + np.eye(len(root))
            step = excess - root * np.linalg.solve(matrix, root * pull)
            self.search(step, -step @ pull, lambda moved: self.potential(hardness, pressure, place, moved), hardness)
        raise RuntimeError("relaxation: Newton's method found no minimum of the energy")

    def search(self, step: Column, slope: float, wall, hardness: float) -> None:
        """Halves the step until the energy falls as its slope promises; below rounding it takes the whole step."""
        moved = self.compliance @ step
        linear, quadratic = self.force @ moved, 0.5 * step @ moved
        before = wall(self.displacement).sum() / hardness
        energy = 0.5 * self.force @ self.displacement + before
        for t in 0.5 ** np.arange(40):
            change = t * (linear + t * quadratic) + wall(self.displacement + t * moved).sum() / hardness - before
            if np.isfinite(change) and (change <= 1e-4 * t * slope or -slope <= 1e-13 * energy):
                self.force += t * step
                self.displacement += t * moved
                return
        raise RuntimeError("relaxation: no step lowers the energy")


def relaxed_force(poisson: float, compression: float, hardness: float, cutoff: float, nodes: int | None = None) -> float:
    """Force at rest, πRE.

    The midpoint rule converges exponentially once the nodes resolve the pressure, over the width 1/√α, and the waves of
    the highest order (measured: to 1e-11).
    """
    half_width = min(np.sqrt(2.0 * (max(compression, 0.0) + 40.0 / hardness)), 0.5 * np.pi)
    if nodes is None:
        for_modes = 128.0 + 4.0 * half_width * (_orders(poisson, cutoff).shape[1] - 1)
        nodes = int(min(max(128.0, min(for_modes, 3.0 * half_width * np.sqrt(hardness))), 1024.0))
    # Softer walls that have the same place for a pressure of this size lead to the wall in question.
    pressure = 0.3 * np.sqrt(max(compression, 1.0 / hardness))
    place = np.log(pressure / hardness) / hardness
    disk = _Disk(poisson, cutoff, compression, half_width, nodes)
    softer = 8.0 / max(compression - place, 1e-3)
    while softer < hardness:
        disk.relax(softer, pressure, place, 1e-2)
        softer *= 2.0
    disk.relax(hardness, pressure, place, 1e-12 + 8.0 * np.finfo(float).eps * hardness)
    return float(disk.force.sum() / np.pi)
