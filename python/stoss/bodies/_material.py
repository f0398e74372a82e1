"""Materials in SI: the only place where a user's units meet the core's."""

from __future__ import annotations

import dataclasses
import json
import math
from types import MappingProxyType
from typing import Any, Mapping, NamedTuple, Sequence

import numpy as np

from stoss import _core
from stoss._arguments import brief, choice, number, numbers, optional_number, refusal
from stoss._errors import InvalidInput


Relaxation = Sequence[Sequence[float]]
"""Shares of the modulus E(0) that relax, and their times."""


def relaxation_of(given: Any) -> tuple[tuple[float, float], ...] | None:
    """The terms that were given, as pairs of numbers."""
    if given is None:
        return None
    terms = numbers("relaxation", given)
    if terms.size == 0:
        return ()
    if terms.ndim != 2 or terms.shape[1] != 2 or not np.isfinite(terms).all():
        raise refusal("relaxation", given, "pairs (share, time), as in [(0.5, 1), (0.2, 10)]")
    return tuple((float(share), float(time)) for share, time in terms)


def young_of(words: dict[str, Any]) -> float | None:
    """E(0) of the material of a body; refuses ways of losing energy that are out of range or do not go together."""
    for name in ("quality", "frequency"):
        its = words.get(name, words.get("material", {}).get(name, 0.0))
        if not math.isfinite(its):
            raise refusal(name, its, "a finite number")
    try:
        return _core.check_losses(json.dumps({"kind": "sphere", **words}))
    except InvalidInput as error:
        raise error.renamed(error.name.removeprefix("body ").removeprefix("material ")) from None


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

    @property
    def momentum(self) -> float:
        """Force times time, N s."""
        return self.force * self.time


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
        relaxation (sequence of (float, float), optional): In place of `loss_time`, a Prony series: shares
            of the modulus E(0) that relax, and their times in s, 20 at most. `young` is E(0).
        young_is ({'instantaneous', 'relaxed'}): With `relaxation`: whether `young` that is given is E(0) or
            E∞, what is left of it after all relaxation. The attribute is E(0).
        quality (float or tuple of float, optional): In place of both, the quality Q, 3 to 1e9, the same at
            all frequencies; or (Q, ω) with the angular frequency ω in rad/s at which `young` is the
            modulus.
        frequency (float, optional): ω; of 10 kHz without it.

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
    relaxation: Relaxation | None = None
    quality: float | None = None
    frequency: float | None = None
    young_is: dataclasses.InitVar[str] = "instantaneous"

    def __post_init__(self, young_is: Any) -> None:
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
        loss_time = optional_number("loss_time", self.loss_time)
        if loss_time is not None and not 0.0 <= loss_time < math.inf:
            raise refusal("loss_time", loss_time, "0 or more, in s")
        object.__setattr__(self, "loss_time", loss_time)
        self._set_relaxation(choice("young_is", young_is, ("instantaneous", "relaxed")))

    @classmethod
    def of_wave_speeds(cls, c_p: float, c_s: float, density: float, **its: Any) -> Material:
        """Make a material of the speeds of its waves, as ultrasound measures them.

        E = ρc_s²(3c_p² − 4c_s²)/(c_p² − c_s²), ν = (c_p² − 2c_s²)/2(c_p² − c_s²).

        Parameters:
            c_p (float): Speed of longitudinal waves, m/s, above √(4/3) c_s.
            c_s (float): Speed of transverse waves, m/s.
            density (float): ρ, kg/m³.
            **its: All else, as of `Material`.

        Examples:
            >>> steel = stoss.Material.of_wave_speeds(5900, 3200, 7850)
            >>> f"{steel.young:.3g}", round(steel.poisson, 3)
            ('2.08e+11', 0.292)
        """
        young, poisson = _core.material_of_wave_speeds(number("c_p", c_p), number("c_s", c_s), number("density", density))
        return cls(young=young, poisson=poisson, density=density, **its)

    @classmethod
    def of_rigid(cls, density: float) -> Material:
        """Make a material for a rigid body. Only its density counts, as its modulus cancels.

        Parameters:
            density (float): ρ, kg/m³.

        Examples:
            >>> bullet = stoss.Sphere(radius=0.005, rigid=True, material=stoss.Material.of_rigid(7800))
            >>> mat = stoss.HalfSpace(material=stoss.materials["rubber"])
            >>> stoss.restitution(bullet, against=mat, speed=1.0).restitution
            0.7973...
        """
        units = _core.units_of_rigid()
        return cls(young=units["young"], poisson=units["poisson"], density=density)

    def __repr__(self) -> str:
        return f"Material({', '.join(f'{name}={brief(value)}' for name, value in self._words().items())})"

    def _set_relaxation(self, young_is: str) -> None:
        """Set what relaxes, as the core reads it."""
        quality = self.quality
        if isinstance(quality, (tuple, list)):
            if len(quality) != 2:
                raise refusal("quality", quality, "Q, or (Q, ω) with its frequency in rad/s")
            object.__setattr__(self, "frequency", quality[1])
            quality = quality[0]
        object.__setattr__(self, "relaxation", relaxation_of(self.relaxation))
        object.__setattr__(self, "quality", optional_number("quality", quality))
        object.__setattr__(self, "frequency", optional_number("frequency", self.frequency))
        if self.quality == 0.0:
            raise refusal("quality", self.quality, "3 to 1e9, or None")
        if self.relaxation is None and self.quality is None and self.frequency is None and young_is == "instantaneous":
            return
        words = {"young_is": young_is} if young_is == "relaxed" else {}
        object.__setattr__(self, "young", young_of({"material": {**self._words(), **words}, "radius": 1.0}))

    def _words(self) -> dict[str, Any]:
        """All that was given, in plain types."""
        return {name: value for name, value in vars(self).items() if value is not None}

    def _constants(self, plane: Any = None) -> dict[str, float]:
        """Those of a solid, or of a disk: ν, E, ρ of a thin plate; ν/(1−ν), E/(1−ν²), ρ in plane strain."""
        if plane is not None and (not isinstance(plane, str) or plane not in ("stress", "strain")):
            raise refusal("plane", plane, "'stress' or 'strain'")
        modulus = self.young / (1.0 - self.poisson**2) if plane == "strain" else self.young
        poisson = _core.plane_poisson(self.young, self.poisson, self.density, plane == "strain")
        return {"poisson": poisson, "young": modulus, "density": self.density}


class _Materials(dict[str, Material]):
    """Those of the core, which says which there are; names in upper or lower case."""

    def __missing__(self, name: Any) -> Material:
        return self[_core.material_of_the_list(str(name))]


materials: Mapping[str, Material] = MappingProxyType(
    _Materials(
        (
            name,
            Material(
                young=young, poisson=poisson, density=density, yield_strength=strength, surface_energy=energy,
                quality=quality, frequency=frequency if quality else None, relaxation=terms,
            ),
        )  # fmt: skip
        for name, young, poisson, density, strength, energy, quality, frequency, terms in _core.named_materials()
    )
)
"""Typical materials, those of the command: ``stoss materials`` lists them with their sources.

Yours differs, rubber and rock by factors: measure it. What has no `yield_strength` here is brittle, or not known well
enough; structural steel has 0.235 GPa and more. Each has one `quality` at all frequencies or a `relaxation`, if its loss
is known: an order of magnitude. So are surface energies, which are those of smooth surfaces. How well each constant is known is in `stoss.predict`, which knows these materials again. What ε means for each of them: docs/reference/materials.md.
"""

NAMES: Mapping[Material, str] = MappingProxyType({material: name for name, material in materials.items()})
"""What a material of these constants is called."""
