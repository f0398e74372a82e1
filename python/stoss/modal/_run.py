"""The pipeline: meshes, modes, compliance, file."""

from __future__ import annotations

import argparse
from typing import Any

from mpi4py import MPI

from stoss.modal._body import body_of
from stoss.modal._compliance import pressures
from stoss.modal._map import run_map
from stoss.modal._mesh import Sizes
from stoss.modal._progress import Progress, write
from stoss.modal._solve import Meshed, Solved, key_of, meshes_of


def run(given: argparse.Namespace) -> None:
    """Writes the file that the arguments ask for."""
    comm = MPI.COMM_WORLD
    progress = Progress(given.output + ".part", key_of(given), comm.rank == 0)
    if given.map:
        run_map(given, progress)
        return
    meshes = meshes_of(given)
    fine = _solve(given, progress, 0, *meshes[0], None)
    coarse = _solve(given, progress, 1, *meshes[1], fine) if len(meshes) > 1 else None
    body = body_of(given, fine, coarse)
    if comm.rank == 0:
        write(given.output, body)
    progress.say(f"written: {given.output}")
    progress.done()


def _solve(
    given: argparse.Namespace, progress: Progress, index: int, path: str, sizes: Sizes | None, finer: Any
) -> Any:
    """All that one mesh tells of the point, in SI; a coarser one in the same way as the finer."""
    kind = "coarse " if index else ""
    known = MPI.COMM_WORLD.bcast(progress.results.get(str(index)))
    if known is not None:
        progress.say(f"{kind}mesh: results of an earlier run, {progress.path}")
        return known
    progress.say(f"{kind}mesh: {path}", lasting=False)
    meshed = Meshed(given, progress, index, path, sizes)
    surface = meshed.surface(given.point, given.normal, given.tangent)
    mean = 0.5 * sum(meshed.curvature(surface)) * meshed.length
    pressed = pressures(surface, mean, finer["widest"] / meshed.length if finer else None)
    aside = [pressures(surface, mean, pressed.widest, along=True)] if given.tangent else []
    solved = Solved(meshed, progress, finer)
    progress.say(f"{kind}mesh: compliance", lasting=False)
    known = next(solved.points([pressed], aside))
    progress.keep(str(index), known)
    progress.say(f"{kind}mesh: {len(solved.frequency)} modes and the compliance")
    return known
