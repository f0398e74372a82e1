"""Materials in SI: the only place where a user's units meet the core's."""

from __future__ import annotations

import dataclasses
import math
from types import MappingProxyType
from typing import Any, Mapping, NamedTuple

from stoss import _core
from stoss._arguments import brief, number, optional_number, refusal


class Scales(NamedTuple):
    """SI values of the units of all results: multiply a result by its scale.

    Attributes:
        length (float): Radius R, or length L of a rod, m.
        speed (float): Bar speed c, m/s.
        time (float): R/c, s.
        frequency (float): c/R, rad/s.
        force (float): mc²/R: πRE of a disk of unit thickness, N/m; (4π/3)R²E of a sphere or EA of a
            rod, N.
    """

    length: float
    speed: float
    time: float
    frequency: float
    force: float


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class Material:
    """An isotropic elastic material of bodies, in SI.

    Bodies made of it meet at speeds in m/s, and results also have SI values, under names that end
    in ``_si``.

    Parameters:
        young (float): Young's modulus E, Pa.
        poisson (float): Poisson's ratio ν of the solid, −1 < ν < ½.
        density (float): Density ρ, kg/m³.
        yield_strength (float, optional): Yield strength in simple tension, Pa, 1e-30 to 1e30. A
            sphere begins to yield where the contact pressure is 1.6 times that: its results say at
            which speed (`yield_speed`), and which of them are beyond it. They are elastic all the
            same.
        loss_time (float, optional): Loss time η, s: stress = (1 + η ∂/∂t) elastic stress. Bodies
            made of it have this loss time unless they get their own, such as ``loss_time=0``. A
            rigid body loses nothing.
        surface_energy (float, optional): Surface energy γ, J/m², 0 to 1e6. Two surfaces stick with
            the work of adhesion 2√(γ₁γ₂), which only `stoss.predict` uses.
        quality (tuple of float, optional): In place of `loss_time`, (Q, ω) with the quality Q at
            the angular frequency ω in rad/s, π over the contact time for an impact: η = 1/(Qω).
            With the same η a slower impact, of lower frequency, has a higher quality. A ball whose
            Q is the same at all frequencies loses 2.41/Q of its energy and not the 3.54/Q of this η:
            with ω = 4.62 over the contact time the loss is that of such a Q.

    Examples:
        >>> steel = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
        >>> disk = stoss.Disk(radius=0.01, material=steel)
        >>> round(disk.scales.speed)
        5172
        >>> stoss.restitution(disk, speed=5.0)  # 5 m/s
        Restitution(poisson=0.3, speed=0.000966708 c: restitution 0.9871212 ± 0.0000090)
    """

    young: float
    poisson: float
    density: float
    yield_strength: float | None = None
    loss_time: float | None = None
    surface_energy: float | None = None
    quality: dataclasses.InitVar[tuple[float, float] | None] = None

    def __post_init__(self, quality: Any) -> None:
        for name in ("young", "poisson", "density"):
            object.__setattr__(self, name, number(name, getattr(self, name)))
        self._constants()  # refuses what is out of range
        strength = optional_number("yield_strength", self.yield_strength)
        if strength is not None and not 1e-30 <= strength <= 1e30:
            raise refusal("yield_strength", strength, "above 0, 1e-30 to 1e30 (in Pa; steel has 2e8 to 2e9)")
        object.__setattr__(self, "yield_strength", strength)
        energy = optional_number("surface_energy", self.surface_energy)
        if energy is not None and not 0.0 <= energy <= 1e6:
            raise refusal("surface_energy", energy, "0 to 1e6 (in J/m^2; glass has 0.02 to 0.3)")
        object.__setattr__(self, "surface_energy", energy)
        object.__setattr__(self, "loss_time", self._chosen_loss_time(quality))

    def __repr__(self) -> str:
        given = {name: value for name, value in vars(self).items() if value is not None}
        return f"Material({', '.join(f'{name}={brief(value)}' for name, value in given.items())})"

    def _chosen_loss_time(self, quality: Any) -> float | None:
        loss_time = optional_number("loss_time", self.loss_time)
        if quality is not None:
            if loss_time is not None:
                raise refusal("quality", quality, "none with loss_time")
            if not isinstance(quality, (tuple, list)) or len(quality) != 2:
                raise refusal("quality", quality, "(Q, ω), a quality and its frequency in rad/s")
            return _core.loss_time_of_quality(number("quality", quality[0]), number("frequency", quality[1]))
        if loss_time is not None and not 0.0 <= loss_time < math.inf:
            raise refusal("loss_time", loss_time, "0 or more, in s")
        return loss_time

    def _constants(self, plane: Any = None) -> dict[str, float]:
        """Those of a solid, or of a disk: ν, E, ρ of a thin plate; ν/(1−ν), E/(1−ν²), ρ in plane strain."""
        if plane is not None and (not isinstance(plane, str) or plane not in ("stress", "strain")):
            raise refusal("plane", plane, "'stress' or 'strain'")
        modulus = self.young / (1.0 - self.poisson**2) if plane == "strain" else self.young
        poisson = _core.plane_poisson(self.young, self.poisson, self.density, plane == "strain")
        return {"poisson": poisson, "young": modulus, "density": self.density}


class _Materials(dict[str, Material]):
    """Those of the core, which says which there are."""

    def __missing__(self, name: Any) -> Material:
        _core.require_material(str(name))
        raise KeyError(name)


materials: Mapping[str, Material] = MappingProxyType(
    _Materials(
        (
            name,
            Material(
                young=young, poisson=poisson, density=density, yield_strength=strength, loss_time=loss_time,
                surface_energy=energy,
            ),
        )  # fmt: skip
        for name, young, poisson, density, strength, loss_time, energy in _core.named_materials()
    )
)
"""Typical materials, those of the command: ``stoss materials`` lists them with their sources.

Yours differs, rubber and rock by factors: measure it. What has no `yield_strength` here is brittle, or not known well
enough; structural steel has 0.235 GPa and more. Loss times are those of a quality at 10 kHz, that of rubber at 500 Hz:
contacts of 50 µs and 1 ms. They are orders of magnitude, and so are surface energies, which are those of smooth
surfaces. How well each constant is known is in `stoss.predict`, which knows these materials again. What ε means for each of them: docs/reference/materials.md.
"""

NAMES: Mapping[Material, str] = MappingProxyType({material: name for name, material in materials.items()})
"""What a material of these constants is called."""
