"""What one mesh tells: its modes over all of its surface, and its static compliance at points."""

from __future__ import annotations

import argparse
import dataclasses
import hashlib
import math
import os
from typing import Any, Iterator, Sequence

import numpy as np
from mpi4py import MPI
from numpy.typing import NDArray

from stoss import __version__
from stoss._errors import InvalidInput
from stoss.modal._body import arrays, ratio, share
from stoss.modal._compliance import Pressures, compliances
from stoss.modal._elasticity import Elasticity, Held, displacements
from stoss.modal._mesh import Sizes, is_shape, load
from stoss.modal._modes import Spectrum
from stoss.modal._progress import Progress
from stoss.modal._skin import Skin
from stoss.modal._supports import holds
from stoss.modal._surface import Surface

LARGE = 10.0
"""Diagonal in m of bodies that are more often in another unit."""
OUTER = 0.7
"""Share of the volume that tetrahedra at the surface may have where errors of frequencies are of a high order."""

Vector = NDArray[np.float64]


def meshes_of(given: argparse.Namespace) -> list[tuple[str, Sizes | None]]:
    """Files, and the sizes of the meshes to be made of a shape: the fine one, and the coarse one if there is one."""
    if given.shape or is_shape(given.mesh):
        sizes = Sizes(given.size, given.size_at_point, plate=given.shape)
        made: list[tuple[str, Sizes | None]] = [(given.mesh, sizes)]
        if not given.errors_unknown:
            made.append((given.mesh, dataclasses.replace(sizes, coarser=given.coarser)))
        return made
    return [(given.mesh, None)] + ([(given.coarse, None)] if given.coarse else [])


class Meshed:
    """A mesh with its surface, and what holds it, before anything is solved.

    Attributes:
        skin: Its surface.
        length: That in m by which its lengths are divided.
        smooth: Whether errors of frequencies are of a high order: meshes of a shape that differ by the length of
            edges alone, of a free body without notches and without walls of few tetrahedra.
    """

    def __init__(
        self, given: argparse.Namespace, progress: Progress, index: int, path: str, sizes: Sizes | None
    ) -> None:
        self.given, self.path, self.kind = given, path, "coarse " if index else ""
        thick = index == 0 and bool(given.coarse or not given.errors_unknown)
        names = sorted({each.surface for each in given.supports})
        unit = 1.0 if given.shape else given.scale
        loaded = load(path, unit, given.point, sizes, MPI.COMM_WORLD, thick, names)
        mesh, self.length, self._surfaces, outer = loaded
        if index == 0 and given.unit is None and 2.0 * self.length > LARGE:
            progress.say(
                f"the body measures {2.0 * self.length:.3g} m from corner to corner, as no unit is given:"
                " if its lengths are in mm, --unit mm"
            )
        self.skin = Skin(displacements(mesh))
        alike = sizes is not None and not given.shape and outer < OUTER
        self.smooth = alike and not holds(given.supports) and not self.skin.notched()
        self._held = [(each, self.skin.marked(self._surfaces[each.surface])) for each in given.supports]

    def surface(
        self,
        point: Sequence[float],
        normal: Sequence[float],
        tangent: Sequence[float] | None = None,
        guessed: bool = False,
    ) -> Surface:
        """What is near a point. Refuses one on what is held, and a hollow."""
        surface = Surface(self.skin, self.length, point, normal, tangent, guessed)
        for each, marked in self._held:
            if np.any(marked[surface.facets]):
                raise InvalidInput.conflict(
                    "point", f"it lies on '{each.surface}', or beside it: {each}", "another point"
                )
        bends = self.curvature(surface)
        if sum(bends) < 0.0:
            raise InvalidInput.out_of_range(
                "curvature", f"{bends[0]:.4g} and {bends[1]:.4g} 1/m, a hollow", "a sum of 0 or more", "--curvature"
            )
        return surface

    def curvature(self, surface: Surface) -> tuple[float, float]:
        """That which is given, or else the mesh's, 1/m."""
        first, second = self.given.curvature or tuple(k / self.length for k in surface.curvature)
        return first, second

    def held(self) -> list[Held]:
        """What holds the body, in units with E = ρ = 1."""
        found = []
        stiffness, weight = self.given.young * self.length, self.given.density * self.length**3
        for each, _ in self._held:
            unit = stiffness / self.length**2 if each.each else stiffness
            springs = each.normal / unit, each.tangential / unit, each.mass / weight
            found.append(Held(self._surfaces[each.surface], *springs, each.each))
        return found


class Solved:
    """The modes of a mesh. Lengths in m, else in units with E = ρ = 1 and half the diagonal.

    Attributes:
        whole: What it says of the body as a whole, in SI.
        frequency: In Hz.
    """

    def __init__(self, meshed: Meshed, progress: Progress, finer: Any) -> None:
        given, self.meshed = meshed.given, meshed
        self.given = given
        length, kind = meshed.length, meshed.kind
        body = Elasticity(meshed.skin.space, given.poisson, meshed.held())
        unknowns, tetrahedra = body.mass.getSize()[0], body.mesh.topology.index_map(3).size_global
        progress.say(f"{kind}mesh: {tetrahedra} tetrahedra, {unknowns} unknowns")
        if finer and given.coarse and ratio(finer["tetrahedra"], tetrahedra) < 1.1:
            most = int(finer["tetrahedra"] / 1.1**3)
            raise InvalidInput.conflict(meshed.path, f"has {tetrahedra} tetrahedra, allowed at most {most}")
        self.spectrum = Spectrum(body)
        self.speed, self.weight = math.sqrt(given.young / given.density), given.density * length**3
        self.whole = {
            "tetrahedra": tetrahedra, "unknowns": unknowns, "curved": meshed.skin.curved, "smooth": meshed.smooth,
            "mass": body.volume * self.weight,
            "inertia": (body.inertia * self.weight * length**2).tolist(), "centre": (body.centre * length).tolist(),
        }  # fmt: skip
        count = given.modes
        if given.up_to:
            count = self.spectrum.below((2.0 * math.pi * given.up_to * length / self.speed) ** 2) - len(body.rigid)
            if count < 1:
                raise InvalidInput.out_of_range(
                    "up-to", f"{given.up_to} Hz", "a higher one", "no elastic mode is below it"
                )
        progress.say(f"{kind}mesh: {count} modes", lasting=False)
        omega, self._shapes = self.spectrum.modes(
            count, meshed.skin, lambda done: progress.say(f"{kind}mesh: mode {done} of {count}", False)
        )
        self.frequency = omega * self.speed / length / (2.0 * math.pi)

    def modes(self, surface: Surface) -> dict[str, list[float]]:
        """At a point: in SI, as the file has them."""
        nodes, weights = surface.weights()
        found = {"frequency": self.frequency.tolist()}
        axes = {"": surface.normal}
        if surface.tangent is not None:
            axes["tangential_"] = surface.tangent
        for prefix, axis in axes.items():
            moved = self._shapes[:, nodes] @ axis @ weights.T / math.sqrt(self.weight)
            found[f"{prefix}displacement"] = moved[:, 0].tolist()
            found[f"{prefix}displacement_curvature"] = (moved[:, 1] / self.meshed.length**2).tolist()
        return found

    def points(self, pressed: Sequence[Pressures], along: Sequence[Pressures] = ()) -> Iterator[dict[str, Any]]:
        """What the mesh tells of points where these pressures act, in SI."""
        soft = 1.0 / (self.given.young * self.meshed.length)
        poisson = self.given.poisson
        aside = compliances(self.spectrum, poisson, along)
        for one, (constant, reach) in zip(pressed, compliances(self.spectrum, poisson, pressed)):
            surface = one.surface
            its: dict[str, Any] = {
                "curvature": self.meshed.curvature(surface), "modes": self.modes(surface),
                "compliance": constant * soft, "reach": reach * soft, "widest": one.widest * self.meshed.length,
            }  # fmt: skip
            if surface.tangent is not None:
                constant, reach = next(aside)
                its |= {"tangential_compliance": constant * soft, "tangential_reach": reach * soft}
            if holds(self.given.supports):
                for prefix in ("", "tangential_") if surface.tangent is not None else ("",):
                    its[f"{prefix}compliance"] += share(arrays(its["modes"]), prefix, self.spectrum.apart)
            yield self.whole | its


def key_of(given: argparse.Namespace) -> str:
    """Of what the results depend on: the files and the arguments."""
    state = hashlib.sha256(__version__.encode())
    for path in (given.mesh, given.coarse):
        if path and os.path.isfile(path):
            with open(path, "rb") as stream:
                state.update(stream.read())
    asked = {
        name: value for name, value in vars(given).items() if name not in ("output", "name", "map", "speed", "against")
    }
    state.update(repr(sorted(asked.items())).encode())
    return state.hexdigest()
