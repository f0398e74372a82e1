"""Bodies and blocks that are their numbers alone: their fields are those of the core's table of kinds."""

from __future__ import annotations

import dataclasses

from stoss.bodies._solid import Endless, Solid


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
        (5177, 0.966)
        >>> lossy = stoss.restitution(stoss.Sphere(poisson=0.3, loss_time=0.3), speed=0.01)
        >>> round(lossy.restitution, 3), round(lossy.dissipated, 3)
        (0.866, 0.25)
    """

    _kind = "sphere"


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class HollowSphere(Solid):
    """A shell between concentric spheres, as a table-tennis ball: a sphere with a hole.

    Units are those of a sphere, with the mass of the shell, (4π/3)R³ρ(1 − inner³). It meets what spheres meet and
    turns with its own moment of inertia. Linear elasticity ends early in thin shells: see
    `limits <https://stoss.readthedocs.io/en/latest/reference/limits.html>`_.

    Parameters:
        poisson: Poisson's ratio ν, −0.95 to 0.4999.
        inner (float): Radius of the hole over R, 0 to 0.99: 1 − h/R of a wall of the thickness h.

    Examples:
        >>> celluloid = stoss.Material(young=2.5e9, poisson=0.35, density=1400)
        >>> ball = stoss.HollowSphere(radius=20e-3, inner=0.98, material=celluloid)
        >>> round(ball.scales.speed)
        1336
    """

    _kind = "hollow-sphere"


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class Rod(Solid):
    """A thin elastic rod that meets a wall or another rod with one end.

    Units are its length L, bar speed c and mass. At a wall it has an exact answer, restitution 1
    and contact time 2L/c: a check of everything else.

    Parameters:
        length: Length L; 1, or with a material to be given in m.
        area: Area of the cross-section, A; 1, or with a material to be given in m².
        material (Material): In place of `young` and `density`.

    Examples:
        >>> bounce = stoss.impact(stoss.Rod(), speed=0.1, cutoff=1000)
        >>> round(bounce.restitution, 2), round(bounce.contact_time, 2)
        (1.0, 2.0)
    """

    _kind = "rod"


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class HalfSpace(Endless):
    """An elastic half-space, which spheres meet: a block so large that no wave comes back in time.

    Waves carry energy away in it: see `Impact.lost_to_second`. The block is thick enough
    if a wave to its other side and back takes longer than the contact. Without a material its
    numbers are ratios to those of the sphere, or in the same units.

    Parameters:
        poisson: Poisson's ratio ν, −0.95 to 0.4999; default: that of the sphere.
        young, density: Young's modulus E and density ρ, 1e-3 to 1e6 of those of the sphere; default
            1.

    Examples:
        >>> stoss.restitution(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.01)
        Restitution(Sphere(poisson=0.3) against HalfSpace(poisson=0.3), speed=0.01 c: restitution 0.959850 ± 0.000011)
        >>> steel, glass = stoss.materials["structural steel"], stoss.materials["glass"]
        >>> ball = stoss.Sphere(radius=5e-3, material=steel)
        >>> drop = stoss.restitution(ball, against=stoss.HalfSpace(material=glass), speed=1)
        >>> round(drop.restitution, 3), round(drop.dissipated, 4), f"{drop.contact_time_si:.2g} s"
        (0.995, 0.002, '4.6e-05 s')
    """

    _kind = "half-space"


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class HalfPlane(Endless):
    """An elastic half-plane, which disks meet: a half-space in two dimensions.

    Parameters:
        poisson: 2-D Poisson's ratio ν, −0.95 to 0.995; default: that of the disk.
        young, density: 2-D Young's modulus E and density ρ, 1e-3 to 1e6 of those of the disk;
            default 1.
        plane ({'stress', 'strain'}): With a material: that of the disk.

    Examples:
        >>> stoss.restitution(poisson=0.33, against=stoss.HalfPlane(), speed=0.1)
        Restitution(Disk(poisson=0.33) against HalfPlane(poisson=0.33), speed=0.1 c: restitution 0.56990 ± 0.00032)
    """

    _kind = "half-plane"


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class Strip(Endless):
    """An elastic strip, which disks meet: a plate in two dimensions.

    Parameters:
        thickness (float): Thickness h, in the unit of the disk's radius, or with a material in m.
        poisson: 2-D Poisson's ratio ν, −0.95 to 0.995; default: that of the disk.
        young, density: 2-D Young's modulus E and density ρ, 1e-3 to 1e6 of those of the disk;
            default 1.
        plane ({'stress', 'strain'}): With a material: that of the disk.

    Examples:
        >>> stoss.Strip(thickness=0.5, density=2)
        Strip(thickness=0.5, density=2)
    """

    _kind = "strip"
