"""Plates with an edge, rectangles and discs, meshed in layers around a block that is fine at the point."""

from __future__ import annotations

import argparse
import dataclasses
import math
import re
from typing import Any, Sequence

from stoss._errors import InvalidInput
from stoss.modal._supports import NUMBER, Support

EDGES = ("free", "supported", "clamped")
SIZES = re.compile("x".join([f"({NUMBER})"] * 3))
DISC = re.compile("x".join([f"({NUMBER})"] * 2))
BLOCK = 3.6
"""Half of the width of the block around the point, in thicknesses."""
NEAR = 1.0 / 25.0
"""Edges at the point, in thicknesses."""
WAVE = 4.0
"""Edges far from it for each wavelength of the highest mode."""
STIFF = 1e4
"""Of springs that hold an edge as good as a clamp, in E/thickness for each unit of area."""


@dataclasses.dataclass(frozen=True)
class Plate:
    """Its widths, or its diameter, and thickness, and the point that is struck, from its middle: in m."""

    widths: tuple[float, ...]
    thickness: float
    at: tuple[float, float]

    @property
    def distance(self) -> float:
        """From the point to the edge, negative outside."""
        if len(self.widths) == 1:
            return 0.5 * self.widths[0] - math.hypot(*self.at)
        return min(0.5 * width - abs(x) for width, x in zip(self.widths, self.at))

    @property
    def area(self) -> float:
        """Of one face."""
        return math.pi / 4.0 * self.widths[0] ** 2 if len(self.widths) == 1 else self.widths[0] * self.widths[1]

    def __str__(self) -> str:
        what = "disc" if len(self.widths) == 1 else "plate"
        return f"{what} {'x'.join(f'{size:g}' for size in (*self.widths, self.thickness))} m"


def add_options(parser: argparse.ArgumentParser) -> None:
    """Those of a plate, in place of a mesh."""
    add = parser.add_argument
    add("--plate", metavar="LxWxH", help="a rectangular plate in place of a mesh: length, width, thickness")
    add("--disc", metavar="DxH", help="a circular one: diameter, thickness")
    add("--edge", choices=EDGES, help="of the plate (default free)")
    add("--at", metavar="X,Y", help="struck so far from its middle (default 0,0)")


def plate_of(given: argparse.Namespace, unit: float) -> Plate | None:
    """That of the arguments, if there is one. Raises InvalidInput."""
    if given.plate is None and given.disc is None:
        for name in ("edge", "at"):
            if getattr(given, name) is not None:
                raise InvalidInput.conflict(name, "is of a plate or a disc", "--plate LxWxH or --disc DxH")
        return None
    if given.plate is not None and given.disc is not None:
        raise InvalidInput.conflict("plate", "give a plate or a disc, not both")
    name = "plate" if given.plate is not None else "disc"
    for other in ("mesh", "point", "normal"):
        if getattr(given, other) is not None:
            raise InvalidInput.conflict(other, f"with a {name}, which has its own: its upper face", "--at X,Y")
    text = getattr(given, name)
    found = (SIZES if name == "plate" else DISC).fullmatch(text)
    sizes = [unit * float(each) for each in found.groups()] if found else []
    if not found or not all(0.0 < each < math.inf for each in sizes):
        raise InvalidInput.out_of_range(
            name, f"'{text}'", "LxWxH, lengths above 0" if name == "plate" else "DxH, lengths above 0", "as 0.3x0.01"
        )
    at = re.fullmatch(f"({NUMBER}),({NUMBER})", given.at or "0,0")
    if not at:
        raise InvalidInput.out_of_range("at", f"'{given.at}'", "X,Y from the middle")
    made = Plate(tuple(sizes[:-1]), sizes[-1], (unit * float(at[1]), unit * float(at[2])))
    if max(made.widths) > 200.0 * made.thickness:
        raise InvalidInput.out_of_range(name, f"'{text}'", "up to 200 thicknesses wide", "the mesh grows too large")
    if made.distance < made.thickness:
        raise InvalidInput.out_of_range(
            "at", f"{made.distance / unit:.4g} from the edge", f"a thickness, {made.thickness / unit:.4g}, or more"
        )
    return made


def support_of(plate: Plate, edge: str | None, young: float) -> tuple[Support, ...]:
    """What holds its edge. Supported: it does not move up, down or along itself, and is free to turn."""
    if edge == "clamped":
        return (Support("edge"),)
    if edge == "supported":
        return (Support("edge", 0.0, STIFF * young / plate.thickness, each=True),)
    return ()


def mesh_plate(gmsh: Any, plate: Plate, sizes: Any) -> None:
    """Leaves its mesh in Gmsh: quadratic tetrahedra, two layers of them, or one of the coarser mesh."""
    geo, half = gmsh.model.geo, 0.5 * plate.thickness
    layers = 1 if sizes.coarser > 1.0 else 2
    block = min(BLOCK * plate.thickness, 0.65 * plate.distance)
    outer = _outline(geo, plate.widths, half)
    corners = [geo.addPoint(plate.at[0] + s * block, plate.at[1] + t * block, half) for s, t in _SQUARE]
    inner = [geo.addLine(corners[i], corners[(i + 1) % 4]) for i in range(4)]
    loops = [geo.addCurveLoop(outer), geo.addCurveLoop(inner)]
    frame, top = geo.addPlaneSurface(loops), geo.addPlaneSurface([loops[1]])
    made = geo.extrude([(2, frame)], 0.0, 0.0, -plate.thickness, numElements=[layers])
    sides = [tag for _, tag in made[2:]]
    geo.synchronize()
    lower = []
    for side in sides[4:]:
        for _, curve in gmsh.model.getBoundary([(2, side)], oriented=False):
            ends = gmsh.model.getBoundary([(1, curve)], oriented=False)
            if all(gmsh.model.getValue(0, point, [])[2] < 0.0 for _, point in ends):
                lower.append(curve)
    bottom = geo.addPlaneSurface([geo.addCurveLoop(lower, reorient=True)])
    geo.addVolume([geo.addSurfaceLoop([top, bottom, *sides[4:]])])
    geo.synchronize()
    gmsh.model.setPhysicalName(2, gmsh.model.addPhysicalGroup(2, sides[:4]), "edge")
    centres = [entity for entity in gmsh.model.getEntities(0) if not len(gmsh.model.getAdjacencies(*entity)[0])]
    gmsh.model.removeEntities(centres)  # of arcs, which would be nodes without a tetrahedron
    even = 12.0 * sizes.near
    x, y = (f"({name}-({value!r}))" for name, value in zip("xy", plate.at))
    grown = f"{sizes.near!r}+0.25*(Sqrt({x}^2+{y}^2+(z-{half!r})^2+{even!r}^2)-{even!r})"
    field = gmsh.model.mesh.field.add("MathEval")
    gmsh.model.mesh.field.setString(field, "F", f"{sizes.coarser!r}*({grown})")
    gmsh.model.mesh.field.setAsBackgroundMesh(field)
    options = {"MeshSizeMax": sizes.coarser * sizes.far, "MeshSizeFromPoints": 0, "MeshSizeExtendFromBoundary": 0,
               "ElementOrder": 2, "HighOrderOptimize": 0, "Algorithm": 6}  # fmt: skip
    for name, value in options.items():
        gmsh.option.setNumber(f"Mesh.{name}", value)
    gmsh.model.mesh.generate(3)


_SQUARE = ((-1, -1), (1, -1), (1, 1), (-1, 1))


def _outline(geo: Any, widths: Sequence[float], height: float) -> list[int]:
    """Four curves around the upper face."""
    if len(widths) == 2:
        points = [geo.addPoint(0.5 * s * widths[0], 0.5 * t * widths[1], height) for s, t in _SQUARE]
        return [geo.addLine(points[i], points[(i + 1) % 4]) for i in range(4)]
    radius, middle = 0.5 * widths[0], geo.addPoint(0.0, 0.0, height)
    around = ((1, 0), (0, 1), (-1, 0), (0, -1))
    points = [geo.addPoint(radius * s, radius * t, height) for s, t in around]
    return [geo.addCircleArc(points[i], middle, points[(i + 1) % 4]) for i in range(4)]


def far_size(plate: Plate, modes: int) -> float:
    """Edges far from the point: for the waves of so many modes, by their number in an area, and the plate's widths."""
    wave = math.sqrt(math.pi * plate.area / modes)
    return min(wave / WAVE, min(plate.widths) / 8.0)
