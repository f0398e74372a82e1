"""One case of a sweep: a body and what it meets, with all that its values depend on but the point."""

from __future__ import annotations

import hashlib
import json
import math
from typing import NamedTuple, Sequence

from stoss.bodies._bodies import Body
from stoss.bodies._encounter import Against, yield_speed_of, yield_warning_of
from stoss.bodies._solid import Solid, Specification
from stoss.sweeps._bodies import reference
from stoss.sweeps._computation import Accuracy


class Case(NamedTuple):
    """One body and what it meets: all points along the axes have its modes in common."""

    place: tuple[int, int]
    body: Body
    against: Against
    inputs: Specification
    key: str


def yield_warning(cases: Sequence[Case], fastest: float) -> str:
    """What the core says of the cases that yield first, m/s; nothing if none yields."""
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
