"""`stoss.fit`: the constants of a force law that come nearest to elasticity, and how far off they are."""

from __future__ import annotations

import dataclasses
import importlib
import os
import warnings
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, Sequence

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import boolean, choice, instance, integer, number, numbers, refusal
from stoss._documentation import documented
from stoss._errors import InvalidInput, StossWarning
from stoss.bodies._bodies import Sphere, shown
from stoss.bodies._encounter import Against, choose_against
from stoss.bodies._solid import own_units
from stoss.bodies._walls import HalfSpace, HardWall
from stoss.export._files import write_lines
from stoss.results._result import Column, Result
from stoss.results._si import warn_at

if TYPE_CHECKING:
    from stoss.laws._law import Impacts, Law

LAWS = tuple(_core.fitted_laws())
PROGRAMS = tuple(_core.fitted_programs())


class Misfit(NamedTuple):
    """How far a law is from elasticity over a range of speeds.

    Attributes:
        maximum (float): Largest deviation.
        rms (float): Root mean square.
    """

    maximum: float
    rms: float


def _misfit(deviation: NDArray[np.float64]) -> Misfit:
    return Misfit(float(np.abs(deviation).max()), float(np.sqrt(np.mean(deviation**2))))


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Fit(Result):
    """A force law fitted to elasticity, beside what stoss computes.

    All is in SI with a material, else in the units in which the bodies were given: c is √(E/ρ) there.

    Attributes:
        law: Name of the law.
        program: Whose integration the law has, and whose `lines` there are; None of the law by itself.
        friction: Coefficient μ of Coulomb's law.
        misfit: Largest and root mean square deviation from stoss of `restitution`, of
            `contact_time`, relative, and of `tangential_restitution`, where the law has them.
        constants: Constants of the law, by name.
        lines: The law in the words of the program.
        fitted: The law itself: `restitution(speed)`, `contact_time(speed)` and
            `tangential_restitution(speed, sliding)` take arrays.
        speed: Speed of approach.
        restitution, law_restitution: ε as stoss computes it, and of the law.
        contact_time, law_contact_time: The same of the contact time; NaN of a law without.
        sliding: s/(μv) of the impacts at an angle.
        tangential_restitution, law_tangential_restitution: ε_t at each speed and each `sliding`.
    """

    _name: ClassVar[str] = "fit"
    _axis: ClassVar[str] = "speed"
    _told = ("body", "against", "law", "program", "friction", "misfit", "constants")

    body: Sphere
    against: Against
    law: str
    program: str | None
    friction: float
    misfit: dict[str, Misfit]
    constants: dict[str, float]
    lines: tuple[str, ...]
    fitted: Law = dataclasses.field(repr=False)
    speed: NDArray[np.float64]
    restitution: NDArray[np.float64]
    law_restitution: NDArray[np.float64]
    contact_time: NDArray[np.float64]
    law_contact_time: NDArray[np.float64]
    sliding: NDArray[np.float64]
    tangential_restitution: NDArray[np.float64]
    law_tangential_restitution: NDArray[np.float64]

    def __repr__(self) -> str:
        off = ", ".join(f"{name} off by {each.maximum:.2g} ({each.rms:.2g} rms)" for name, each in self.misfit.items())
        return f"Fit({self.law}, {shown(self.body, self.against)}: {off})"

    def __str__(self) -> str:
        return "\n".join([*self._head(), *self.lines])

    def __post_init__(self) -> None:
        for each in vars(self).values():
            if isinstance(each, np.ndarray):
                each.flags.writeable = False

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write `lines` to a file, under comments that say how far off the law is where the program allows any.

        The file appears whole or not at all.
        """
        head = self._head() if self._program is None or self._program.comment is not None else []
        write_lines(path, (f"{line}\n" for line in [*head, *self.lines]))

    @property
    def _program(self) -> Any:
        return None if self.program is None else _names().PROGRAMS[self.program]

    def _head(self) -> list[str]:
        """The misfit, then law and constants; with a program as its comments."""
        lines = [f"{'misfit':24}{'maximum':>11}{'rms':>11}"]
        for name, each in self.misfit.items():
            relative = name == "contact_time"
            values = (f"{100 * value:.2g} %" if relative else f"{value:.2g}" for value in each)
            lines.append(f"{name:24}" + "".join(f"{value:>11}" for value in values))
        if self.friction > 0.0 and "tangential_restitution" not in self.misfit:
            lines.append("tangential_restitution   not fitted")
        units = self.fitted.UNITS if self.body.material is not None else {}
        lines.append(f"{self.law}: {self.fitted.EQUATION}")
        lines += [f"{name} = {value:.6g} {units.get(name, '')}".rstrip() for name, value in self.constants.items()]
        if self._program is None:
            return lines
        return [f"{self._program.comment or '# '}{line}{self._program.end}" for line in lines]

    def _table(self) -> dict[str, Column]:
        names = ("speed", "restitution", "law_restitution", "contact_time", "law_contact_time")
        return {name: getattr(self, name) for name in names}

    def _unit(self, name: str) -> str:
        units = {"speed": "m/s", "contact_time": "s", "law_contact_time": "s"}
        return units.get(name, "") if self.body.material is not None else ""


def _names() -> Any:
    """All laws and programs; they need SciPy, which the rest of the package does not."""
    try:
        return importlib.import_module("stoss.laws._names")
    except ImportError as error:
        if not (error.name or "").startswith("scipy"):
            raise
        raise ImportError("fit needs SciPy: pip install scipy, or apt install python3-scipy") from None


def _range(speed: Any) -> tuple[float, float]:
    """A slowest and a fastest speed."""
    ends = numbers("speed", speed)
    if ends.shape != (2,) or not 0.0 < ends[0] < ends[1]:
        raise refusal("speed", speed, "(slowest, fastest), two speeds above 0")
    return float(ends[0]), float(ends[1])


@documented
def fit(
    body: Sphere,
    *,
    against: Sphere | HalfSpace | HardWall | str | None = None,
    law: str,
    speed: Sequence[float],
    friction: float = 0.0,
    program: str | None = None,
    threads: int = 0,
    progress: bool = False,
) -> Fit:
    """Fit a force law to elasticity: the constants whose ε, contact time and ε_t come nearest to stoss.

    Nine speeds count equally, at equal distances in their logarithm. The constant that decides ε has the least root mean
    square error of ε. Then the stiffness has that of the contact time, relative, and the stiffness
    along the surface that of ε_t, at nine s/(μv) from 0.5 to 8. A law may be far off: look at `misfit`.

    Parameters:
        body (Sphere): The first body.
        against ('same', Sphere, HalfSpace or HardWall): What it meets: an equal or another sphere,
            an elastic block, or a rigid wall (default).
        law: 'linear', 'tsuji' (Hertz with a constant α), 'viscoelastic' (Kuwabara and Kono,
            Brilliantov and Pöschel), 'hunt-crossley', 'thornton' (elastic–plastic), 'walton' (three
            numbers), 'mujoco' (solref), 'table' (rows of v and ε) or 'polynomial' (of the angle).
        speed: Slowest and fastest speed of approach, c (with a material: m/s).
        friction: Coefficient μ of Coulomb's law, 0 to 5. Without it nothing is said of ε_t.
        program: The law as this program integrates it, with its lines: 'lammps', 'liggghts', 'yade',
            'chrono', 'simbody', 'mujoco', 'gazebo' and others, which a refusal lists. Default: the
            law by itself, whose contact ends where its force is gone.

    Examples:
        >>> ball = stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"])
        >>> best = stoss.fit(ball, against="same", law="viscoelastic", speed=(0.01, 1), program="lammps")
        >>> best
        Fit(viscoelastic, Sphere(poisson=0.3, radius=0.005 m) against Sphere(poisson=0.3, radius=0.005 m):
        restitution off by 0.00018 (0.00011 rms), contact_time off by 0.005 (0.0026 rms))
        >>> print(best.lines[1])
        pair_coeff * * hertz 1.555...e+11 3460... damping viscoelastic tangential linear_nohistory 0 0
    """
    ball: Sphere = instance("body", body, (Sphere,))
    met = choose_against(ball, against, (HardWall,))
    slowest, fastest = _range(speed)
    chosen = choice("law", law, LAWS)
    mu, count, shows = number("friction", friction), integer("threads", threads), boolean("progress", progress)
    (speeds,) = own_units(ball, "fit", speed=np.array([slowest, fastest]))
    _core.check_curve(speeds, 1e-3, 1e-6, count)
    if not 0.0 <= mu <= 5.0:
        raise refusal("friction", friction, "0 to 5")
    laws, wording = _names(), None
    if program is not None:
        of = laws.PROGRAMS[choice("program", program, PROGRAMS)]
        wording = of.laws.get(chosen)
        if wording is None:
            raise InvalidInput.out_of_range("law", f"{chosen} for {program}", ", ".join(of.laws))
        if not of.walls and not isinstance(met, Sphere):
            raise refusal("against", against, f"a stoss.Sphere for {program}")
        if not of.balls and isinstance(met, Sphere):
            raise refusal("against", against, f"a stoss.HalfSpace or a rigid wall for {program}")
    elastic = importlib.import_module("stoss.laws._elastic")
    spring, ratios = (wording.spring, wording.ratios) if wording else (laws.Spring(), laws.KAPPA)
    tells = ratios is not None and chosen not in ("thornton", "mujoco", "table")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", StossWarning)  # said below, once
        impacts: Impacts = elastic.impacts_of(ball, met, slowest, fastest, mu if tells else 0.0, count, shows)
    warn_at(ball, met, speeds, 2)
    its = (wording and wording.law) or laws.LAWS[chosen]
    made: Law = its.fitted(impacts, spring, ratios or laws.KAPPA)
    made = dataclasses.replace(made, friction=mu)  # also where nothing is fitted to it
    return _result(ball, met, chosen, program, mu, made, impacts, () if wording is None else tuple(wording.write(made)))


def _result(
    ball: Sphere, met: Against, law: str, program: str | None, mu: float, made: Law, impacts: Impacts,
    lines: tuple[str, ...],
) -> Fit:  # fmt: skip
    """The law beside the impacts."""
    epsilon, times = made.restitution(impacts.speed), made.contact_time(impacts.speed)
    along = made.tangential_restitution(impacts.speed, impacts.sliding) if impacts.sliding.size else None
    misfit = {"restitution": _misfit(epsilon - impacts.restitution)}
    if times is not None:
        misfit["contact_time"] = _misfit(times / impacts.contact_time - 1.0)
    if along is not None:
        misfit["tangential_restitution"] = _misfit(along - impacts.tangential)
    missing = np.full_like(impacts.speed, np.nan)
    return Fit(
        ball, met, law, program, mu, misfit, made.constants, lines, made, impacts.speed, impacts.restitution, epsilon,
        impacts.contact_time, missing if times is None else times, impacts.sliding, impacts.tangential,
        np.full_like(impacts.tangential, np.nan) if along is None else along,
    )  # fmt: skip
