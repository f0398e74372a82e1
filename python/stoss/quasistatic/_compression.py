"""Disks and spheres pressed slowly against a wall: force against compression, and contacts held at rest."""

from __future__ import annotations

import dataclasses
import functools
from typing import Any, Callable, ClassVar, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, brief, broadcast, choice, instance, integer, number, numbers
from stoss._documentation import documented
from stoss.bodies._bodies import Disk, Sphere
from stoss.bodies._encounter import choose_body
from stoss.results._quantities import Number
from stoss.results._result import Column, Result, picture, unit

LAWS: Mapping[type, tuple[str, ...]] = {Disk: ("center", "diameter"), Sphere: ("center", "hertz")}
"""Laws of compression of the bodies that have some."""

_force = "F, 0 to `limit_force`, mc²/R; broadcasts with `poisson`."
_of_a_law = functools.partial(documented, body="What is pressed.", force=_force)


def choose_law(body: Any, law: Any) -> str:
    """One of the laws of a body; without one, of disks."""
    return choice("law", law, LAWS[Sphere if isinstance(body, Sphere) else Disk])


def poissons_of(body: Any, poisson: Any) -> NDArray[np.float64]:
    """The Poisson's ratio of a disk or a sphere, or those that were given of disks."""
    if body is None and poisson is not None:
        return numbers("poisson", poisson)
    found: Disk | Sphere = instance("body", choose_body(body, poisson), (Disk, Sphere))
    return np.array(found.poisson)


def over(function: Callable[..., NDArray[Any]], *fixed: Any, **given: Any) -> Any:
    """What a function of the core has over arrays that broadcast: a number, an array, or a list of structured fields."""
    arrays = broadcast(3, **{name: numbers(name, value) for name, value in given.items()})
    found, shape = function(*fixed, *(each.ravel() for each in arrays)), arrays[0].shape
    names = found.dtype.names
    return arranged(found, shape) if names is None else [arranged(found[name], shape) for name in names]


def by_law(name: str, body: Any, poisson: Any, law: Any, **given: Any) -> Number:
    """What the core's function of that name returns for a law, a Poisson's ratio and the other arguments, over arrays."""
    nu = poissons_of(body, poisson)
    function = getattr(_core, f"point_{name}" if isinstance(body, Sphere) else name)
    return over(function, choose_law(body, law), poisson=nu, **given)  # type: ignore[no-any-return]


@_of_a_law
def compression(
    body: Disk | Sphere | None = None, *, force: ArrayLike, poisson: ArrayLike | None = None, law: str = "center"
) -> Number:
    """Compression δ(F) by a law of compression, R.

    The next order is smaller by about F, of a sphere by about F^(1/3).

    Examples:
        >>> round(stoss.quasistatic.compression(force=0.001, poisson=0.33), 6)
        0.006575
        >>> round(stoss.quasistatic.compression(stoss.Sphere(poisson=0.3), force=0.001), 6)
        0.018322
    """
    return by_law("compression", body, poisson, law, force=force)


@_of_a_law
def compression_force(
    body: Disk | Sphere | None = None, *, compression: ArrayLike, poisson: ArrayLike | None = None, law: str = "center"
) -> Number:
    """Force F(δ) by a law of compression, mc²/R: the inverse of `compression`.

    Its relative error is 1e-14.

    Parameters:
        compression: δ from 0 to that of `limit_force`, R; broadcasts with `poisson`.

    Examples:
        >>> stoss.quasistatic.compression_force(compression=[0.01, 0.02], poisson=0.33).round(6)
        array([0.001645, 0.003821])
    """
    return by_law("compression_force", body, poisson, law, compression=compression)


@_of_a_law
def compression_energy(
    body: Disk | Sphere | None = None, *, force: ArrayLike, poisson: ArrayLike | None = None, law: str = "center"
) -> Number:
    """Energy ∫F dδ from no contact to the force F, mc²; of a disk F² [½ ln(s/F) − ½b − ¼].

    Examples:
        >>> impact = stoss.quasistatic.slow_impact(poisson=0.33, speed=0.01)
        >>> energy = stoss.quasistatic.compression_energy(force=impact.max_force, poisson=0.33)
        >>> round(energy / (0.5 * 0.01**2), 12)
        1.0
    """
    return by_law("compression_energy", body, poisson, law, force=force)


def contact_radius(body: Sphere, *, force: ArrayLike) -> Number:
    """Radius a = (π(1 − ν²)F)^{1/3} of the contact of a sphere, R: the same for both laws.

    Parameters:
        body (Sphere):
        force (array_like): F, up to where a is R, mc²/R.

    Examples:
        >>> round(stoss.quasistatic.contact_radius(stoss.Sphere(poisson=0.3), force=0.001), 6)
        0.141927
    """
    ball: Sphere = instance("body", body, (Sphere,))
    return over(_core.contact_radius, poisson=ball.poisson, force=force)  # type: ignore[no-any-return]


@_of_a_law
def limit_force(body: Disk | Sphere | None = None, *, poisson: ArrayLike | None = None, law: str = "center") -> Number:
    """Force where δ(F) has its maximum and the law ends, mc²/R; of a disk s e^{−1−b}.

    That of a sphere ends at a contact of the radius R at the latest. A law means little from a
    tenth of this force on.

    Examples:
        >>> round(stoss.quasistatic.limit_force(poisson=0.33), 4)
        0.2638
    """
    return by_law("limit_force", body, poisson, law)


@_of_a_law
def limit_speed(body: Disk | Sphere | None = None, *, poisson: ArrayLike | None = None, law: str = "center") -> Number:
    """Highest speed of a slow impact, at which it reaches `limit_force`, c; of a disk `limit_force`/√2.

    Examples:
        >>> round(stoss.quasistatic.limit_speed(poisson=0.33), 4)
        0.1865
    """
    return by_law("limit_speed", body, poisson, law)


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class StaticContact(Result):
    """A disk or a sphere held against a hard wall, at rest.

    Attributes:
        force, force_error: Force of the contact, mc²/R: πRE of a disk, (4π/3)R²E of a sphere; and its
            estimated error.
        half_width: Half the width of the contact along the undeformed edge, R; its radius for a sphere.
        energy: Stored in the body, mc²; its derivative by δ is F.
        contact_nodes: Nodes with a pressure, the first ones. Those of a sphere are rings.
        spacing: Distance of the nodes, R.
        position: Places of the nodes along the undeformed edge or meridian, from the middle of the
            contact, R.
        pressure: At the nodes, in the direction of x, per length of the undeformed edge or area of
            the undeformed surface, E. The sum of 2·spacing·pressure is πF; of a sphere the sum of
            4π·sin(position)·sin(spacing/2)·pressure is (4π/3)F. The innermost ring has 13 % too
            little pressure, the next 2.4 % too much, all others are within 1 %.
    """

    plot = picture("Pressure along the edge. See `stoss.plot.static_contact`.")
    _name: ClassVar[str] = "static contact"
    _units = {"position": "R", "pressure": "E"}
    _told = ("body", "poisson", "compression", "force", "force_error", "half_width", "energy")

    body: Disk | Sphere
    poisson: float
    compression: float
    force: float
    force_error: float
    half_width: float
    energy: float
    contact_nodes: int
    spacing: float
    position: NDArray[np.float64]
    pressure: NDArray[np.float64]

    def __repr__(self) -> str:
        size = "radius" if isinstance(self.body, Sphere) else "half-width"
        return (
            f"StaticContact({self._of()}, compression={self.compression:g} R: force {self.force:.7g} "
            f"± {self.force_error:.1g} {unit('force', body=self.body._kind, si=False)}, {size} {self.half_width:.6g} R)"
        )

    def _of(self) -> str:
        poisson = f"poisson={brief(self.poisson)}"
        return f"Sphere({poisson})" if isinstance(self.body, Sphere) else poisson

    def _table(self) -> dict[str, Column]:
        return {"position": self.position, "pressure": self.pressure}


@documented
def static_contact(
    body: Disk | Sphere | None = None, *, compression: float, poisson: float | None = None, nodes: int = 160
) -> StaticContact:
    """The contact of a body whose centre of mass is held at the distance R − δ from a hard wall.

    Small-strain elasticity with the compliance of all modes and the exact shape of the edge; no law
    of contact enters. It means little for δ above about 0.1.

    Parameters:
        compression: δ, 1e-12 to 0.5, R (also with a material).
        nodes: On half of the contact, 16 to 1024; the force converges with their square. A sphere
            takes 0.3 s with 160 for δ below 1e-3, 0.1 s with 80.

    Examples:
        >>> contact = stoss.quasistatic.static_contact(poisson=0.33, compression=0.01)
        >>> by_law = stoss.quasistatic.compression_force(poisson=0.33, compression=0.01)
        >>> round(by_law / contact.force - 1, 4)
        0.0011
        >>> stoss.quasistatic.static_contact(stoss.Sphere(poisson=0.3), compression=0.01)
        StaticContact(Sphere(poisson=0.3), compression=0.01 R: force 0.0003848227 ± 4e-09 mc^2/R, radius 0.103397 R)
    """
    pressed: Disk | Sphere = instance("body", choose_body(body, poisson), (Disk, Sphere))
    delta, count = number("compression", compression), integer("nodes", nodes)
    function = _core.point_static_contact if isinstance(pressed, Sphere) else _core.static_contact
    found = function(pressed.poisson, delta, count)
    return StaticContact(body=pressed, poisson=pressed.poisson, compression=delta, **found)
