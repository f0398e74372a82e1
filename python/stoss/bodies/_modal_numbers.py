"""The numbers of a body by its modes as they come from users: the names they have, and made ready for the core."""

from __future__ import annotations

import json
from typing import Any, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import number, numbers, refusal
from stoss._errors import InvalidInput
from stoss.bodies._faces import FACE
from stoss.bodies._kinds import Specification

FORMAT = "stoss modal body 1"
NUMBERS = ("mass", "young", "poisson", "density", "compliance", "loss_time", "compliance_error", "complete_to")
ALONG = ("tangential_displacement", "tangential_displacement_curvature", "tangential_displacement_error")
LISTS = ("frequency", "displacement", "displacement_curvature", "frequency_error", "displacement_error", *ALONG)
TANGENT = ("direction", "compliance", "compliance_error", "mass", "inertia", "arm", "cross")
NESTED = {"modes": LISTS, "rotation": ("inertia", "point", "normal"), "tangent": TANGENT}


def ready(its: Any) -> dict[str, Any]:
    """What a ModalBody keeps of what it was given: read-only arrays, finite numbers, its mappings in plain names."""
    made: dict[str, Any] = {}
    for name in LISTS:
        given = getattr(its, name)
        needed = name in ("frequency", "displacement")
        made[name] = _fixed(name, given) if needed or given is not None else None
    count = made["frequency"].size
    for name in ("frequency_error", "displacement_error"):
        made[name] = _fixed(name, np.zeros(count)) if made[name] is None else made[name]
    highest = made["frequency"][-1] if count else None
    for name in FACE:
        made[name] = number(name, getattr(its, name))
    for name in NUMBERS:
        given = getattr(its, name)
        if name != "complete_to" or given is not None or highest is None:
            made[name] = _finite(name, number(name, given))
    made.setdefault("complete_to", None if highest is None else float(highest))
    bends = _finite("curvature", numbers("curvature", its.curvature))
    if bends.shape not in ((), (2,)):
        raise refusal("curvature", its.curvature, "one number or two in 1/m (0: a plane)")
    made["curvature"] = float(bends) if bends.ndim == 0 else (float(bends[0]), float(bends[1]))
    for name, needs in (("rotation", "inertia, point and normal"), ("tangent", "direction and compliance")):
        given = getattr(its, name)
        if given is None:
            continue
        if not isinstance(given, Mapping):
            raise refusal(name, given, f"a mapping with {needs}")
        made[name] = {str(inner): _inner(name, str(inner), each) for inner, each in given.items()}
    if not isinstance(its.held, (bool, np.bool_)):
        raise refusal("held", its.held, "True or False")
    made["held"] = bool(its.held)
    for name in ("name", "origin"):
        if not isinstance(getattr(its, name), str):
            raise refusal(name, getattr(its, name), "a text")
    return made


def require(document: Specification) -> None:
    """Refuse what the core refuses of a body."""
    try:
        _core.encounter(json.dumps({"first": {"kind": "modal", "body": document}}))
    except InvalidInput as error:
        raise error.renamed(error.name.removeprefix("first ").removeprefix("body ")) from None


def _finite(name: str, value: Any) -> Any:
    if not np.all(np.isfinite(value)):
        raise refusal(name, value, "finite numbers")
    return value


def _fixed(name: str, given: ArrayLike, most: int = 1) -> NDArray[np.float64]:
    """A read-only copy of a list, or of what has so many dimensions."""
    array = _finite(name, numbers(name, given))
    if not 1 <= array.ndim <= most:
        raise refusal(name, given, "a list of numbers")
    array.flags.writeable = False
    return array  # type: ignore[no-any-return]


def _inner(where: str, name: str, given: Any) -> Any:
    """A number of a tangent, or a list."""
    if where == "tangent" and name != "direction":
        return _finite(name, number(f"tangent {name}", given))
    return _fixed(name, given, 2)
