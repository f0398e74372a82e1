"""Half-spaces and half-planes."""

from __future__ import annotations

import dataclasses
from typing import Any, TypeVar, Union

from stoss import _core
from stoss._arguments import number, refusal
from stoss._body_values import call, fill, fill_loss_time
from stoss._material import Material

Kind = TypeVar("Kind", bound="_Unbounded")


class _Unbounded:
    """What a half-space and a half-plane have in common: no size, and a Poisson's ratio that may be
    the first's."""

    poisson: float | None
    young: float
    density: float
    loss_time: float
    material: Material | None

    def _fill(self, made: dict[str, float], material: Any, loss_time: Any, **given: Any) -> None:
        usual = {"young": 1.0, "density": 1.0} | made
        poisson = given.pop("poisson")
        fill(self, usual, material, **given)
        fill_loss_time(self, loss_time, material)
        if material is None:
            object.__setattr__(self, "poisson", None if poisson is None else number("poisson", poisson))
        else:
            fill(self, usual, material, poisson=poisson)
        object.__setattr__(self, "material", material)
        made_one: Any = self._beside(0.0)
        made_one._maker()  # refuses what is out of range

    def _beside(self: Kind, poisson: float) -> Kind:
        """The same, with the Poisson's ratio of the first body where it has none."""
        if self.poisson is not None:
            return self
        of_its_kind: Any = type(self)
        made: Kind = of_its_kind(poisson=poisson, young=self.young, density=self.density, loss_time=self.loss_time)
        return made


@dataclasses.dataclass(frozen=True, init=False, repr=False)
class HalfSpace(_Unbounded):
    """An elastic half-space, which spheres meet: a block so large that no wave comes back in time.

    Waves carry energy away in it: see `Impact.lost_to_second`. The block is thick enough
    if a wave to its other side and back takes longer than the contact. Without a material its
    numbers are ratios to those of the sphere, or in the same units.

    Parameters
    ----------
    poisson : float, optional
        Poisson's ratio ν, −0.95 to 0.4999; default: that of the sphere.
    young, density : float, optional
        Young's modulus E and density ρ, 1e-3 to 1e6 of those of the sphere; default 1.
    loss_time : float, optional
        Loss time η of a Kelvin–Voigt material, stress = (1 + η ∂/∂t) elastic stress; 0, or
        that of the material. In R/c of the sphere; with a material in s. Its loss is in
        `lost_to_second` and in `dissipated`.
    material : Material
        In place of `poisson`, `young` and `density`, for a sphere that has one.

    Examples
    --------
    >>> stoss.restitution(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.01)
    Restitution(Sphere(poisson=0.3) against HalfSpace(poisson=0.3), speed=0.01 c: restitution 0.9598516 ± 0.0000044)
    >>> steel, glass = stoss.materials["steel"], stoss.materials["glass"]
    >>> ball = stoss.Sphere(radius=5e-3, material=steel)
    >>> drop = stoss.restitution(ball, against=stoss.HalfSpace(material=glass), speed=1)
    >>> round(drop.restitution, 3), round(drop.dissipated, 4), f"{drop.contact_time_si:.2g} s"
    (0.994, 0.0033, '4.6e-05 s')
    """

    poisson: float | None
    young: float
    density: float
    loss_time: float
    material: Material | None

    def __init__(
        self,
        *,
        poisson: float | None = None,
        young: float | None = None,
        density: float | None = None,
        loss_time: float | None = None,
        material: Material | None = None,
    ) -> None:
        made: dict[str, float] = {}
        if material is not None:
            material = _checked(material)
            made = {"poisson": material.poisson, "young": material.young, "density": material.density}
        self._fill(made, material, loss_time, poisson=poisson, young=young, density=density)

    def __repr__(self) -> str:
        return call(self, ("poisson", "young", "density", "loss_time"), ("loss_time", "material"))

    def _maker(self) -> _core.BodyMaker:
        assert self.poisson is not None
        return _core.half_space(self.poisson, self.young, self.density, self.loss_time)


@dataclasses.dataclass(frozen=True, init=False, repr=False)
class HalfPlane(_Unbounded):
    """An elastic half-plane, which disks meet: a half-space in two dimensions.

    Parameters
    ----------
    poisson : float, optional
        2-D Poisson's ratio ν, −0.95 to 0.995; default: that of the disk.
    young, density : float, optional
        2-D Young's modulus E and density ρ, 1e-3 to 1e6 of those of the disk; default 1.
    loss_time : float, optional
        Loss time η, as of a half-space.
    material : Material
        In place of `poisson`, `young` and `density`, for a disk that has one.
    plane : {'stress', 'strain'}
        With a material: that of the disk.

    Examples
    --------
    >>> stoss.restitution(poisson=0.33, against=stoss.HalfPlane(), speed=0.1)
    Restitution(Disk(poisson=0.33) against HalfPlane(poisson=0.33), speed=0.1 c: restitution 0.56990 ± 0.00032)
    """

    poisson: float | None
    young: float
    density: float
    loss_time: float
    material: Material | None
    plane: str | None

    def __init__(
        self,
        *,
        poisson: float | None = None,
        young: float | None = None,
        density: float | None = None,
        loss_time: float | None = None,
        material: Material | None = None,
        plane: str | None = None,
    ) -> None:
        made: dict[str, float] = {}
        if material is None:
            if plane is not None:
                raise refusal("plane", plane, "none without a material (`poisson` is the 2-D Poisson's ratio)")
        else:
            made = _checked(material)._in_plane("stress" if plane is None else plane)
            plane = "stress" if plane is None else plane
        object.__setattr__(self, "plane", plane)
        self._fill(made, material, loss_time, poisson=poisson, young=young, density=density)

    def __repr__(self) -> str:
        return call(self, ("poisson", "young", "density", "loss_time"), ("loss_time", "material", "plane"))

    def _maker(self) -> _core.BodyMaker:
        assert self.poisson is not None
        return _core.half_plane(self.poisson, self.young, self.density, self.loss_time)


def _checked(material: Any) -> Material:
    if not isinstance(material, Material):
        raise refusal("material", material, "a stoss.Material")
    return material


Unbounded = Union[HalfSpace, HalfPlane]
UNBOUNDED = (HalfSpace, HalfPlane)
"""The classes of what extends to infinity, for isinstance."""
