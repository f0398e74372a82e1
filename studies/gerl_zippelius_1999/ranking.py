"""The paper's choice of modes: ranked by mean energy in a preliminary run with more of them.

The preliminary run is one at the exponential wall (eq. Hamiltonint) with all modes up to a cutoff. The mean is taken
over the contact; which mean the paper takes it does not say.
"""

from __future__ import annotations

from typing import Mapping

import numpy as np
import stoss
from numpy.typing import NDArray

POISSON = 0.33


def ranked(energies: NDArray) -> NDArray[np.intp]:
    """Places of the modes, the most energetic first; of equals the first in the list."""
    return np.argsort(-energies["average"], kind="stable")


def selected_impact(preliminary: stoss.Impact, count: int) -> stoss.Impact:
    """The final run: the same impact with the `count` modes of highest mean energy in the preliminary one only."""
    keep = np.zeros(preliminary.modes, dtype=bool)
    keep[ranked(preliminary.mode_energies)[:count]] = True
    return stoss.impact(
        body=preliminary.body, speed=preliminary.speed, cutoff=preliminary.cutoff, wall=preliminary.wall, keep=keep
    )  # fmt: skip


def place(energies: Mapping[str, NDArray] | NDArray, order: int, index: int) -> int:
    """Row of the mode (n, l) in a list or table."""
    return int(np.flatnonzero((energies["order"] == order) & (energies["index"] == index))[0])
