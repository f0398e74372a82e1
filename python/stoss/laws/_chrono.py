"""Chrono: a smooth contact with constants of the user, `Hooke` for the linear law, `Hertz` for the viscoelastic one.

Damping is per reduced mass, `Hertz` has R√δ before both constants, and forces never pull. Friction has no spring that
remembers: it is that of sliding. Pairs only. Not tried
here. Source: its class ChContactSMC.
"""

from __future__ import annotations

from typing import Any

from stoss.laws._collision import Spring
from stoss.laws._program import Program, Wording, digits


def _lines(law: Any, model: str, size: float) -> list[str]:
    values = {"Kn": law.stiffness / size, "Gn": law.damping / (law.pair.mass * size), "Kt": 0.0, "Gt": 0.0}
    values["Friction"] = law.friction
    return [
        "chrono::ChSystemSMC system(false);  // constants of the user",
        f"system.SetContactForceModel(chrono::ChSystemSMC::{model});",
        "auto material = chrono_types::make_shared<chrono::ChMaterialSurfaceSMC>();",
        *(f"material->Set{name}({digits(value)});" for name, value in values.items()),
    ]


def _linear(law: Any) -> list[str]:
    return _lines(law, "Hooke", 1.0)


def _viscoelastic(law: Any) -> list[str]:
    return _lines(law, "Hertz", law.pair.radius)


PUSHES = Spring()
CHRONO = Program(
    {"linear": Wording(_linear, PUSHES, None), "viscoelastic": Wording(_viscoelastic, PUSHES, None)},
    comment="// ",
    walls=False,
)
