"""Stress under Hertz' contact, and in a disk that stands on a wall."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, broadcast, choice, numbers
from stoss._result import Number


class PlaneStress(NamedTuple):
    """Stress in the plane, E; tension is positive.

    Attributes
    ----------
    xx, yy, xy : float or ndarray
        x points into the body, y along the wall.
    """

    xx: Number
    yy: Number
    xy: Number


def _arrays(**given: Any) -> tuple[list[NDArray[np.float64]], tuple[int, ...]]:
    arrays = broadcast(3, **{name: numbers(name, value) for name, value in given.items()})
    return [each.ravel() for each in arrays], arrays[0].shape


def _stress(table: NDArray[Any], shape: tuple[int, ...]) -> PlaneStress:
    return PlaneStress(*(arranged(table[name], shape) for name in ("xx", "yy", "xy")))


def hertz_pressure(*, force: ArrayLike, y: ArrayLike) -> Number:
    """Pressure ½√(a² − y²) of Hertz' contact of half-width a = 2√F, E; 0 outside it.

    This is the pressure of Gerl & Zippelius, section V.

    Parameters
    ----------
    force : array_like
        F, 0 to 0.25 (where the half-width is the radius), πRE.
    y : array_like
        Along the wall from the middle of the contact, R; broadcasts with `force`.

    Returns
    -------
    float or ndarray

    Raises
    ------
    InvalidInput
        For arguments out of range.

    Examples
    --------
    >>> stoss.quasistatic.hertz_pressure(force=0.0025, y=[0.0, 0.06, 0.2])
    array([0.05, 0.04, 0.  ])
    """
    arrays, shape = _arrays(force=force, y=y)
    return arranged(_core.hertz_pressure(*arrays), shape)  # type: ignore[no-any-return]


def hertz_stress(*, force: ArrayLike, depth: ArrayLike, y: ArrayLike) -> PlaneStress:
    """Stress under Hertz' contact in a half-plane, E.

    The relative error is 1e-14 (Gerl & Zippelius, section V).

    Parameters
    ----------
    force : array_like
        F, 0 to 0.25, πRE.
    depth : array_like
        x ≥ 0 below the surface, R.
    y : array_like
        Along the wall from the middle of the contact, R. All three broadcast.

    Returns
    -------
    PlaneStress
        The named tuple (xx, yy, xy).

    Raises
    ------
    InvalidInput
        For arguments out of range.

    Examples
    --------
    >>> stress = stoss.quasistatic.hertz_stress(force=0.0025, depth=[0.0, 0.1], y=0.0)
    >>> stress.xx.round(4)
    array([-0.05  , -0.0354])
    """
    arrays, shape = _arrays(force=force, depth=depth, y=y)
    return _stress(_core.hertz_stress(*arrays), shape)


def heavy_disk_stress(*, force: ArrayLike, x: ArrayLike, y: ArrayLike, contact: str = "point") -> PlaneStress:
    """Stress in a disk that stands on a wall under its weight F = ρgR/E, E.

    A disk that the same force accelerates has the same stress.

    Parameters
    ----------
    force : array_like
        F, 0 to 0.25, πRE.
    x, y : array_like
        Points of the disk, R: from the point of contact x goes through the centre (1, 0), y along
        the wall. All three broadcast.
    contact : {'point', 'hertz'}, optional
        On one point, which is exact (Michell), or on a Hertz contact, the superposition of Gerl &
        Zippelius for small F.

    Returns
    -------
    PlaneStress
        The named tuple (xx, yy, xy).

    Raises
    ------
    InvalidInput
        For points outside the disk or, with 'point', in the point of contact.

    Examples
    --------
    >>> stress = stoss.quasistatic.heavy_disk_stress(force=0.001, x=1.0, y=0.0)
    >>> round(stress.xx, 6), round(stress.yy, 6)
    (-0.0015, 0.0005)
    """
    hertz = choice("contact", contact, ("point", "hertz")) == "hertz"
    arrays, shape = _arrays(force=force, x=x, y=y)
    return _stress(_core.heavy_disk_stress(hertz, *arrays), shape)
