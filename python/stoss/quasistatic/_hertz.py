"""Stress under Hertz' contact."""

from __future__ import annotations

from typing import Any, NamedTuple, overload

from numpy.typing import ArrayLike

from stoss import _core
from stoss._arguments import instance
from stoss.bodies._bodies import Disk, Sphere
from stoss.quasistatic._compression import over
from stoss.results._quantities import Number


class PlaneStress(NamedTuple):
    """Stress in the plane, E; tension is positive.

    Attributes:
        xx, yy, xy (float or ndarray): x points into the body, y along the wall.
    """

    xx: Number
    yy: Number
    xy: Number


class AxisymmetricStress(NamedTuple):
    """Stress in cylinder coordinates around the axis of a contact, E; tension is positive.

    Attributes:
        radial, hoop, axial, shear (float or ndarray): σ_rr, σ_φφ, σ_zz and σ_rz; z points into the
            body.
    """

    radial: Number
    hoop: Number
    axial: Number
    shear: Number


class GreatestShear(NamedTuple):
    """Where under the middle of a contact the shear stress is largest, and how large.

    Attributes:
        depth (float or ndarray): In R.
        shear (float or ndarray): In E.
    """

    depth: Number
    shear: Number


def _sphere(body: Any) -> Sphere | None:
    """The sphere, if it is one."""
    if body is not None:
        instance("body", body, (Disk, Sphere))
    return body if isinstance(body, Sphere) else None


def hertz_pressure(body: Disk | Sphere | None = None, *, force: ArrayLike, y: ArrayLike) -> Number:
    """Pressure of Hertz' contact with a wall, E; 0 outside it.

    For a disk it is ½√(a² − y²) with the half-width a = 2√F, the same for all of them (Gerl &
    Zippelius, section V); of a sphere p₀√(1 − y²/a²) on a circle.

    Parameters:
        body (Disk or Sphere, optional): A disk if it is left out.
        force (array_like): F, 0 to where the half-width or the radius of the contact is R (of a
            disk 0.25), mc²/R.
        y (array_like): Along the wall from the middle of the contact, R; broadcasts with `force`.
            Not negative for a sphere.

    Examples:
        >>> stoss.quasistatic.hertz_pressure(force=0.0025, y=[0.0, 0.06, 0.2])
        array([0.05, 0.04, 0.  ])
        >>> stoss.quasistatic.hertz_pressure(stoss.Sphere(poisson=0.3), force=1e-4, y=[0.0, 0.06, 0.2]).round(6)
        array([0.046086, 0.019027, 0.      ])
    """
    sphere = _sphere(body)
    if sphere is not None:
        return over(_core.point_hertz_pressure, sphere.poisson, force=force, y=y)  # type: ignore[no-any-return]
    return over(_core.hertz_pressure, force=force, y=y)  # type: ignore[no-any-return]


@overload
def hertz_stress(body: Sphere, *, force: ArrayLike, depth: ArrayLike, y: ArrayLike) -> AxisymmetricStress: ...


@overload
def hertz_stress(body: Disk | None = None, *, force: ArrayLike, depth: ArrayLike, y: ArrayLike) -> PlaneStress: ...


def hertz_stress(
    body: Disk | Sphere | None = None, *, force: ArrayLike, depth: ArrayLike, y: ArrayLike
) -> PlaneStress | AxisymmetricStress:
    """Stress under Hertz' contact in the half-plane or half-space that stands for the body, E.

    The relative error of a disk's `PlaneStress` is 1e-14 (Gerl & Zippelius, section V). The
    `AxisymmetricStress` of a sphere is Huber's (1904) closed form.

    Parameters:
        body (Disk or Sphere, optional): A disk if it is left out.
        force (array_like): F, as for `hertz_pressure`, mc²/R.
        depth (array_like): x ≥ 0 below the surface, R.
        y (array_like): Along the wall from the middle of the contact, R; of a sphere the distance y
            ≥ 0 from the axis. All three broadcast.

    Examples:
        >>> stress = stoss.quasistatic.hertz_stress(force=0.0025, depth=[0.0, 0.1], y=0.0)
        >>> stress.xx.round(4)
        array([-0.05  , -0.0354])
        >>> stress = stoss.quasistatic.hertz_stress(stoss.Sphere(poisson=0.3), force=1e-4, depth=[0.0, 0.1], y=0.0)
        >>> stress.axial.round(4)
        array([-0.0461, -0.0139])
    """
    sphere = _sphere(body)
    if sphere is not None:
        return AxisymmetricStress(*over(_core.point_hertz_stress, sphere.poisson, force=force, depth=depth, y=y))
    return PlaneStress(*over(_core.hertz_stress, force=force, depth=depth, y=y))


def greatest_shear(body: Sphere, *, force: ArrayLike) -> GreatestShear:
    """The maximum shear stress ½(σ_rr − σ_zz) on the axis below Hertz' contact of a sphere with a wall, and its depth.

    At ν = 0.3 it is 0.310 p₀ at the depth 0.481 a: where the sphere begins to yield.

    Parameters:
        body (Sphere):
        force (array_like): F, as for `hertz_pressure`, mc²/R.

    Examples:
        >>> ball = stoss.Sphere(poisson=0.3)
        >>> below = stoss.quasistatic.greatest_shear(ball, force=1e-4)
        >>> round(below.shear / stoss.quasistatic.hertz_pressure(ball, force=1e-4, y=0.0), 3)
        0.31
    """
    ball: Sphere = instance("body", body, (Sphere,))
    return GreatestShear(*over(_core.greatest_shear, ball.poisson, force=force))
