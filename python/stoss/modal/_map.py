"""The map of ε over the surface of a body: each point as a body file would have it, all from the same modes."""

from __future__ import annotations

import argparse
import collections
import copy
import dataclasses
import warnings
from typing import Any, Sequence

import numpy as np
from mpi4py import MPI
from numpy.typing import NDArray

from stoss._errors import InvalidInput, StossWarning
from stoss.bodies._modal import ModalBody
from stoss.bodies._solids import Sphere
from stoss.export._files import require_writable
from stoss.modal._body import body_of
from stoss.modal._compliance import Pressures, pressures
from stoss.modal._map_files import names_of, write_map
from stoss.modal._map_options import in_short
from stoss.modal._places import Places, places_on
from stoss.modal._progress import FORMAT, Progress, plain
from stoss.modal._solve import Meshed, Solved, meshes_of
from stoss.results._restitution import restitution

TOLERANCE = 0.01
"""The relative error of 1 − ε² that is asked for; where it is not reached, the value has a larger one."""

Vector = NDArray[np.float64]


@dataclasses.dataclass(frozen=True)
class Map:
    """ε at points of a surface: rows are speeds.

    Attributes:
        places: The points, in m, and triangles between them.
        speeds: In m/s.
        restitution, error, contact_time: NaN where they are not known.
        reasons: Why not, of each point; "" if they are.
        origin: The meshes it comes from.
    """

    places: Places
    speeds: Vector
    restitution: Vector
    error: Vector
    contact_time: Vector
    reasons: Sequence[str]
    origin: str

    def counts(self) -> list[tuple[str, int]]:
        """Reasons why points have no value, and at how many."""
        return collections.Counter(reason for reason in self.reasons if reason).most_common()


def run_map(given: argparse.Namespace, progress: Progress) -> None:
    """Writes the files of the map that the arguments ask for."""
    for name in names_of(given):
        require_writable(name)
    meshes = meshes_of(given)
    comm = MPI.COMM_WORLD
    found: list[list[Any]] = []
    places: Any = None
    for index, (path, sizes) in enumerate(meshes):
        known = comm.bcast(progress.results.get(str(index)))
        if known is None:
            known = _told(given, progress, index, path, sizes, places, found[0] if found else None)
        else:
            progress.say(f"{'coarse ' * bool(index)}mesh: results of an earlier run, {progress.path}")
        places = places or Places.of_dict(known["places"])
        found.append(known["points"])
    if comm.rank == 0:
        made = _mapped(given, progress, places, found)
        for path in write_map(given, made):
            progress.say(f"written: {path}")
        for reason, count in made.counts():
            progress.say(f"no value at {count} of {len(places.points)} points: {reason}")
    progress.done()


def _told(
    given: argparse.Namespace, progress: Progress, index: int, path: str, sizes: Any, places: Any, finer: Any
) -> dict[str, Any]:
    """What one mesh tells of all points: of each a dictionary as a body file needs it, or why there is none."""
    kind = "coarse " if index else ""
    progress.say(f"{kind}mesh: {path}", lasting=False)
    meshed = Meshed(given, progress, index, path, sizes)
    if places is None:
        places = places_on(meshed.skin, meshed.length, given.points)
        progress.say(f"{len(places.points)} points on the surface")
    told: list[Any] = [each if isinstance(each, str) else None for each in finer or [None] * len(places.points)]
    pressed: list[Pressures] = []
    for at, why in enumerate(told):
        if why is not None:
            continue
        try:
            surface = meshed.surface(places.points[at], places.normals[at], guessed=finer is None)
            places.normals[at] = surface.normal
            mean = 0.5 * sum(meshed.curvature(surface)) * meshed.length
            widest = finer[at]["widest"] / meshed.length if finer else None
            pressed.append(pressures(surface, mean, widest))
        except InvalidInput as error:
            told[at] = in_short(str(error)) + (", for the coarse mesh" if finer else "")
    if not pressed:
        (reason, _), *_ = collections.Counter(told).most_common(1)
        raise InvalidInput.conflict("map", f"at no point ε is known, mostly: {reason}", "--size")
    solved = Solved(meshed, progress, next((each for each in finer or [] if not isinstance(each, str)), None))
    waiting = [at for at, why in enumerate(told) if why is None]
    for at, its in zip(waiting, solved.points(pressed)):
        told[at] = its
        progress.say(f"{kind}mesh: point {at} of {len(told)}", lasting=False)
    known = {"places": places.to_dict(), "points": told}
    progress.keep(str(index), known)
    progress.say(f"{kind}mesh: {len(solved.frequency)} modes, and the compliance at {len(pressed)} points")
    return known


def _mapped(given: argparse.Namespace, progress: Progress, places: Places, found: list[list[Any]]) -> Map:
    """ε at each point, by the document of a body there."""
    shape = (len(given.speed), len(places.points))
    values, errors, times = (np.full(shape, np.nan) for _ in range(3))
    reasons, origin = [""] * shape[1], ""
    for at, each in enumerate(zip(*found)):
        progress.say(f"impact at point {at} of {shape[1]}", lasting=False)
        reasons[at] = next((its for its in reversed(each) if isinstance(its, str)), "")
        if reasons[at]:
            continue
        document = document_at(given, places.points[at], places.normals[at], each)
        origin = document["origin"]
        try:
            hit = _hit(given, ModalBody.from_dict(document))
        except InvalidInput as error:
            reasons[at] = in_short(str(error))
            continue
        known = np.isfinite(hit.restitution_error)
        for column, its in zip((values, errors, times), (hit.restitution, hit.restitution_error, hit.contact_time_si)):
            column[known, at] = its[known]
        if not np.all(known):
            reasons[at] = in_short(str(np.asarray(hit.reason)[~known][0]))
    return Map(places, np.array(given.speed), values, errors, times, reasons, origin)


def document_at(given: argparse.Namespace, point: Vector, normal: Vector, told: Sequence[Any]) -> dict[str, Any]:
    """The document of the body at a point, as its file has it."""
    there = copy.copy(given)
    there.point, there.normal, there.tangent = point.tolist(), normal.tolist(), None
    document: dict[str, Any] = plain({"format": FORMAT, **body_of(there, told[0], told[1] if len(told) > 1 else None)})
    return document


def _hit(given: argparse.Namespace, body: ModalBody) -> Any:
    """ε at all speeds, where the body meets what was asked for, or a sphere meets it."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", StossWarning)
        if isinstance(given.against, Sphere):
            return restitution(given.against, against=body, speed=given.speed, tolerance=TOLERANCE)
        return restitution(body, against=given.against, speed=given.speed, tolerance=TOLERANCE)
