"""The coefficient of restitution as Gerl and Zippelius compute it."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import number, numbers
from stoss.export._text import with_error
from stoss.results._result import Column, Result, columns, picture


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Extrapolation(Result):
    """ε and 1 − ε² by the two limits of the paper, α → ∞ and N → ∞, with the errors of its regressions.

    Attributes
    ----------
    hard_wall : ndarray
        1 − ε² for α → ∞ at each cutoff, a structured array with the fields value and error.
    impacts : ndarray
        1 − ε² of each impact, a structured array with the fields cutoff, modes, hardness,
        lost_fraction and steps.
    """

    plot = picture("1 − ε² against 1/α with the regressions. See `stoss.plot.extrapolation`.")
    _name: ClassVar[str] = "extrapolation"
    _kind = "soft impact"
    _told = ("poisson", "speed", "restitution", "restitution_error", "lost_fraction", "lost_fraction_error")

    poisson: float
    speed: float
    restitution: float
    restitution_error: float
    lost_fraction: float
    lost_fraction_error: float
    hard_wall: NDArray[Any]
    impacts: NDArray[Any]
    steps: int

    def __repr__(self) -> str:
        value = with_error(self.restitution, self.restitution_error)
        return f"Extrapolation(poisson={self.poisson:g}, speed={self.speed:g} c: restitution {value})"

    def _table(self) -> dict[str, Column]:
        return columns(self.impacts)


def extrapolated_restitution(
    *, poisson: float, speed: float, cutoffs: ArrayLike = (), hardnesses: ArrayLike = ()
) -> Extrapolation:
    """Compute ε as Gerl and Zippelius do: exponential walls and two extrapolations.

    1 − ε² is extrapolated in 1/α, then in 1/√N. This shows that their method agrees with
    `restitution`, and what it costs.

    Parameters
    ----------
    poisson : float
        2-D Poisson's ratio, −0.95 to 0.995.
    speed : float
        Of the centre of mass, 1e-3 to 0.5, c.
    cutoffs : array_like, optional
        At least three, ascending, c/R; default: those that keep 300, 400, 600 and 940 modes.
    hardnesses : array_like, optional
        αR, at least three, ascending; default: αv/c = 25, 33, 50 and 100.

    Examples
    --------
    >>> stoss.extrapolated_restitution(poisson=0.33, speed=0.1)
    Extrapolation(poisson=0.33, speed=0.1 c: restitution 0.9467 ± 0.0010)
    """
    nu, v = number("poisson", poisson), number("speed", speed)
    series = (numbers("cutoffs", cutoffs).ravel(), numbers("hardnesses", hardnesses).ravel())
    found = _core.extrapolated_restitution(nu, v, *series)
    return Extrapolation(poisson=nu, speed=v, **found)
