"""What stoss computes of the impacts that were measured, and how it answers to constants."""

from __future__ import annotations

import dataclasses
import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stoss._errors import InvalidInput, StossWarning
from stoss.bodies._bodies import Disk, Sphere
from stoss.bodies._encounter import choose_against, encounter, yield_speed_of
from stoss.bodies._faces import LENGTHS_OF_FACE
from stoss.bodies._solid import own_units
from stoss.bodies._walls import UNBOUNDED
from stoss.calibration._constants import Meeting
from stoss.calibration._data import Data
from stoss.results._impact import impact
from stoss.results._oblique import oblique
from stoss.results._restitution import restitution

Array = NDArray[np.float64]

TOLERANCE, ABSOLUTE, TOLERANCE_OF_SLIDING = 1e-3, 1e-5, 3e-3
COARSE, RADIANS = 8.0, 60.0
"""The cutoff of cheap impacts, c/R; on blocks this over the contact time: the number of modes grows with its square."""

FIELDS = {
    "restitution": ("restitution", "restitution_error"),
    "contact_time": ("contact_time_si", "contact_time_si_error"),
    "peak_force": ("max_force_si", "max_force_si_error"),
}


class Impacts:
    """The measured impacts, of any bodies.

    Cheap values are those of single impacts. Their errors are nearly the same for bodies that are nearly the same, so
    that differences of them are good.
    """

    def __init__(self, data: Data) -> None:
        central = np.flatnonzero(data.quantity != "tangential_restitution")
        self._speeds, self._which = np.unique(data.speed[central], return_inverse=True)
        self._rows = {name: central[data.quantity[central] == name] for name in FIELDS}
        self._of = {name: self._which[data.quantity[central] == name] for name in FIELDS}
        self._oblique = np.flatnonzero(data.quantity == "tangential_restitution")
        self._data = data
        self._cheap: list[dict[str, Any]] = []

    def computed(self, meeting: Meeting) -> tuple[Array, Array]:
        """Values to the tolerance, with their errors."""
        values, errors = self._tangential(meeting)
        if self._speeds.size:
            body, against = real(meeting, float(self._speeds[-1]))
            found = restitution(body, against=against, speed=self._speeds, tolerance=TOLERANCE, absolute=ABSOLUTE)
            self._cheap = [_cheap(body, against, *each) for each in zip(self._speeds, np.ravel(found.contact_time))]
            for name, (field, its_error) in FIELDS.items():
                values[self._rows[name]] = np.ravel(getattr(found, field))[self._of[name]]
                errors[self._rows[name]] = np.ravel(getattr(found, its_error))[self._of[name]]
        if not np.isfinite(values).all():
            at = float(self._data.speed[~np.isfinite(values)][0])
            raise InvalidInput.out_of_range("speed", f"{at:.4g} m/s", "speeds at which there is a law for these bodies")
        return values, errors

    def cheap(self, meeting: Meeting) -> Array:
        """Values of single impacts at the resolutions of the last ones that were `computed`."""
        values, _ = self._tangential(meeting)
        if self._speeds.size:
            body, against = real(meeting, float(self._speeds[-1]))
            with _silence():
                hits = [impact(body, against=against, **how) for how in self._cheap]
            for name, (field, _) in FIELDS.items():
                values[self._rows[name]] = [getattr(hits[k], field) for k in self._of[name]]
        return values

    def _tangential(self, meeting: Meeting) -> tuple[Array, Array]:
        """Values of the oblique impacts, and room for the others."""
        values, errors = np.empty(self._data.speed.size), np.zeros(self._data.speed.size)
        if self._oblique.size:
            body, against = real(meeting, 0.0)
            speed, angle = self._data.speed[self._oblique], self._data.angle[self._oblique]
            with _silence():
                how: dict[str, Any] = {"friction": meeting.friction, "tolerance": TOLERANCE_OF_SLIDING}
                found = oblique(body, against=against, speed=speed, angle=angle, **how)
            values[self._oblique] = found.tangential_restitution
            errors[self._oblique] = found.tangential_restitution_error
        return values, errors


def real(meeting: Meeting, fastest: float) -> tuple[Any, Any]:
    """What meets, with faces that yield where their materials do below that speed; then smooth, as `predict` has it."""
    body, against = meeting.body, meeting.against
    begins = yield_speed_of(body, against) if isinstance(body, Sphere) else None
    if begins is None or fastest <= begins:
        return body, against
    return _yielding(body), against if isinstance(against, str) else _yielding(against)


def _yielding(solid: Any) -> Any:
    strength = getattr(solid, "yield_strength", 0.0) or getattr(solid.material, "yield_strength", None)
    if not strength or not hasattr(solid, "yield_strength"):
        return solid
    return dataclasses.replace(solid, yield_strength=strength, **dict.fromkeys(LENGTHS_OF_FACE, 0.0))


def _cheap(body: Any, against: Any, speed: float, duration: float) -> dict[str, Any]:
    """The cutoff of an impact, and the number of nodes that it has."""
    met = choose_against(body, against)
    (own,) = own_units(body, "restitution", speed=np.array(speed))
    cutoff = encounter(body, met).usual_cutoff(float(own), COARSE)
    if isinstance(met, UNBOUNDED):
        cutoff = min(cutoff, max(RADIANS / duration, 1.0))
    how: dict[str, Any] = {"speed": float(speed), "cutoff": float(cutoff)}
    if isinstance(body, (Disk, Sphere)):
        with _silence():
            how["nodes"] = impact(body, against=against, **how).nodes
    return how


class _silence(warnings.catch_warnings):  # type: ignore[type-arg]
    """Nothing is said of bodies that are tried; of those that are found it is."""

    def __enter__(self) -> None:
        super().__enter__()
        warnings.simplefilter("ignore", StossWarning)
