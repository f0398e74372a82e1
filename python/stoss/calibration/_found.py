"""Constants from measurements: what was given, the search, and what was found."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Mapping

import numpy as np
from scipy.stats import chi2

from stoss._errors import InvalidInput
from stoss.bodies._bodies import Sphere
from stoss.calibration._air import HIGHEST_REYNOLDS_NUMBER, Flight
from stoss.calibration._calibration import CalibratedConstant, Calibration
from stoss.calibration._constants import Constant, Meeting
from stoss.calibration._data import Data, data_of
from stoss.calibration._held import Held, cannot_be_told, held_by, held_in
from stoss.calibration._search import Search, Solution


def found(given: Any, meeting: Meeting, unknowns: list[Constant], air: bool, known: Mapping[str, float]) -> Calibration:
    """The constants that come nearest to the measurements."""
    if any(each.own == "friction" for each in unknowns):
        start = next(each.start for each in unknowns if each.own == "friction")
        meeting = dataclasses.replace(meeting, friction=start)
    names = held_in(meeting, unknowns, known)
    flight = _flight(meeting.body, air)
    data = data_of(given, flight)
    _require_told(data, meeting, unknowns)
    search = Search(data, meeting, unknowns)
    solution = search.found()
    return _made(data, unknowns, solution, held_by(search, solution, unknowns, names), flight)


def _flight(body: object, air: bool) -> Flight | None:
    """The flight of a sphere; its size and mass are those that were given, whatever is sought."""
    if not isinstance(body, Sphere):
        return None
    radius: float = getattr(body, "radius")
    density: float = body.density + body.extra_mass / (4.0 / 3.0 * math.pi * radius**3)
    return Flight(radius, density, air)


def _require_told(data: Data, meeting: Meeting, unknowns: list[Constant]) -> None:
    values, constants = data.value.size, len(unknowns)
    if values < constants:
        raise InvalidInput.out_of_range(
            "data", f"{values} values for {constants} unknown constants", "as many values, or more"
        )
    if values == constants and not data.known:
        raise InvalidInput.out_of_range(
            "data",
            f"{values} values without uncertainties",
            f"more than {constants}, or their uncertainties",
            "nothing else says how well the constants are known",
        )
    angles = (data.quantity == "tangential_restitution").any()
    sought = any(each.own == "friction" for each in unknowns)
    if angles and meeting.friction is None:
        raise InvalidInput.missing("friction", "", "tangential_restitution needs it, known or unknown")
    if sought and not angles:
        raise InvalidInput.out_of_range(
            "unknown", "friction", "constants that the data depend on", "it needs angle and tangential_restitution"
        )
    if not np.linalg.eigvalsh(data.covariance)[0] > 0.0:
        raise InvalidInput.out_of_range("data", "an uncertainty of 0", "above 0", "of each value")


def _made(
    data: Data, unknowns: list[Constant], solution: Solution, held: list[Held], flight: Flight | None
) -> Calibration:  # fmt: skip
    chi_squared, freedom = float(solution.residuals @ solution.residuals), data.value.size - len(unknowns)
    scale = 1.0 if data.known else chi_squared / freedom
    covariance = solution.covariance * scale
    deviation = np.sqrt(np.diag(covariance))
    correlation = covariance / np.outer(deviation, deviation)
    by_held = np.sqrt(
        sum(((each.changes * math.log1p(each.uncertainty)) ** 2 for each in held), np.zeros(len(unknowns)))
    )
    values = np.exp(solution.logs)
    constants = tuple(
        CalibratedConstant(
            name=each.name,
            value=float(value),
            uncertainty=float(value * own),
            by_constants=float(value * other),
            numerical=float(value * numerical),
            unit=each.kind.unit,
        )
        for each, value, own, other, numerical in zip(unknowns, values, deviation, by_held, solution.numerical)
    )
    its = solution.meeting
    return Calibration(
        body=its.body,
        against=its.against,
        friction=its.friction,
        air=bool(flight and flight.air),
        constants=constants,
        correlation=correlation,
        quantity=data.quantity.astype(object),
        speed=data.speed,
        angle=data.angle,
        measured=data.value,
        uncertainty=data.uncertainty * math.sqrt(scale),
        fitted=solution.values,
        fitted_error=solution.errors,
        band=np.sqrt(np.einsum("ik,kl,il->i", solution.slopes, covariance, solution.slopes)),
        chi_squared=chi_squared / scale,
        degrees_of_freedom=freedom,
        probability=float(chi2.sf(chi_squared, freedom)) if data.known and freedom else math.nan,
        not_told_apart=tuple(cannot_be_told(unknowns, correlation, held, its)),
        notes=tuple(_notes(data, flight)),
    )


def _notes(data: Data, flight: Flight | None) -> list[str]:
    notes = []
    if data.flies and flight is not None:
        notes.append(
            "heights and times: " + ("drag of a smooth sphere and buoyancy in air" if flight.air else "without air")
        )
        reynolds = flight.reynolds(float(data.speed.max()))
        if reynolds > HIGHEST_REYNOLDS_NUMBER:
            notes.append(f"Reynolds' number {reynolds:.2g} is above the range of the law of drag, 3e5")
    if not data.known:
        notes.append("no uncertainties given: taken to be equal, of ε absolutely, of times and forces relatively")
    return notes
