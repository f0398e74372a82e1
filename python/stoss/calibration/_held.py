"""Constants that are held while others are sought: what they do to these, and which cannot be told from them."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Mapping

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._errors import InvalidInput
from stoss.bodies._losses import LOSSES
from stoss.bodies._material import NAMES, Material
from stoss.bodies._walls import ExponentialWall, HardWall
from stoss.calibration._constants import SIDES, Constant, Meeting, has_own_losses
from stoss.calibration._search import STEP, Search, Solution

ALIKE = 0.98  # cosine from which on two constants change the data in the same way
LEAST = 0.02  # change of the logarithm of a constant, per that of a held one, that is worth a line


@dataclasses.dataclass(frozen=True)
class Held:
    """A constant that was held.

    Attributes:
        name: As that of an unknown one.
        uncertainty: u: it is known within a factor of 1 + u.
        changes: Change of the logarithms of the unknown constants, per that of this one.
        alike: Which of these changes the data in the same way.
    """

    name: str
    uncertainty: float
    changes: NDArray[np.float64]
    alike: tuple[str, ...]


def held_in(meeting: Meeting, unknowns: list[Constant], known: Mapping[str, float]) -> dict[str, float]:
    """Names of the constants that are held, with their u: of named materials those of the list, else 0.

    Refuses names of `known` that are no such constants.
    """
    sought = {each.name for each in unknowns}
    found: dict[str, float] = {}
    for side, solid in zip(SIDES, (meeting.body, meeting.against)):
        material = getattr(solid, "material", None)
        if not isinstance(material, Material) or getattr(solid, "layers", None):
            continue
        listed = _core.uncertainties_of_material(NAMES[material]) if material in NAMES else {}
        for name in ("young", "density", *(() if has_own_losses(solid) else LOSSES), "yield_strength"):
            if getattr(material, name) and side + name not in sought:
                found[side + name] = listed.get("loss" if name in LOSSES else name, 0.0)
        for name in ("yield_hardening", "roughness"):
            if getattr(solid, name, 0.0) and side + name not in sought:
                found[side + name] = 0.0
    for name, its in known.items():
        if name not in found:
            raise InvalidInput.out_of_range(
                "uncertainties", repr(name), ", ".join(found) or "none of these bodies", "constants that are held"
            )
        if not 0.0 <= its <= 10.0:
            raise InvalidInput.out_of_range(
                f"uncertainties {name}", f"{its:g}", "0 to 10", "the constant is known within a factor of 1 + this"
            )
    return found | dict(known)


def held_by(search: Search, solution: Solution, unknowns: list[Constant], names: Mapping[str, float]) -> list[Held]:
    """What each of the held constants does to the unknown ones: δθ = −A δf, by cheap impacts."""
    white = search.whitened(solution.slopes)
    here = search.cheap(solution.meeting)
    found = []
    for name, uncertainty in names.items():
        value = solution.meeting.value(name)
        if value is None:
            continue
        try:
            there = search.cheap(solution.meeting.changed({name: value * math.exp(STEP)}))
        except InvalidInput:  # as a modulus beyond the range of ratios
            continue
        changes = -solution.answer @ ((there - here) / STEP)
        slope = search.whitened((there - here) / STEP)
        its = np.sqrt(slope @ slope)
        cosines = np.abs(white.T @ slope) / np.maximum(np.sqrt((white**2).sum(axis=0)) * its, 1e-300)
        alike = [
            each.name
            for each, cosine, change in zip(unknowns, cosines, changes)
            if cosine > ALIKE and abs(change) > LEAST
        ]
        found.append(Held(name, uncertainty, changes, tuple(alike)))
    return found


def cannot_be_told(
    unknowns: list[Constant], correlation: NDArray[np.float64], held: list[Held], meeting: Meeting
) -> list[str]:
    """What these data do not tell apart, a sentence each."""
    said = []
    for k, one in enumerate(unknowns):
        for j in range(k):
            if abs(correlation[k, j]) > 0.95:
                said.append(
                    f"{unknowns[j].name} and {one.name} are hardly told apart (correlation {correlation[k, j]:.3f})"
                )
    for each in held:
        for name in each.alike:
            k = [its.name for its in unknowns].index(name)
            change = 100.0 * (math.exp(each.changes[k] * math.log(1.1)) - 1.0)
            said.append(
                f"{name} cannot be told from {each.name}: 10 % more of the latter is {change:+.2g} % of the former"
            )
    if any(its.name in LOSSES for its in unknowns) and _is_wall(meeting.against):
        said.append("a rigid wall takes no waves: what those in a real target carry away counts as loss of the body")
    return said


def _is_wall(against: Any) -> bool:
    return isinstance(against, (HardWall, ExponentialWall))
