"""Materials and sizes in SI: the only place where a user's units meet the core's."""

from __future__ import annotations

import contextlib
import dataclasses
from typing import Iterator, NamedTuple

from stoss import _core
from stoss._arguments import number, refusal
from stoss._errors import InvalidInput


class Scales(NamedTuple):
    """SI values of the units of all results: multiply a result by its scale.

    Attributes
    ----------
    length : float
        Radius R, m.
    speed : float
        Bar speed c, m/s.
    time : float
        R/c, s.
    frequency : float
        c/R, rad/s.
    force : float
        πRE = mc²/R of a disk of unit thickness, N/m.
    """

    length: float
    speed: float
    time: float
    frequency: float
    force: float


@dataclasses.dataclass(frozen=True, kw_only=True)
class Material:
    """An isotropic elastic material and the radius of the disk made of it, in SI.

    In results made with it speeds are given in m/s, and SI values stand beside the dimensionless
    ones under names that end in ``_si``. The bar speed is c = √(E/ρ), or √(E/((1−ν²)ρ)) in plane
    strain.

    Parameters
    ----------
    young : float
        Young's modulus E, Pa.
    poisson : float
        Poisson number ν of the solid, −1 < ν < ½.
    density : float
        Density ρ, kg/m³.
    radius : float
        Radius R of the disk, m.
    plane : {'stress', 'strain'}
        A thin plate, or a slice of a long cylinder.

    Raises
    ------
    InvalidInput
        Unless all constants are positive and ν in its range.

    Examples
    --------
    >>> steel = stoss.Material(young=2.1e11, poisson=0.3, density=7850, radius=0.01)
    >>> round(steel.scales.speed)
    5172
    >>> stoss.restitution(material=steel, speed=5.0)  # 5 m/s
    Restitution(poisson=0.3, speed=0.000966708 c: restitution 0.987119 ± 0.000011)
    """

    young: float
    poisson: float
    density: float
    radius: float
    plane: str = "stress"

    def __post_init__(self) -> None:
        for name in ("young", "poisson", "density", "radius"):
            object.__setattr__(self, name, number(name, getattr(self, name)))
        if not isinstance(self.plane, str) or self.plane not in ("stress", "strain"):
            raise refusal("plane", self.plane, "'stress' or 'strain'")
        _ = self.scales, self.plane_poisson

    @property
    def scales(self) -> Scales:
        """SI values of the units of all results."""
        strain = self.plane == "strain"
        return Scales(*_core.scales(self.young, self.poisson, self.density, strain, self.radius))

    @property
    def plane_poisson(self) -> float:
        """2-D Poisson number that the core computes with: ν, or ν/(1−ν) in plane strain."""
        return _core.plane_poisson(self.young, self.poisson, self.density, self.plane == "strain")


@contextlib.contextmanager
def speeds_in_si(material: Material | None) -> Iterator[None]:
    """Says to a user who thinks in m/s what the core's refusal of a speed means."""
    try:
        yield
    except InvalidInput as error:
        if material is None or not str(error).startswith("speed"):
            raise
        raise InvalidInput(f"{error}; with this material c is {material.scales.speed:.6g} m/s") from None
