"""Coefficients of restitution of an ensemble of bodies that vibrate."""

from __future__ import annotations

import dataclasses
from typing import Any, Callable, ClassVar, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import boolean, integer, number, refusal
from stoss._documentation import documented
from stoss._errors import Interrupted, InvalidInput
from stoss.bodies._bodies import Body, shown
from stoss.bodies._encounter import Against, choose_against, choose_body, refinable
from stoss.bodies._solid import own_number
from stoss.bodies._state import Oscillation, choose_state
from stoss.bodies._walls import Unbounded, Wall
from stoss.export._tables import span, with_error
from stoss.results._progress import bar
from stoss.results._quantities import SampleQuantities
from stoss.results._result import RowResult, columns, picture
from stoss.results._si import InSi, warn_at, warn_of_doubt, warn_of_limits


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class RestitutionDistribution(SampleQuantities, InSi, RowResult):
    """Coefficients of restitution of bodies that vibrate at random before the impact.

    Arrays have one element for each sample; ``len()`` is their number, an index gives one of them,
    a slice the samples among them. In the mean, samples without
    a value (NaN) do not count.

    Attributes:
        temperature: Mean energy of each mode, as a share of the translational energy before the
            impact.
        highest: Modes up to this frequency vibrate, c/R.
        spectrum: The modes that vibrate: a structured array with the fields body (0 of the first, 1
            of the second), order, index and energy, which is the mean, as a share of the
            translational one.
        error: Of 1 − ε², asked for.
        mean, mean_error, numerical_error: ⟨ε⟩, its statistical error (infinite for one sample) and its
            numerical one, the mean of `restitution_error`.
        spread: Standard deviation of ε, infinite for one sample.
        above_one: Share of the samples with ε > 1.
    """

    plot = picture("Histogram of ε. See `stoss.plot.distribution`.")
    _name: ClassVar[str] = "distribution"
    _axis: ClassVar[str] = "sample"

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
    reason: NDArray[np.object_]

    def __getitem__(self, key: Any) -> Any:
        """A sample as a dict, or for a slice, an array of indices or of flags, these samples, summed up anew."""
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
        """How many samples have ε in which interval, and the ends of the intervals, as `numpy.histogram` has them.

        Examples:
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


Spectrum = Union[Callable[[float], float], Oscillation, Sequence[Oscillation], NDArray[Any]]


@documented
def restitution_distribution(
    body: Body | None = None,
    *,
    speed: float,
    against: Wall | Body | Unbounded | str | None = None,
    poisson: float | None = None,
    temperature: float | None = None,
    spectrum: Spectrum | None = None,
    highest: float | None = None,
    samples: int = 1000,
    seed: int = 0,
    error: float = 1e-3,
    threads: int = 0,
    progress: bool = False,
) -> RestitutionDistribution:
    """Compute the coefficients of restitution of an ensemble of bodies that vibrate at random.

    Before each impact every mode has an energy E that is drawn like exp(−E/⟨E⟩), and any phase.
    Only modes that are symmetric about the line of impact count, and half-spaces rest.

    Parameters:
        temperature: Mean energy ⟨E⟩ of each mode with ω ≤ `highest`, of both bodies, as a share of
            the translational energy before the impact, 0 to 1e6.
        spectrum (callable, Oscillation, sequence of them or ndarray): In place of `temperature`:
            the mean energies, 0 to 1e6, of the same modes as a function of ω in c/R of the first
            body; or modes with their mean energies, whose phases do not count.
        highest: Modes up to this frequency vibrate, c/R of the first body; at a wall to 128. If
            None, up to 10, where the bodies allow it. Without a limit a warm classical body would
            have no finite energy.
        samples: How many impacts, 1 to 10⁶.
        seed: Each seed gives another ensemble. Sample k depends only on the seed, k and the modes.
        error: Error of 1 − ε² of each impact to reach, 1e-9 to 0.5.

    Examples:
        >>> warm = stoss.restitution_distribution(stoss.Sphere(poisson=0.3), speed=0.01, temperature=0.01, samples=100)
        >>> warm
        RestitutionDistribution(Sphere(poisson=0.3), speed=0.01 c, temperature 0.01: 100 samples, mean 0.99887 ± 0.00033, restitution 0.990655 to 1.00778)
        >>> bool(warm.above_one > 0)
        True
    """
    chosen = choose_body(body, poisson, rigid=True)
    initial = own_number(chosen, "distribution", "speed", speed)
    met = choose_against(chosen, against)
    count, chance, threads = integer("samples", samples), integer("seed", seed), integer("threads", threads)
    limit = number("error", error)
    if chance < 0:
        raise refusal("seed", seed, "0 to 2147483647")
    warmth = None if temperature is None else number("temperature", temperature)
    contact = refinable(chosen, met)
    top = _core.usual_highest(contact) if highest is None else number("highest", highest)
    means = _choose_spectrum(contact, warmth, spectrum, top)
    _core.check_distribution(contact, initial, means, count, chance, limit, threads)

    rows, reasons = np.zeros(count, dtype=_core.sample_row), list[str]()
    stopped = False
    with bar(count, boolean("progress", progress)) as seen:
        try:
            tick = None if seen is None else seen.update
            _core.restitution_distribution(contact, initial, means, chance, limit, threads, rows, reasons, tick, 0)
        except KeyboardInterrupt:
            stopped = True
    by_frequency = warmth is not None or callable(spectrum)
    done, why = rows[: len(reasons)], np.array(reasons, dtype=object)
    for array in (done, why):
        array.flags.writeable = False
    values: dict[str, Any] = columns(done)
    result = RestitutionDistribution(
        body=chosen, against=met, speed=initial, temperature=warmth, highest=top if by_frequency else None,
        spectrum=means, seed=chance, error=limit, reason=why, **values,
        **summary_of(values["restitution"], values["restitution_error"]),
    )  # fmt: skip
    if stopped:
        text = f"restitution_distribution: interrupted after {len(reasons)} of {count} samples (they are in .best)"
        raise Interrupted(text, result)
    warn_of_doubt(result.converged, "samples", 2)
    warn_of_limits(result, 2)
    warn_at(chosen, met, initial, 2)
    return result


def _choose_spectrum(
    contact: _core.RefinableContact, temperature: float | None, spectrum: Any, highest: float
) -> NDArray[Any]:
    """The modes that vibrate with their mean energies, as the core takes them, read-only."""
    if (temperature is None) == (spectrum is None):
        got = "neither" if spectrum is None else "temperature and spectrum"
        raise InvalidInput.out_of_range("temperature", got, "one of temperature and spectrum")
    if temperature is not None or callable(spectrum):
        modes = _core.thermal(contact, 0.0 if temperature is None else temperature, highest)
    else:
        modes = choose_state(spectrum, "spectrum")
    means = np.zeros(modes.size, dtype=_core.mean_energy)
    for name in means.dtype.names or ():
        means[name] = modes[name]
    if callable(spectrum):
        means["energy"] = [number("spectrum", spectrum(float(omega))) for omega in _core.frequencies(contact, modes)]
    means.flags.writeable = False
    return means
