"""What measurements say of single impacts.

Whatever was measured becomes values of ε, ε_t, contact time or peak force at a speed of impact, with one covariance:
successive values of a bouncing ball share times, and so their errors.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from stoss._arguments import refusal
from stoss._errors import InvalidInput
from stoss.calibration._air import Flight
from stoss.calibration._table import UNCERTAINTY, VALUES, Given, columns_of


@dataclasses.dataclass(frozen=True)
class Data:
    """Values of single impacts.

    Attributes:
        quantity: Which of `VALUES` each is.
        speed: Of approach along the normal, m/s.
        angle: From the normal, degrees; 0 of central impacts.
        value: As measured, after what the air has taken.
        covariance: Covariance of the values; if their uncertainties are not known, of the relative size that they share.
        known: Whether the uncertainties are known.
        flies: Whether heights or times of flight were given.
    """

    quantity: NDArray[np.str_]
    speed: NDArray[np.float64]
    angle: NDArray[np.float64]
    value: NDArray[np.float64]
    covariance: NDArray[np.float64]
    known: bool
    flies: bool

    @property
    def uncertainty(self) -> NDArray[np.float64]:
        """Uncertainty of each value by itself."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))


def data_of(given: Given, flight: Flight | None) -> Data:
    """What the measurements say of single impacts.

    @param flight of the body, if it is a sphere: heights and times need it
    """
    columns = columns_of(given)
    if flight is None and ("time" in columns or "drop_height" in columns):
        raise InvalidInput.out_of_range("data", "heights or times of a body", "those of a sphere, or speeds")
    parts = [_of_times(columns, flight)] if flight and "time" in columns else []
    parts += [_of_rows(columns, flight)] if "speed" in columns or "drop_height" in columns else []
    rows = [row for part, _ in parts for row in part]
    sizes = [len(part) for part, _ in parts]
    covariance = np.zeros((len(rows), len(rows)))
    for k, (part, its) in enumerate(parts):
        first = sum(sizes[:k])
        covariance[first : first + len(part), first : first + len(part)] = its
    if not rows:
        raise InvalidInput.out_of_range(
            "data", "no measured value", "one or more", "columns: " + ", ".join(VALUES) + ", rebound_height or time"
        )
    quantity, speed, angle, value = (np.array(each) for each in zip(*rows))
    _require_values(quantity, speed, angle, value)
    known = np.isfinite(np.diag(covariance))
    if known.any() and not known.all():
        raise InvalidInput.out_of_range(
            "data", f"{np.count_nonzero(known)} of {known.size} values with an uncertainty", "all or none"
        )
    if not known.any():
        covariance = np.diag(
            np.where(np.isin(quantity, ("restitution", "tangential_restitution")), 1.0, np.abs(value)) ** 2
        )
    return Data(
        quantity,
        speed,
        angle,
        value,
        covariance,
        bool(known.all()),
        bool({"time", "drop_height", "rebound_height"} & set(columns)),
    )


Rows = list[tuple[str, float, float, float]]


def _of_rows(columns: dict[str, NDArray[np.float64]], flight: Flight | None) -> tuple[Rows, NDArray[np.float64]]:
    """Values of rows that have a speed or a height of fall."""
    rows: Rows = []
    variances: list[float] = []
    count = len(next(iter(columns.values())))

    def cell(name: str, i: int) -> float:
        return float(columns[name][i]) if name in columns else math.nan

    for i in range(count):
        speed, height, rebound = cell("speed", i), cell("drop_height", i), cell("rebound_height", i)
        if math.isfinite(speed) and math.isfinite(height):
            raise InvalidInput.out_of_range("data", f"speed and drop_height in row {i + 1}", "one of them")
        if math.isfinite(height):
            assert flight is not None
            _require_height("drop_height", height, i)
            speed = flight.after_fall(height)
        told = [name for name in VALUES if math.isfinite(cell(name, i))]
        if not math.isfinite(speed):
            if told or math.isfinite(rebound):
                raise InvalidInput.out_of_range("data", f"row {i + 1} without a speed or a drop_height", "one of them")
            continue
        angle = 0.0 if math.isnan(cell("angle", i)) else cell("angle", i)
        for name in told:
            rows.append((name, speed, angle, cell(name, i)))
            variances.append(cell(name + UNCERTAINTY, i) ** 2)
        if math.isfinite(rebound):
            if flight is None or math.isnan(height) and flight.air and "speed" not in columns:
                raise InvalidInput.out_of_range(
                    "rebound_height", f"{rebound:g} in row {i + 1}", "with a drop_height or a speed"
                )
            _require_height("rebound_height", rebound, i)
            rows.append(("restitution", speed, angle, flight.before_rise(rebound) / speed))
            variances.append(
                _of_heights(
                    flight,
                    height,
                    speed,
                    rebound,
                    cell("drop_height" + UNCERTAINTY, i),
                    cell("rebound_height" + UNCERTAINTY, i),
                )
            )
    return rows, np.diag(variances) if variances else np.zeros((0, 0))


def _of_heights(
    flight: Flight, height: float, speed: float, rebound: float, of_drop: float, of_rebound: float
) -> float:
    """Variance of ε from those of both heights."""
    step = 1e-4
    up = flight.before_rise(rebound)
    slope = (flight.before_rise(rebound * (1.0 + step)) - up) / (step * rebound)
    variance = (slope * of_rebound / speed) ** 2
    if math.isfinite(height) and math.isfinite(of_drop):
        slope = (flight.after_fall(height * (1.0 + step)) - speed) / (step * height)
        variance += (up / speed**2 * slope * of_drop) ** 2
    return variance


def _of_times(columns: dict[str, NDArray[np.float64]], flight: Flight) -> tuple[Rows, NDArray[np.float64]]:
    """Values of a ball that bounces: each ε of two flights, of which each has two times of impact."""
    places = np.flatnonzero(np.isfinite(columns["time"]))
    times = columns["time"][places]
    if times.size < 3 or not (np.diff(times) > 0.0).all():
        raise refusal("time", times.tolist(), "three or more times of successive impacts, ascending")
    ends = np.array([flight.of_flight(float(each)) for each in np.diff(times)])
    begins, arrives = ends[:, 0], ends[:, 1]
    value = begins[1:] / arrives[:-1]
    rows: Rows = [("restitution", float(speed), 0.0, float(its)) for speed, its in zip(arrives[:-1], value)]
    if "time" + UNCERTAINTY not in columns:
        return rows, np.full((value.size, value.size), np.nan)
    step = 1e-4 * np.diff(times)
    later = np.array([flight.of_flight(float(each)) for each in np.diff(times) + step])
    slopes = (later - ends) / step[:, None]
    change = np.zeros((value.size, times.size))
    for k in range(value.size):
        before, after = -value[k] / arrives[k] * slopes[k, 1], slopes[k + 1, 0] / arrives[k]
        change[k, k : k + 3] = -before, before - after, after
    its = columns["time" + UNCERTAINTY][places]
    covariance = (change * its**2) @ change.T
    return rows, covariance


def _require_height(name: str, value: float, row: int) -> None:
    if not 0.0 < value < 1e6:
        raise InvalidInput.out_of_range(name, f"{value:g} in row {row + 1}", "above 0 m")


ALLOWED: Mapping[str, tuple[Callable[[float], bool], str]] = {
    "restitution": (lambda value: 0.0 <= value < 1.0, "0 to below 1: no body gives more than it got"),
    "tangential_restitution": (lambda value: -1.0 <= value <= 1.0, "-1 to 1"),
    "contact_time": (lambda value: value > 0.0, "above 0 s"),
    "peak_force": (lambda value: value > 0.0, "above 0 N"),
}  # fmt: skip


def _require_values(quantity: Any, speed: Any, angle: Any, value: Any) -> None:
    for name, its_speed, its_angle, its in zip(quantity.tolist(), speed.tolist(), angle.tolist(), value.tolist()):
        at = f" at {its_speed:.4g} m/s"
        if not its_speed > 0.0 or math.isinf(its_speed):
            raise InvalidInput.out_of_range("speed", f"{its_speed:g}", "above 0 m/s")
        if not abs(its_angle) < 90.0:
            raise InvalidInput.out_of_range("angle", f"{its_angle:g}{at}", "above -90 to below 90 degrees")
        allowed, said = ALLOWED[name]
        if not allowed(its) or math.isinf(its):
            raise InvalidInput.out_of_range(name, f"{its:.6g}{at}", said)
        if name == "tangential_restitution" and its_angle == 0.0:
            raise InvalidInput.out_of_range(
                "angle", f"none beside a tangential_restitution{at}", "the angle of approach, degrees"
            )
