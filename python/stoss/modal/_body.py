"""The document of a body at a point, from what two meshes tell."""

from __future__ import annotations

import argparse
import math
import os
from typing import Any

import numpy as np
from dolfinx import cpp

from stoss import __version__
from stoss.modal._spectra import merged
from stoss.modal._supports import holds

SECOND = 2.0
"""Order in the length of edges that errors have at least."""
SMOOTH = 2.75, 5.0
"""Between which orders those of frequencies of smooth bodies lie, measured (docs/developer/bodies.md)."""
COMPLIANCE = 3.0
"""That of the compliance along the normal; that along the tangent has the least one."""
LONGEST = 1.7
"""How much longer edges of the coarse mesh may be where orders above the least one are taken."""


def body_of(given: argparse.Namespace, fine: Any, coarse: Any) -> dict[str, Any]:
    """The keys of the file, from what each mesh tells of the point: without a coarse one its errors are unknown."""
    held, longer = holds(given.supports), given.coarser
    if coarse is not None and given.coarse is not None:
        longer = ratio(fine["tetrahedra"], coarse["tetrahedra"])
    growth = max(1.0, beyond(longer, SECOND))
    both = [arrays(each["modes"]) for each in (fine, coarse) if each is not None]
    modes = merged(both[0], both[1] if len(both) > 1 else None, growth, bounds(fine, coarse or fine, longer, growth))
    complete, count = float(modes.pop("complete_to")[0]), int(modes.pop("count")[0])
    meshes = [f"{each['tetrahedra']} tetrahedra ({each['unknowns']} unknowns)" for each in (fine, coarse) if each]
    files = " and ".join(os.path.basename(each) for each in (given.mesh, given.coarse) if each)

    def statics(prefix: str) -> dict[str, float]:
        """The compliance and its error, of a held body that of what its modes leave."""
        values = [float(each[f"{prefix}compliance"]) for each in (fine, coarse) if each]
        if held:
            values = [value - share(each, prefix, count) for value, each in zip(values, both)]
        whole = share(modes, prefix, len(modes["frequency"])) if held else 0.0
        alike = not prefix and given.coarse is None  # meshes of a shape, finer at the point by as much as elsewhere
        off = (beyond(min(longer, LONGEST), COMPLIANCE) if alike else growth) * abs(values[0] - values[-1])
        return {"compliance": values[0] + whole, "compliance_error": float(fine[f"{prefix}reach"]) + off}

    normal = np.asarray(given.normal) / np.linalg.norm(given.normal)
    motion: dict[str, Any] = {"held": True}
    if not held:
        arm = _rounded(np.asarray(given.point) - np.asarray(fine["centre"]))
        motion = {"rotation": {"inertia": _rounded(fine["inertia"]), "point": arm, "normal": normal}}
    body = {
        "name": given.name or (str(given.shape) if given.shape else os.path.splitext(os.path.basename(given.mesh))[0]),
        "origin": f"stoss.modal {__version__}, DOLFINx {cpp.__version__}: {files}, "
        + ", ".join(meshes)
        + "".join(f", {each}" for each in given.supports)
        + ("" if coarse else "; errors of the mesh are unknown"),
        "mass": fine["mass"],
        **motion,
        "curvature": fine["curvature"],
        "young": given.young, "poisson": given.poisson, "density": given.density,
        **statics(""),
        "complete_to": complete,
        "modes": modes,
    }  # fmt: skip
    if given.tangent:
        body["tangent"] = {
            "direction": np.asarray(given.tangent) / np.linalg.norm(given.tangent),
            **statics("tangential_"),
            **({"inertia": 0.0, "arm": 0.0} if held else {}),
        }
    return body | ({"loss_time": given.loss_time} if given.loss_time else {})


def beyond(longer: float, order: float) -> float:
    """An error of this order of the fine mesh over its difference from the coarse one, with edges so much longer."""
    return float(1.0 / (longer**order - 1.0))


def bounds(fine: Any, coarse: Any, longer: float, growth: float) -> tuple[float, float]:
    """Least and most that errors of frequencies are of the differences between both meshes."""
    if not fine["curved"]:
        return -growth, growth  # straight edges cut a round body smaller, or fill a hollow one
    if not (fine["smooth"] and coarse["smooth"]) or longer > LONGEST:
        return 0.0, growth  # a mesh only makes a body stiffer
    most, least = (beyond(longer, order) for order in SMOOTH)
    return least, most


def share(modes: dict[str, Any], prefix: str, count: int) -> float:
    """What the lowest modes have of the compliance: of a slender body that is held nearly all."""
    moved = modes[f"{prefix}displacement"][:count] / (2.0 * math.pi * modes["frequency"][:count])
    return float(moved @ moved)


def _rounded(values: Any) -> Any:
    """Without what is only rounding beside the largest."""
    return np.where(np.abs(values) < 1e-12 * np.max(np.abs(values)), 0.0, values)


def ratio(fine: int, coarse: int) -> float:
    """How much longer the edges of a mesh are, by its tetrahedra."""
    return float((fine / coarse) ** (1.0 / 3.0))


def arrays(modes: dict[str, list[float]]) -> dict[str, Any]:
    return {name: np.asarray(values) for name, values in modes.items()}
