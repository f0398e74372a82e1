"""LAMMPS: `pair_style granular`, or `fix wall/gran granular` at a wall.

`hertz` has F = k_n √R δ^{3/2} and, with `viscoelastic` damping, η √(Rδ) m δ̇; `tsuji` damping asks for a restitution e
from which it makes α by a polynomial, 0.0003 at e = 1, so an almost elastic α needs an e slightly above 1. Contacts
pull before they part. Tried with the version of 29 September 2021. Source: its page on pair_style granular.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from scipy import optimize

from stoss._arguments import refusal
from stoss.laws._collision import Spring
from stoss.laws._program import Program, Wording, digits

ALPHA = (1.2728, -4.2783, 11.087, -22.348, 27.467, -18.022, 4.8218)
"""α = Σ ALPHA[i] eⁱ."""


def nominal(alpha: float) -> float:
    """The e of which LAMMPS makes this α."""
    polynomial = np.polynomial.Polynomial(ALPHA)
    if not 0.0 < alpha < ALPHA[0]:
        raise refusal("alpha", alpha, f"0 to {ALPHA[0]} (what LAMMPS makes of a restitution)")
    return float(optimize.brentq(lambda e: polynomial(e) - alpha, 0.0, 1.002, xtol=1e-14))


def _contact(law: Any, normal: str, damping: str, spring: str, stiffness: float | None) -> list[str]:
    """One contact: its normal force, its damping, and friction."""
    along = f"{spring} {digits(stiffness)} 0 {digits(law.friction)}" if stiffness else "linear_nohistory 0 0"
    words = f"{normal} damping {damping} tangential {along}"
    if law.pair.second_radius is None:
        return [f"fix wall all wall/gran granular {words} zplane 0.0 NULL"]
    return ["pair_style granular", f"pair_coeff * * {words}"]


def _linear(law: Any) -> list[str]:
    normal = f"hooke {digits(law.stiffness)} {digits(law.damping)}"
    along = law.tangential_ratio and law.tangential_ratio * law.stiffness
    return _contact(law, normal, "velocity", "linear_history", along)


def _hertz(law: Any, damping: str, value: float) -> list[str]:
    modulus = law.stiffness / math.sqrt(law.pair.radius)
    along = law.tangential_ratio and 1.5 * law.tangential_ratio * modulus
    return _contact(law, f"hertz {digits(modulus)} {digits(value)}", damping, "mindlin", along)


def _tsuji(law: Any) -> list[str]:
    return _hertz(law, "tsuji", nominal(law.alpha))


def _viscoelastic(law: Any) -> list[str]:
    return _hertz(law, "viscoelastic", law.damping / (law.pair.mass * math.sqrt(law.pair.radius)))


PULLS = Spring(tension=True)
LAMMPS = Program(
    {
        "linear": Wording(_linear, PULLS),
        "tsuji": Wording(_tsuji, PULLS),
        "viscoelastic": Wording(_viscoelastic, PULLS),
    }
)
