"""One case of a sweep: a body and what it meets, with all that its values depend on but the point."""

from __future__ import annotations

import hashlib
import json
from typing import NamedTuple

from stoss.bodies._bodies import Body
from stoss.bodies._encounter import Against
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


def case_of(place: tuple[int, int], body: Body, against: Against, accuracy: Accuracy) -> Case:
    """A case with all inputs but the point, and their hash; a body of a file by the hash of its document."""
    met = reference(against) if isinstance(against, Solid) else {"kind": "wall"}
    inputs: Specification = {"body": reference(body), "against": met, **accuracy}
    text = json.dumps(inputs, sort_keys=True)
    return Case(place, body, against, inputs, hashlib.sha256(text.encode()).hexdigest()[:16])
