"""ε as a function of the speed and of the ratio of radii."""

from __future__ import annotations

import dataclasses
import functools
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import boolean, choice, integer, number, numbers, refusal
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body, Disk, Sphere, shown
from stoss.bodies._encounter import choose_against, choose_body, encounter
from stoss.bodies._solid import is_rigid, own_units
from stoss.export._tables import brief_range
from stoss.results._progress import waiting
from stoss.results._result import Column, picture
from stoss.results._si import Evaluated, warn_at


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class PairTable(Evaluated):
    """ε of two bodies of any sizes: call it with speeds and ratios of radii, get values.

    Between computed values it is a cubic in ln v and one in (r − 1)/(r + 1). Speeds are those of
    approach, in c of the first body or, with a material, in m/s; their sign does not count. Made by
    `pair_table`.

    Attributes:
        body, against: The two; their radii do not count.
        alike: Whether they are of one material: a ratio and its inverse are then the same pair.
        speed, ratio: Places of the computed values, rising; speeds in c.
        interpolation_error: Error of the interpolation between them; one element less each way.

    Examples:
        >>> epsilon = stoss.pair_table(poisson=0.33, ratio=(1, 1.5), speed=(0.01, 0.2), error=1e-2)
        >>> round(epsilon(0.1, 1.2), 2), epsilon.error(0.1, 1.2) < 1e-2
        (0.96, True)
    """

    plot = picture("ε against speed for some ratios. See `stoss.plot.pair_table`.")
    _name: ClassVar[str] = "pair table"
    _given = {"speed": "speed"}
    _told = ("body", "against", "beyond")

    body: Body
    against: Body
    beyond: str
    alike: bool
    speed: NDArray[np.float64]
    ratio: NDArray[np.float64]
    restitution: NDArray[np.float64]
    restitution_error: NDArray[np.float64]
    interpolation_error: NDArray[np.float64]

    def __call__(self, speed: ArrayLike, ratio: ArrayLike) -> Any:
        """ε: a float for two numbers, otherwise an array of the shape to which they broadcast."""
        return self._of(speed, ratio, self._core.values)

    def error(self, speed: ArrayLike, ratio: ArrayLike) -> Any:
        """Error of ε, interpolation included; infinite where it is unknown."""
        return self._of(speed, ratio, self._core.errors)

    def __repr__(self) -> str:
        speeds, unit = brief_range(*map(float, self._given_speed[[0, -1]])), self._given_unit[0]
        ratios = brief_range(float(self.ratio[0]), float(self.ratio[-1]))
        met = "" if self.alike else f" against {shown(self.against)}"
        return (
            f"PairTable({shown(self.body)}{met}, speed={speeds} {unit}, ratio={ratios}: "
            f"{self.speed.size} speeds, {self.ratio.size} ratios, error below {self.greatest_error:.2g})"
        )

    @property
    def greatest_error(self) -> float:
        """Error of ε anywhere in the range."""
        return self._core.greatest_error()

    @functools.cached_property
    def _core(self) -> _core.PairTable:
        grids = (self.speed, self.ratio, self.restitution, self.restitution_error, self.interpolation_error)
        speed, ratio, value, bars, interpolation = (np.ascontiguousarray(each).ravel() for each in grids)
        return _core.make_pair_table(speed, ratio, value, bars, interpolation, self.alike, self.beyond)

    def _columns(self) -> dict[str, Column]:
        columns = {
            "speed": self.speed[:, np.newaxis],
            "ratio": self.ratio,
            "restitution": self.restitution,
            "restitution_error": self.restitution_error,
            "interpolation_error": np.pad(self.interpolation_error, (0, 1)),  # of the cell that begins there
        }
        columns |= {name: each[:, np.newaxis] for name, each in self._derived().items()}
        return {name: np.broadcast_to(each, self.restitution.shape) for name, each in columns.items()}

    def _arranged_columns(self) -> tuple[dict[str, Column], tuple[str, ...]]:
        return self._columns(), ("speed", "ratio")

    def _of(self, speed: ArrayLike, ratio: ArrayLike, function: Any) -> Any:
        values = self._at(function, speed, ratio=numbers("ratio", ratio))
        return values if values.ndim else float(values)


@documented
def pair_table(
    body: Body | None = None,
    *,
    speed: ArrayLike,
    ratio: ArrayLike,
    against: Body | str = "same",
    poisson: float | None = None,
    error: float = 1e-3,
    beyond: str = "error",
    threads: int = 0,
    progress: bool = False,
) -> PairTable:
    """Compute ε of two bodies as a function of the speed and of the ratio of their radii.

    For mixtures: of elastic disks or spheres of given materials ε depends on v/c and on the ratio
    of the radii alone. Speeds and ratios are added where the values computed so far do not predict
    those between them. A table for ratios of 1 to 3 takes seconds. Lossy and rigid bodies are refused.

    Parameters:
        body: The first, elastic; its radius does not count.
        speed (tuple of two float): Slowest and fastest speed of approach, 1e-8 to 1, c (with a
            material: m/s).
        ratio (tuple of two float): Smallest and largest radius of the second over that of the
            first, 1e-3 to 1e3; of spheres to some 50.
        against ('same', Disk or Sphere, optional): The second. Default: of the same material; a
            ratio and its inverse are then the same.
        error: Maximum error of ε, interpolation included, 1e-6 to 0.1.
        beyond ({'error', 'clamp'}, optional): Beyond the range, refuse, or give
            the value at the nearest edge, with an infinite error.

    Examples:
        >>> epsilon = stoss.pair_table(stoss.Disk(poisson=0.33), ratio=(1, 2), speed=(0.01, 0.3), error=5e-3)
        >>> round(epsilon(0.1, 2.0), 2), epsilon.error(0.1, 2.0) < 5e-3, epsilon([[0.02], [0.1]], [1.1, 1 / 1.1]).shape
        (0.85, True, (2, 2))
    """
    chosen = choose_body(body, poisson)
    met = choose_against(chosen, against, ())
    if not isinstance(chosen, (Disk, Sphere)) or not isinstance(met, (Disk, Sphere)) or is_rigid(met):
        raise refusal("against", against, "two elastic disks or two elastic spheres")
    ranges = {"speed": numbers("speed", speed), "ratio": numbers("ratio", ratio)}
    for name, ends in ranges.items():
        if ends.shape != (2,):
            raise InvalidInput.out_of_range(
                name, f"an array of shape {ends.shape}", "two numbers, smallest and largest"
            )
    outside = choice("beyond", beyond, ("error", "clamp"))
    limit, count = number("error", error), integer("threads", threads)
    speeds, ratios = (each.tolist() for each in own_units(chosen, "table", **ranges))
    with waiting(boolean("progress", progress), "pair_table"):
        made = _core.adaptive_pair_table(encounter(chosen, met), speeds, ratios, limit, count)
    v, r, value, bars, interpolation, alike = made.given()
    shape = (v.size, r.size)
    grids = [v, r, value.reshape(shape), bars.reshape(shape), interpolation.reshape(v.size - 1, r.size - 1)]
    for grid in grids:
        grid.flags.writeable = False
    warn_at(chosen, met, v, 2)
    return PairTable(chosen, met, outside, alike, *grids)
