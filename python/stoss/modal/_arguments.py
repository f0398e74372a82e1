"""What `python -m stoss.modal` takes from the command line."""

from __future__ import annotations

import argparse
import math
import operator
import re
from typing import Any, Callable, NoReturn, Sequence

from stoss._errors import InvalidInput
from stoss.modal import _map_options, _plates
from stoss.modal._supports import add_options, supports_of

WORDS = """The modes of a body and its compliance at one point of its surface, by finite elements.

Give two meshes of the same body, fine and coarse, for errors: each number errs by what it differs
between them. From a shape (.geo, .step, .brep) both are made here. The file is for stoss."""

SHAPES = (".geo", ".step", ".stp", ".brep")
UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6}


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise InvalidInput.conflict("arguments", message, "see python -m stoss.modal --help")


def _numbers(*counts: int) -> Callable[[str], tuple[float, ...]]:
    """Takes so many numbers, or any number of them, with commas between them."""

    def numbers(text: str) -> tuple[float, ...]:
        values = tuple(float(part) for part in text.split(","))
        if (counts and len(values) not in counts) or not all(map(math.isfinite, values)):
            raise ValueError
        return values

    numbers.__name__ = f"list of {counts[-1] if counts else ''} numbers with commas".replace("  ", " ")
    return numbers


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="python -m stoss.modal", description=WORDS, allow_abbrev=False,
                     formatter_class=argparse.RawDescriptionHelpFormatter)  # fmt: skip
    parser._negative_number_matcher = re.compile(r"^-[\d.]")  # --normal -1,0,0 is no option
    add = parser.add_argument
    add("mesh", nargs="?", help="Gmsh mesh of tetrahedra (.msh), or a shape (.geo, .step, .brep)")
    add("coarse", nargs="?", help="a coarser mesh of the same body, for the errors")
    add("-o", "--output", metavar="FILE", help="what is written, JSON")
    place: dict[str, Any] = {"type": _numbers(3), "metavar": "X,Y,Z"}
    add("--point", **place, help="contact point, in the unit of the mesh")
    add("--normal", **place, help="outward normal of the surface there")
    add("--tangent", **place, help="direction of friction, along the surface: for oblique impacts")
    add("--unit", choices=UNITS, help="of mesh, point and sizes (default m)")
    add("--material", metavar="NAME", help="one of stoss.materials; or these three:")
    add("--young", type=float, metavar="PA", help="Young's modulus")
    add("--poisson", type=float, metavar="NU", help="Poisson's ratio")
    add("--density", type=float, metavar="KG/M3", help="density")
    add("--loss-time", type=float, metavar="S", help="of a Kelvin-Voigt material (default: none)")
    add("--modes", type=int, metavar="N", help="at least so many (default 50, of a plate 80)")
    add("--up-to", type=float, metavar="HZ", help="all modes up to this frequency instead")
    add("--curvature", type=_numbers(1, 2), metavar="K1,K2", help="default: the mesh's")
    add("--radius", type=float, metavar="R", help="one radius of curvature instead")
    add("--size", type=float, metavar="H", help="of a shape: edges of the fine mesh")
    add("--size-at-point", type=float, metavar="H", help="at the point (default: an eighth of it)")
    add("--coarser", type=float, default=1.4, metavar="Q", help="of the coarse mesh (1.4)")
    add("--errors-unknown", action="store_true", help="one mesh is enough")
    _plates.add_options(parser)
    add_options(parser)
    _map_options.add_options(parser, _numbers())
    add("--name", help="of the body (default: that of the mesh)")
    return parser


def parse(words: Sequence[str]) -> argparse.Namespace:
    """The arguments, checked as far as they go without a mesh; lengths are in m afterwards."""
    given = _parser().parse_args(words)
    unit = UNITS[given.unit or "m"]
    given.scale = unit
    _map_options.take_map(given)
    given.shape = _plates.plate_of(given, unit)
    if given.shape:
        _take_plate(given, given.shape, unit)
    for name in ("mesh",) if given.map else ("mesh", "point", "normal"):
        if getattr(given, name) is None:
            raise InvalidInput.missing(name, ": MESH --point X,Y,Z --normal X,Y,Z, or --plate LxWxH, or --disc DxH")
    given.modes = given.modes if given.modes is not None else 50
    shape = bool(given.shape) or given.mesh.lower().endswith(SHAPES)
    if given.normal and math.hypot(*given.normal) == 0.0:
        raise InvalidInput.out_of_range("normal", "length 0", "any direction out of the body")
    if given.tangent is not None:
        _perpendicular(given.tangent, given.normal)
    if given.modes < 1:
        raise InvalidInput.out_of_range("modes", given.modes, "1 or more")
    for name in ("size", "size_at_point", "radius", "up_to", "loss_time", "young", "density"):
        value = getattr(given, name)
        if value is not None and not 0.0 < value < math.inf:
            raise InvalidInput.out_of_range(name.replace("_", "-"), value, "above 0")
    if shape and given.size is None:
        raise InvalidInput.missing("size", "the edge length of the mesh to be made of a shape")
    if shape and given.coarse:
        raise InvalidInput.conflict(given.coarse, "a shape needs no second file", "see --coarser")
    if not shape and not given.coarse and not given.errors_unknown:
        raise InvalidInput.conflict(
            "with one mesh the errors are unknown", "give a coarser one too, or --errors-unknown"
        )
    if not 1.1 <= given.coarser <= 4.0:
        raise InvalidInput.out_of_range("coarser", given.coarser, "1.1 to 4")
    if given.point:
        given.point = tuple(unit * x for x in given.point)
    if given.size is not None:
        given.size_at_point = unit * (given.size_at_point or given.size / (1.0 if given.map else 8.0))
        given.size *= unit
    if given.radius is not None:
        given.curvature = (1.0 / (unit * given.radius),) * 2
    elif given.curvature is not None:
        given.curvature = tuple(k / unit for k in given.curvature) * (3 - len(given.curvature))
    _material(given)
    given.supports = supports_of(given)
    if given.shape:
        given.supports += _plates.support_of(given.shape, given.edge, given.young)
    return given


def _take_plate(given: argparse.Namespace, plate: _plates.Plate, unit: float) -> None:
    """The place, the curvature and the sizes of the mesh of a plate, in the unit of the other lengths."""
    given.mesh, given.normal = str(plate), (0.0, 0.0, 1.0)
    given.point = tuple(x / unit for x in (*plate.at, 0.5 * plate.thickness))
    given.curvature, given.radius = (0.0, 0.0), None
    given.modes = given.modes if given.modes is not None else 80
    given.size = given.size or _plates.far_size(plate, max(given.modes, 1)) / unit
    given.size_at_point = given.size_at_point or _plates.NEAR * plate.thickness / unit


def _perpendicular(tangent: Sequence[float], normal: Sequence[float]) -> None:
    length = math.hypot(*tangent) * math.hypot(*normal)
    if length == 0.0:
        raise InvalidInput.out_of_range("tangent", "length 0", "any direction along the surface")
    off = math.degrees(math.asin(min(1.0, abs(sum(map(operator.mul, tangent, normal))) / length)))
    if off > 1.0:
        raise InvalidInput.out_of_range(
            "tangent", f"{off:.1f} degrees off the surface", "up to 1", "a right angle to normal"
        )


def _material(given: argparse.Namespace) -> None:
    constants = (given.young, given.poisson, given.density)
    if given.material is not None:
        if any(each is not None for each in constants):
            raise InvalidInput.conflict("material", "give either a name, or young, poisson and density, not both")
        from stoss import materials

        named = materials[given.material]
        given.young, given.poisson, given.density = named.young, named.poisson, named.density
    elif any(each is None for each in constants):
        raise InvalidInput.missing("material", ": --material NAME, or --young, --poisson, --density")
    if not -1.0 < given.poisson <= 0.49:
        raise InvalidInput.out_of_range("poisson", given.poisson, "-1 to 0.49", "elements lock")
