"""LIGGGHTS: `pair_style gran`, or `fix wall/gran` at a wall, with the properties of its materials.

`hertz` makes G* of the Young's modulus and Poisson's ratio that it is given, so that the stiffness along the surface is
2(1 − ν)/(2 − ν) of that along the normal, 2/3 to 1: these two numbers are chosen for the stiffnesses, and are not
those of the solid. Its α is √5 ln e/√(ln²e + π²), which is right for contacts that pull before they part, as here.
Tangential damping is off. Tried with version 3.8.0. Source: its pages on the gran models.
"""

from __future__ import annotations

import math
from typing import Any

from stoss.laws._collision import Spring
from stoss.laws._program import Program, Wording, digits

MINDLIN = (2.0 / 3.0, 1.0)
"""2(1 − ν)/(2 − ν) for ν = ½ and 0."""


EXPECTED = (5e6, 1e9)
"""Young's moduli beyond which LIGGGHTS wants to be told that this is meant."""


def solid(law: Any) -> tuple[float, float]:
    """Young's modulus and Poisson's ratio of two equal bodies with the stiffnesses of a Hertzian law."""
    ratio = law.tangential_ratio or 1.0
    nu = max((2.0 - 2.0 * ratio) / (2.0 - ratio), 0.0)
    return 2.0 * law.modulus * (1.0 - nu**2), nu


def _lines(law: Any, model: str, constants: dict[str, float], of_types: dict[str, float]) -> list[str]:
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


def _linear(law: Any) -> list[str]:
    along = (law.tangential_ratio or 1.0) * law.stiffness
    constants = {"kn": law.stiffness, "kt": along, "gamman_abs": law.damping, "gammat_abs": 0.0}
    return _lines(law, "hooke/stiffness", constants, {})


def _tsuji(law: Any) -> list[str]:
    young, nu = solid(law)
    return _lines(law, "hertz", {"coefficientRestitution": law.nominal}, {"youngsModulus": young, "poissonsRatio": nu})


def _viscoelastic(law: Any) -> list[str]:
    root = math.sqrt(law.pair.radius)
    along = 1.5 * (law.tangential_ratio or 1.0) * law.stiffness / root
    constants = {"kn": law.stiffness / root, "kt": along, "gamman": law.damping / (law.pair.mass * root), "gammat": 0.0}
    return _lines(law, "hertz/stiffness", constants, {})


PULLS = Spring(tension=True)
LIGGGHTS = Program(
    {
        "linear": Wording(_linear, PULLS),
        "tsuji": Wording(_tsuji, PULLS, MINDLIN),
        "viscoelastic": Wording(_viscoelastic, PULLS),
    }
)
