"""SI values of results of bodies that have a material."""

from __future__ import annotations

import contextlib
import dataclasses
import os
import warnings
from typing import Any, Callable, Iterator, TypeVar

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import broadcast, numbers, refusal
from stoss._documentation import documented
from stoss._errors import Interrupted, InvalidInput, NotConverged, StossWarning
from stoss.bodies._encounter import material_warnings_of, yield_speed_of
from stoss.bodies._material import Material
from stoss.bodies._solid import alone
from stoss.bodies._walls import Plate
from stoss.export._files import write_lines
from stoss.results._quantities import Number, Si
from stoss.results._result import Result


def si_name(name: str) -> str:
    """Name of the SI value of a column: contact_time_error is contact_time_si_error."""
    own = name.removesuffix("_error")
    return f"{own}_si{name[len(own):]}"


class InSi(Result):
    """A result whose first body may have a material."""

    body: Any

    @property
    def material(self) -> Material | None:
        """What the first body is made of, if that is known.

        With a material there are SI values, `speed_si` and so on, and of a sphere with a yield strength `yield_speed`,
        `yield_speed_si` and `beyond_yield`.
        """
        return None if self.body is None else self.body.material

    def _in_si(self, name: str) -> Number:
        """What a column is in SI."""
        if self.material is None:
            raise AttributeError(f"{si_name(name)}: this result has no material (make its body with one)")
        return getattr(self, name) * getattr(self.body.scales, self._dimensions()[name])  # type: ignore[no-any-return]

    def _kind_of_body(self) -> str:
        return "disk" if self.body is None else str(self.body._kind)

    def _derived(self) -> dict[str, Any]:
        if self.material is None:
            return {}
        held = [name for name in self._dimensions() if hasattr(type(self), si_name(name))]
        return {si_name(name): self._in_si(name) for name in held if getattr(self, name) is not None}


class SpeedInSi(InSi):
    """Values at speeds of approach."""

    speed: Any
    speed_si = Si("Speed of approach, m/s.")

    @property
    def _given_speed(self) -> Any:
        """The speed in the unit in which speeds are given."""
        return self.speed if self.material is None else self.speed_si

    @property
    def _given_unit(self) -> tuple[str, float]:
        """That unit, and how many of it are c."""
        return ("c", 1.0) if self.material is None else ("m/s", self.body.scales.speed)

    def _at(self, function: Callable[..., NDArray[Any]], speed: Any, **others: Any) -> NDArray[Any]:
        """What a function of the core has at speeds as they are given, in the shape to which all broadcast."""
        given = broadcast(speed=in_c(self.body, numbers("speed", speed)), **others)
        with told_in_c(self.body):
            found = function(*(each.ravel() for each in given))
        return found.reshape(found.shape[:-1] + given[0].shape)


class Evaluated(SpeedInSi):
    """What a table of the core evaluates at speeds: it is made again where it is needed, and never written."""

    _core: Any

    def __getstate__(self) -> dict[str, Any]:
        return {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}


class Coded(Evaluated):
    """A table that is written as source code: the names in C are those of `to_c`."""

    @documented
    def to_rust(self, path: str | os.PathLike[str], *, name: str = "stoss") -> None:
        """Write a module of Rust with the functions of `to_c`; it needs nothing else.

        Parameters:
            name: Prefix of the names in Rust.
        """
        self._write_code("rust_module", path, name)

    @documented
    def to_js(self, path: str | os.PathLike[str], *, name: str = "stoss") -> None:
        """Write a module of JavaScript that exports the functions of `to_c`.

        Parameters:
            name: Prefix of the names in JavaScript.
        """
        self._write_code("js_module", path, name)

    def _write_code(self, language: str, path: Any, name: Any) -> None:
        """Source code: `c_header`, `rust_module` or `js_module`. The file appears whole or not at all."""
        if not isinstance(name, str):
            raise refusal("name", name, "a str")
        write_lines(path, [getattr(self._core, language)(name, *self._given_unit, self._made_by())])


def in_c(body: Any, speed: NDArray[np.float64]) -> NDArray[np.float64]:
    """Speeds as they are given with this body, of any size, in its c."""
    return speed if body is None else alone(body).in_c(speed.ravel()).reshape(speed.shape)


@contextlib.contextmanager
def told_in_c(body: Any) -> Iterator[None]:
    """Says to a user who thinks in SI what c is where a speed is refused in it."""
    try:
        yield
    except InvalidInput as error:
        if error.name != "speed" or getattr(body, "material", None) is None:
            raise
        raise error.renamed("speed", f"with this material c is {body.scales.speed:.6g} m/s") from None


class MayYield(SpeedInSi):
    """Impacts that may be so fast that a sphere, or what it meets, begins to yield."""

    _units = {"yield_speed": "c", "yield_speed_si": "m/s"}

    @property
    def yield_speed_si(self) -> Number:
        """Speed at which the sphere, or the weaker of two, begins to yield, m/s, once for each value."""
        found = self._yield_speed()
        if found is None:
            raise AttributeError("yield_speed_si: no sphere of this result has a yield strength (see stoss.Material)")
        return found if isinstance(self.speed, float) else np.full(np.shape(self.speed), found)

    @property
    def yield_speed(self) -> Number:
        """The same in c."""
        return self.yield_speed_si / self.body.scales.speed  # type: ignore[no-any-return]

    @property
    def beyond_yield(self) -> bool | NDArray[np.bool_]:
        """Whether the impact is faster: the elastic results are then bounds."""
        return self.yield_speed_si < self.speed_si

    def _yield_speed(self) -> float | None:
        return yield_speed_of(self.body, getattr(self, "against", None))

    def _derived(self) -> dict[str, Any]:
        names = ("yield_speed", "yield_speed_si", "beyond_yield")
        yielding = {} if self._yield_speed() is None else {name: getattr(self, name) for name in names}
        return super()._derived() | yielding


def warn_of_doubt(converged: Any, said: str, stacklevel: int) -> None:
    """A warning, as from that many calls above, of values or samples that are not as accurate as asked for."""
    doubtful = np.size(converged) - np.count_nonzero(converged)
    if doubtful:
        text = f"{doubtful} of {np.size(converged)} {said} not as accurate as asked for (see .converged, .reason)"
        warnings.warn(text, StossWarning, stacklevel=stacklevel + 1)


Curve = TypeVar("Curve", bound=MayYield)


def finished(curve: Curve, done: int | None) -> Curve:
    """The values that a function has computed, for its return: with what its user must be told of them.

    Parameters:
        done: How many there are where Ctrl-C has stopped it.
    """
    result: Any = curve
    if done is not None:
        said = f"interrupted after {done} of {np.size(result.reason)} values (they are in .best)"
        raise Interrupted(f"{curve._name}: {said}", curve)
    if isinstance(result.reason, str):  # one value
        if not result.converged:
            raise NotConverged(f"{curve._name}: {result.reason}", curve)
    else:
        warn_of_doubt(result.converged, "values", 3)
    warn_of_limits(curve, 3)
    warn_of_materials(curve, 3)
    return curve


def warn_of_materials(result: MayYield, stacklevel: int) -> None:
    """Warnings, as from that many calls above, of what materials do that was not computed."""
    warn_at(result.body, getattr(result, "against", None), result.speed, stacklevel + 1)


def warn_at(body: Any, against: Any, speed: Any, stacklevel: int) -> None:
    """The same of bodies at speeds in c."""
    if getattr(body, "material", None) is None or np.size(speed) == 0:
        return
    for said in material_warnings_of(body, against, float(np.max(speed)) * body.scales.speed):
        warnings.warn(said, StossWarning, stacklevel=stacklevel + 1)


BEYOND = {
    "stays": ("", ""),
    "beyond_small_strain": (
        "strain", "strain of some {:.3g}, above 0.1: linear elasticity is no longer accurate there"
    ),
    "beyond_small_turn": (
        "turned",
        "the bodies turn by {:.2g} rad while they touch, and their contact rolls by more than its half-width: linear"
        " kinematics is no longer accurate there",
    ),
}
"""Flags of results, and of those that no model describes well the quantity and what is said of its maximum."""


def warn_of_limits(result: Any, stacklevel: int) -> None:
    """Warnings, as from that many calls above, of bodies that stay, or deform or turn too much for what is computed."""
    for flag, (quantity, said) in BEYOND.items():
        beyond = np.asarray(getattr(result, flag, False))
        if np.any(beyond):
            most = np.max(np.asarray(getattr(result, quantity))[beyond]) if quantity else 0.0
            text = said.format(most) or _core.note_of_staying()
            warnings.warn(text, StossWarning, stacklevel=stacklevel + 1)
    values = np.asarray(getattr(result, "restitution", np.nan), dtype=float)
    if isinstance(getattr(result, "against", None), Plate) and np.any(values > 0.0):
        if text := _core.note_of_a_plate(float(np.min(values[values > 0.0]))):
            warnings.warn(text, StossWarning, stacklevel=stacklevel + 1)
