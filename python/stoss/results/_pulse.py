"""The force of an impact in time, and its spectrum."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import boolean, integer, number
from stoss._documentation import documented
from stoss._errors import NotConverged
from stoss.bodies._bodies import Body, shown
from stoss.bodies._encounter import Against, choose_against, choose_body, refinable
from stoss.bodies._solid import own_number
from stoss.bodies._state import State, choose_state
from stoss.bodies._walls import Unbounded, Wall
from stoss.export._tables import with_error
from stoss.results._progress import waiting
from stoss.results._quantities import PulseQuantities, Si
from stoss.results._result import Column, picture
from stoss.results._seismogram import Seismogram, seismogram_of
from stoss.results._si import MayYield, warn_of_materials
from stoss.results._waveforms import Waveforms


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Pulse(PulseQuantities, Waveforms, MayYield):
    """The force of an impact in time, with its error, and its spectrum.

    Columns, of `to_csv` and the like, are time, force and the error of the force.

    Attributes:
        tolerance: Asked for: error of the force at any time over its maximum.
        time: From where unexcited bodies would touch, R/c, evenly spaced.
        force, force_error: At these times, mc²/R: πRE of a disk, (4π/3)R²E of a sphere; and its estimated
            error.
        hertz: Force of the pulse of Hertz' theory of these bodies; nan of what does not touch on a circle.
        frequency: Angular frequencies of the spectrum from 0 to beyond the first null, c/R.
        amplitude, amplitude_error: |∫F e^{-iωt} dt| over the impulse; and its estimated error.
        reason: Why it is not converged; empty where it is.
    """

    plot = picture("F(t) with its error, beside Hertz' pulse. See `stoss.plot.pulse`.")
    spectrum = picture("Spectrum of the force. See `stoss.plot.pulse_spectrum`.", "spectrum")
    _name: ClassVar[str] = "pulse"
    _axis: ClassVar[str] = "time"
    _told = ("body", "against", "speed", "tolerance", "threshold", "state")
    _given = {"speed": "speed", "time": "time", "force": "force", "force_error": "force", "hertz": "force",
              "frequency": "frequency"}  # fmt: skip
    _traces: ClassVar[tuple[str, ...]] = ("force",)

    time_si = Si("Time, s.")
    force_si = Si("Force, N, of a disk N/m.")
    force_si_error = Si("Estimated error of `force_si`.")
    hertz_si = Si("Force of Hertz' pulse, N.")
    frequency_si = Si("Angular frequency, rad/s.")

    body: Body
    against: Against
    speed: float
    tolerance: float
    state: NDArray[Any] | None
    time: NDArray[np.float64]
    force: NDArray[np.float64]
    force_error: NDArray[np.float64]
    hertz: NDArray[np.float64]
    frequency: NDArray[np.float64]
    amplitude: NDArray[np.float64]
    amplitude_error: NDArray[np.float64]
    reason: str
    _handle: _core.Pulse = dataclasses.field(repr=False)

    def __len__(self) -> int:
        return self.time.size

    def __repr__(self) -> str:
        force = f"{with_error(self.peak_force, self.peak_force_error)} mc²/R"
        lasts = f"{with_error(self.contact_time, self.contact_time_error)} {self._unit('contact_time')}"
        if self.material is not None:
            force, lasts = f"{self.peak_force_si:.6g} N", f"{self.contact_time_si:.6g} s"
        ends = f"restitution {self.restitution:.5f}{'' if self.converged else ', not converged'}"
        return f"Pulse({shown(self.body, self.against)}, speed={self.speed:.6g} c: {force} for {lasts}, {ends})"

    def at(
        self, distance: float = 0.0, depth: float = 0.0, *, until: float | None = None, points: int = 500
    ) -> Seismogram:
        """Motion of a point of the half-space or the plate that is met, in time: what a sensor there records.

        The material is elastic. The contact is as large as it is, with Hertz's pressure. A value of a
        half-space takes 0.1 s, one of a plate up to 2 s.

        Parameters:
            distance (float, optional): Along the surface from the first point of contact, R (with
                materials: m).
            depth (float, optional): Below the surface that is hit; the thickness of a plate: on its other
                face.
            until (float, optional): Last time, R/c (with materials: s). Default: when all waves have passed,
                of a plate with its first echoes.
            points (int, optional): Number of times from first touch on, 2 to 20000.

        Examples:
            >>> ball = stoss.Sphere(radius=1.5e-3, material=stoss.materials["bearing steel"])
            >>> block = stoss.Plate(thickness=0.05, material=stoss.materials["glass"])
            >>> hit = stoss.pulse(ball, speed=1.0, against=block)
            >>> below = hit.at(depth=0.05)
            >>> below
            Seismogram(0 m along the surface, 0.05 m deep: at most 7.96e-09 m and 0.00129 m/s, 500 times to 0.000104 s)
        """
        return seismogram_of(self, distance, depth, until, points)

    def __reduce__(self) -> tuple[Any, ...]:
        # Repeated, which gives the same bits, rather than written.
        return _computed, (self.body, self.against, self.speed, self.tolerance, self.threshold, len(self), self.state)

    def _columns(self) -> dict[str, Column]:
        columns = {"time": self.time, "force": self.force, "force_error": self.force_error}
        if self.material is not None:
            columns |= {name: np.asarray(getattr(self, name)) for name in ("time_si", "force_si", "force_si_error")}
        return columns

    def _derived(self) -> dict[str, Any]:
        known = super()._derived()
        return {name: each for name, each in known.items() if name != "hertz_si" or np.isfinite(each).all()}


@documented
def pulse(
    body: Body | None = None,
    *,
    speed: float,
    against: Wall | Body | Unbounded | str | None = None,
    poisson: float | None = None,
    tolerance: float = 1e-2,
    threshold: float = 1e-2,
    points: int = 400,
    state: State = None,
    progress: bool = False,
) -> Pulse:
    """Force of one impact in time to a tolerance, with its error, its duration and its spectrum.

    The cutoff rises until the error of the force at any time, between flat ends that of its maximum, is
    below `tolerance` times the maximum. If that cannot be met, it raises `NotConverged`. Rough,
    yielding and lossy bodies are as for `restitution`.

    Parameters:
        tolerance: Error of the force at any time over its maximum, 1e-5 to 0.5.
        threshold: Share of the maximum above which `duration` is taken, 0 to 0.9.
        points: Number of times, and of frequencies, 16 to 100000.

    Examples:
        >>> hit = stoss.pulse(stoss.Sphere(poisson=0.3), speed=0.01)
        >>> hit.peak_force_error < 0.01 * hit.peak_force, len(hit)
        (True, 400)
        >>> round(hit.from_hertz, 2)
        0.17
        >>> abs(hit.force.sum() * (hit.time[1] - hit.time[0]) - hit.impulse) < 1e-4 * hit.impulse
        True
    """
    chosen = choose_body(body, poisson, rigid=True)
    initial = own_number(chosen, "pulse", "speed", speed)
    met = choose_against(chosen, against)
    limit, share, count = number("tolerance", tolerance), number("threshold", threshold), integer("points", points)
    with waiting(boolean("progress", progress), "pulse"):
        result = _computed(chosen, met, initial, limit, share, count, state)
    if not result.converged:
        raise NotConverged(f"pulse: {result.reason}", result)
    warn_of_materials(result, 2)
    return result


def _computed(
    body: Body, against: Against, speed: float, tolerance: float, threshold: float, points: int, state: Any
) -> Pulse:
    modes = choose_state(state)
    handle = _core.pulse(refinable(body, against), speed, tolerance, threshold, points, modes)
    return Pulse(
        body=body, against=against, speed=speed, tolerance=tolerance, state=modes if modes.size else None,
        reason=handle.reason(), _handle=handle, **handle.series(), **handle.numbers(),
    )  # fmt: skip
