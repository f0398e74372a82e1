"""One case of a sweep: a body and what it meets, with all that its values depend on but the point."""

from __future__ import annotations

import hashlib
import json
import math
from typing import NamedTuple, Sequence

from stoss.bodies._bodies import Body
from stoss.bodies._encounter import Against, material_warnings_of, yield_speed_of, yield_warning_of
from stoss.bodies._solid import Solid, Specification
from stoss.sweeps._bodies import reference
from stoss.sweeps._computation import Accuracy


MOST_WARNINGS = 4
"""Of losses in the materials of different cases, in one sweep."""


class Case(NamedTuple):
    """One body and what it meets: all points along the axes have its modes in common."""

    place: tuple[int, int]
    body: Body
    against: Against
    inputs: Specification
    key: str


def material_warnings(cases: Sequence[Case], slowest: float, fastest: float) -> list[str]:
    """What the core says of the materials of the cases, m/s: of yielding the worst case, of losses the first few."""
    yields = _yield_warning(cases, fastest)
    said = [yields] if yields else []
    others: dict[str, int] = {}
    for case in cases:
        for text in material_warnings_of(case.body, case.against, slowest, fastest):
            if "yields above" not in text:
                others[text] = others.get(text, 0) + 1
    said += list(others)[:MOST_WARNINGS]
    left = len(others) - MOST_WARNINGS
    return said + ([f"{left} more warnings of other cases like the last"] if left > 0 else [])


def _yield_warning(cases: Sequence[Case], fastest: float) -> str:
    onsets = [(yield_speed_of(case.body, case.against) or math.inf, place) for place, case in enumerate(cases)]
    beyond = sum(onset < fastest for onset, _ in onsets)
    if beyond == 0:
        return ""
    first = cases[min(onsets)[1]]
    said = yield_warning_of(first.body, first.against, fastest)
    return said if len(cases) == 1 else f"{beyond} of {len(cases)} cases beyond yielding; in the worst {said}"


def case_of(place: tuple[int, int], body: Body, against: Against, accuracy: Accuracy) -> Case:
    """A case with all inputs but the point, and their hash; a body of a file by the hash of its document."""
    met = reference(against) if isinstance(against, Solid) else {"kind": "wall"}
    inputs: Specification = {"body": reference(body), "against": met, **accuracy}
    text = json.dumps(inputs, sort_keys=True)
    return Case(place, body, against, inputs, hashlib.sha256(text.encode()).hexdigest()[:16])
