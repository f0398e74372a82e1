"""Bodies."""

from __future__ import annotations

from typing import Union

from stoss.bodies._modal import ModalBody
from stoss.bodies._faces import FACE
from stoss.bodies._kinds import KINDS
from stoss.bodies._solid import is_rigid
from stoss.bodies._solids import Disk as Disk, HollowSphere as HollowSphere, Rod as Rod, Sphere as Sphere
from stoss.bodies._walls import UNBOUNDED, Unbounded

Body = Union[Disk, Rod, Sphere, HollowSphere, ModalBody]
"""Any body: a disk, a rod, a sphere, solid or hollow, or one by its modes at a point."""

BODIES = (Disk, Rod, Sphere, HollowSphere, ModalBody)
"""The classes of bodies, for isinstance."""

PARTNERS = (*BODIES, *UNBOUNDED)
"""The classes of what a body can meet that is no wall."""


def shown(body: Body | Unbounded, against: object = None) -> str:
    """The body, and what it meets if that is no wall, in the line that says what a result is."""
    if isinstance(against, PARTNERS):
        return f"{shown(body)} against {shown(against)}"
    if body.material is None or KINDS[body._kind].from_file:
        return repr(body)
    if layers := getattr(body, "layers", None):
        return f"{type(body).__name__}({len(layers)} layers)"
    said = [f"poisson={body.poisson:.6g}"] if hasattr(body, "poisson") else []
    lengths = [each.name for each in KINDS[body._kind].parameters if each.unit == "m"]
    lengths = [name for name in lengths if name not in FACE or getattr(body, name)]
    said += [f"{name}={getattr(body, name):g} m" for name in lengths]
    return f"{type(body).__name__}({', '.join([*said, *['rigid'] * is_rigid(body)])})"
