"""Programs whose contacts keep a spring along the surface: LAMMPS, LIGGGHTS, Yade."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from scipy import optimize

from stoss._arguments import refusal
from stoss.laws._program import PULLS, RISES, Program, Wording, digits

# LAMMPS: `pair_style granular`, or `fix wall/gran granular` at a wall. `hertz` has F = k_n √R δ^{3/2} and, with
# `viscoelastic` damping, η √(Rδ) m δ̇; `tsuji` damping asks for a restitution e from which it makes α by a
# polynomial, 0.0003 at e = 1, so an almost elastic α needs an e slightly above 1. Contacts pull before they part.
# Tried with the version of 29 September 2021. Source: its page on pair_style granular.


ALPHA = (1.2728, -4.2783, 11.087, -22.348, 27.467, -18.022, 4.8218)
"""α = Σ ALPHA[i] eⁱ."""


def nominal(alpha: float) -> float:
    """The e of which LAMMPS makes this α."""
    polynomial = np.polynomial.Polynomial(ALPHA)
    if not 0.0 < alpha < ALPHA[0]:
        raise refusal("alpha", alpha, f"0 to {ALPHA[0]} (what LAMMPS makes of a restitution)")
    return float(optimize.brentq(lambda e: polynomial(e) - alpha, 0.0, 1.002, xtol=1e-14))


def _lammps_contact(law: Any, normal: str, damping: str, spring: str, stiffness: float | None) -> list[str]:
    """One contact: its normal force, its damping, and friction."""
    along = f"{spring} {digits(stiffness)} 0 {digits(law.friction)}" if stiffness else "linear_nohistory 0 0"
    words = f"{normal} damping {damping} tangential {along}"
    if law.pair.second_radius is None:
        return [f"fix wall all wall/gran granular {words} zplane 0.0 NULL"]
    return ["pair_style granular", f"pair_coeff * * {words}"]


def _lammps_linear(law: Any) -> list[str]:
    normal = f"hooke {digits(law.stiffness)} {digits(law.damping)}"
    along = law.tangential_ratio and law.tangential_ratio * law.stiffness
    return _lammps_contact(law, normal, "velocity", "linear_history", along)


def _lammps_hertz(law: Any, damping: str, value: float) -> list[str]:
    modulus = law.stiffness / math.sqrt(law.pair.radius)
    along = law.tangential_ratio and 1.5 * law.tangential_ratio * modulus
    return _lammps_contact(law, f"hertz {digits(modulus)} {digits(value)}", damping, "mindlin", along)


def _lammps_tsuji(law: Any) -> list[str]:
    return _lammps_hertz(law, "tsuji", nominal(law.alpha))


def _lammps_viscoelastic(law: Any) -> list[str]:
    return _lammps_hertz(law, "viscoelastic", law.damping / (law.pair.mass * math.sqrt(law.pair.radius)))


LAMMPS = Program(
    {
        "linear": Wording(_lammps_linear, PULLS),
        "tsuji": Wording(_lammps_tsuji, PULLS),
        "viscoelastic": Wording(_lammps_viscoelastic, PULLS),
    }
)


# LIGGGHTS: `pair_style gran`, or `fix wall/gran` at a wall, with the properties of its materials. `hertz` makes G* of
# the Young's modulus and Poisson's ratio that it is given, so that the stiffness along the surface is 2(1 − ν)/(2 −
# ν) of that along the normal, 2/3 to 1: these two numbers are chosen for the stiffnesses, and are not those of the
# solid. Its α is √5 ln e/√(ln²e + π²), which is right for contacts that pull before they part, as here. Tangential
# damping is off. Tried with version 3.8.0. Source: its pages on the gran models.


MINDLIN = (2.0 / 3.0, 1.0)
"""2(1 − ν)/(2 − ν) for ν = ½ and 0."""


EXPECTED = (5e6, 1e9)
"""Young's moduli beyond which LIGGGHTS wants to be told that this is meant."""


def solid(law: Any) -> tuple[float, float]:
    """Young's modulus and Poisson's ratio of two equal bodies with the stiffnesses of a Hertzian law."""
    ratio = law.tangential_ratio or 1.0
    nu = max((2.0 - 2.0 * ratio) / (2.0 - ratio), 0.0)
    return 2.0 * law.modulus * (1.0 - nu**2), nu


def _liggghts_lines(law: Any, model: str, constants: dict[str, float], of_types: dict[str, float]) -> list[str]:
    """Properties of one kind of particles, or of two, and the contact."""
    types = 1 if law.pair.second_density is not None and _alike(law) else 2
    young = of_types.get("youngsModulus", EXPECTED[0])
    lines = ["soft_particles yes"] * (young < EXPECTED[0]) + ["hard_particles yes"] * (young > EXPECTED[1])
    for name, value in of_types.items():
        lines.append(f"fix {name} all property/global {name} peratomtype {' '.join([digits(value)] * types)}")
    for name, value in {**constants, "coefficientFriction": law.friction}.items():
        values = " ".join([digits(value)] * types**2)
        lines.append(f"fix {name} all property/global {name} peratomtypepair {types} {values}")
    words = f"model {model} tangential history"
    settings = "tangential_damping off" + (" absolute_damping on" if model == "hooke/stiffness" else "")
    if law.pair.second_radius is None:
        return lines + [f"fix wall all wall/gran {words} primitive type 2 zplane 0.0 {settings}"]
    return lines + [f"pair_style gran {words} {settings}", "pair_coeff * *"]


def _alike(law: Any) -> bool:
    pair = law.pair
    return bool(pair.second_radius == pair.first_radius and pair.second_density == pair.first_density)


def _liggghts_linear(law: Any) -> list[str]:
    along = (law.tangential_ratio or 1.0) * law.stiffness
    constants = {"kn": law.stiffness, "kt": along, "gamman_abs": law.damping, "gammat_abs": 0.0}
    return _liggghts_lines(law, "hooke/stiffness", constants, {})


def _liggghts_tsuji(law: Any) -> list[str]:
    young, nu = solid(law)
    of_types = {"youngsModulus": young, "poissonsRatio": nu}
    return _liggghts_lines(law, "hertz", {"coefficientRestitution": law.nominal}, of_types)


def _liggghts_viscoelastic(law: Any) -> list[str]:
    root = math.sqrt(law.pair.radius)
    along = 1.5 * (law.tangential_ratio or 1.0) * law.stiffness / root
    constants = {"kn": law.stiffness / root, "kt": along, "gamman": law.damping / (law.pair.mass * root), "gammat": 0.0}
    return _liggghts_lines(law, "hertz/stiffness", constants, {})


LIGGGHTS = Program(
    {
        "linear": Wording(_liggghts_linear, PULLS),
        "tsuji": Wording(_liggghts_tsuji, PULLS, MINDLIN),
        "viscoelastic": Wording(_liggghts_viscoelastic, PULLS),
    }
)


# Yade: `ViscElMat` for the linear law, `FrictMat` with Mindlin's physics for Tsuji's. `ViscElMat` halves its
# constants for a pair. `betan` makes c = 2β√(m dF/dδ), so α = √6 β. Forces never pull, and the one along the surface
# rises by today's stiffness. As in LIGGGHTS, Young's modulus and Poisson's ratio are chosen for the two stiffnesses.
# At walls Yade takes another radius: pairs only. Tried with version 2023.02a. Source: its class reference.


def _yade_engines(functor: str, physics: str, law: str) -> list[str]:
    return [f"{functor} = [Ig2_Sphere_Sphere_ScGeom()], [{physics}], [{law}()]"]


def _yade_linear(law: Any) -> list[str]:
    along = (law.tangential_ratio or 1.0) * law.stiffness
    constants = {"kn": 2.0 * law.stiffness, "cn": 2.0 * law.damping, "ks": 2.0 * along, "cs": 0.0}
    return [
        f"material = ViscElMat({_words(constants)}, {_yade_solid(law)})",
        *_yade_engines("contact", "Ip2_ViscElMat_ViscElMat_ViscElPhys()", "Law2_ScGeom_ViscElPhys_Basic"),
    ]


def _yade_tsuji(law: Any) -> list[str]:
    young, nu = solid(law)
    beta = f"MatchMaker(matches=((0, 0, {digits(law.alpha / math.sqrt(6.0))}),))"
    physics = f"Ip2_FrictMat_FrictMat_MindlinPhys(betan={beta}, betas=MatchMaker(matches=((0, 0, 0),)))"
    return [
        f"material = FrictMat({_words({'young': young, 'poisson': nu})}, {_yade_solid(law)})",
        *_yade_engines("contact", physics, "Law2_ScGeom_MindlinPhys_Mindlin"),
    ]


def _yade_solid(law: Any) -> str:
    return _words({"density": law.pair.first_density, "frictionAngle": math.atan(law.friction)})


def _words(given: dict[str, float]) -> str:
    return ", ".join(f"{name}={digits(value)}" for name, value in given.items())


YADE = Program({"linear": Wording(_yade_linear, RISES), "tsuji": Wording(_yade_tsuji, RISES, MINDLIN)}, walls=False)
