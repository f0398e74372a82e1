"""Rayleigh's estimate of what a slow impact loses to vibration."""

from __future__ import annotations

import dataclasses
import warnings
from typing import Any, ClassVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, number
from stoss._bodies import Disk, speeds_in_si
from stoss._errors import StossWarning
from stoss._result import Number, columns, span, with_error
from stoss._si import InSi
from stoss._slow_impact import slow_inputs


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class RayleighEstimate(InSi):
    """What slow impacts lose to vibration, to first order of a perturbation theory.

    Numbers if all inputs were numbers, otherwise arrays of the shape to which `poisson` and `speed`
    broadcast.

    Attributes
    ----------
    law : str
        Of compression.
    cutoff : float
        Modes up to this frequency are driven, c/R.
    poisson, speed, contact_time, max_compression, max_force : float or ndarray
        Of the impact that drives the modes, as in `SlowImpact`.
    lost_fraction : float or ndarray
        1 − ε². May exceed 1 where it means nothing.
    lost_fraction_error : float or ndarray
        By how much the full solution may differ from it, from `kinetic_share`.
    kinetic_share : float or ndarray
        Greatest kinetic energy of the modes as they follow the force, as a share of ½mv²: the
        theory's small number.
    beyond_perturbation : bool or ndarray
        Whether it is above 0.04: `lost_fraction` is then no estimate, but 1.8 to 19 times too
        great.
    modes : int or ndarray
        Number of modes.
    mode_energies : ndarray or None
        For a single speed, a structured array with the fields order, index, omega, amplitude (∫F
        cos ωt dt / v, with t from the turning point) and after (energy after the impact, as a share
        of ½mv²).
    body : Disk or None
        What it was made with, if it was one.
    material : Material or None
        Of the body. If there is one, `speed_si`, `contact_time_si`, `max_force_si` and
        `max_compression_si` are the SI values.
    """

    _name: ClassVar[str] = "rayleigh"
    _kind = "rayleigh"
    _given = {"poisson": "", "speed": "speed"}

    law: str
    cutoff: float
    poisson: Number
    speed: Number
    lost_fraction: Number
    lost_fraction_error: Number
    contact_time: Number
    max_compression: Number
    max_force: Number
    kinetic_share: Number
    beyond_perturbation: Union[bool, NDArray[np.bool_]]
    modes: Union[int, NDArray[np.int64]]
    mode_energies: NDArray[Any] | None
    body: Disk | None

    def __repr__(self) -> str:
        of = f"poisson={span(self.poisson)}, speed={span(self.speed)} c"
        if isinstance(self.lost_fraction, float):
            value = with_error(self.lost_fraction, float(self.lost_fraction_error))
            doubt = ", beyond perturbation theory" if self.beyond_perturbation else ""
            return f"RayleighEstimate({of}: lost fraction {value}{doubt})"
        beyond = np.count_nonzero(self.beyond_perturbation)
        value = f"lost fraction {span(self.lost_fraction)}, {beyond} beyond perturbation theory"
        return f"RayleighEstimate({np.size(self.speed)} values, {of}: {value})"

    def plot(self, ax: Any = None) -> Any:
        """1 − ε² against v. See `stoss.plot.rayleigh`."""
        return self._picture(ax)

    def _inputs(self) -> dict[str, Any]:
        return {"law": self.law, "cutoff": self.cutoff} | ({"body": self.body} if self.body else {})


def rayleigh(
    body: Disk | None = None,
    *,
    speed: ArrayLike,
    poisson: ArrayLike | None = None,
    law: str = "center",
    cutoff: float = 60.0,
) -> RayleighEstimate:
    """Rayleigh's estimate of the energy that slow impacts leave in vibration, with its error.

    The force F(t) of a `slow_impact` drives every mode at the point of contact, Q̈ + ω²Q = −C F/m,
    which leaves it the share C² (∫F cos ωt dt / v)² of the energy. For a value that is as exact as
    you ask use `stoss.restitution`.

    Parameters
    ----------
    body : Disk
    speed : array_like
        Of the centre of mass towards the wall, 1e-100 to `limit_speed`, c (with a material: m/s).
        Two equal disks that each move at `speed` towards each other are the same problem.
    poisson : array_like
        In place of `body`: 2-D Poisson number, −0.95 to 0.995; broadcasts with `speed`.
    law : {'center', 'diameter', 'printed'}, optional
        Of compression, see `stoss.quasistatic`.
    cutoff : float, optional
        Highest frequency of the modes, up to 1000, c/R.

    Returns
    -------
    RayleighEstimate

    Raises
    ------
    InvalidInput
        For arguments out of range.

    Warns
    -----
    StossWarning
        If there are values beyond perturbation theory; at ν = 0.33 from v = 0.024 c on.

    Examples
    --------
    >>> stoss.quasistatic.rayleigh(poisson=0.33, speed=1e-6)
    RayleighEstimate(poisson=0.33, speed=1e-06 c: lost fraction 0.0061 ± 0.0039)
    """
    chosen, poissons, speeds = slow_inputs(body, speed, poisson, law)
    highest = number("cutoff", cutoff)
    table = np.zeros(speeds.size, dtype=_core.rayleigh_row)
    energies: NDArray[Any] | None = None
    with speeds_in_si(body):
        for nu in np.unique(poissons):
            where = np.flatnonzero(poissons == nu)
            table[where], energies = _core.rayleigh(chosen, float(nu), speeds.ravel()[where], highest)
    values = {"poisson": poissons, "speed": speeds, **columns(table)}
    shaped = {name: arranged(column, speeds.shape) for name, column in values.items()}
    beyond = np.count_nonzero(table["beyond_perturbation"])
    if beyond:
        text = f"{beyond} of {speeds.size} values beyond perturbation theory: their lost_fraction is far too great"
        warnings.warn(text, StossWarning, stacklevel=2)
    energies = energies if speeds.ndim == 0 else None
    return RayleighEstimate(law=chosen, cutoff=highest, body=body, mode_energies=energies, **shaped)
