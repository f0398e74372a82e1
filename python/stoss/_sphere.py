"""Spheres."""

from __future__ import annotations

import dataclasses

from stoss import _core
from stoss._arguments import boolean
from stoss._body_values import call, fill, fill_loss_time, known_material, own_loss_time, size
from stoss._material import Material, Scales


@dataclasses.dataclass(frozen=True, init=False, repr=False)
class Sphere:
    """An elastic sphere: its Poisson's ratio, and its size and material relative to other bodies.

    Without a material all sizes are ratios in any consistent units; at a rigid wall only `poisson`
    counts. With a material, the radius and all speeds are in SI. Spheres meet walls and each other
    centrally and without friction. Units are the radius R, the bar speed c = √(E/ρ) and the mass;
    forces are in mc²/R = (4π/3)R²E.

    Parameters
    ----------
    poisson : float
        Poisson's ratio ν, −0.95 to 0.4999.
    radius : float
        Radius R; 1, or with a material to be given in m.
    young, density : float, optional
        Young's modulus E and density ρ.
    loss_time : float, optional
        Loss time η of a Kelvin–Voigt material, stress = (1 + η ∂/∂t) elastic stress; 0, or
        that of the material. In the unit of time that the others imply, R/c of the first body; with
        a material in s.
    material : Material
        In place of `poisson`, `young` and `density`.
    rigid : bool, optional
        Young's modulus is infinite. The sphere keeps its mass, and the given modulus remains a
        unit. It meets elastic bodies: spheres and half-spaces.

    Examples
    --------
    >>> stoss.impact(stoss.Sphere(poisson=0.3), speed=0.1, cutoff=25).contacts
    1
    >>> ball = stoss.Sphere(radius=5e-3, material=stoss.materials["steel"])
    >>> round(ball.scales.speed), round(ball.scales.time * 1e6, 3)
    (5172, 0.967)
    >>> lossy = stoss.restitution(stoss.Sphere(poisson=0.3, loss_time=0.3), speed=0.01)
    >>> round(lossy.restitution, 3), round(lossy.dissipated, 3)
    (0.866, 0.25)
    """

    poisson: float
    radius: float
    young: float
    density: float
    loss_time: float
    material: Material | None
    rigid: bool

    def __init__(
        self,
        *,
        poisson: float | None = None,
        radius: float | None = None,
        young: float | None = None,
        density: float | None = None,
        loss_time: float | None = None,
        material: Material | None = None,
        rigid: bool = False,
    ) -> None:
        made: dict[str, float] = {"young": 1.0, "density": 1.0}
        if material is not None:
            size("radius", radius, material)
            made = {"poisson": material.poisson, "young": material.young, "density": material.density}
        fill(self, made, material, poisson=poisson, young=young, density=density)
        fill(self, {"radius": 1.0}, None, radius=radius)
        object.__setattr__(self, "material", material)
        object.__setattr__(self, "rigid", boolean("rigid", rigid))
        fill_loss_time(self, loss_time, material, self.rigid)
        self._maker()  # refuses what is out of range

    def __repr__(self) -> str:
        ratios = ("poisson", "radius", "young", "density", "loss_time", "rigid")
        return call(self, ratios, ("radius", "loss_time", "material", "rigid"))

    @property
    def scales(self) -> Scales:
        """SI values of the units of all results of which this is the first body."""
        known_material(self)
        return Scales(*_core.sphere_scales(self.poisson, self.radius, self.young, self.density))

    def _maker(self) -> _core.BodyMaker:
        elastic = _core.sphere(self.poisson, self.radius, self.young, self.density, self.loss_time)
        return _core.rigid(elastic) if self.rigid else elastic

    def _shape(self) -> Sphere:
        """What counts at a wall: the same for all sizes."""
        return Sphere(poisson=self.poisson, loss_time=own_loss_time(self, self.radius))
