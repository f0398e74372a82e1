"""SI values of results of bodies that have a material."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stoss.bodies._bodies import Body
from stoss._errors import StossWarning
from stoss.bodies._material import Material
from stoss.results._result import Number, Result
from stoss.bodies._yielding import yield_speed_of


def si_name(name: str) -> str:
    """Name of the SI value of a column: contact_time_error is contact_time_si_error."""
    own = name.removesuffix("_error")
    return f"{own}_si{name[len(own):]}"


class SpeedInSi(Result):
    """The speed in SI, where the body has a material."""

    body: Any
    speed: Any

    @property
    def speed_si(self) -> Number:
        """Speed of approach, m/s."""
        if self.body.material is None:
            raise AttributeError("speed_si: this result has no material (make its body with one)")
        return self.speed * self.body.scales.speed  # type: ignore[no-any-return]

    def _kind_of_body(self) -> str:
        return str(self.body._kind)

    def _derived(self) -> dict[str, Any]:
        return {} if self.body.material is None else {"speed_si": self.speed_si}


class InSi(Result):
    """SI values, as names that end in _si; of spheres with a yield strength, where yielding begins."""

    _units = {"yield_speed": "c", "yield_speed_si": "m/s"}

    body: Body | None
    speed: Any
    contact_time: Any
    max_force: Any
    max_compression: Any

    @property
    def material(self) -> Material | None:
        """What the first body is made of, if that is known."""
        return None if self.body is None else self.body.material

    def _in_si(self, name: str) -> Number:
        """What a column is in SI, by its dimension."""
        if self.body is None or self.body.material is None:
            raise AttributeError(f"{si_name(name)}: this result has no material (make its body with one)")
        return getattr(self, name) * getattr(self.body.scales, self._dimensions()[name])  # type: ignore[no-any-return]

    def _kind_of_body(self) -> str:
        return "disk" if self.body is None else self.body._kind

    @property
    def speed_si(self) -> Number:
        """Speed before the impact, m/s."""
        return self._in_si("speed")

    @property
    def contact_time_si(self) -> Number:
        """Contact time, s."""
        return self._in_si("contact_time")

    @property
    def max_force_si(self) -> Number:
        """Maximum force: of a disk per thickness, N/m; of a sphere or a rod, N."""
        return self._in_si("max_force")

    @property
    def max_compression_si(self) -> Number:
        """Maximum compression, m."""
        return self._in_si("max_compression")

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
        return self.yield_speed_si / self.body.scales.speed  # type: ignore[union-attr]

    @property
    def beyond_yield(self) -> bool | NDArray[np.bool_]:
        """Whether the impact is faster: the elastic results are then bounds."""
        return self.yield_speed_si < self.speed_si

    def _yield_speed(self) -> float | None:
        return yield_speed_of(self.body, getattr(self, "against", None))

    def _derived(self) -> dict[str, Any]:
        if self.material is None:
            return {}
        names = [si_name(name) for name in self._dimensions() if hasattr(type(self), si_name(name))]
        if self._yield_speed() is not None:
            names += ["yield_speed", "yield_speed_si", "beyond_yield"]
        return {name: getattr(self, name) for name in names}


def warn_of_yielding(result: InSi, stacklevel: int) -> None:
    """A warning, as from that many calls above, if impacts are faster than the speed at which yielding begins."""
    found = result._yield_speed()
    if found is not None and np.any(result.beyond_yield):
        hint = "see .beyond_yield: elastic values are bounds there"
        text = f"speed above {found:.4g} m/s, where yielding begins ({hint})"
        warnings.warn(text, StossWarning, stacklevel=stacklevel + 1)


class InSiOfAnImpact(InSi):
    """SI values of an impact that was computed step by step."""

    impulse_time: Any

    @property
    def impulse_time_si(self) -> Number:
        """Time between 1 % and 99 % of the impulse, s."""
        return self._in_si("impulse_time")


class InSiWithErrors(InSiOfAnImpact):
    """The errors too."""

    contact_time_error: Any
    impulse_time_error: Any
    max_force_error: Any
    max_compression_error: Any

    @property
    def contact_time_si_error(self) -> Number:
        """Error of the contact time, s."""
        return self._in_si("contact_time_error")

    @property
    def impulse_time_si_error(self) -> Number:
        """Error of the impulse time, s."""
        return self._in_si("impulse_time_error")

    @property
    def max_force_si_error(self) -> Number:
        """Error of the maximum force, N/m or N."""
        return self._in_si("max_force_error")

    @property
    def max_compression_si_error(self) -> Number:
        """Error of the maximum compression, m."""
        return self._in_si("max_compression_error")
