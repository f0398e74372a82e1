"""The pipeline: meshes, modes, compliance, file."""

from __future__ import annotations

import argparse
import dataclasses
import hashlib
import math
import os
from typing import Any

import numpy as np
from dolfinx import cpp
from mpi4py import MPI

from stoss import __version__
from stoss._errors import InvalidInput
from stoss.modal._progress import Progress, write
from stoss.modal._compliance import compliance
from stoss.modal._elasticity import Elasticity, Held
from stoss.modal._mesh import Sizes, is_shape, load
from stoss.modal._modes import Spectrum
from stoss.modal._spectra import merged
from stoss.modal._supports import holds
from stoss.modal._surface import Surface


def run(given: argparse.Namespace) -> None:
    """Writes the file that the arguments ask for."""
    comm = MPI.COMM_WORLD
    progress = Progress(given.output + ".part", _key(given), comm.rank == 0)
    meshes: list[tuple[str, Sizes | None]] = [(given.mesh, None)]
    if given.shape or is_shape(given.mesh):
        sizes = Sizes(given.size, given.size_at_point, plate=given.shape)
        meshes = [(given.mesh, sizes)]
        if not given.errors_unknown:
            meshes.append((given.mesh, dataclasses.replace(sizes, coarser=given.coarser)))
    elif given.coarse:
        meshes.append((given.coarse, None))
    fine = _solve(given, progress, 0, *meshes[0], None)
    coarse = _solve(given, progress, 1, *meshes[1], fine) if len(meshes) > 1 else None
    body = _body(given, fine, coarse)
    if comm.rank == 0:
        write(given.output, body)
    progress.say(f"written: {given.output}")
    progress.done()


def _solve(
    given: argparse.Namespace,
    progress: Progress,
    index: int,
    path: str,
    sizes: Sizes | None,
    finer: Any,
) -> Any:
    """All that one mesh tells, in SI; a coarser one in the same way as the finer."""
    comm = MPI.COMM_WORLD
    kind = "coarse " if index else ""
    known = comm.bcast(progress.results.get(str(index)))
    if known is not None and "modes" in known:
        progress.say(f"{kind}mesh: results of an earlier run, {progress.path}")
        return known
    progress.say(f"{kind}mesh: {path}", lasting=False)
    thick = index == 0 and bool(given.coarse or not given.errors_unknown)
    names = sorted({each.surface for each in given.supports})
    mesh, length, surfaces = load(path, 1.0 if given.shape else given.scale, given.point, sizes, comm, thick, names)
    surface = Surface(mesh, length, given.point, given.normal, given.tangent)
    curvature = given.curvature or tuple(k / length for k in surface.curvature)
    if min(curvature) < 0.0:
        raise InvalidInput.out_of_range("curvature", f"{min(curvature):.4g} 1/m, a hollow", "0 or more", "--curvature")
    body = Elasticity(mesh, given.poisson, _held(given, surfaces, length, surface))
    unknowns, tetrahedra = body.mass.getSize()[0], mesh.topology.index_map(3).size_global
    progress.say(f"{kind}mesh: {tetrahedra} tetrahedra, {unknowns} unknowns")
    if finer and given.coarse and _ratio(finer["tetrahedra"], tetrahedra) < 1.1:
        most = int(finer["tetrahedra"] / 1.1**3)
        raise InvalidInput.conflict(path, f"has {tetrahedra} tetrahedra, allowed at most {most}")
    spectrum = Spectrum(body)
    speed, weight = math.sqrt(given.young / given.density), given.density * length**3
    mean = 0.5 * sum(curvature) * length
    widest = finer["widest"] / length if finer else None

    def static() -> dict[str, Any]:
        progress.say(f"{kind}mesh: compliance", lasting=False)
        return _static(given, spectrum, surface, mean, widest)

    if known is None:
        known = {
            "tetrahedra": tetrahedra, "unknowns": unknowns, "curvature": curvature,
            "mass": body.volume * weight, "inertia": (body.inertia * weight * length**2).tolist(),
            "centre": (body.centre * length).tolist(),
        }  # fmt: skip
        if not holds(given.supports):
            known |= static()
            progress.keep(str(index), known)
    count = given.modes
    if given.up_to:
        count = spectrum.below((2.0 * math.pi * given.up_to * length / speed) ** 2) - len(body.rigid)
        if count < 1:
            raise InvalidInput.out_of_range("up-to", f"{given.up_to} Hz", "a higher one", "no elastic mode is below it")
    progress.say(f"{kind}mesh: {count} modes", lasting=False)
    modes = spectrum.modes(count, surface, lambda done: progress.say(f"{kind}mesh: mode {done} of {count}", False))
    frequency = modes.pop("omega") * speed / length / (2.0 * math.pi)
    known["modes"] = {"frequency": frequency.tolist()}
    for name, moved in modes.items():
        unit = math.sqrt(weight) * (length**2 if name.endswith("_curvature") else 1.0)
        known["modes"][name] = (moved / unit).tolist()
    if holds(given.supports):
        apart = min(6, len(frequency))
        spectrum.set_apart(apart)
        known |= static()
        for prefix in ("", "tangential_") if given.tangent else ("",):
            known[f"{prefix}compliance"] += _share(_arrays(known["modes"]), prefix, apart)
    progress.keep(str(index), known)
    progress.say(f"{kind}mesh: {len(frequency)} modes and the compliance")
    return known


def _held(given: argparse.Namespace, surfaces: Any, length: float, surface: Surface) -> list[Held]:
    """What holds the body, in units with E = ρ = 1. Refuses a contact on what is held."""
    comm, found = MPI.COMM_WORLD, []
    stiffness, weight = given.young * length, given.density * length**3
    for each in given.supports:
        facets = surfaces[each.surface]
        if comm.allreduce(len(np.intersect1d(facets, surface.facets))):
            raise InvalidInput.conflict("point", f"it lies on '{each.surface}', or beside it: {each}", "another point")
        unit = stiffness / length**2 if each.each else stiffness
        found.append(Held(facets, each.normal / unit, each.tangential / unit, each.mass / weight, each.each))
    return found


def _body(given: argparse.Namespace, fine: Any, coarse: Any) -> dict[str, Any]:
    """The keys of the file."""
    growth, held = 1.0, holds(given.supports)
    if coarse is not None:
        ratio = given.coarser
        if given.coarse is not None:
            ratio = _ratio(fine["tetrahedra"], coarse["tetrahedra"])
        growth = max(1.0, 1.0 / (ratio**2 - 1.0))  # as if all errors were of second order
    both = [_arrays(each["modes"]) for each in (fine, coarse) if each is not None]
    modes = merged(both[0], both[1] if len(both) > 1 else None, growth)
    complete = float(modes.pop("complete_to")[0])
    meshes = [
        f"{each['tetrahedra']} tetrahedra ({each['unknowns']} unknowns)"
        for each in (fine, coarse)
        if each
    ]
    files = " and ".join(os.path.basename(each) for each in (given.mesh, given.coarse) if each)

    def statics(prefix: str) -> dict[str, float]:
        """The compliance and its error, of a held body that of what its modes leave."""
        values = [float(each[f"{prefix}compliance"]) for each in (fine, coarse) if each]
        if held:
            count = int(np.sum(both[0]["frequency"] <= complete))
            values = [value - _share(each, prefix, count) for value, each in zip(values, both)]
        whole = _share(modes, prefix, len(modes["frequency"])) if held else 0.0
        off = growth * abs(values[0] - values[-1])
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


def _static(
    given: argparse.Namespace, spectrum: Spectrum, surface: Surface, curvature: float, widest: Any
) -> dict[str, Any]:
    """The compliances at the point, in SI, with how far they reach."""
    length = surface.length
    soft = 1.0 / (given.young * length)
    found = compliance(spectrum, surface, given.poisson, curvature, widest)
    its = {"compliance": found["c0"] * soft, "reach": found["reach"] * soft, "widest": found["widest"] * length}
    if given.tangent:
        aside = compliance(spectrum, surface, given.poisson, curvature, found["widest"], along=True)
        its |= {"tangential_compliance": aside["c0"] * soft, "tangential_reach": aside["reach"] * soft}
    return its


def _share(modes: dict[str, Any], prefix: str, count: int) -> float:
    """What the lowest modes have of the compliance: of a slender body that is held nearly all."""
    moved = modes[f"{prefix}displacement"][:count] / (2.0 * math.pi * modes["frequency"][:count])
    return float(moved @ moved)


def _rounded(values: Any) -> Any:
    """Without what is only rounding beside the largest."""
    return np.where(np.abs(values) < 1e-12 * np.max(np.abs(values)), 0.0, values)


def _ratio(fine: int, coarse: int) -> float:
    """How much longer the edges of a mesh are, by its tetrahedra."""
    return float((fine / coarse) ** (1.0 / 3.0))


def _arrays(modes: dict[str, list[float]]) -> dict[str, Any]:
    return {name: np.asarray(values) for name, values in modes.items()}


def _key(given: argparse.Namespace) -> str:
    """Of what the results depend on: the files and the arguments."""
    state = hashlib.sha256(__version__.encode())
    for path in (given.mesh, given.coarse):
        if path and os.path.isfile(path):
            with open(path, "rb") as stream:
                state.update(stream.read())
    asked = {name: value for name, value in vars(given).items() if name not in ("output", "name")}
    state.update(repr(sorted(asked.items())).encode())
    return state.hexdigest()
