"""The paper's impacts on one exponential wall, and what counts as contact and compression there."""

from __future__ import annotations

import numpy as np
import stoss

from .common import Table

POISSON = 0.33
HARDNESS = 500.0  # 1/R
SCALED = 50.0  # αv, c/R
MODES = 940
PRESSURE = 0.1  # E; of the plane from which compressions at the exponential wall are counted
SHARE = 0.01  # of the maximum force: contact at the exponential wall


def plane(hardness: float) -> float:
    """How far the plane of the pressure 0.1 E stands before that of V₀e^{αx} = 1, R."""
    return float(np.log(hardness / PRESSURE) / hardness)


def cutoff_of(count: int) -> float:
    """A cutoff below which there are so many modes."""
    omega = np.sort(stoss.modes(poisson=POISSON, cutoff=1.1 * np.sqrt(count / 0.45)).omega)
    return float(omega[count - 1 : count + 1].mean())


def soft(speeds: tuple[float, ...], scaled: bool) -> Table:
    """The paper's own impacts, at one wall or at walls that follow the speed."""
    cutoff = cutoff_of(MODES)
    rows = []
    for speed in speeds:
        hardness = SCALED / speed if scaled else HARDNESS
        wall = stoss.ExponentialWall(hardness=hardness)
        path = stoss.impact(poisson=POISSON, speed=speed, cutoff=cutoff, against=wall, tail="none").trajectory()
        pressed = path.time[path.force > SHARE * path.force.max()]
        rows.append((speed, hardness, pressed[-1] - pressed[0], 1.0 + path.center.max() + plane(hardness)))
    names = ("speed[c]", "hardness[1/R]", "contact_time[R/c]", "max_compression_from_pressure_plane[R]")
    return dict(zip(names, np.array(rows).T))
