"""Coefficients of restitution of an ensemble of bodies that vibrate."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss.bodies._bodies import Body, shown
from stoss.bodies._encounter import Against
from stoss.export._text import span, with_error
from stoss.results._result import RowResult, picture
from stoss.results._si import InSi, Si


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class RestitutionDistribution(InSi, RowResult):
    """Coefficients of restitution of bodies that vibrate at random before the impact.

    Arrays have one element for each sample; ``len()`` is their number, an index gives one of them,
    a slice the samples among them. In the mean, samples without
    a value (NaN) do not count.

    Attributes
    ----------
    temperature : float or None
        Mean energy of each mode, as a share of the translational energy before the impact.
    highest : float or None
        Modes up to this frequency vibrate, c/R.
    spectrum : ndarray
        The modes that vibrate: a structured array with the fields body (0 of the first, 1 of the
        second), order, index and energy, which is the mean, as a share of the translational one.
    error : float
        Of 1 − ε², asked for.
    mean, mean_error, numerical_error : float
        ⟨ε⟩; its statistical error, infinite for one sample; its numerical one, the mean of
        `restitution_error`.
    spread : float
        Standard deviation of ε, infinite for one sample.
    above_one : float
        Share of the samples with ε > 1.
    sample : ndarray of int
        Number of the sample, from 0.
    vibration : ndarray
        Energy of all modes before the impact, as a share of the translational one.
    """

    plot = picture("Histogram of ε. See `stoss.plot.distribution`.")
    _name: ClassVar[str] = "distribution"
    _kind = "sample"
    _axis: ClassVar[str] = "sample"
    contact_time_si = Si("Contact time, s.")
    contact_time_si_error = Si("Error of the contact time, s.")

    body: Body
    against: Against
    speed: float
    temperature: float | None
    highest: float | None
    spectrum: NDArray[Any]
    seed: int
    error: float
    mean: float
    mean_error: float
    numerical_error: float
    spread: float
    above_one: float
    sample: NDArray[np.int64]
    vibration: NDArray[np.float64]
    restitution: NDArray[np.float64]
    restitution_error: NDArray[np.float64]
    lost_fraction: NDArray[np.float64]
    lost_fraction_error: NDArray[np.float64]
    contact_time: NDArray[np.float64]
    contact_time_error: NDArray[np.float64]
    contacts: NDArray[np.int64]
    steps: NDArray[np.int64]
    converged: NDArray[np.bool_]
    beyond_small_strain: NDArray[np.bool_]
    reason: NDArray[np.object_]

    def __getitem__(self, key: Any) -> Any:
        """A sample as a dict, or for a slice, an array of indices or of flags, these samples,
        summed up anew."""
        part = super().__getitem__(key)
        if isinstance(part, dict):
            return part
        return dataclasses.replace(part, **summary_of(part.restitution, part.restitution_error))

    def __repr__(self) -> str:
        warm = f"{len(self.spectrum)} modes" if self.temperature is None else f"temperature {self.temperature:.6g}"
        return (
            f"RestitutionDistribution({shown(self.body, self.against)}, speed={self.speed:.6g} c, {warm}: {len(self)} samples, "
            f"mean {with_error(self.mean, self.mean_error)}, restitution {span(self.restitution)})"
        )

    def histogram(self, bins: Any = "auto", range: ArrayLike | None = None) -> tuple[NDArray[Any], NDArray[Any]]:
        """How many samples have ε in which interval.

        Parameters
        ----------
        bins, range
            As `numpy.histogram` has them.

        Returns
        -------
        count, edges : ndarray
            The latter has one element more.

        Examples
        --------
        >>> warm = stoss.restitution_distribution(poisson=0.33, speed=0.1, temperature=0.02, samples=20)
        >>> count, edges = warm.histogram(bins=5)
        >>> int(count.sum()), edges.size
        (20, 6)
        """
        return np.histogram(self.restitution[np.isfinite(self.restitution)], bins, range)  # type: ignore[arg-type]

    def _inputs(self) -> dict[str, Any]:
        named = {name: getattr(self, name) for name in ("body", "against", "speed", "temperature", "highest")}
        named |= {"modes": len(self.spectrum), "samples": len(self), "seed": self.seed, "error": self.error}
        return {name: value for name, value in named.items() if value is not None}


def summary_of(restitution: NDArray[np.float64], error: NDArray[np.float64]) -> dict[str, Any]:
    """What sums up samples; NaN where none has a value."""
    names = {
        "mean": "restitution",
        "mean_error": "restitution_statistical_error",
        "numerical_error": "restitution_numerical_error",
        "spread": "standard_deviation",
        "above_one": "share_above_one",
    }
    if not np.isfinite(restitution).any():
        return dict.fromkeys(names, np.nan)
    summary = _core.summary(np.ascontiguousarray(restitution), np.ascontiguousarray(error))
    return {name: summary[own] for name, own in names.items()}
