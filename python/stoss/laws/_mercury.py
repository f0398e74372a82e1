"""MercuryDPM: a species for the linear law and one for Tsuji's.

Contacts pull before they part. The spring along the surface of the linear species keeps its path; that of its Mindlin
species is another law, so that of Tsuji is written without friction. Pairs only. Not
tried here. Source: its classes
LinearViscoelasticInteraction, SlidingFrictionInteraction and HertzianViscoelasticInteraction.
"""

from __future__ import annotations

from typing import Any

from stoss.laws._collision import Spring
from stoss.laws._program import Program, Wording, digits


def _species(name: str, law: Any, values: dict[str, float]) -> list[str]:
    return [
        f"auto species = speciesHandler.copyAndAddObject({name}());",
        f"species->setDensity({digits(law.pair.first_density)});",
        *(f"species->set{key}({digits(value)});" for key, value in values.items()),
    ]


def _linear(law: Any) -> list[str]:
    values = {"Stiffness": law.stiffness, "Dissipation": law.damping}
    if law.tangential_ratio:
        values |= {"SlidingStiffness": law.tangential_ratio * law.stiffness, "SlidingDissipation": 0.0}
        values |= {"SlidingFrictionCoefficient": law.friction}
    return _species("LinearViscoelasticSlidingFrictionSpecies", law, values)


def _tsuji(law: Any) -> list[str]:
    values = {"EffectiveElasticModulus": law.modulus, "Dissipation": law.alpha}
    return _species("HertzianViscoelasticSpecies", law, values)


PULLS = Spring(tension=True)
MERCURY = Program(
    {"linear": Wording(_linear, PULLS), "tsuji": Wording(_tsuji, PULLS, None)}, comment="// ", walls=False
)
