"""Yade: `ViscElMat` for the linear law, `FrictMat` with Mindlin's physics for Tsuji's.

`ViscElMat` halves its constants for a pair. `betan` makes c = 2β√(m dF/dδ), so α = √6 β. Forces never pull, and the one
along the surface rises by today's stiffness. As in LIGGGHTS, Young's modulus and Poisson's ratio are chosen for the two
stiffnesses. At walls Yade takes another radius: pairs only. Tried with version 2023.02a. Source: its class reference.
"""

from __future__ import annotations

import math
from typing import Any

from stoss.laws._collision import Spring
from stoss.laws._liggghts import MINDLIN, solid
from stoss.laws._program import Program, Wording, digits


def _engines(functor: str, physics: str, law: str) -> list[str]:
    return [f"{functor} = [Ig2_Sphere_Sphere_ScGeom()], [{physics}], [{law}()]"]


def _linear(law: Any) -> list[str]:
    along = (law.tangential_ratio or 1.0) * law.stiffness
    constants = {"kn": 2.0 * law.stiffness, "cn": 2.0 * law.damping, "ks": 2.0 * along, "cs": 0.0}
    return [
        f"material = ViscElMat({_words(constants)}, {_solid(law)})",
        *_engines("contact", "Ip2_ViscElMat_ViscElMat_ViscElPhys()", "Law2_ScGeom_ViscElPhys_Basic"),
    ]


def _tsuji(law: Any) -> list[str]:
    young, nu = solid(law)
    beta = f"MatchMaker(matches=((0, 0, {digits(law.alpha / math.sqrt(6.0))}),))"
    physics = f"Ip2_FrictMat_FrictMat_MindlinPhys(betan={beta}, betas=MatchMaker(matches=((0, 0, 0),)))"
    return [
        f"material = FrictMat({_words({'young': young, 'poisson': nu})}, {_solid(law)})",
        *_engines("contact", physics, "Law2_ScGeom_MindlinPhys_Mindlin"),
    ]


def _solid(law: Any) -> str:
    return _words({"density": law.pair.first_density, "frictionAngle": math.atan(law.friction)})


def _words(given: dict[str, float]) -> str:
    return ", ".join(f"{name}={digits(value)}" for name, value in given.items())


RISES = Spring(tension=False, rising=True)
YADE = Program({"linear": Wording(_linear, RISES), "tsuji": Wording(_tsuji, RISES, MINDLIN)}, walls=False)
