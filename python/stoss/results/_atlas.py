"""The atlas: values of a sweep that is shipped with the package, interpolated with their error.

Tensor products of cubics through the four nearest nodes in ν, ln v and, of pairs, the logarithm of
the ratio of radii; the nodes are equally spaced in these. The error is that of the sweep plus that
of the interpolation, which studies/atlas/make.py measures at nodes that it holds out.
"""

from __future__ import annotations

import dataclasses
import functools
from importlib import resources
from typing import Any, Callable, ClassVar, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss._arguments import arranged, numbers, refusal
from stoss._documentation import documented
from stoss.bodies._faces import is_rough
from stoss.bodies._losses import relaxes
from stoss.bodies._bodies import Body, Disk, Sphere
from stoss.bodies._encounter import Against, choose_against, choose_body
from stoss.bodies._walls import UNBOUNDED, HalfPlane, HalfSpace, HardWall, Unbounded
from stoss.export._tables import span, with_error
from stoss.results._quantities import Number
from stoss.results._result import Column
from stoss.results._si import SpeedInSi, in_c, warn_at

Array = NDArray[np.float64]


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class AtlasValue(SpeedInSi):
    """Coefficients of restitution of the atlas.

    Numbers, or arrays of the shape of `speed`. The error is that of the values of the atlas and of their
    interpolation.
    """

    _name: ClassVar[str] = "atlas"
    _given = {"speed": "speed"}
    _axis: ClassVar[str] = "speed"
    _told = ("body", "against")

    body: Body
    against: Against
    speed: Number
    restitution: Number
    restitution_error: Number

    def __repr__(self) -> str:
        if isinstance(self.restitution, float) and isinstance(self.restitution_error, float):
            return f"AtlasValue({with_error(self.restitution, self.restitution_error)})"
        return f"AtlasValue({np.shape(self.restitution)}: restitution {span(self.restitution)})"

    def _table(self) -> dict[str, Column]:
        return {name: np.asarray(getattr(self, name)) for name in ("speed", "restitution", "restitution_error")}

    def _arranged_columns(self) -> tuple[dict[str, Column], tuple[str, ...]]:
        dimensions = np.ndim(self.restitution)
        return self._columns(), ("speed",) if dimensions == 1 else tuple(f"axis_{k}" for k in range(dimensions))


@documented
def atlas(
    body: Body | None = None,
    *,
    speed: ArrayLike,
    against: HardWall | Body | Unbounded | str | None = None,
    poisson: float | None = None,
) -> AtlasValue:
    """Look up the coefficient of restitution of a sphere or a disk, in microseconds.

    The atlas has bodies without loss, spheres of ν from 0 to 0.48 and disks from 0 to 0.9, at a
    rigid wall, at a half-space or a half-plane of their own material, and in pairs of their own
    material with radii up to 1:10, at speeds of approach from 1e-4 to 0.3 c. Everything else is
    refused: `stoss.restitution` computes it.

    Parameters:
        body (Sphere or Disk): The first body.
        speed: Speed of approach, c (with a material: m/s).

    Examples:
        >>> value = stoss.atlas(stoss.Sphere(poisson=0.3), speed=0.1)
        >>> exact = stoss.restitution(stoss.Sphere(poisson=0.3), speed=0.1)
        >>> abs(value.restitution - exact.restitution) < value.restitution_error
        True
    """
    chosen = choose_body(body, poisson)
    if not isinstance(chosen, (Sphere, Disk)) or chosen.loss_time != 0.0 or relaxes(chosen) or is_rough(chosen):
        raise refusal("body", chosen, "a smooth sphere or disk without loss, loss_time=0, in the atlas (use stoss.restitution)")
    met = choose_against(chosen, against, (HardWall,))
    which, ratio = _what(chosen, met)
    table = _tables()
    own, name = chosen._kind, f"{chosen._kind}_{which}"
    values, error = table[name], table[f"{name}_error"] + table[f"{name}_interpolation_error"]
    places = [_places("poisson", table[f"{own}_poisson"], np.array([chosen.poisson]), np.asarray)]
    if which == "pair":
        places.append(_places("ratio of the radii", table["ratio"], np.array([ratio]), np.log))
    for place, count in places:
        first, weights = stencil(place, count)
        values = np.tensordot(weights[0], values[first[0] : first[0] + 4], 1)
        error = error[_cell(place, count)].max(axis=(0, 1))
    given = numbers("speed", speed)
    speeds, found, bars = in_c(chosen, given).ravel(), np.empty(given.size), np.empty(given.size)
    many = 65536  # between which Ctrl-C is heeded
    for begin in range(0, given.size, many):
        part = slice(begin, begin + many)
        place, count = _places("speed in c", table["speed"], speeds[part], np.log)
        first, weights = stencil(place, count)
        found[part] = (weights * values[first[:, None] + np.arange(4)]).sum(axis=1)
        bars[part] = error[_cell(place, count)].max(axis=1)
    warn_at(chosen, met, speeds, 2)
    return AtlasValue(chosen, met, *(arranged(each, given.shape) for each in (speeds, found, bars)))


def _what(body: Sphere | Disk, met: Any) -> tuple[str, float]:
    """Which table, and the ratio of the radii."""
    if is_rough(met):
        raise refusal("against", met, "a smooth face in the atlas (use stoss.restitution)")
    if isinstance(met, HardWall):
        return "wall", 1.0
    alike = all(getattr(met, name) == getattr(body, name) for name in ("poisson", "young", "density"))
    if not alike or met.loss_time != 0.0 or relaxes(met) or getattr(met, "rigid", False):
        raise refusal("against", met, "the material of the first, without loss, loss_time=0, in the atlas (use stoss.restitution)")
    if isinstance(met, (HalfSpace, HalfPlane)):
        return "block", 1.0
    if isinstance(met, UNBOUNDED):
        raise refusal("against", met, "a wall, a half-space, a half-plane or a body in the atlas (use stoss.restitution)")
    # What each of two bodies of one material loses is the same whoever is called the first.
    return "pair", max(met.radius, body.radius) / min(met.radius, body.radius)


def _places(name: str, nodes: Array, at: Array, scale: Callable[[Array], Array]) -> tuple[Array, int]:
    """Where the numbers lie among the nodes, which are equally spaced on that scale, and how many nodes there are."""
    outside = at[~((at >= nodes[0] * (1 - 1e-12)) & (at <= nodes[-1] * (1 + 1e-12)))]
    if outside.size:
        allowed = f"{nodes[0]:.6g} to {nodes[-1]:.6g} in the atlas (use stoss.restitution)"
        raise refusal(name, float(outside[0]), allowed)
    low, high = scale(nodes[:1])[0], scale(nodes[-1:])[0]
    return (scale(at) - low) / (high - low) * (nodes.size - 1), nodes.size


def stencil(place: Array, count: int) -> tuple[NDArray[np.intp], Array]:
    """The first of the four of `count` nodes around each place, and Lagrange's weights of the cubic through them."""
    first = np.clip(np.floor(place).astype(np.intp) - 1, 0, count - 4)
    s = place - first
    weights = [-(s - 1) * (s - 2) * (s - 3) / 6, s * (s - 2) * (s - 3) / 2, -s * (s - 1) * (s - 3) / 2]
    return first, np.stack([*weights, s * (s - 1) * (s - 2) / 6], axis=-1)


def _cell(place: Array, count: int) -> NDArray[np.intp]:
    """The two nodes on both sides of each place."""
    low = np.clip(np.floor(place).astype(np.intp), 0, count - 2)
    return np.stack([low, low + 1], axis=-1)


@functools.lru_cache(maxsize=1)
def _tables() -> Mapping[str, Array]:
    with resources.files("stoss").joinpath("atlas.npz").open("rb") as stream, np.load(stream) as file:
        return {name: file[name].astype(np.float64) for name in file.files}
