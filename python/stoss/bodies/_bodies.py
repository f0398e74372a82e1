"""Bodies."""

from __future__ import annotations

import dataclasses
from typing import Union

from stoss.bodies._material import Material
from stoss.bodies._modal import ModalBody
from stoss.bodies._solid import KINDS, LEFT_OUT, Solid, is_rigid
from stoss.bodies._walls import UNBOUNDED, Unbounded


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class Disk(Solid):
    """An elastic disk: its 2-D Poisson's ratio, and its size and material relative to other bodies.

    Without a material all sizes are ratios in any consistent units; at a rigid wall only `poisson`
    counts. With a material, the radius and all speeds are in SI. Modes are computed when they are
    needed and kept for the next call.

    Parameters:
        poisson: 2-D Poisson's ratio ν, −0.95 to 0.995.
        material (Material): In place of `poisson`, `young` and `density`: then these attributes are
            ν, E and ρ in plane stress, ν/(1−ν), E/(1−ν²) and ρ in plane strain.
        plane ({'stress', 'strain'}): With a material: a thin plate, or a slice of a long cylinder.

    Examples:
        >>> stoss.impact(stoss.Disk(poisson=0.33), speed=0.1, cutoff=25).contacts
        1
        >>> stoss.Disk(radius=5e-3, material=stoss.materials["structural steel"], plane="strain").poisson
        0.4285714285714286
    """

    _kind = "disk"

    poisson: float = LEFT_OUT
    radius: float = LEFT_OUT
    young: float = LEFT_OUT
    density: float = LEFT_OUT
    loss_time: float = LEFT_OUT
    material: Material | None = None
    plane: str | None = None
    rigid: bool = False


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class Sphere(Solid):
    """An elastic sphere: its Poisson's ratio, and its size and material relative to other bodies.

    Without a material all sizes are ratios in any consistent units; at a rigid wall only `poisson`
    counts. With a material, the radius and all speeds are in SI. Units are the radius
    R, the bar speed c = √(E/ρ) and the mass; forces are in mc²/R = (4π/3)R²E.

    Parameters:
        poisson: Poisson's ratio ν, −0.95 to 0.4999.

    Examples:
        >>> stoss.impact(stoss.Sphere(poisson=0.3), speed=0.1, cutoff=25).contacts
        1
        >>> ball = stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"])
        >>> round(ball.scales.speed), round(ball.scales.time * 1e6, 3)
        (5172, 0.967)
        >>> lossy = stoss.restitution(stoss.Sphere(poisson=0.3, loss_time=0.3), speed=0.01)
        >>> round(lossy.restitution, 3), round(lossy.dissipated, 3)
        (0.866, 0.25)
    """

    _kind = "sphere"

    poisson: float = LEFT_OUT
    radius: float = LEFT_OUT
    young: float = LEFT_OUT
    density: float = LEFT_OUT
    loss_time: float = LEFT_OUT
    material: Material | None = None
    rigid: bool = False


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class Rod(Solid):
    """A thin elastic rod that meets a wall or another rod with one end.

    Units are its length L, bar speed c and mass. At a wall it has an exact answer, restitution 1
    and contact time 2L/c: a check of everything else.

    Parameters:
        length: Length L; 1, or with a material to be given in m.
        area: Of the cross-section, A; 1, or with a material to be given in m².
        material (Material): In place of `young` and `density`.

    Examples:
        >>> bounce = stoss.impact(stoss.Rod(), speed=0.1, cutoff=1000)
        >>> round(bounce.restitution, 2), round(bounce.contact_time, 2)
        (1.0, 2.0)
    """

    _kind = "rod"

    length: float = LEFT_OUT
    young: float = LEFT_OUT
    density: float = LEFT_OUT
    area: float = LEFT_OUT
    loss_time: float = LEFT_OUT
    material: Material | None = None


Body = Union[Disk, Rod, Sphere, ModalBody]
"""Any body: a disk, a rod, a sphere, or one by its modes at a point."""

BODIES = (Disk, Rod, Sphere, ModalBody)
"""The classes of bodies, for isinstance."""

PARTNERS = (*BODIES, *UNBOUNDED)
"""The classes of what a body can meet that is no wall."""


def shown(body: Body | Unbounded, against: object = None) -> str:
    """The body, and what it meets if that is no wall, in the line that says what a result is."""
    if isinstance(against, PARTNERS):
        return f"{shown(body)} against {shown(against)}"
    if body.material is None or KINDS[body._kind].from_file:
        return repr(body)
    if layers := getattr(body, "layers", None):
        return f"{type(body).__name__}({len(layers)} layers)"
    said = [f"poisson={body.poisson:.6g}"] if hasattr(body, "poisson") else []
    lengths = [each.name for each in KINDS[body._kind].parameters if each.unit == "m"]
    said += [f"{name}={getattr(body, name):g} m" for name in lengths]
    return f"{type(body).__name__}({', '.join([*said, *['rigid'] * is_rigid(body)])})"
