"""Impacts that follow the wall's force statically, and Rayleigh's estimate of what they lose to vibration."""

from __future__ import annotations

import dataclasses
import warnings
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, broadcast, number, numbers
from stoss._documentation import documented
from stoss._errors import StossWarning
from stoss.bodies._bodies import Disk, Sphere
from stoss.export._tables import span, with_error
from stoss.quasistatic._compression import choose_law, poissons_of
from stoss.results._quantities import Number, RayleighQuantities, SlowImpactQuantities
from stoss.results._result import columns, picture
from stoss.results._si import MayYield, in_c, told_in_c, warn_of_materials


class OfSlowImpacts(MayYield):
    """What slow impacts and their estimates have in common.

    Attributes:
        speed: Speed of the centre of mass towards the wall, c.
        body (Disk, Sphere or None): What it was made with, if it was one.
        max_radius: Maximum radius of the contact of a sphere, R; None of disks.
    """

    _given = {"poisson": "", "speed": "speed"}
    _told: ClassVar[tuple[str, ...]] = ("law", "body")


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SlowImpact(SlowImpactQuantities, OfSlowImpacts):
    """Slow impacts of a disk or a sphere, by conservation of energy: nothing is lost.

    Numbers if all inputs were numbers, otherwise arrays of the shape to which `poisson` and `speed`
    broadcast. Relative errors, as solutions of their equation, are below 1e-14, of spheres 1e-13.
    """

    plot = picture("Contact time against speed. See `stoss.plot.slow_impact`.")
    _name: ClassVar[str] = "slow impact"

    law: str
    poisson: Number
    speed: Number
    body: Disk | Sphere | None

    def __repr__(self) -> str:
        count = "" if isinstance(self.speed, float) else f"{np.size(self.speed)} values, "
        return (
            f"SlowImpact({count}poisson={span(self.poisson)}, speed={span(self.speed)} c: "
            f"contact time {span(self.contact_time)} R/c, compression {span(self.max_compression)} R)"
        )


def slow_inputs(body: Any, speed: Any, poisson: Any, law: Any) -> tuple[str, NDArray[np.float64], NDArray[np.float64]]:
    """The law, and Poisson's ratios and speeds in c of one shape."""
    poissons = poissons_of(body, poisson)
    chosen = choose_law(body, law)
    poissons, speeds = broadcast(3, poisson=poissons, speed=in_c(body, numbers("speed", speed)))
    return chosen, poissons, speeds


@documented
def slow_impact(
    body: Disk | Sphere | None = None, *, speed: ArrayLike, poisson: ArrayLike | None = None, law: str = "center"
) -> SlowImpact:
    """Impacts that are so slow that the body follows the wall's force statically: δ̈ = −F(δ).

    A `StossWarning` says that a sphere of that material yields at such a speed.

    Parameters:
        speed: Speed of the centre of mass towards the wall, 1e-100 (sphere: 1e-12) to `limit_speed`,
            c (with a material: m/s). Two equal bodies that each move at `speed` towards each other
            are the same problem.

    Examples:
        >>> slow = stoss.quasistatic.slow_impact(poisson=0.33, speed=[1e-12, 1e-6, 1e-3])
        >>> slow.contact_time.round(3)
        array([16.968, 12.174,  8.754])
        >>> stoss.quasistatic.slow_impact(stoss.Sphere(poisson=0.3), speed=1e-4)
        SlowImpact(poisson=0.3, speed=0.0001 c: contact time 30.5867 R/c, compression 0.00104057 R)
    """
    chosen, poissons, speeds = slow_inputs(body, speed, poisson, law)
    with told_in_c(body):
        function = _core.point_slow_impact if isinstance(body, Sphere) else _core.slow_impact
        table = function(chosen, poissons.ravel(), speeds.ravel())
    values = {"poisson": poissons, "speed": speeds, **columns(table)}
    shaped: dict[str, Any] = {name: arranged(column, speeds.shape) for name, column in values.items()}
    of_spheres: dict[str, Any] = {"max_radius": None}
    result = SlowImpact(law=chosen, body=body, **of_spheres | shaped)
    warn_of_materials(result, 2)
    return result


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class RayleighEstimate(RayleighQuantities, OfSlowImpacts):
    """What slow impacts lose to vibration, to first order of a perturbation theory.

    Numbers if all inputs were numbers, otherwise arrays of the shape to which `poisson` and `speed`
    broadcast.

    Attributes:
        cutoff: Modes up to this frequency are driven, c/R.
        mean_lost_fraction: The law of v → 0 averaged over the phases of the modes of a sphere,
            c(ν) v; None of disks.
        beyond_perturbation: Whether it is above 0.04: `lost_fraction` is then no estimate, but 1.8
            to 19 times too large.
        mode_energies: For a single speed, a structured array with the fields order, index, omega,
            amplitude (∫F cos(ωt + φ) dt / v, with t from the turning point and the phase φ that a
            mode gains from the stiffness of the contact of a sphere; 0 of a disk) and after (energy
            after the impact, as a share of ½mv²).
    """

    plot = picture("1 − ε² against v. See `stoss.plot.rayleigh`.")
    _name: ClassVar[str] = "rayleigh"
    _told = ("law", "cutoff", "body")

    law: str
    cutoff: float
    poisson: Number
    speed: Number
    mode_energies: NDArray[Any] | None
    body: Disk | Sphere | None

    def __repr__(self) -> str:
        of = f"poisson={span(self.poisson)}, speed={span(self.speed)} c"
        if isinstance(self.lost_fraction, float):
            value = with_error(self.lost_fraction, float(self.lost_fraction_error))
            doubt = ", beyond perturbation theory" if self.beyond_perturbation else ""
            return f"RayleighEstimate({of}: lost fraction {value}{doubt})"
        beyond = np.count_nonzero(self.beyond_perturbation)
        value = f"lost fraction {span(self.lost_fraction)}, {beyond} beyond perturbation theory"
        return f"RayleighEstimate({np.size(self.speed)} values, {of}: {value})"


@documented
def rayleigh(
    body: Disk | Sphere | None = None,
    *,
    speed: ArrayLike,
    poisson: ArrayLike | None = None,
    law: str = "center",
    cutoff: float = 60.0,
) -> RayleighEstimate:
    """Rayleigh's estimate of the energy that slow impacts leave in vibration, with its error.

    The force F(t) of a `slow_impact` drives every mode at the point of contact, Q̈ + ω²Q = −C F/m,
    which leaves it the share C² (∫F cos ωt dt / v)² of the energy. The stiffness of a sphere's
    contact also turns the phases of its modes. For a value that is as exact as you ask use
    `stoss.restitution`. A `StossWarning` tells of values beyond perturbation theory, of a disk at
    ν = 0.33 from v = 0.024 c on, of a sphere at ν = 0.3 from 0.039 c on, and of yielding.

    Parameters:
        speed: Speed of the centre of mass towards the wall, 1e-100 (sphere: 1e-12) to `limit_speed`,
            c (with a material: m/s). Two equal bodies that each move at `speed` towards each other
            are the same problem.
        cutoff: Highest frequency of the modes, up to 1000, c/R.

    Examples:
        >>> stoss.quasistatic.rayleigh(poisson=0.33, speed=1e-6)
        RayleighEstimate(poisson=0.33, speed=1e-06 c: lost fraction 0.0061 ± 0.0039)
        >>> stoss.quasistatic.rayleigh(stoss.Sphere(poisson=0.3), speed=1e-6)
        RayleighEstimate(poisson=0.3, speed=1e-06 c: lost fraction 0.000000337 ± 0.000000011)
    """
    chosen, poissons, speeds = slow_inputs(body, speed, poisson, law)
    highest = number("cutoff", cutoff)
    function, row = _core.rayleigh, _core.rayleigh_row
    if isinstance(body, Sphere):
        function, row = _core.point_rayleigh, _core.point_rayleigh_row
    table, energies = np.zeros(speeds.size, dtype=row), None
    with told_in_c(body):
        for nu in np.unique(poissons):
            where = np.flatnonzero(poissons == nu)
            table[where], energies = function(chosen, float(nu), speeds.ravel()[where], highest)
    values = {"poisson": poissons, "speed": speeds, **columns(table)}
    shaped = {name: arranged(column, speeds.shape) for name, column in values.items()}
    if beyond := np.count_nonzero(table["beyond_perturbation"]):
        text = f"{beyond} of {speeds.size} values beyond perturbation theory: their lost_fraction is far too great"
        warnings.warn(text, StossWarning, stacklevel=2)
    shaped |= {"law": chosen, "cutoff": highest, "mode_energies": energies if speeds.ndim == 0 else None}
    of_spheres: dict[str, Any] = {"mean_lost_fraction": None, "max_radius": None}
    result = RayleighEstimate(body=body, **of_spheres | shaped)
    warn_of_materials(result, 2)
    return result
