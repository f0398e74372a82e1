"""Bodies."""

from __future__ import annotations

import contextlib
import dataclasses
from typing import Any, Iterator, Union

from stoss import _core
from stoss._arguments import boolean, refusal
from stoss._body_values import call, fill, fill_loss_time, known_material, own_loss_time, size
from stoss._errors import InvalidInput
from stoss._half_space import UNBOUNDED, Unbounded
from stoss._material import Material, Scales
from stoss._sphere import Sphere as Sphere


@dataclasses.dataclass(frozen=True, init=False, repr=False)
class Disk:
    """An elastic disk: its 2-D Poisson's ratio, and its size and material relative to other bodies.

    Without a material all sizes are ratios in any consistent units; at a rigid wall only `poisson`
    counts. With a material, the radius and all speeds are in SI. Modes are computed when they are
    needed and kept for the next call.

    Parameters
    ----------
    poisson : float
        2-D Poisson's ratio ν, −0.95 to 0.995.
    radius : float
        Radius R; 1, or with a material to be given in m.
    young, density : float, optional
        Young's modulus E and density ρ.
    loss_time : float, optional
        Loss time η of a Kelvin–Voigt material, stress = (1 + η ∂/∂t) elastic stress; 0, or
        that of the material. In the unit of time that the others imply, R/c of the first body; with
        a material in s.
    material : Material
        In place of `poisson`, `young` and `density`: then these attributes are ν, E and ρ in plane
        stress, ν/(1−ν), E/(1−ν²) and ρ in plane strain.
    plane : {'stress', 'strain'}
        With a material: a thin plate, or a slice of a long cylinder.
    rigid : bool, optional
        Young's modulus is infinite. The disk keeps its mass, and the given modulus remains a unit.
        It meets elastic bodies: disks and half-planes.

    Examples
    --------
    >>> stoss.impact(stoss.Disk(poisson=0.33), speed=0.1, cutoff=25).contacts
    1
    >>> stoss.Disk(radius=5e-3, material=stoss.materials["steel"], plane="strain").poisson
    0.4285714285714286
    """

    poisson: float
    radius: float
    young: float
    density: float
    loss_time: float
    material: Material | None
    plane: str | None
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
        plane: str | None = None,
        rigid: bool = False,
    ) -> None:
        made: dict[str, float] = {"young": 1.0, "density": 1.0}
        if material is None:
            if plane is not None:
                raise refusal("plane", plane, "none without a material (`poisson` is the 2-D Poisson's ratio)")
        else:
            size_in_si = size("radius", radius, material)
            plane = "stress" if plane is None else plane
            made = material._in_plane(plane)
            material._scales(plane, size_in_si)  # refuses what is out of range
        fill(self, made, material, poisson=poisson, young=young, density=density)
        fill(self, {"radius": 1.0}, None, radius=radius)
        object.__setattr__(self, "material", material)
        object.__setattr__(self, "plane", plane)
        object.__setattr__(self, "rigid", boolean("rigid", rigid))
        fill_loss_time(self, loss_time, material, self.rigid)
        self._maker()  # refuses what is out of range

    def __repr__(self) -> str:
        ratios = ("poisson", "radius", "young", "density", "loss_time", "rigid")
        return call(self, ratios, ("radius", "loss_time", "material", "plane", "rigid"))

    @property
    def scales(self) -> Scales:
        """SI values of the units of all results of which this is the first body."""
        return known_material(self)._scales(str(self.plane), self.radius)

    def _maker(self) -> _core.BodyMaker:
        elastic = _core.disk(self.poisson, self.radius, self.young, self.density, self.loss_time)
        return _core.rigid(elastic) if self.rigid else elastic

    def _shape(self) -> Disk:
        """What counts at a wall: the same for all sizes."""
        return Disk(poisson=self.poisson, loss_time=own_loss_time(self, self.radius))


@dataclasses.dataclass(frozen=True, init=False, repr=False)
class Rod:
    """A thin elastic rod that meets a wall or another rod with one end.

    Units are its length L, bar speed c and mass. At a wall it has an exact answer, restitution 1
    and contact time 2L/c: a check of everything else.

    Parameters
    ----------
    length : float
        Length L; 1, or with a material to be given in m.
    young, density : float, optional
        Young's modulus E and density ρ.
    area : float
        Of the cross-section, A; 1, or with a material to be given in m².
    loss_time : float, optional
        Loss time η of a Kelvin–Voigt material, stress = (1 + η ∂/∂t) elastic stress; 0, or
        that of the material. In the unit of time that the others imply, L/c of the first body; with
        a material in s.
    material : Material
        In place of `young` and `density`.

    Examples
    --------
    >>> bounce = stoss.impact(stoss.Rod(), speed=0.1, cutoff=1000)
    >>> round(bounce.restitution, 2), round(bounce.contact_time, 2)
    (1.0, 2.0)
    """

    length: float
    young: float
    density: float
    area: float
    loss_time: float
    material: Material | None

    def __init__(
        self,
        *,
        length: float | None = None,
        young: float | None = None,
        density: float | None = None,
        area: float | None = None,
        loss_time: float | None = None,
        material: Material | None = None,
    ) -> None:
        made = {"young": 1.0, "density": 1.0}
        if material is not None:
            size("length", length, material)
            size("area", area, material)
            made = {"young": material.young, "density": material.density}
        fill(self, made, material, young=young, density=density)
        fill(self, {"length": 1.0, "area": 1.0}, None, length=length, area=area)
        fill_loss_time(self, loss_time, material)
        object.__setattr__(self, "material", material)
        self._maker()  # refuses what is out of range

    def __repr__(self) -> str:
        ratios = ("length", "young", "density", "area", "loss_time")
        return call(self, ratios, ("length", "area", "loss_time", "material"))

    @property
    def scales(self) -> Scales:
        """SI values of the units of all results of which this is the first body."""
        known_material(self)
        return Scales(*_core.rod_scales(self.length, self.young, self.density, self.area))

    def _maker(self) -> _core.BodyMaker:
        return _core.rod(self.length, self.young, self.density, self.area, self.loss_time)

    def _shape(self) -> Rod:
        """What counts at a wall: the same for all sizes."""
        return Rod(loss_time=own_loss_time(self, self.length))


Body = Union[Disk, Rod, Sphere]
"""Any body: a disk, a rod or a sphere."""

BODIES = (Disk, Rod, Sphere)
"""The classes of bodies, for isinstance."""

PARTNERS = (*BODIES, *UNBOUNDED)
"""The classes of what a body can meet that is no wall."""


def kind(body: Any) -> str:
    """What the core calls the kind of a body: its units depend on it."""
    return type(body).__name__.lower()


def is_rigid(body: Any) -> bool:
    """Whether it is a body that does not deform."""
    return bool(getattr(body, "rigid", False))


def shown(body: Body | Unbounded) -> str:
    """The body in the line that says what a result is."""
    if body.material is None:
        return repr(body)
    if isinstance(body, UNBOUNDED):
        return f"{type(body).__name__}(poisson={body.poisson:.6g})"
    if isinstance(body, Rod):
        return f"Rod(length={body.length:g} m)"
    rigid = ", rigid" if body.rigid else ""
    return f"{type(body).__name__}(poisson={body.poisson:.6g}, radius={body.radius:g} m{rigid})"


def speed_unit(body: Body | None) -> float:
    """What a speed that a user gives is divided by."""
    return 1.0 if body is None or body.material is None else body.scales.speed


@contextlib.contextmanager
def speeds_in_si(body: Body | None) -> Iterator[None]:
    """Says to a user who thinks in m/s what the core's refusal of a speed means."""
    try:
        yield
    except InvalidInput as error:
        if body is None or body.material is None or not str(error).startswith("speed"):
            raise
        raise InvalidInput(f"{error}; with this material c is {body.scales.speed:.6g} m/s") from None
