"""The paper's choice of modes: ranked by mean energy in a preliminary run with more of them.

The preliminary run is one at the exponential wall (eq. 40) with all modes up to a cutoff. The mean
is taken over the contact; the paper does not say which mean it takes.
"""

from __future__ import annotations

from typing import Mapping

import numpy as np
import stoss
from numpy.typing import NDArray

from gerl_zippelius_1999.two_limits import cutoff, line, walls


def ranked(energies: NDArray) -> NDArray[np.intp]:
    """Places of the modes, the most energetic first; of equals the first in the list."""
    return np.argsort(-energies["average"], kind="stable")


def selected_impact(preliminary: stoss.Impact, count: int) -> stoss.Impact:
    """The final run: the same impact, with the `count` modes that rank first in `preliminary`."""
    keep = np.zeros(preliminary.modes, dtype=bool)
    keep[ranked(preliminary.mode_energies)[:count]] = True
    return stoss.impact(
        preliminary.body, speed=preliminary.speed, cutoff=preliminary.cutoff, against=preliminary.against, keep=keep
    )  # fmt: skip


def ranked_intercepts(poisson: float, speed: float, pool: int, counts: tuple[int, ...]) -> NDArray:
    """1 − ε² at the hard wall (α → ∞, as in figure 7) and its error: counts × 2.

    With the `counts` modes that rank first in a preliminary run with `pool` modes.
    """
    highest = cutoff(pool, poisson)

    def run(alpha: float, keep: NDArray[np.bool_] | None = None) -> stoss.Impact:
        wall = stoss.ExponentialWall(hardness=float(alpha))
        return stoss.impact(poisson=poisson, speed=speed, cutoff=highest, against=wall, keep=keep)

    rank = np.argsort(ranked(run(np.sort(walls(speed))[-2]).mode_energies))
    lost = [[run(alpha, rank < n).lost_fraction for alpha in walls(speed)] for n in counts]
    return np.array([line(1.0 / walls(speed), np.array(of_count))[:2] for of_count in lost])


def place(energies: Mapping[str, NDArray] | NDArray, order: int, index: int) -> int:
    """Row of the mode (n, l) in a list or table."""
    return int(np.flatnonzero((energies["order"] == order) & (energies["index"] == index))[0])
