"""What simulation programs need to know of a law: how each integrates it, and how it wants it written."""

from __future__ import annotations

from typing import Any, Callable, Mapping, NamedTuple

from stoss.laws._law import KAPPA, Law, Spring


class Wording(NamedTuple):
    """A law in the words of a program.

    `ratios` are the stiffnesses along the surface over that along the normal that it can have; None if its friction
    has no spring. `law` takes the place of the law of that name, if the program has another power of the overlap.
    """

    write: Callable[[Any], list[str]]
    spring: Spring
    ratios: tuple[float, float] | None = KAPPA
    law: type[Law] | None = None


class Program(NamedTuple):
    """The laws that a program has, and how its comments begin and end: `comment` is None of a file without any.

    `walls` and `balls` say what a ball can meet in it.
    """

    laws: Mapping[str, Wording]
    comment: str | None = "# "
    end: str = ""
    walls: bool = True
    balls: bool = True


def digits(value: float) -> str:
    """A number for an input file: the shortest of ten digits."""
    return f"{value:.10g}"


PUSHES, PULLS = Spring(), Spring(tension=True)
RISES = Spring(tension=False, rising=True)


# Chrono: a smooth contact with constants of the user, `Hooke` for the linear law, `Hertz` for the viscoelastic one.
# Damping is per reduced mass, `Hertz` has R√δ before both constants, and forces never pull. Friction has no spring
# that remembers: it is that of sliding. Pairs only. Not tried here. Source: its class ChContactSMC.


def _chrono_lines(law: Any, model: str, size: float) -> list[str]:
    values = {"Kn": law.stiffness / size, "Gn": law.damping / (law.pair.mass * size), "Kt": 0.0, "Gt": 0.0}
    values["Friction"] = law.friction
    return [
        "chrono::ChSystemSMC system(false);  // constants of the user",
        f"system.SetContactForceModel(chrono::ChSystemSMC::{model});",
        "auto material = chrono_types::make_shared<chrono::ChMaterialSurfaceSMC>();",
        *(f"material->Set{name}({digits(value)});" for name, value in values.items()),
    ]


def _chrono_linear(law: Any) -> list[str]:
    return _chrono_lines(law, "Hooke", 1.0)


def _chrono_viscoelastic(law: Any) -> list[str]:
    return _chrono_lines(law, "Hertz", law.pair.radius)


CHRONO = Program(
    {"linear": Wording(_chrono_linear, PUSHES, None), "viscoelastic": Wording(_chrono_viscoelastic, PUSHES, None)},
    comment="// ",
    walls=False,
)


# MercuryDPM: a species for the linear law and one for Tsuji's. Contacts pull before they part. The spring along the
# surface of the linear species keeps its path; that of its Mindlin species is another law, so that of Tsuji is
# written without friction. Pairs only. Not tried here. Source: its classes LinearViscoelasticInteraction,
# SlidingFrictionInteraction and HertzianViscoelasticInteraction.


def _mercury_species(name: str, law: Any, values: dict[str, float]) -> list[str]:
    return [
        f"auto species = speciesHandler.copyAndAddObject({name}());",
        f"species->setDensity({digits(law.pair.first_density)});",
        *(f"species->set{key}({digits(value)});" for key, value in values.items()),
    ]


def _mercury_linear(law: Any) -> list[str]:
    values = {"Stiffness": law.stiffness, "Dissipation": law.damping}
    if law.tangential_ratio:
        values |= {"SlidingStiffness": law.tangential_ratio * law.stiffness, "SlidingDissipation": 0.0}
        values |= {"SlidingFrictionCoefficient": law.friction}
    return _mercury_species("LinearViscoelasticSlidingFrictionSpecies", law, values)


def _mercury_tsuji(law: Any) -> list[str]:
    values = {"EffectiveElasticModulus": law.modulus, "Dissipation": law.alpha}
    return _mercury_species("HertzianViscoelasticSpecies", law, values)


MERCURY = Program(
    {"linear": Wording(_mercury_linear, PULLS), "tsuji": Wording(_mercury_tsuji, PULLS, None)},
    comment="// ",
    walls=False,
)


# MuJoCo: `solref` and `solimp` of a default geometry. The time step must resolve the contact, which is much shorter
# than the time constant. Friction brakes sliding and has no spring. Tried with version 2.2.2. Source: its
# documentation, Modeling, Solver parameters.


IMPEDANCE = 0.9
"""d, which does not count along the normal."""


def _mujoco_lines(law: Any) -> list[str]:
    solref = f"{digits(law.timeconst)} {digits(law.dampratio)}"
    solimp = f"{IMPEDANCE} {IMPEDANCE} {digits(law.pair.first_radius)}"
    friction = f'condim="3" friction="{digits(law.friction)} 0 0"' if law.friction else 'condim="1"'
    return [f'<default><geom solref="{solref}" solimp="{solimp}" {friction}/></default>']


MUJOCO = Program({"mujoco": Wording(_mujoco_lines, Spring(), None)}, comment="<!-- ", end=" -->")


# Altair AcuTrace and Aspherix: rows of a speed and ε, as `stoss table --format two-column` writes them.


def _rows(law: Any) -> list[str]:
    return [f"{digits(speed)} {digits(value)}" for speed, value in zip(law.speeds, law.values)]


TWO_COLUMNS = Program({"table": Wording(_rows, Spring(), None)}, comment=None)
