"""SI values of results of bodies that have a material."""

from __future__ import annotations

from typing import Any

from stoss._bodies import Body, Rod
from stoss._material import Material, Scales
from stoss._result import Number


class InSi:
    """SI values, as names that end in _si."""

    body: Body | None
    speed: Any
    contact_time: Any
    max_force: Any
    max_compression: Any

    @property
    def material(self) -> Material | None:
        """What the first body is made of, if that is known."""
        return None if self.body is None else self.body.material

    def _scales(self, name: str) -> Scales:
        if self.body is None or self.body.material is None:
            raise AttributeError(f"{name}: this result has no material (make its body with one)")
        return self.body.scales

    def _of_a_rod(self) -> bool:
        return isinstance(self.body, Rod)

    @property
    def speed_si(self) -> Number:
        """Speed before the impact, m/s."""
        return self.speed * self._scales("speed_si").speed  # type: ignore[no-any-return]

    @property
    def contact_time_si(self) -> Number:
        """Contact time, s."""
        return self.contact_time * self._scales("contact_time_si").time  # type: ignore[no-any-return]

    @property
    def max_force_si(self) -> Number:
        """Greatest force: of a disk per thickness, N/m; of a rod, N."""
        return self.max_force * self._scales("max_force_si").force  # type: ignore[no-any-return]

    @property
    def max_compression_si(self) -> Number:
        """Greatest compression, m."""
        return self.max_compression * self._scales("max_compression_si").length  # type: ignore[no-any-return]

    def _derived(self) -> dict[str, Any]:
        names = [name for name in SI_COLUMNS if hasattr(type(self), name)]
        return {name: getattr(self, name) for name in names} if self.material is not None else {}


class InSiWithErrors(InSi):
    """The errors too."""

    contact_time_error: Any
    max_force_error: Any
    max_compression_error: Any

    @property
    def contact_time_si_error(self) -> Number:
        """Error of the contact time, s."""
        return self.contact_time_error * self._scales("contact_time_si_error").time  # type: ignore[no-any-return]

    @property
    def max_force_si_error(self) -> Number:
        """Error of the greatest force, N/m or N."""
        return self.max_force_error * self._scales("max_force_si_error").force  # type: ignore[no-any-return]

    @property
    def max_compression_si_error(self) -> Number:
        """Error of the greatest compression, m."""
        scales = self._scales("max_compression_si_error")
        return self.max_compression_error * scales.length  # type: ignore[no-any-return]


SI_COLUMNS = (
    "speed_si", "contact_time_si", "contact_time_si_error", "max_force_si", "max_force_si_error",
    "max_compression_si", "max_compression_si_error",
)  # fmt: skip
