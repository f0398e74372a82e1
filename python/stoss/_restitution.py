"""The coefficient of restitution with its error."""

from __future__ import annotations

import dataclasses
import warnings
from typing import Any, ClassVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, boolean, broadcast, integer, number, numbers
from stoss._bodies import Body, Disk, Rod, choose_body
from stoss._curve import Curve, gather
from stoss._errors import Interrupted, NotConverged, StossWarning
from stoss._material import Material, speeds_in_si
from stoss._progress import bar
from stoss._result import Column, Number, Result, columns, shown, span
from stoss._si import SI_UNITS, InSiWithErrors

Integer = Union[int, NDArray[np.int64]]
Flag = Union[bool, NDArray[np.bool_]]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Restitution(InSiWithErrors, Result):
    """The coefficient of restitution against a hard wall, with errors.

    Numbers if all inputs were numbers, otherwise arrays of the shape to which `poisson` and `speed`
    broadcast. The true error is within the estimated one in 95 % of all cases.

    Attributes
    ----------
    body : Disk, Rod or None
        None if there are several Poisson numbers.
    poisson : float or ndarray
        2-D Poisson number; NaN for a rod.
    speed : float or ndarray
        Of the centre of mass towards the wall, c.
    restitution, restitution_error : float or ndarray
        ε = −v_f/v_i of the centre of mass, and its estimated error.
    lost_fraction, lost_fraction_error : float or ndarray
        1 − ε².
    contact_time, contact_time_error : float or ndarray
        From first to last contact, R/c.
    max_compression, max_compression_error : float or ndarray
        R.
    max_force, max_force_error : float or ndarray
        πRE = mc²/R.
    cutoff, energy_error, modes : float, int or ndarray
        Of the finest impact: c/R; what is missing, as a share of the initial energy; number of kept
        modes.
    runs, steps : int or ndarray
        Impacts computed, and their time steps.
    converged : bool or ndarray
        Whether the tolerance is met.
    beyond_small_strain : bool or ndarray
        Speed above 0.5 c or compression above 0.5 R, where linear elasticity has lost its meaning.
    reason : str or ndarray of str
        Why it is not converged; empty where it is.
    tolerance : float
        Asked for: error of 1 − ε² over 1 − ε².
    material : Material or None
        What it was made with. If there is one, `speed_si`, `contact_time_si`, `max_force_si`,
        `max_compression_si` and their errors, `contact_time_si_error` and so on, are the SI values.
    """

    _name: ClassVar[str] = "restitution"
    _units = {
        "speed": "c", "contact_time": "R/c", "contact_time_error": "R/c", "max_compression": "R",
        "max_compression_error": "R", "max_force": "piRE", "max_force_error": "piRE", "cutoff": "c/R", **SI_UNITS,
    }  # fmt: skip

    body: Body | None
    poisson: Number
    speed: Number
    restitution: Number
    restitution_error: Number
    lost_fraction: Number
    lost_fraction_error: Number
    contact_time: Number
    contact_time_error: Number
    max_compression: Number
    max_compression_error: Number
    max_force: Number
    max_force_error: Number
    cutoff: Number
    energy_error: Number
    modes: Integer
    runs: Integer
    steps: Integer
    converged: Flag
    beyond_small_strain: Flag
    reason: str | NDArray[np.object_]
    tolerance: float
    material: Material | None

    def __repr__(self) -> str:
        body = repr(self.body) if isinstance(self.body, Rod) else f"poisson={span(self.poisson)}"
        of = f"{body}, speed={span(self.speed)} c"
        if isinstance(self.restitution, float):
            value = f"restitution {shown(self.restitution, float(self.restitution_error))}"
            return f"Restitution({of}: {value}{'' if self.converged else ', not converged'})"
        doubtful = int(np.size(self.converged) - np.count_nonzero(self.converged))
        state = "all converged" if doubtful == 0 else f"{doubtful} not converged"
        return f"Restitution({np.size(self.speed)} values, {of}: restitution {span(self.restitution)}, {state})"

    def plot(self, ax: Any = None) -> Any:
        """ε against v with error bars. See `stoss.plot.restitution`."""
        from stoss import plot

        return plot.restitution(self, ax)

    def _inputs(self) -> dict[str, Any]:
        named = {"body": self.body, "tolerance": self.tolerance, "material": self.material}
        return {key: value for key, value in named.items() if value is not None}

    def _table(self) -> dict[str, Column]:
        skipped = ("body", "reason", "tolerance", "material")
        names = [field.name for field in dataclasses.fields(self) if field.name not in skipped]
        return {name: np.asarray(getattr(self, name)) for name in names}


def restitution(
    *,
    speed: ArrayLike,
    poisson: ArrayLike | None = None,
    material: Material | None = None,
    body: Body | None = None,
    tolerance: float = 1e-3,
    threads: int = 0,
    progress: bool = False,
) -> Restitution:
    """Compute the coefficient of restitution ε = −v_f/v_i at a hard wall, with its error.

    Cutoff, time step and contact grid are refined together until the estimated error of 1 − ε² is
    below ``tolerance * (1 − ε²)``. A value takes 3 ms in the median, 0.1 s or more in one case of a
    hundred.

    Parameters
    ----------
    speed : array_like
        Of the centre of mass towards the wall, 1e-8 to 1, c (with a material: m/s). Two equal
        bodies that each move at `speed` towards each other are the same problem.
    poisson : array_like
        2-D Poisson number of a disk, −0.95 to 0.995; broadcasts with `speed`. Or
    material : Material
        a material and radius in SI, or
    body : Disk or Rod
        a body.
    tolerance : float, optional
        Relative error of 1 − ε².
    threads : int, optional
        0: as many as the machine has. Results do not depend on it.
    progress : bool, optional
        Show a bar on stderr.

    Returns
    -------
    Restitution

    Raises
    ------
    InvalidInput
        For arguments out of range, before anything is computed.
    NotConverged
        If `speed` and `poisson` are numbers and the tolerance cannot be met; the best value is its
        attribute `best`. In arrays such values are marked, and a `StossWarning` says how many there
        are.
    Interrupted
        After Ctrl-C; what is done is its attribute `best`.

    Examples
    --------
    >>> stoss.restitution(poisson=0.33, speed=0.1)
    Restitution(poisson=0.33, speed=0.1 c: restitution 0.947044 ± 0.000038)
    >>> curve = stoss.restitution(poisson=0.33, speed=np.geomspace(1e-4, 0.3, 50))
    >>> curve.restitution.shape
    (50,)
    >>> curve.restitution.max().round(4)
    0.9974
    """
    chosen = choose_body(None if poisson is None else 0.0, material, body)
    speeds = numbers("speed", speed)
    if material is not None:
        speeds = speeds / material.scales.speed
    poissons = np.full((), getattr(chosen, "poisson", np.nan)) if poisson is None else numbers("poisson", poisson)
    poissons, speeds = broadcast(20, poisson=poissons, speed=speeds)
    limit, count = number("tolerance", tolerance), integer("threads", threads)
    places: dict[Body, NDArray[np.intp]] = {chosen: np.arange(speeds.size)}
    if poisson is not None:
        places = {Disk(poisson=value): np.flatnonzero(poissons == value) for value in np.unique(poissons)}
    with speeds_in_si(material):
        _core.check_curve(speeds.ravel(), limit, count)

    curves = [Curve(each, where, speeds.ravel()[where]) for each, where in places.items()]
    stopped = False
    with bar(speeds.size, boolean("progress", progress)) as seen:
        try:
            for curve in curves:
                curve.compute(limit, count, None if seen is None else seen.update)
        except KeyboardInterrupt:
            stopped = True
    table, reasons = gather(curves, speeds.size)
    result = _make(curves[0].body if len(curves) == 1 else None, poissons, speeds, table, reasons, limit, material)
    if stopped:
        done = sum(len(curve.reasons) for curve in curves)
        raise Interrupted(f"restitution: interrupted after {done} of {speeds.size} values (they are in .best)", result)
    _judge(result)
    return result


def _make(
    body: Body | None,
    poissons: NDArray[np.float64],
    speeds: NDArray[np.float64],
    table: NDArray[Any],
    reasons: NDArray[np.object_],
    tolerance: float,
    material: Material | None,
) -> Restitution:
    values = {name: arranged(column, speeds.shape) for name, column in columns(table).items()}
    given = {"poisson": poissons, "speed": speeds, "reason": reasons}
    inputs = {name: arranged(column, speeds.shape) for name, column in given.items()}
    return Restitution(body=body, tolerance=tolerance, material=material, **inputs, **values)


def _judge(result: Restitution) -> None:
    """Raises for one value, warns for several."""
    if isinstance(result.reason, str):
        if not result.converged:
            raise NotConverged(f"restitution: {result.reason}", result)
    elif not np.all(result.converged):
        count = np.size(result.converged)
        doubtful = count - np.count_nonzero(result.converged)
        text = f"{doubtful} of {count} values not as accurate as asked for (see .converged, .reason)"
        warnings.warn(text, StossWarning, stacklevel=3)
    if np.any(result.beyond_small_strain):
        text = "speed above 0.5 c or compression above 0.5 R: linear elasticity has lost its meaning here"
        warnings.warn(text, StossWarning, stacklevel=3)
