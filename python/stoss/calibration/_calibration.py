"""`stoss.calibrate`: constants of materials from measured impacts."""

from __future__ import annotations

import dataclasses
import importlib
import math
import os
from typing import Any, ClassVar, Mapping

import numpy as np
from numpy.typing import NDArray

from stoss._arguments import boolean, instance, refusal
from stoss._documentation import documented
from stoss.bodies._bodies import BODIES, PARTNERS, Body, shown
from stoss.bodies._encounter import Against, choose_against
from stoss.bodies._material import Material
from stoss.bodies._solid import describe, own_number
from stoss.calibration._constants import Meeting, Unknowns, unknowns_of
from stoss.export._tables import plain, with_error
from stoss.results._prediction import choose_uncertainties
from stoss.results._progress import waiting
from stoss.results._result import Column, Result, picture


@dataclasses.dataclass(frozen=True)
class CalibratedConstant:
    """A constant that measurements tell.

    Attributes:
        name (str): As "quality", or "against.young" of what is met.
        value (float): Which comes nearest to them.
        uncertainty (float): Standard uncertainty, from those of the data.
        by_constants (float): From the uncertainties of constants that are held.
        numerical (float): From the numerical errors of the computed values.
        unit (str): In SI.
    """

    name: str
    value: float
    uncertainty: float
    by_constants: float
    numerical: float
    unit: str

    def __str__(self) -> str:
        said = f"{self.name} = {with_error(self.value, self.uncertainty)} {self.unit}".rstrip()
        return f"{said} (constants ± {self.by_constants:.1g}, numerical ± {self.numerical:.1g})"


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Calibration(Result):
    """Constants that come nearest to measured impacts, with all that is uncertain of them.

    Attributes:
        body, against: What meets, with these constants: ready for every other call. `against` is 'same' where both
            are one body.
        friction: Coefficient of Coulomb's law, None where there was none.
        constants: What was found, in the order of the unknowns.
        correlation (ndarray): That of the constants, from the uncertainties of the data.
        quantity (ndarray): What each value is: 'restitution', 'tangential_restitution', 'contact_time' or 'peak_force'.
        speed (ndarray): Speed of impact along the normal, m/s.
        angle (ndarray): From the normal, degrees.
        measured, uncertainty (ndarray): Values, after what the air has taken, and their standard uncertainties. Where
            none were given, those that the scatter tells.
        fitted, fitted_error (ndarray): Values of stoss with these constants, and their numerical errors.
        band (ndarray): Standard uncertainty of `fitted` from that of the constants.
        chi_squared: Sum of the squares of residuals over their uncertainties.
        degrees_of_freedom: Number of values, less that of constants.
        probability: That of a larger chi_squared, if all is as assumed. NaN where no uncertainties were given, and
            without degrees of freedom.
        not_told_apart: What these data do not tell apart, a sentence each.
        notes: Further remarks, such as whether air was taken off.
    """

    plot = picture("Measured and computed values, with the band of the constants. See `stoss.plot.calibration`.")
    _name: ClassVar[str] = "calibrate"
    _axis: ClassVar[str] = "value"
    _told = ("body", "against", "friction", "air")

    body: Body
    against: Against | str
    friction: float | None
    air: bool
    constants: tuple[CalibratedConstant, ...]
    correlation: NDArray[np.float64]
    quantity: NDArray[np.object_]
    speed: NDArray[np.float64]
    angle: NDArray[np.float64]
    measured: NDArray[np.float64]
    uncertainty: NDArray[np.float64]
    fitted: NDArray[np.float64]
    fitted_error: NDArray[np.float64]
    band: NDArray[np.float64]
    chi_squared: float
    degrees_of_freedom: int
    probability: float
    not_told_apart: tuple[str, ...]
    notes: tuple[str, ...]

    def __repr__(self) -> str:
        return f"Calibration({shown(self.body)}: {'; '.join(map(str, self.constants))})"

    def __str__(self) -> str:
        return "\n".join(importlib.import_module("stoss.calibration._report").lines(self))

    def __post_init__(self) -> None:
        for each in vars(self).values():
            if isinstance(each, np.ndarray):
                each.flags.writeable = False

    @property
    def material(self) -> Material:
        """That of the body, with these constants."""
        return self.body.material  # type: ignore[return-value]

    def to_dict(self) -> dict[str, Any]:
        """As of all results, with the encounter that was found as its document."""
        against: Any = self.against
        if not isinstance(against, str):
            against = describe(against) if isinstance(against, PARTNERS) else against._document(1.0)
        made: dict[str, Any] = plain({field.name: getattr(self, field.name) for field in dataclasses.fields(self)})
        return made | {
            "encounter": plain({"first": describe(self.body), "against": against}),
            "goodness": self.goodness,
        }

    @property
    def uncertainties(self) -> dict[str, float]:
        """Those of the constants as `stoss.predict` takes them: with the data's and the held constants' together."""
        names = {"quality": "loss", "loss_time": "loss", "relaxation": "loss"}
        known = ("young", "density", "loss", "yield_strength", "roughness")
        found = {}
        for each in self.constants:
            *side, own = each.name.split(".")
            name = ".".join([*side, names.get(own, own)])
            if names.get(own, own) in known and each.value:
                found[name] = min(math.hypot(each.uncertainty, each.by_constants) / each.value, 10.0)
        return found

    def report(self, path: str | os.PathLike[str]) -> None:
        """Write a page in HTML with constants, goodness of fit, values and picture, whole or not at all.

        Parameters:
            path: File to write; an existing one is replaced.
        """
        importlib.import_module("stoss.calibration._report").write(self, path)

    @property
    def goodness(self) -> str:
        """A sentence on the goodness of fit."""
        of = f"chi squared {self.chi_squared:.3g} with {self.degrees_of_freedom} degrees of freedom"
        if math.isnan(self.probability):
            said = (
                "; uncertainties of the data follow from their scatter"
                if self.degrees_of_freedom
                else ": no more values than constants"
            )
            return of + said
        poor = ": the model or the uncertainties are not right" if self.probability < 0.01 else ""
        return f"{of}, probability of more {self.probability:.2g}{poor}"

    def _table(self) -> dict[str, Column]:
        names = ("quantity", "speed", "angle", "measured", "uncertainty", "fitted", "fitted_error", "band")
        return {name: getattr(self, name) for name in names}

    def _unit(self, name: str) -> str:
        return {"speed": "m/s", "angle": "degrees"}.get(name, "")


@documented
def calibrate(
    data: str | os.PathLike[str] | Mapping[str, Any],
    body: Body,
    *,
    against: Any = None,
    unknown: Unknowns,
    friction: float | None = None,
    air: bool = True,
    uncertainties: Mapping[str, float] | None = None,
    progress: bool = False,
) -> Calibration:
    """Find the constants of materials that come nearest to measured impacts, by weighted least squares.

    Columns of the data, all in SI: `speed` of impact along the normal or `drop_height`, and beside it any
    of `restitution`, `rebound_height`, `contact_time`, `peak_force`, `angle` with `tangential_restitution`;
    or `time` of the successive impacts of a ball that bounces. Each value may have its standard
    uncertainty, as `restitution_uncertainty`. Without any, they follow from the scatter. Cells may be empty.
    Heights and times are those of a smooth sphere in resting air of 20 °C, with Clift and Gauvin's drag and
    with buoyancy.

    What is computed is ε, force and time of `stoss.restitution`, of bodies that yield where their material has a
    yield strength, and ε_t of `stoss.oblique`. Adhesion is left out.

    Parameters:
        data (path, mapping of columns, or pandas.DataFrame): The measurements, up to 1000 rows.
        body (Body): With a material, whose constants are right where they are not unknown.
        unknown (str, sequence of str, or mapping): One to three of 'quality', 'loss_time', 'relaxation' (a
            factor on the terms of a series), 'young', 'density', 'yield_strength', 'yield_hardening',
            'roughness', 'radius', 'friction'; of what is met as 'against.young'. Mapped to values, these are
            where the search begins.
        friction: Coefficient of Coulomb's law, for ε_t, where it is known.
        air: Whether air resists the flight of a sphere.
        uncertainties (mapping of str to float): Constants that are held, by name, each known within a factor
            of 1 + u, u from 0 to 10. Default: those of `stoss.materials`.

    Raises:
        InvalidInput: For ε of 1 and more, fewer values than unknown constants, and constants that the data do not tell.
        NotConverged: If the search does not end.

    Examples:
        >>> glass = stoss.Material(young=7e10, poisson=0.22, density=2500, quality=100)
        >>> ball = stoss.Sphere(radius=0.01, material=glass)
        >>> data = {"speed": [0.5, 1.0], "restitution": [0.975, 0.974], "restitution_uncertainty": [0.001, 0.001]}
        >>> found = stoss.calibrate(data, ball, unknown="quality")
        >>> round(found.constants[0].value), round(found.constants[0].uncertainty, 1)
        (47, 1.3)
        >>> round(float(stoss.restitution(found.body, speed=2.0).restitution), 3)
        0.974
    """
    its: Any = instance("body", body, BODIES)
    if its.material is None or getattr(its, "rigid", False):
        raise refusal("body", body, "an elastic body with a material")
    met: Any = "same" if isinstance(against, str) and against == "same" else choose_against(its, against)
    mu = None if friction is None else own_number(its, "calibrate", "friction", friction)
    meeting = Meeting(its, met, mu)
    known = choose_uncertainties(uncertainties)
    with waiting(boolean("progress", progress), "calibrate"):
        made: Calibration = _work().found(data, meeting, unknowns_of(unknown, meeting), boolean("air", air), known)
    return made


def _work() -> Any:
    """What needs SciPy, which the rest of the package does not."""
    try:
        return importlib.import_module("stoss.calibration._found")
    except ImportError as error:
        if not (error.name or "").startswith("scipy"):
            raise
        raise ImportError("calibrate needs SciPy: pip install scipy, or apt install python3-scipy") from None
