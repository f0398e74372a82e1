"""The whole collision rule as a function, and collisions by it."""

from __future__ import annotations

import dataclasses
import functools
import json
import os
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import numbers, refusal
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body, shown
from stoss.bodies._encounter import Against, encounter
from stoss.export import _files, _netcdf
from stoss.export._files import write_lines
from stoss.export._tables import brief_range
from stoss.results._collided import Motion, collided
from stoss.results._result import Column
from stoss.results._si import Coded, in_c

Array = NDArray[np.float64]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class CollisionRule(Coded):
    """What a collision with friction does, as a function: ε_n and s′, and velocities and spins after.

    s = v_t + Ω₁R₁ + Ω₂R₂ is the velocity at which the first body's point of contact slides over the
    second's. Tabulated is q = s′/(|s| + μv_n) against ln v_n and z = (|s| − μv_n)/(|s| + μv_n), of
    a mixture also against (r − 1)/(r + 1) of the ratio r of the radii. Speeds are in c or, with a
    material, in m/s. ε_n ≤ 1 and |s′| ≤ |s| always hold. Made by `collision_rule`.

    Attributes:
        friction: Coefficient for which it holds; None: for any.
        alike: Whether a ratio of radii and its inverse are the same pair.
        speed, slip, ratio: Places of the computed q: v_n in c, z, and r.
        sliding, sliding_error: q there, speeds down, and its error.
        sliding_interpolation_error: Error of the interpolation between them.
        restitution_speed, restitution_slip, restitution_ratio, restitution, restitution_error,
        restitution_interpolation_error: The same of ε_n, on places of its own.

    Examples:
        >>> rule = stoss.collision_rule(stoss.Sphere(poisson=0.3), against="same", speed=(1e-3, 1e-2))
        >>> restitution, sliding = rule(0.005, 0.004, friction=0.3)
        >>> round(restitution, 3), round(sliding / 0.004, 1)
        (1.0, -0.6)
    """

    _name: ClassVar[str] = "collision rule"
    _given = {"speed": "speed"}
    _told = ("body", "against", "friction", "beyond")

    body: Body
    against: Against
    friction: float | None
    beyond: str
    alike: bool
    speed: Array
    slip: Array
    ratio: Array
    sliding: Array
    sliding_error: Array
    sliding_interpolation_error: Array
    restitution_speed: Array
    restitution_slip: Array
    restitution_ratio: Array
    restitution: Array
    restitution_error: Array
    restitution_interpolation_error: Array

    def __call__(
        self, speed: ArrayLike, sliding: ArrayLike, friction: ArrayLike | None = None, ratio: ArrayLike = 1.0
    ) -> tuple[Any, Any]:
        """ε_n and s′: floats for numbers, otherwise arrays of the shape to which they broadcast.

        `sliding` is s, and `ratio` counts in a mixture only. The friction may be left out where it
        is known.
        """
        found = self._of(speed, sliding, friction, ratio)
        return _shown(found[0]), _shown(found[2] * self._given_unit[1])

    def error(
        self, speed: ArrayLike, sliding: ArrayLike, friction: ArrayLike | None = None, ratio: ArrayLike = 1.0
    ) -> tuple[Any, Any]:
        """Error of ε_n, and error of s′ over |v_t| + |Ω₁|R₁ + |Ω₂|R₂ + μv_n; infinite where they are unknown."""
        found = self._of(speed, sliding, friction, ratio)
        return _shown(found[1]), _shown(found[3])

    def collide(
        self,
        velocity: ArrayLike,
        spin: ArrayLike,
        normal: ArrayLike,
        second_velocity: ArrayLike = 0.0,
        second_spin: ArrayLike = 0.0,
        *,
        friction: ArrayLike | None = None,
        radius: ArrayLike | None = None,
        second_radius: ArrayLike | None = None,
    ) -> Motion:
        """Velocities and spins after collisions: of the first bodies, then of the second.

        In space velocities and spins are arrays of shape (..., 3), in a plane velocities of
        (..., 2) and spins, from x to y, of (...). Bodies that do not approach keep their motion.
        Momentum and angular momentum are kept to rounding, and energy is never gained. Beyond the
        range of a table without values there, velocities and spins are NaN. Raises InvalidInput for
        a normal of length 0 and for numbers that are not finite.

        Parameters:
            velocity, second_velocity: c, with a material m/s.
            spin, second_spin: c/R of the first, with a material rad/s.
            normal: From the first to the second, of any length but 0.
            friction: May be left out where it is known.
            radius, second_radius: Radii in a mixture, in R of the first, with a material in m.
        """
        rubbing = self._friction(friction)
        radii = None if radius is None else self._radii(radius, second_radius)
        motions = (velocity, second_velocity, spin, second_spin, normal)
        return collided(self._core, encounter(self.body, self.against), self.body, motions, rubbing, radii)

    def __repr__(self) -> str:
        speeds, unit = brief_range(*map(float, self._given_speed[[0, -1]])), self._given_unit[0]
        ratio = f", ratio={brief_range(float(self.ratio[0]), float(self.ratio[-1]))}" if self.ratio.size > 1 else ""
        friction = "any friction" if self.friction is None else f"friction={self.friction:g}"
        normal, along = self.greatest_error
        return (
            f"CollisionRule({shown(self.body, self.against)}, speed={speeds} {unit}{ratio}, {friction}: "
            f"{self.sliding.size} values, errors below {normal:.2g} of ε_n and {along:.2g} of s′)"
        )

    @property
    def greatest_error(self) -> tuple[float, float]:
        """Errors of ε_n, and of s′ over |v_t| + |Ω₁|R₁ + |Ω₂|R₂ + μv_n, anywhere in the range."""
        return self._core.errors()

    @property
    def nodes(self) -> tuple[Array, Array]:
        """What is interpolated, of ε_n and of q: for each place the value and its derivatives.

        The last axis has the value, then for ln v_n, z and (r − 1)/(r + 1), as far as they have
        more than one place, the derivatives by it of all that came before.
        """
        normal, along = self._core.nodes()
        return normal.reshape(*self.restitution.shape, -1), along.reshape(*self.sliding.shape, -1)

    @documented
    def to_c(self, path: str | os.PathLike[str], *, name: str = "stoss") -> None:
        """Write the rule as a header in C, which C++ takes too.

        It defines ``stoss_rule_restitution``, ``stoss_rule_sliding``, their errors, and
        ``stoss_rule_collide_2d`` and ``_3d``, which change velocities and spins, in C89 and with
        <math.h> only. Speeds are in the unit in which the rule is called. The file appears whole or
        not at all.

        Parameters:
            name: Prefix of the names in C.

        Examples:
            >>> rule = stoss.collision_rule(stoss.Sphere(poisson=0.3), speed=(1e-3, 1e-2))
            >>> rule.to_c("rule.h")
        """
        self._write_code("c_header", path, name)

    @documented
    def to_json(self, path: str | os.PathLike[str]) -> None:
        """Write all that the rule holds as JSON. The file appears whole or not at all."""
        document = {"format": _files.RULE, "version": _core.version, **self.to_dict()}
        write_lines(path, [json.dumps(document), "\n"])

    @documented
    def to_netcdf(self, path: str | os.PathLike[str]) -> None:
        """Write the columns of `to_csv` as NetCDF-4, along speed, slip and ratio. Needs netCDF4."""
        columns, dimensions = self._arranged_columns()
        _netcdf.write_columns(os.fspath(path), columns, dimensions, self._units_of(columns), self._inputs(), _files.RULE)

    @functools.cached_property
    def _core(self) -> _core.RuleTable:
        sliding = (
            self.speed, self.slip, self.ratio,
            self.sliding.ravel(), self.sliding_error.ravel(), self.sliding_interpolation_error.ravel(),
        )  # fmt: skip
        restitution = (
            self.restitution_speed, self.restitution_slip, self.restitution_ratio,
            self.restitution.ravel(), self.restitution_error.ravel(), self.restitution_interpolation_error.ravel(),
        )  # fmt: skip
        return _core.make_rule(restitution, sliding, self.alike, self.friction, self.beyond)

    def _friction(self, friction: ArrayLike | None) -> Array:
        if friction is None and self.friction is None:
            raise refusal("friction", friction, "a coefficient, 0 or more (this rule is for any)")
        return numbers("friction", self.friction if friction is None else friction)

    def _radii(self, radius: ArrayLike, second_radius: ArrayLike | None) -> tuple[Array, Array]:
        unit = 1.0 if self.body.material is None else self.body.scales.length
        second = radius if second_radius is None else second_radius
        radii = numbers("radius", radius) / unit, numbers("second_radius", second) / unit
        for name, each in zip(("radius", "second_radius"), radii):
            if not np.all(each > 0):
                raise InvalidInput.out_of_range(name, f"{np.min(each):g}", "positive ones")
        return radii

    def _of(self, speed: Any, sliding: Any, friction: Any, ratio: Any) -> Array:
        slips = in_c(self.body, numbers("sliding", sliding))
        others = {"sliding": slips, "friction": self._friction(friction), "ratio": numbers("ratio", ratio)}
        return self._at(self._core.evaluate, speed, **others)

    def _columns(self) -> dict[str, Column]:
        places = np.meshgrid(self.speed, self.slip, self.ratio, indexing="ij")
        columns = dict(zip(("speed", "slip", "ratio"), places))
        columns |= {"sliding": self.sliding, "sliding_error": self.sliding_error}
        speed, slip, ratio = places
        friction = 1.0 if self.friction is None else self.friction
        last = np.minimum(slip, 1 - 1e-12)
        found = self._core.evaluate(
            *(np.ascontiguousarray(each).ravel() for each in
              (speed, friction * speed * (1 + last) / (1 - last), np.full_like(speed, friction), ratio))
        ).reshape(4, *speed.shape)  # fmt: skip
        columns |= {"restitution": found[0], "restitution_error": found[1]}
        return columns | {name: np.broadcast_to(each[:, None, None], speed.shape) for name, each in self._derived().items()}

    def _arranged_columns(self) -> tuple[dict[str, Column], tuple[str, ...]]:
        return self._columns(), ("speed", "slip", "ratio")


def _shown(values: Array) -> Any:
    return values if values.ndim else float(values)
