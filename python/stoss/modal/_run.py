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
from stoss.modal._elasticity import Elasticity
from stoss.modal._mesh import Sizes, is_shape, load
from stoss.modal._modes import Spectrum
from stoss.modal._spectra import merged
from stoss.modal._surface import Surface


def run(given: argparse.Namespace) -> None:
    """Writes the file that the arguments ask for."""
    comm = MPI.COMM_WORLD
    progress = Progress(given.output + ".part", _key(given), comm.rank == 0)
    meshes: list[tuple[str, Sizes | None]] = [(given.mesh, None)]
    if is_shape(given.mesh):
        sizes = Sizes(given.size, given.size_at_point)
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
    mesh, length = load(path, given.scale, given.point, sizes, comm, thick)
    surface = Surface(mesh, length, given.point, given.normal, given.tangent)
    curvature = given.curvature or tuple(k / length for k in surface.curvature)
    if min(curvature) < 0.0:
        raise InvalidInput.out_of_range("curvature", f"{min(curvature):.4g} 1/m, a hollow", "0 or more", "--curvature")
    body = Elasticity(mesh, given.poisson)
    unknowns, tetrahedra = body.mass.getSize()[0], mesh.topology.index_map(3).size_global
    progress.say(f"{kind}mesh: {tetrahedra} tetrahedra, {unknowns} unknowns")
    if finer and given.coarse and _ratio(finer["tetrahedra"], tetrahedra) < 1.1:
        most = int(finer["tetrahedra"] / 1.1**3)
        raise InvalidInput.conflict(path, f"has {tetrahedra} tetrahedra, allowed at most {most}")
    spectrum = Spectrum(body)
    speed, weight = math.sqrt(given.young / given.density), given.density * length**3
    if known is None:
        progress.say(f"{kind}mesh: compliance", lasting=False)
        mean = 0.5 * sum(curvature) * length
        widest = finer["widest"] / length if finer else None
        static = compliance(spectrum, surface, given.poisson, mean, widest)
        soft = 1.0 / (given.young * length)
        known = {
            "tetrahedra": tetrahedra, "unknowns": unknowns, "curvature": curvature,
            "volume": body.volume * length**3,
            "mass": body.volume * weight, "inertia": (body.inertia * weight * length**2).tolist(),
            "centre": (body.centre * length).tolist(), "compliance": static["c0"] * soft,
            "reach": static["reach"] * soft, "widest": static["widest"] * length,
        }  # fmt: skip
        if given.tangent:
            aside = compliance(spectrum, surface, given.poisson, mean, static["widest"], along=True)
            known["tangential_compliance"] = aside["c0"] * soft
            known["tangential_reach"] = aside["reach"] * soft
        progress.keep(str(index), known)
    count = given.modes
    if given.up_to:
        count = spectrum.below((2.0 * math.pi * given.up_to * length / speed) ** 2) - 6
        if count < 1:
            raise InvalidInput.out_of_range("up-to", f"{given.up_to} Hz", "a higher one", "no elastic mode is below it")
    progress.say(f"{kind}mesh: {count} modes", lasting=False)
    modes = spectrum.modes(count, surface, lambda done: progress.say(f"{kind}mesh: mode {done} of {count}", False))
    frequency = modes.pop("omega") * speed / length / (2.0 * math.pi)
    known["modes"] = {"frequency": frequency.tolist()}
    for name, moved in modes.items():
        unit = math.sqrt(weight) * (length**2 if name.endswith("_curvature") else 1.0)
        known["modes"][name] = (moved / unit).tolist()
    progress.keep(str(index), known)
    progress.say(f"{kind}mesh: {len(frequency)} modes and the compliance")
    return known


def _body(given: argparse.Namespace, fine: Any, coarse: Any) -> dict[str, Any]:
    """The keys of the file."""
    growth = 1.0
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

    def error(prefix: str) -> float:
        reach = float(fine[f"{prefix}reach"])
        if coarse is None:
            return reach
        name = f"{prefix}compliance"
        return reach + growth * abs(float(fine[name]) - float(coarse[name]))

    normal = np.asarray(given.normal) / np.linalg.norm(given.normal)
    body = {
        "name": given.name or os.path.splitext(os.path.basename(given.mesh))[0],
        "origin": f"stoss.modal {__version__}, DOLFINx {cpp.__version__}: {files}, "
        + ", ".join(meshes)
        + ("" if coarse else "; errors of the mesh are unknown"),
        "mass": fine["mass"],
        "rotation": {
            "inertia": _rounded(fine["inertia"]),
            "point": _rounded(np.asarray(given.point) - np.asarray(fine["centre"])),
            "normal": normal,
        },
        "curvature": fine["curvature"],
        "young": given.young, "poisson": given.poisson, "density": given.density,
        "compliance": fine["compliance"], "compliance_error": error(""),
        "complete_to": complete,
        "modes": modes,
    }  # fmt: skip
    if given.tangent:
        body["tangent"] = {
            "direction": np.asarray(given.tangent) / np.linalg.norm(given.tangent),
            "compliance": fine["tangential_compliance"],
            "compliance_error": error("tangential_"),
        }
    return body | ({"loss_time": given.loss_time} if given.loss_time else {})


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
