"""MuJoCo: `solref` and `solimp` of a default geometry.

The time step must resolve the contact, which is much shorter than the time constant. Friction brakes sliding and has
no spring. Tried with version 2.2.2. Source: its documentation, Modeling, Solver
parameters.
"""

from __future__ import annotations

from typing import Any

from stoss.laws._collision import Spring
from stoss.laws._program import Program, Wording, digits

IMPEDANCE = 0.9
"""d, which does not count along the normal."""


def _lines(law: Any) -> list[str]:
    solref = f"{digits(law.timeconst)} {digits(law.dampratio)}"
    solimp = f"{IMPEDANCE} {IMPEDANCE} {digits(law.pair.first_radius)}"
    friction = f'condim="3" friction="{digits(law.friction)} 0 0"' if law.friction else 'condim="1"'
    return [f'<default><geom solref="{solref}" solimp="{solimp}" {friction}/></default>']


MUJOCO = Program({"mujoco": Wording(_lines, Spring(), None)}, comment="<!-- ", end=" -->")
