"""The law of compression that the paper prints, eq. (56), δ = F (ln(4/F) − 1 − ν), which stoss does not have.

In units of s e^{−1−b} for forces, lengths and speeds all laws δ = F (ln(s/F) − b) are one, so that the law of the
centre gives it: contact times and lost fractions are those at another speed.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from stoss import quasistatic


def law_and_unit(law: str, poisson: float) -> tuple[str, float]:
    """A law of stoss, and the unit in which it is the law of that name."""
    if law != "printed":
        return law, 1.0
    return "center", 4.0 * np.exp(-2.0 - poisson) / quasistatic.limit_force(poisson=poisson)


def force_by(law: str, poisson: float, compression: float | NDArray[np.float64]) -> NDArray[np.float64]:
    """F at a compression, πRE and R."""
    own, unit = law_and_unit(law, poisson)
    scaled = np.asarray(compression) / unit
    return np.asarray(unit * quasistatic.compression_force(law=own, poisson=poisson, compression=scaled))
