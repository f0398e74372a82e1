"""What a receiver on or in a half-space or a plate records of an impact. A method of `Pulse`."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import integer
from stoss.bodies._encounter import encounter
from stoss.bodies._solid import own_number
from stoss.results._quantities import RecordedInstantQuantities, Si
from stoss.results._result import RowResult, columns, picture
from stoss.results._si import InSi
from stoss.results._waveforms import Waveforms


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Seismogram(RecordedInstantQuantities, Waveforms, RowResult, InSi):
    """Motion of a receiver in time, with its error: displacement and velocity, and the force behind.

    ``len()`` is the number of times, an index a row as a dict. Of a point in the depth `normal` is
    into the depth, which is away from the body that hits: on the other face of a plate, outwards.

    Attributes:
        pulse (Pulse): The force that moves it; units are those of its first body.
        distance: Of the receiver along the surface from the first point of contact, R.
        depth: Below the surface that is hit, R.
        arrival: Time of the first wave, straight from the contact, R/c.
    """

    plot = picture("Displacement and velocity against time, with errors. See `stoss.plot.seismogram`.")
    _name: ClassVar[str] = "seismogram"
    _axis: ClassVar[str] = "time"
    _told = ("pulse", "distance", "depth", "arrival")
    _units = {"distance_si": "m", "depth_si": "m", "arrival_si": "s"}
    _traces: ClassVar[tuple[str, ...]] = ("normal", "radial", "normal_velocity", "radial_velocity")

    distance_si = Si("Distance of the receiver, m.")
    depth_si = Si("Depth of the receiver, m.")
    arrival_si = Si("Time of the first wave, s.")

    pulse: Any
    distance: float
    depth: float
    arrival: float

    @property
    def body(self) -> Any:
        """The body that hits, in whose units it is."""
        return self.pulse.body

    def __repr__(self) -> str:
        shown, unit = ("_si", "m") if self.material is not None else ("", "R")
        speed, seconds = ("m/s", "s") if shown else ("c", "R/c")
        distance, depth, time = (getattr(self, name + shown) for name in ("distance", "depth", "time"))
        normal, velocity = (np.abs(getattr(self, name + shown)).max() for name in ("normal", "normal_velocity"))
        return (
            f"Seismogram({distance:.6g} {unit} along the surface, {depth:.6g} {unit} deep: at most {normal:.3g} {unit} "
            f"and {velocity:.3g} {speed}, {len(self)} times to {time[-1]:.3g} {seconds})"
        )

    @classmethod
    def _dimensions(cls) -> dict[str, str]:
        return {**super()._dimensions(), "distance": "length", "depth": "length", "arrival": "time"}

    def _axis_column(self) -> str:
        return "time"

    def _table(self) -> dict[str, NDArray[Any]]:
        return {name: np.asarray(getattr(self, name)) for name in super()._dimensions()}

    def _columns(self) -> dict[str, NDArray[Any]]:
        many = {name: each for name, each in self._derived().items() if np.ndim(each)}
        return self._table() | {name: np.asarray(each) for name, each in many.items()}


def seismogram_of(pulse: Any, distance: Any, depth: Any, until: Any, points: Any) -> Seismogram:
    """That of a receiver, as it comes from a user."""
    given = {"distance": distance, "depth": depth}
    place: dict[str, Any] = {name: own_number(pulse.body, "pulse", name, each) for name, each in given.items()}
    last = 0.0 if until is None else own_number(pulse.body, "pulse", "until", until)
    numbers, rows = _core.seismogram(
        encounter(pulse.body, pulse.against), pulse._handle, place["distance"], place["depth"], last,
        integer("points", points),
    )  # fmt: skip
    held: dict[str, Any] = {name: np.array(column) for name, column in columns(rows).items()}
    for column in held.values():
        column.flags.writeable = False
    return Seismogram(pulse=pulse, arrival=numbers["arrival"], **place, **held)
