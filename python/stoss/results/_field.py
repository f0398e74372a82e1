"""Displacement and stress inside a disk or a sphere."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

import numpy as np
from numpy.typing import NDArray

from stoss.export._text import span
from stoss.results._result import Column, Number, Result

if TYPE_CHECKING:
    from stoss.results._impact import Impact

FieldKind = TypeVar("FieldKind", bound="Field")


class OfAnImpact(Result):
    """What is seen of an impact at some times."""

    impact: Impact

    def _kind_of_body(self) -> str:
        return self.impact._kind_of_body()

    def _inputs(self) -> dict[str, Any]:
        return self.impact._inputs() | {"speed": self.impact.speed, "cutoff": self.impact.cutoff}


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Field(OfAnImpact):
    """The deformed body and the stress inside it: what a `DiskField` and a `SphereField` have in common.

    Arrays are times × radii × angles, or radii × angles for one time.

    Attributes
    ----------
    of : int
        Inside which body: 0 the first, 1 the second. Units are those of the first.
    size : float
        Radius of the body, R.
    time, center, force, contact_half_width : float or ndarray
        Of each instant: R/c; x of the body's centre in R; F in mc²/R (of disks πRE); R.
    radius, angle : ndarray
        Of the points in the undeformed body: in its own radius; radians, 0 towards the contact.
    x, y : ndarray
        Where the points are now, R. The wall is at x = 0 and the body at x < 0. Of two bodies the
        first is at x < 0: they first touch at x = 0, and their common centre of mass is at rest.
    stress_rr : ndarray
        σ_rr, E; tension is positive.
    von_mises, principal_difference : ndarray
        In E.
    """

    _name: ClassVar[str] = "field"
    _kind = "snapshot"
    _stresses: ClassVar[tuple[str, ...]] = ()  # in the order of the columns
    _units = {"angle": "rad", "x": "R", "y": "R", "von_mises": "E", "principal_difference": "E"} | {
        f"stress_{pair}": "E" for pair in ("rr", "tt", "pp", "rt", "rp")
    }

    impact: Impact = dataclasses.field(repr=False)
    of: int
    size: float
    time: Number
    center: Number
    force: Number
    contact_half_width: Number
    radius: NDArray[np.float64]
    angle: NDArray[np.float64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    stress_rr: NDArray[np.float64]
    von_mises: NDArray[np.float64]
    principal_difference: NDArray[np.float64]

    def __repr__(self) -> str:
        points = f"{len(self.radius)} radii x {len(self.angle)} angles"
        return f"{type(self).__name__}(time {span(self.time)} R/c, {points}, of {self.impact!r})"

    def plot(self, ax: Any = None) -> Any:
        """Stress inside the body. See `stoss.plot.stress`."""
        return self._picture(ax)

    def _table(self) -> dict[str, Column]:
        shape = self.x.shape
        instants = {name: np.asarray(getattr(self, name)) for name in ("time", "center", "force", "contact_half_width")}
        columns = {name: np.broadcast_to(value[..., None, None], shape) for name, value in instants.items()}
        columns["radius"] = np.broadcast_to(self.radius[:, None], shape)
        columns["angle"] = np.broadcast_to(self.angle, shape)
        for name in ("x", "y", *self._stresses, "von_mises", "principal_difference"):
            columns[name] = getattr(self, name)
        return columns

    @classmethod
    def _from_core(
        cls: type[FieldKind],
        impact: Impact,
        of: int,
        shape: tuple[int, ...],
        order: NDArray[np.intp],
        instants: NDArray[Any],
        fields: dict[str, Any],
        radius: NDArray[np.float64],
        angle: NDArray[np.float64],
    ) -> FieldKind:
        """From the core's arrays, whose times are sorted: `order` says where each belongs."""
        back = np.argsort(order, kind="stable")
        in_order = bool(np.all(order == np.arange(order.size)))

        def arranged(array: NDArray[np.float64]) -> Any:
            values = (array if in_order else array[back]).reshape(shape + array.shape[1:])
            values.flags.writeable = False
            return values if values.ndim else float(values)

        center, size = fields.pop("center"), float(fields.pop("size"))
        reach = size * radius[:, None] + fields["radial"]
        out = reach * np.cos(angle)
        out -= fields["tangential"] * np.sin(angle)
        up = reach * np.sin(angle)
        up += fields["tangential"] * np.cos(angle)
        if of == 1:  # the second body looks the other way
            out *= -1.0
        for array in (radius, angle):
            array.flags.writeable = False
        return cls(
            impact=impact,
            of=of,
            size=size,
            center=arranged(center),
            radius=radius,
            angle=angle,
            x=arranged(out + center[:, None, None]),
            y=arranged(up),
            **{name: arranged(instants[name]) for name in ("time", "force", "contact_half_width")},
            **{name: arranged(array) for name, array in fields.items() if name not in ("radial", "tangential")},
        )


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class DiskField(Field):
    """The deformed disk and the stress inside it.

    Attributes
    ----------
    stress_rr, stress_pp, stress_rp : ndarray
        σ_rr, σ_φφ and σ_rφ, E; tension is positive.
    von_mises : ndarray
        √(σ₁² − σ₁σ₂ + σ₂²) of plane stress, E.
    principal_difference : ndarray
        ``|σ₁ − σ₂|``, E: what photoelastic fringes count.

    See Also
    --------
    Field : what it has in common with the field of a sphere.
    """

    _stresses = ("stress_rr", "stress_pp", "stress_rp")

    stress_pp: NDArray[np.float64]
    stress_rp: NDArray[np.float64]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SphereField(Field):
    """The deformed sphere and the stress inside it, on a plane through the axis of the impact.

    Angles are polar angles θ from the contact; negative ones are the other half of the plane, the
    mirror image of the first.

    Attributes
    ----------
    stress_rr, stress_tt, stress_pp, stress_rt : ndarray
        σ_rr, σ_θθ, σ_φφ (across the plane) and σ_rθ, E; tension is positive.
    von_mises : ndarray
        √(½[(σ₁−σ₂)² + (σ₂−σ₃)² + (σ₃−σ₁)²]), E.
    principal_difference : ndarray
        ``|σ₁ − σ₂|`` of the principal stresses in the plane, E: what a thin slice would show as
        photoelastic fringes.

    See Also
    --------
    Field : what it has in common with the field of a disk.
    """

    _stresses = ("stress_rr", "stress_tt", "stress_pp", "stress_rt")

    stress_tt: NDArray[np.float64]
    stress_pp: NDArray[np.float64]
    stress_rt: NDArray[np.float64]
