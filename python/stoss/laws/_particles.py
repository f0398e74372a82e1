"""Programs of particles that make their constants of one ε: Kratos, MFIX, Lethe."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
from scipy import optimize

from stoss._arguments import refusal
from stoss.laws._granular import solid
from stoss.laws._program import PULLS, PUSHES, Program, Wording, digits

# Kratos: materials and their relation, as MaterialsDEM.json has them. Its law of Hertz is Tsuji's, never pulls, and has
# α = √6 γ, where γ follows from the ε that it is given by a polynomial of C. Thornton and others (Powder Technology
# 233, 30, 2013). That is right within 3e-4 up to 0.9; of 0.99 it makes 0.979, of 0.999 0.984, and beyond γ is 0. So it
# is given the number of which it makes this α. Along the surface it has a dashpot of the same γ: ε_t is not fitted. Not
# tried here. Source: its class DEM_D_Hertz_viscous_Coulomb, and GammaForHertzThornton.


THORNTON = (
    0.0, -6.918798, -16.41105, 146.8049, -796.4559, 2928.711, -7206.864, 11494.29, -11342.18, 6276.757, -1489.915,
)  # fmt: skip
"""ln of 1/(1 + e)² (1 − 1/(1 + γ²)) = Σ THORNTON[i] eⁱ."""


def alpha_of(e: float) -> float:
    """What Kratos makes of a restitution up to 0.999."""
    inverse = 1.0 - (1.0 + e) ** 2 * math.exp(np.polynomial.Polynomial(THORNTON)(e))
    return math.sqrt(6.0 * (1.0 / inverse - 1.0))


def restitution_of(alpha: float) -> float:
    """The restitution of which Kratos makes this α."""
    if not alpha_of(0.999) <= alpha <= alpha_of(0.001):
        allowed = f"{alpha_of(0.999):.4g} to {alpha_of(0.001):.4g} (what Kratos makes of a restitution)"
        raise refusal("alpha", alpha, allowed)
    return float(optimize.brentq(lambda e: alpha_of(e) - alpha, 0.001, 0.999, xtol=1e-14))


def _kratos_lines(law: Any) -> list[str]:
    young, nu = solid(law)
    ball = {"PARTICLE_DENSITY": law.pair.first_density, "YOUNG_MODULUS": young, "POISSON_RATIO": nu}
    relation = {"COEFFICIENT_OF_RESTITUTION": restitution_of(law.alpha)}
    relation |= {"STATIC_FRICTION": law.friction, "DYNAMIC_FRICTION": law.friction, "FRICTION_DECAY": 0.0}
    relation |= {"ROLLING_FRICTION": 0.0, "ROLLING_FRICTION_WITH_WALLS": 0.0}
    of_ball, of_pair = ({name: float(digits(value)) for name, value in each.items()} for each in (ball, relation))
    kind: dict[str, Any] = {"DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME": "DEM_D_Hertz_viscous_Coulomb"}
    document = {
        "materials": [{"material_name": "ball", "material_id": 1, "Variables": of_ball}],
        "material_relations": [
            {"material_names_list": ["ball", "ball"], "material_ids_list": [1, 1], "Variables": kind | of_pair}
        ],
        "material_assignation_table": [["SpheresPart", "ball"]],
    }
    return json.dumps(document, indent=2).splitlines()


KRATOS = Program({"tsuji": Wording(_kratos_lines, PUSHES, None)}, comment=None, walls=False)


# MFIX: keywords of the linear spring and dashpot, whose contacts pull before they part. With DES_ETAT_FAC = 0 nothing
# damps along the surface. At walls the keywords have a W. Not tried here. Source: its keywords of the discrete element
# model, and calc_force_dem.f.


def _mfix_lines(law: Any) -> list[str]:
    wall = law.pair.second_radius is None
    w, of_wall = ("_w", "_wall") if wall else ("", "")
    values = {f"kn{w}": law.stiffness, f"kt{w}_fac": law.tangential_ratio or 0.0, f"des_etat{w}_fac": 0.0}
    values |= {f"mew{w}": law.friction, f"des_en{of_wall}_input(1)": law.epsilon}
    return ["des_coll_model = 'LSD'", *(f"{name} = {digits(value)}" for name, value in values.items())]


MFIX = Program({"linear": Wording(_mfix_lines, PULLS)}, comment="! ")


# Lethe: properties of a type of particles, and of the wall. Its Hertzian laws have α = −√5 ln e/√(ln²e + π²), contacts
# pull before they part, and a dashpot acts along the surface: ε_t is not fitted. Not tried here. Source: its parameter
# guide, Lagrangian Physical Properties, and the class SphericalParticleContactForce.


def _lethe_lines(law: Any) -> list[str]:
    young, nu = solid(law)
    values = {"young modulus": young, "poisson ratio": nu, "restitution coefficient": law.nominal}
    values |= {"friction coefficient": law.friction}
    lines = ["subsection lagrangian physical properties", "  set number of particle types = 1"]
    lines += ["  subsection particle type 0", f"    set diameter = {digits(2.0 * law.pair.first_radius)}"]
    lines += [f"    set density particles = {digits(law.pair.first_density)}"]
    lines += [f"    set {name} particles = {digits(value)}" for name, value in values.items()] + ["  end"]
    if law.pair.second_radius is None:
        lines += [f"  set {name} wall = {digits(value)}" for name, value in values.items()]
    return [*lines, "end"]


LETHE = Program({"tsuji": Wording(_lethe_lines, PULLS, None)})
