"""Rayleigh's estimate of what a slow impact loses to vibration."""

from __future__ import annotations

import warnings
from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, number
from stoss.bodies._bodies import Disk, Sphere, speeds_in_si
from stoss._errors import StossWarning
from stoss.quasistatic._estimates import PointRayleighEstimate, RayleighEstimate
from stoss.results._result import columns
from stoss.results._si import warn_of_yielding
from stoss.quasistatic._slow import slow_inputs


@overload
def rayleigh(
    body: Sphere, *, speed: ArrayLike, poisson: None = None, law: str = "center", cutoff: float = 60.0
) -> PointRayleighEstimate: ...


@overload
def rayleigh(
    body: Disk | None = None,
    *,
    speed: ArrayLike,
    poisson: ArrayLike | None = None,
    law: str = "center",
    cutoff: float = 60.0,
) -> RayleighEstimate: ...


def rayleigh(
    body: Disk | Sphere | None = None,
    *,
    speed: ArrayLike,
    poisson: ArrayLike | None = None,
    law: str = "center",
    cutoff: float = 60.0,
) -> RayleighEstimate | PointRayleighEstimate:
    """Rayleigh's estimate of the energy that slow impacts leave in vibration, with its error.

    The force F(t) of a `slow_impact` drives every mode at the point of contact, Q̈ + ω²Q = −C F/m,
    which leaves it the share C² (∫F cos ωt dt / v)² of the energy. The stiffness of a sphere's
    contact turns the phases of its modes besides. For a value that is as exact as you ask use
    `stoss.restitution`.

    Parameters
    ----------
    body : Disk or Sphere
    speed : array_like
        Of the centre of mass towards the wall, 1e-100 (of a sphere 1e-12) to `limit_speed`, c (with
        a material: m/s). Two equal bodies that each move at `speed` towards each other are the same
        problem.
    poisson : array_like
        In place of `body`: 2-D Poisson's ratio of disks, −0.95 to 0.995; broadcasts with `speed`.
    law : {'center', 'diameter', 'printed', 'hertz'}, optional
        Of compression, see `stoss.quasistatic`.
    cutoff : float, optional
        Highest frequency of the modes, up to 1000, c/R.

    Returns
    -------
    RayleighEstimate, or of a sphere PointRayleighEstimate

    Raises
    ------
    InvalidInput
        For arguments out of range.

    Warns
    -----
    StossWarning
        If there are values beyond perturbation theory, of a disk at ν = 0.33 from v = 0.024 c on,
        of a sphere at ν = 0.3 from 0.039 c on; or beyond the speed at which a sphere begins to
        yield.

    Examples
    --------
    >>> stoss.quasistatic.rayleigh(poisson=0.33, speed=1e-6)
    RayleighEstimate(poisson=0.33, speed=1e-06 c: lost fraction 0.0061 ± 0.0039)
    >>> stoss.quasistatic.rayleigh(stoss.Sphere(poisson=0.3), speed=1e-6)
    PointRayleighEstimate(poisson=0.3, speed=1e-06 c: lost fraction 0.000000337 ± 0.000000011)
    """
    chosen, poissons, speeds = slow_inputs(body, speed, poisson, law)
    highest = number("cutoff", cutoff)
    energies: NDArray[Any] | None = None
    with speeds_in_si(body):
        if isinstance(body, Sphere):
            table, energies = _core.point_rayleigh(chosen, body.poisson, speeds.ravel(), highest)
        else:
            table = np.zeros(speeds.size, dtype=_core.rayleigh_row)
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
    if isinstance(body, Sphere):
        result = PointRayleighEstimate(law=chosen, cutoff=highest, body=body, mode_energies=energies, **shaped)
        warn_of_yielding(result, 2)
        return result
    return RayleighEstimate(law=chosen, cutoff=highest, body=body, mode_energies=energies, **shaped)
