"""The distribution of the coefficient of restitution of bodies that vibrate: what it is computed
from."""

from __future__ import annotations

import warnings
from typing import Any, Callable, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import boolean, integer, number, refusal
from stoss._documentation import documented
from stoss._errors import Interrupted, InvalidInput, StossWarning
from stoss.bodies._blocks import Unbounded
from stoss.bodies._bodies import Body, speed_unit, speeds_in_si
from stoss.bodies._encounter import choose_against, choose_body, refinable
from stoss.bodies._state import Oscillation, choose_state
from stoss.bodies._walls import HardWall
from stoss.results._distribution import RestitutionDistribution, summary_of
from stoss.results._progress import bar
from stoss.results._result import columns
from stoss.results._si import warn_of_large_strain

Spectrum = Union[Callable[[float], float], Oscillation, Sequence[Oscillation], NDArray[Any]]


@documented
def restitution_distribution(
    body: Body | None = None,
    *,
    speed: float,
    against: HardWall | Body | Unbounded | str | None = None,
    poisson: float | None = None,
    temperature: float | None = None,
    spectrum: Spectrum | None = None,
    highest: float = 10.0,
    samples: int = 1000,
    seed: int = 0,
    error: float = 1e-3,
    threads: int = 0,
    progress: bool = False,
) -> RestitutionDistribution:
    """Compute the coefficients of restitution of an ensemble of bodies that vibrate at random.

    Before each impact every mode has an energy E that is drawn like exp(−E/⟨E⟩), and any phase.
    Only modes that are symmetric about the line of impact count, and half-spaces rest.

    Parameters
    ----------
    temperature : float
        Mean energy ⟨E⟩ of each mode with ω ≤ `highest`, of both bodies, as a share of the
        translational energy before the impact, 0 to 1e6.
    spectrum : callable, Oscillation, sequence of them or ndarray
        In place of `temperature`: the mean energies, 0 to 1e6, of the same modes as a function of ω
        in c/R of the first body; or modes with their mean energies, whose phases do not count.
    highest : float, optional
        Modes up to this frequency vibrate, c/R of the first body; at a wall to 128. Without a limit
        a warm classical body would have no finite energy.
    samples : int, optional
        How many impacts, 1 to 10⁶.
    seed : int, optional
        Each seed gives another ensemble. Sample k depends only on the seed, k and the modes.
    error : float, optional
        Error of 1 − ε² of each impact to reach, 1e-9 to 0.5.

    Raises
    ------
    Interrupted
        After Ctrl-C; the samples that are done are its attribute `best`.

    Examples
    --------
    >>> warm = stoss.restitution_distribution(stoss.Sphere(poisson=0.3), speed=0.01, temperature=0.01, samples=100)
    >>> warm
    RestitutionDistribution(Sphere(poisson=0.3), speed=0.01 c, temperature 0.01: 100 samples, mean 0.99887 ± 0.00033, restitution 0.990652 to 1.00777)
    >>> bool(warm.above_one > 0)
    True
    """
    chosen = choose_body(body, poisson, rigid=True)
    initial = number("speed", speed) / speed_unit(chosen)
    met = choose_against(chosen, against, (HardWall,))
    count, chance, threads = integer("samples", samples), integer("seed", seed), integer("threads", threads)
    limit, top = number("error", error), number("highest", highest)
    if chance < 0:
        raise refusal("seed", seed, "0 to 2147483647")
    warmth = None if temperature is None else number("temperature", temperature)
    contact = refinable(chosen, met)
    means = _choose_spectrum(contact, warmth, spectrum, top)
    with speeds_in_si(chosen):
        _core.check_distribution(contact, initial, means, count, chance, limit, threads)

    rows, reasons = np.zeros(count, dtype=_core.sample_row), list[str]()
    stopped = False
    with bar(count, boolean("progress", progress)) as seen:
        try:
            tick = None if seen is None else seen.update
            _core.restitution_distribution(contact, initial, means, chance, limit, threads, rows, reasons, tick)
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
    _judge(result)
    return result


def _choose_spectrum(
    contact: _core.RefinableContact, temperature: float | None, spectrum: Any, highest: float
) -> NDArray[Any]:
    """The modes that vibrate with their mean energies, as the core takes them, read-only."""
    if (temperature is None) == (spectrum is None):
        got = "neither" if spectrum is None else "temperature and spectrum"
        raise InvalidInput(f"temperature: got {got}, allowed one of temperature and spectrum")
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


def _judge(result: RestitutionDistribution) -> None:
    """Warns of samples without the value that was asked for."""
    doubtful = len(result) - int(np.count_nonzero(result.converged))
    if doubtful:
        text = f"{doubtful} of {len(result)} samples not as accurate as asked for (see .converged, .reason)"
        warnings.warn(text, StossWarning, stacklevel=3)
    warn_of_large_strain(result, 3)
