"""The constants that come nearest to the measurements, with all that is uncertain of them.

Least squares of residuals r = L⁻¹(y − f(θ)), LLᵀ the covariance of y with the squares of numerical errors, so that no
constant follows these. f is computed to its tolerance; where it is asked for many times, it is that of cheap impacts,
f(θ) ≈ g(θ) + f(θₖ) − g(θₖ), until θₖ is the solution. What data and errors do to constants is linear, δθ = A δy with
A = (JᵀJ)⁻¹JᵀL⁻¹ (P. R. Bevington and D. K. Robinson, Data Reduction and Error Analysis).
"""

from __future__ import annotations

import dataclasses
from typing import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular
from scipy.optimize import least_squares

from stoss._errors import InvalidInput, NotConverged
from stoss.calibration._constants import Constant, Meeting
from stoss.calibration._data import Data
from stoss.calibration._model import Impacts

Array = NDArray[np.float64]

STEP = 0.1  # of the logarithm of a constant, for slopes: times of contact end within steps
ROUNDS = 8  # corrections by computed values
ENOUGH = 0.02  # until constants change by less than this share of σ, or than errors do
SCAN = 9  # values that are tried of each constant before
LARGEST_FACTOR = np.e  # within which a constant must be told


@dataclasses.dataclass(frozen=True)
class Solution:
    """What was found; all matrices are those of logarithms of the constants.

    Attributes:
        meeting: With the constants that were found.
        logs: Of them.
        values, errors: Computed, with numerical errors.
        residuals: Over the uncertainties, whitened.
        slopes: d(value)/d(log constant).
        answer: A, of the logarithms to changes of the values.
        covariance: Covariance of the logarithms, as the uncertainties of the data make it.
        numerical: What numerical errors may do to them.
    """

    meeting: Meeting
    logs: Array
    values: Array
    errors: Array
    residuals: Array
    slopes: Array
    answer: Array
    covariance: Array
    numerical: Array


class Search:
    """Constants of bodies that meet, against data."""

    def __init__(self, data: Data, meeting: Meeting, unknowns: list[Constant]) -> None:
        self._data, self._meeting, self._unknowns = data, meeting, unknowns
        self._impacts = Impacts(data)
        self._of_data = np.linalg.cholesky(data.covariance)
        self._root = self._of_data
        self._low = np.log([each.low for each in unknowns])
        self._high = np.log([each.high for each in unknowns])

    def found(self) -> Solution:
        """The solution. Raises NotConverged."""
        logs = self._scanned(self._corrected(np.log([each.start for each in self._unknowns]))[0])
        for _ in range(ROUNDS):
            values, errors = self._corrected(logs)
            self._root = np.linalg.cholesky(self._data.covariance + np.diag(errors**2) * self._data.known)
            nearest = self._nearest(values, logs)
            slopes = self._slopes(values, nearest)
            answer = self._answer(slopes)
            covariance = answer @ self._data.covariance @ answer.T
            numerical = np.abs(answer * errors).sum(axis=1)
            moved, logs = np.abs(nearest - logs), nearest
            if (moved <= np.maximum(ENOUGH * np.sqrt(np.diag(covariance)), numerical) + 1e-6).all():
                break
        else:
            raise NotConverged("calibrate: constants do not settle: begin with other values, or ask for fewer", None)
        computed = values(logs)
        residuals = solve_triangular(self._of_data, self._data.value - computed, lower=True)
        self._require_told(logs, covariance, residuals)
        return Solution(self.at(logs), logs, computed, errors, residuals, slopes, answer, covariance, numerical)

    def whitened(self, of: Array) -> Array:
        """L⁻¹ of values, or of columns of them."""
        return np.asarray(solve_triangular(self._root, of, lower=True))

    def at(self, logs: Array) -> Meeting:
        """What meets, with other constants."""
        values = (min(max(float(np.exp(log)), each.low), each.high) for log, each in zip(logs, self._unknowns))
        return self._meeting.changed(dict(zip((each.name for each in self._unknowns), values)))

    def cheap(self, meeting: Meeting) -> Array:
        """Values of cheap impacts of other bodies."""
        return self._impacts.cheap(meeting)

    def _corrected(self, logs: Array) -> tuple[Callable[[Array], Array], Array]:
        """Cheap values around a place, corrected by the computed ones there, and the errors of these."""
        computed, errors = self._impacts.computed(self.at(logs))
        correction = computed - self._impacts.cheap(self.at(logs))
        return lambda at: self._impacts.cheap(self.at(at)) + correction, errors

    def _nearest(self, values: Callable[[Array], Array], logs: Array) -> Array:
        """Where the residuals of these values are least, from a place on."""
        best = least_squares(
            lambda at: self.whitened(self._data.value - values(at)), logs, bounds=(self._low, self._high),
            jac=lambda at: -self.whitened(self._slopes(values, at)), xtol=1e-6, ftol=1e-10, max_nfev=30,
        )  # fmt: skip
        return np.asarray(best.x)

    def _scanned(self, values: Callable[[Array], Array]) -> Array:
        """Where to begin: the best of some values of each constant whose begin was not given, one after the other."""
        logs = np.log([each.start for each in self._unknowns])
        for k, each in enumerate(self._unknowns):
            if each.given:
                continue
            tried = np.linspace(max(self._low[k], logs[k] - 3.0), min(self._high[k], logs[k] + 3.0), SCAN)
            places = [np.where(np.arange(logs.size) == k, at, logs) for at in (*tried, logs[k])]
            costs = [self._cost(values, place) for place in places]
            logs = places[int(np.argmin(costs))]
        return logs

    def _cost(self, values: Callable[[Array], Array], logs: Array) -> float:
        try:
            its = self.whitened(self._data.value - values(logs))
        except InvalidInput:  # beyond what a body may be
            return np.inf
        return float(its @ its) if np.isfinite(its).all() else np.inf

    def _slopes(self, values: Callable[[Array], Array], logs: Array) -> Array:
        """Central differences, one-sided at the ends of ranges."""
        slopes = np.empty((self._data.value.size, logs.size))
        for k in range(logs.size):
            ends = [
                np.where(np.arange(logs.size) == k, np.clip(logs + step, self._low, self._high), logs)
                for step in (-STEP, STEP)
            ]
            slopes[:, k] = (values(ends[1]) - values(ends[0])) / (ends[1][k] - ends[0][k])
        return slopes

    def _answer(self, slopes: Array) -> Array:
        """(JᵀJ)⁻¹JᵀL⁻¹. Refuses constants that move no value at all."""
        white = self.whitened(slopes)
        for each, seen in zip(self._unknowns, np.sqrt((white**2).sum(axis=0))):
            if not seen > 0.0:
                raise InvalidInput.out_of_range("unknown", each.name, "constants that the data depend on")
        inverse = np.linalg.pinv(white.T @ white, rcond=1e-14, hermitian=True)
        return np.asarray(solve_triangular(self._root, (inverse @ white.T).T, lower=True, trans="T").T)

    def _require_told(self, logs: Array, covariance: Array, residuals: Array) -> None:
        """Refuse constants that the data do not tell: at an end of their range, or within a large factor."""
        freedom = self._data.value.size - logs.size
        scale = 1.0 if self._data.known else float(residuals @ residuals) / freedom
        for k, each in enumerate(self._unknowns):
            factor = float(np.exp(min(np.sqrt(covariance[k, k] * scale), 700.0)))
            ended = logs[k] - self._low[k] < 1e-6 or self._high[k] - logs[k] < 1e-6
            if factor <= LARGEST_FACTOR and not ended:
                continue
            beside = "" if logs.size == 1 else ", beside the other unknown ones"
            hint = f"these tell it within a factor of {factor:.2g}{beside}"
            if ended:
                end = f"{np.exp(logs[k]):.3g} {each.kind.unit}".rstrip()
                hint = f"the search came to the end of its range, {end}: something else is another"
            raise InvalidInput.out_of_range("unknown", each.name, "constants that the data tell", hint)
