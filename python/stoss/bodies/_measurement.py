"""How a material relaxes, from moduli that were measured at frequencies."""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import number, numbers, refusal
from stoss._documentation import documented
from stoss.bodies._material import Relaxation, relaxation_of


@dataclasses.dataclass(frozen=True, kw_only=True, eq=False)
class FittedRelaxation:
    """A Prony series that comes near measured moduli.

    Attributes:
        frequency (ndarray): Measured angular frequencies, rad/s.
        storage, loss (ndarray): Measured E′ and E″, Pa.
        young (float): Modulus E(0), Pa.
        relaxation (tuple): Shares of E(0) and their times in s, as a `Material` takes them.
        storage_misfit (float): Root mean square of its E′ over the measured one, less 1.
        loss_misfit (float): That of E″.
    """

    frequency: NDArray[np.float64]
    storage: NDArray[np.float64]
    loss: NDArray[np.float64]
    young: float
    relaxation: Relaxation
    storage_misfit: float
    loss_misfit: float

    @documented
    def modulus(self, frequency: ArrayLike) -> NDArray[np.complex128]:
        """Return E′ + iE″ at angular frequencies, Pa.

        Parameters:
            frequency: In rad/s.
        """
        omega = numbers("frequency", frequency)[..., None]
        shares, times = np.array(self.relaxation).reshape(-1, 2).T
        made: NDArray[np.complex128] = self.young * (1.0 - (shares / (1.0 + 1j * omega * times)).sum(axis=-1))
        return made


@documented
def relaxation_of_measurement(frequency: ArrayLike, storage: ArrayLike, loss: ArrayLike) -> FittedRelaxation:
    """Fit a Prony series to moduli that dynamic mechanical analysis has measured, by least squares.

    Times are three a decade over the measured frequencies, 20 at most, and shares above 0. Beyond
    these frequencies the material is taken as elastic.

    Parameters:
        frequency: Angular frequencies, rising, rad/s.
        storage: E′, Pa.
        loss: E″ = E′ tan δ, Pa.

    Examples:
        >>> omega = np.geomspace(1, 1e4, 30)
        >>> moduli = 2e6 * (1 - 0.5 / (1 + 1j * omega * 0.01))
        >>> found = stoss.relaxation_of_measurement(omega, moduli.real, moduli.imag)
        >>> round(found.young / 1e6, 3), found.storage_misfit < 0.01
        (2.0, True)
        >>> rubber = stoss.Material(young=found.young, poisson=0.49, density=1100, relaxation=found.relaxation)
    """
    given = [numbers(name, each) for name, each in (("frequency", frequency), ("storage", storage), ("loss", loss))]
    for name, each in zip(("frequency", "storage", "loss"), given):
        if each.ndim != 1 or each.size != given[0].size:
            raise refusal(name, each, "a list of numbers, as many as frequencies")
    terms, young, storage_misfit, loss_misfit = _core.relaxation_of_measurement(*given)
    return FittedRelaxation(
        frequency=given[0], storage=given[1], loss=given[2], young=young, relaxation=relaxation_of(terms) or (),
        storage_misfit=storage_misfit, loss_misfit=loss_misfit,
    )  # fmt: skip


@documented
def shifted(relaxation: Relaxation, c1: float, c2: float, reference: float, temperature: float) -> Relaxation:
    """Shift times to another temperature: lg a = −c₁ (T − T_r)/(c₂ + T − T_r) (Williams, Landel and Ferry).

    Parameters:
        relaxation: Shares and their times at T_r.
        c1, c2: Constants of the law, c₂ in K.
        reference: T_r.
        temperature: T, in the same scale.

    Examples:
        >>> [(share, f"{time:.3g}") for share, time in stoss.shifted([(0.5, 1.0)], 17.4, 51.6, 20, 30)]
        [(0.5, '0.0015')]
    """
    terms = relaxation_of(relaxation)
    if terms is None:
        raise refusal("relaxation", relaxation, "pairs (share, time), as in [(0.5, 1), (0.2, 10)]")
    names = ("c1", "c2", "reference", "temperature")
    constants = (number(*each) for each in zip(names, (c1, c2, reference, temperature)))
    return relaxation_of(_core.shifted(terms, *constants)) or ()
