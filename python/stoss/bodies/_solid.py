"""What all bodies and blocks have in common: the numbers that the core's table of kinds asks for."""

from __future__ import annotations

import dataclasses
import functools
import json
from typing import Any, ClassVar, TypeVar

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import boolean, brief, instance, number, refusal
from stoss._documentation import with_fields
from stoss._errors import InvalidInput
from stoss.bodies._faces import BESIDE, SMOOTH, face_of, load_of
from stoss.bodies._kinds import KINDS, Parameter, Specification, fields_of
from stoss.bodies._losses import LOSSES, NO_LOSSES, losses_in, losses_of
from stoss.bodies._material import Material, Relaxation as Relaxation, Scales, relaxation_of, young_of

LEFT_OUT: Any = None
"""A number that was not given: the material has it, or the core a usual one."""


class Solid:
    """A body or a block: its numbers, given or those of a material.

    Parameters:
        radius (float): Radius R; 1, or with a material to be given in m.
        young, density (float, optional): Young's modulus E and density ρ.
        loss_time (float, optional): Loss time η, stress = (1 + η ∂/∂t) elastic stress: R/c (of a
            rod L/c) of the first body, or with a material s. Default: 0, or that of the material.
        quality (float, optional): In place of `loss_time`, the quality Q of the material, the same at all
            frequencies, 3 to 1e9. Without a material E is E(0), the modulus at 50 c/R and beyond.
        relaxation (sequence of (float, float), optional): In place of both, shares of the modulus E(0) that
            relax, and their times, in the unit of `loss_time`. Then E is E(0).
        roughness (float, optional): Height (rms) of the elastic asperities of its face, in the unit of the
            sizes, for what has none in R of the first body; 0: smooth. Their length u₀ is 0.45 of it (± 0.05).
        u0 (float, optional): In place of it: u₀, as in a pressure of p₀ e^(−gap/u₀), up to R of the first body.
        coat (float, optional): Thickness of a thin soft layer on its face, in the unit of the sizes; 0: bare.
        coat_young, coat_poisson, coat_quality (float, optional): Young's modulus of the coat, in the unit of
            `young`, its Poisson's ratio (0.3), and its quality Q, 3 to 1e9 (elastic).
        yield_strength (float, optional): From which stress on it yields, in simple tension, in the unit of
            `young`; 0: it is elastic. Of balls, blocks and plates: a model.
        yield_hardening (float, optional): By how much it grows for each unit of plastic strain, in the unit of
            `young`, up to 0.03 of it; 0.
        yield_rate (float, optional): C of the strength at a rate of strain above 1/s, Y (1 + C ln(rate)).
        material (Material): In place of `poisson`, `young` and `density`; for what meets a body
            that has one.
        rigid (bool, optional): Young's modulus is infinite, and the given one is only a unit (see
            `Material.of_rigid`). The body keeps its mass. It meets elastic ones.
        extra_mass (float, optional): Mass fixed to a sphere that moves as it does on average, as that
            of a hammer behind its ball: kg with a material, else `density` · R³. No mode feels it.
    """

    _kind: ClassVar[str]

    poisson: float | None
    young: float
    density: float
    loss_time: float
    quality: float
    relaxation: Relaxation | None
    roughness: float
    u0: float
    material: Material | None

    def __init_subclass__(cls) -> None:
        if "_kind" in vars(cls) and "__annotations__" not in vars(cls):
            cls.__annotations__ = fields_of(KINDS[cls._kind])
            for name, kind in cls.__annotations__.items():
                setattr(cls, name, False if kind == "bool" else LEFT_OUT)
        with_fields(cls, "Parameters")

    def __post_init__(self) -> None:
        """Set all fields to what was given, what is made of the material, or what the core takes for usual."""
        kind, given = KINDS[self._kind], dict(vars(self))
        material, plane, rigid = (given.get(name) for name in ("material", "plane", "rigid"))
        made: dict[str, Any] = {each.name: each.otherwise for each in kind.parameters}
        if material is not None:
            instance("material", material, (Material,))
            plane = "stress" if plane is None and kind.has_plane else plane
            made |= dict.fromkeys(made) | material._constants(plane) | losses_of(material) | SMOOTH | {"extra_mass": 0.0}
        elif plane is not None:
            raise refusal("plane", plane, "none without a material (`poisson` is the 2-D Poisson's ratio)")
        fields: dict[str, Any] = {"material": material}
        if kind.has_plane:
            fields["plane"] = plane
        if kind.can_be_rigid:
            fields["rigid"] = boolean("rigid", rigid)
        own = any(given.get(name) is not None for name in LOSSES)
        if fields.get("rigid") or own:
            made |= NO_LOSSES
        relaxation = relaxation_of(given.get("relaxation"))
        fields["relaxation"] = relaxation if own else made.get("relaxation")
        for each in kind.parameters:
            fields[each.name] = self._chosen(each, given.get(each.name), made[each.name], material)
        for name, value in fields.items():
            object.__setattr__(self, name, value)
        numbers = {each.name: fields[each.name] for each in kind.parameters}
        placeholder = 0.25  # is in the range of all numbers that may be
        _core.check_solid(self._kind, {name: placeholder if of is None else of for name, of in numbers.items()})
        _core.check_face(self.roughness, self.u0)
        if own:
            rigid_too = {"rigid": True} if fields.get("rigid") else {}
            young_of({**rigid_too, **{name: fields[name] for name in LOSSES if fields[name] is not None}})
        if material is not None and kind.bounded:
            _ = self.scales  # refuses what is out of range

    def _chosen(self, asked: Parameter, given: Any, made: float | None, material: Material | None) -> float | None:
        """The value of a parameter; with a material never one that it makes otherwise."""
        if given is None:
            if made is None and material is not None:
                raise InvalidInput.missing(asked.name, "", "a material needs it too, in SI")
            if made is None and (KINDS[self._kind].bounded or not asked.of_material):
                # A block has the Poisson's ratio of what it meets.
                instead = ", or a material instead" if asked.of_material else ""
                raise InvalidInput.missing(asked.name, f"a number{instead}")
            return made
        value = number(asked.name, given)
        if material is not None and asked.of_material and value != made:
            raise refusal(asked.name, given, f"none with a material, which makes it {made:.6g}")
        return value

    def __repr__(self) -> str:
        """The call that makes it, without what is usual."""
        kind, fields = KINDS[self._kind], {each.name: getattr(self, each.name) for each in dataclasses.fields(self)}
        usual: dict[str, Any] = {"plane": "stress", "rigid": False, "poisson": None, **NO_LOSSES}
        if self.material is None:
            usual |= {each.name: each.otherwise for each in kind.parameters} | {"material": None, "plane": None}
        else:
            usual |= {each.name: fields[each.name] for each in kind.parameters if each.of_material}
            usual |= {**SMOOTH, "extra_mass": 0.0, **(NO_LOSSES if fields.get("rigid") else losses_of(self.material))}
        same = all(usual.get(name) == fields.get(name) for name in LOSSES)
        said_of_losses = {} if same else losses_in(self)
        usual |= {name: None if name in said_of_losses else fields.get(name) for name in LOSSES}
        said = ", ".join(f"{name}={brief(value)}" for name, value in fields.items() if usual.get(name) != value)
        return f"{type(self).__name__}({said})"

    @property
    def scales(self) -> Scales:
        """SI values of the units of all results of which this is the first body."""
        if self.material is None:
            raise AttributeError(f"scales: {self!r} has no material (make it with material=stoss.Material(...))")
        return Scales(*alone(self).scales())

    def _numbers(self) -> Specification:
        """It in plain types by its numbers, as an encounter of bodies without a material has it."""
        numbers = {each.name: getattr(self, each.name) for each in KINDS[self._kind].parameters}
        numbers = {name: each for name, each in numbers.items() if name not in BESIDE} | face_of(self) | load_of(self)
        numbers |= {"relaxation": self.relaxation} if self.relaxation is not None else {}
        return {"kind": self._kind, **numbers, **({"rigid": True} if is_rigid(self) else {})}

    def _numbers_at_wall(self) -> Specification:
        """The same in units of its own: at a wall all sizes are one, and share what is made for it."""
        size: float = getattr(self, "radius", None) or getattr(self, "length")
        rate = float((self.young / self.density) ** 0.5 / size)
        shape = {name: getattr(self, name) for name in ("poisson", "inner") if hasattr(self, name)}
        relaxation = self.relaxation and [(share, time * rate) for share, time in self.relaxation]
        losses = {"loss_time": self.loss_time * rate, "quality": self.quality, "relaxation": relaxation}
        given = {name: each for name, each in losses.items() if each or name == "loss_time"}
        return {"kind": self._kind, **shape, **given, **face_of(self, size, self.young),
                **load_of(self, self.density * size**3)}


Block = TypeVar("Block", bound="Endless")


class Endless(Solid):
    """What blocks and plates have in common: no end sideways, and a Poisson's ratio that may be the first's.

    Parameters:
        loss_time (float, optional): Loss time η of a Kelvin–Voigt material, stress = (1 + η ∂/∂t)
            elastic stress; 0, or that of the material. In R/c of the first body; with a material in
            s. Its loss is in `lost_to_second` and in `dissipated`.
    """

    def _beside(self: Block, body: Any) -> Block:
        """The same, with the Poisson's ratio of the first body where it has none."""
        return self if self.poisson is not None else dataclasses.replace(self, poisson=body.poisson)


def describe(solid: Solid) -> Specification:
    """All that makes it, in plain types; with a material in SI."""
    if KINDS[solid._kind].from_file:
        return solid._numbers()
    given = {field.name: getattr(solid, field.name) for field in dataclasses.fields(solid)}
    if layers := given.pop("layers", None):
        each = [{name: value for name, value in describe(layer).items() if name != "kind"} for layer in layers]
        return {"kind": solid._kind, "layers": each, **losses_in(solid), **face_of(solid)}
    if solid.material is not None:
        given = {name: value for name, value in given.items() if name not in ("poisson", "young", "density")}
        given["material"] = solid.material._words()
    usual = {name: value for name, value in given.items() if value is not None and value is not False}
    losses = losses_in(solid) if "loss_time" in given else {}
    its = {name: value for name, value in usual.items() if name not in (*LOSSES, *BESIDE)}
    return {"kind": solid._kind, **its, **losses, **face_of(solid), **load_of(solid)}


@functools.lru_cache(maxsize=64)
def alone(solid: Solid) -> _core.Encounter:
    """An elastic body by itself, in the units in which it is given: it knows those of all that comes with it."""
    elastic = {name: value for name, value in describe(solid).items() if name not in ("rigid", *BESIDE)}
    return _core.encounter(json.dumps({"first": elastic}))


def own_units(body: Solid, question: str, **given: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
    """Inputs of a question in units of the body. Refuses numbers that are out of range, as they were given."""
    its = alone(body)
    return tuple(its.own(question, name, each.ravel()).reshape(each.shape) for name, each in given.items())


def own_number(body: Solid, question: str, name: str, given: Any) -> float:
    """The same of one number, as it comes from a user."""
    return float(own_units(body, question, **{name: np.array(number(name, given))})[0])


def is_rigid(solid: Any) -> bool:
    """Whether it is a body that does not deform."""
    return bool(getattr(solid, "rigid", False))
