"""Walls, half-spaces and plates."""

from __future__ import annotations

import dataclasses
import json
from typing import Any, Sequence, Union

from stoss import _core
from stoss._arguments import brief, instance, number, refusal
from stoss._errors import InvalidInput
from stoss.bodies._material import Material, Relaxation
from stoss.bodies._faces import FACE, face_of
from stoss.bodies._kinds import Parameter, Specification
from stoss.bodies._losses import LOSSES, NO_LOSSES, losses_in, losses_of
from stoss.bodies._solid import LEFT_OUT, Endless, Solid, describe
from stoss.bodies._solids import HalfPlane as HalfPlane, HalfSpace as HalfSpace, Strip as Strip


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class Layer(Solid):
    """A layer of a plate, bonded to those above and below.

    Parameters:
        thickness (float, optional): Thickness h, as of a plate. The last layer may have none: it is a
            block, on which the others lie.
        poisson: Poisson's ratio ν, −0.95 to 0.4999; default: that of the sphere.
        young, density: Young's modulus E and density ρ, relative to those of the sphere; default 1.

    Examples:
        >>> stoss.Layer(thickness=0.2, young=1e-2)
        Layer(thickness=0.2, young=0.01)
    """

    _kind = "plate"

    thickness: float | None = LEFT_OUT
    poisson: float | None = LEFT_OUT
    young: float = LEFT_OUT
    density: float = LEFT_OUT
    material: Material | None = None

    def _chosen(self, asked: Parameter, given: Any, made: float | None, material: Material | None) -> float | None:
        if asked.name == "thickness" and given is None:
            return None
        return super()._chosen(asked, given, made, material)

    def _of_one(self, whole: Specification) -> Specification:
        """What of a plate of this layer alone is not of all together."""
        return {name: value for name, value in whole.items() if name not in ("kind", *LOSSES, *FACE) and value is not None}


@dataclasses.dataclass(frozen=True, kw_only=True, repr=False)
class Plate(Endless):
    """An elastic plate, which spheres meet: infinite sideways, free on both faces.

    It bends where it is struck, and waves run away in it: see `Impact.lost_to_second`. It is large
    enough if no wave comes back from its rim before the contact ends. Its yield speed is that of a
    block of its material, or of its first layer's.

    Parameters:
        thickness (float): Thickness h, in the unit of the sphere's radius, or with a material in m.
        poisson: Poisson's ratio ν, −0.95 to 0.4999; default: that of the sphere.
        young, density: Young's modulus E and density ρ, 1e-3 to 1e6 of those of the sphere; default
            1.
        layers (sequence of Layer, optional): In place of these numbers and of `material`, layers from
            the top down, 20 at most, all with a material or none. Then the numbers are those of the
            first. Each layer loses energy as its material does; then `loss_time`, `quality` and
            `relaxation` are None if they are not the same for all. Given, they hold for all layers.

    Examples:
        >>> stoss.Plate(thickness=2, poisson=0.3, young=0.5)
        Plate(thickness=2, poisson=0.3, young=0.5)
        >>> glass, plastic = stoss.materials["glass"], stoss.materials["PVB"]
        >>> pane = stoss.Layer(thickness=4e-3, material=glass)
        >>> safe = stoss.Plate(layers=[pane, stoss.Layer(thickness=8e-4, material=plastic), pane], loss_time=0)
        >>> safe.thickness, safe.young, len(safe.layers)
        (0.004, 70000000000.0, 3)
    """

    _kind = "plate"

    thickness: float = LEFT_OUT
    poisson: float | None = LEFT_OUT
    young: float = LEFT_OUT
    density: float = LEFT_OUT
    loss_time: float = LEFT_OUT
    quality: float = LEFT_OUT
    roughness: float = LEFT_OUT
    u0: float = LEFT_OUT
    coat: float = LEFT_OUT
    coat_young: float = LEFT_OUT
    coat_poisson: float = LEFT_OUT
    coat_quality: float = LEFT_OUT
    yield_strength: float = LEFT_OUT
    yield_hardening: float = LEFT_OUT
    yield_rate: float = LEFT_OUT
    relaxation: Relaxation | None = None
    material: Material | None = None
    layers: Sequence[Layer] | None = None

    def __post_init__(self) -> None:
        if self.layers is None:
            return super().__post_init__()
        if not isinstance(self.layers, (list, tuple)) or not self.layers:
            raise refusal("layers", self.layers, "stoss.Layer objects, from the top down")
        for each in self.layers:
            instance("layers", each, (Layer,))
        top = self.layers[0]
        for name in ("thickness", "poisson", "young", "density", "material"):
            given, its = getattr(self, name), getattr(top, name)
            if given is not None and given != its:
                raise refusal(name, given, "none beside layers")
            object.__setattr__(self, name, its)
        layers = [each._of_one(describe(each)) for each in self.layers]
        losses, face = ({name: getattr(self, name) for name in names if getattr(self, name) is not None}
                        for names in (LOSSES, FACE))
        document: Specification = {"kind": self._kind, "layers": layers, **losses, **face}
        super().__post_init__()
        object.__setattr__(self, "layers", tuple(self.layers) if len(self.layers) > 1 else None)
        materials = [each.material for each in self.layers or ()]
        if not losses and any(each and self.material and losses_of(each) != losses_of(self.material) for each in materials):
            for name in LOSSES:
                object.__setattr__(self, name, None)
        _require(document, self.material)

    def __repr__(self) -> str:
        if self.layers is None:
            return super().__repr__()
        usual = losses_of(self.material) if self.material else NO_LOSSES
        own = {name: getattr(self, name) for name in LOSSES}
        given = ({} if own == usual else losses_in(self)) | face_of(self)
        return f"Plate(layers={list(self.layers)!r}{''.join(f', {name}={brief(its)}' for name, its in given.items())})"

    def _beside(self, body: Any) -> Plate:
        if self.layers is None:
            return super()._beside(body)
        layers = [each if each.poisson is not None else dataclasses.replace(each, poisson=body.poisson)
                  for each in self.layers]
        return Plate(layers=layers, **losses_in(self), **face_of(self))

    def _numbers(self) -> Specification:
        if self.layers is None:
            return super()._numbers()
        layers = [each._of_one(each._numbers()) for each in self.layers]
        return {"kind": self._kind, "layers": layers, **losses_in(self), **face_of(self)}


def _require(plate: Specification, material: Material | None) -> None:
    """Refuse layers that do not go together, as the core does where a sphere meets them."""
    ball: Specification = {"kind": "sphere", "poisson": 0.3}
    if material is not None:
        ball = {"kind": "sphere", "radius": 1.0, "material": "structural steel"}
    try:
        _core.encounter(json.dumps({"first": ball, "against": plate}))
    except InvalidInput as error:
        raise error.renamed(error.name.removeprefix("against ")) from None


def lower_face(against: Any, body: Any) -> float:
    """Its depth, in radii of the body that it meets; infinite of what has none."""
    layers = getattr(against, "layers", None) or [against]
    known = [each.thickness for each in layers if getattr(each, "thickness", None) is not None]
    return float(sum(known) / body.radius) if len(known) == len(layers) else float("inf")


@dataclasses.dataclass(frozen=True, init=False, repr=False)
class HardWall:
    """A rigid wall: no point of the body passes it, and pressure is never negative (Signorini).

    Parameters:
        roughness (float, optional): Height (rms) of the elastic asperities of its face, in the unit of the
            radius of the body, with a material in m; 0: smooth. Their length u₀ is 0.45 of it (± 0.05).
        u0 (float, optional): In place of it: u₀, as in a pressure of p₀ e^(−gap/u₀).
    """

    roughness: float
    u0: float

    def __init__(self, *, roughness: float = 0.0, u0: float = 0.0, tail: None = None) -> None:
        if tail is not None:
            raise TypeError("HardWall: got tail, which is an argument of the call: stoss.impact(..., tail='static')")
        object.__setattr__(self, "roughness", number("roughness", roughness))
        object.__setattr__(self, "u0", number("u0", u0))
        _core.check_face(self.roughness, self.u0)

    def __repr__(self) -> str:
        return f"HardWall({', '.join(f'{name}={brief(value)}' for name, value in face_of(self).items())})"

    def _document(self, per: float = 1.0) -> Any:
        """As an encounter's document has it. @param per unit of its numbers"""
        face = face_of(self, per)
        return {"kind": "wall", **face} if face else "wall"


@dataclasses.dataclass(frozen=True, kw_only=True)
class ExponentialWall:
    """A rigid wall with elastic asperities of the length 1/α, whose pressure at a depth x is αV₀ e^(αx).

    It is the soft wall of Gerl and Zippelius. Theirs pushes on the length of the edge, and the modes that are not
    kept do not answer: that is ``stoss.impact(..., tail="none")``.

    Parameters:
        hardness (float): α, 1/R of the body, 1 to 1e8.
        strength (float): V₀, ρc²R; it shifts the wall by ln V₀/α and changes nothing else.
    """

    hardness: float = 500.0
    strength: float = 1.0

    def __post_init__(self) -> None:
        for name in ("hardness", "strength"):
            object.__setattr__(self, name, number(name, getattr(self, name)))
        _core.check_wall(self.hardness, self.strength)

    def _document(self, per: float = 1.0) -> Any:
        return {"kind": "exponential", "hardness": self.hardness, "strength": self.strength}


Wall = Union[HardWall, ExponentialWall]
"""Any wall: a hard or an exponential one."""

WALLS = (HardWall, ExponentialWall)
"""The classes of walls, for isinstance."""

Unbounded = Union[HalfSpace, HalfPlane, Plate, Strip]
UNBOUNDED = (HalfSpace, HalfPlane, Plate, Strip)
"""The classes of what extends to infinity, for isinstance."""
