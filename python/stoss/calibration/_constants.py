"""Constants that measurements may tell, and the bodies in which they are others."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Mapping, Sequence, Union

from stoss._arguments import number, refusal
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body
from stoss.bodies._encounter import Against
from stoss.bodies._kinds import KINDS
from stoss.bodies._losses import LOSSES, losses_in, losses_of
from stoss.bodies._material import Material

Unknowns = Union[str, Sequence[str], Mapping[str, "float | None"]]
"""Names, with values to begin with if they are mapped to any."""


@dataclasses.dataclass(frozen=True)
class Kind:
    """A constant by itself.

    Attributes:
        unit: In SI.
        usual: To begin with, where the body has none.
        low, high: Its range; `relative`: over the value to begin with.
        of_material: Whether the material has it, and not the body.
    """

    unit: str
    usual: float
    low: float
    high: float
    relative: bool = True
    of_material: bool = True


KINDS_OF_CONSTANTS: Mapping[str, Kind] = {
    "quality": Kind("", 100.0, 3.0, 1e8, relative=False),
    "loss_time": Kind("s", 1e-6, 1e-4, 1e4),
    "relaxation": Kind("", 1.0, 1e-3, 1e3),
    "young": Kind("Pa", math.nan, 1e-3, 1e3),
    "density": Kind("kg/m^3", math.nan, 1e-2, 1e2),
    "yield_strength": Kind("Pa", 5e8, 1e-2, 1e2),
    "yield_hardening": Kind("Pa", 1e7, 1e-3, 1e3, of_material=False),
    "roughness": Kind("m", 1e-7, 1e-3, 1e3, of_material=False),
    "radius": Kind("m", math.nan, 0.1, 10.0, of_material=False),
    "friction": Kind("", 0.3, 1e-3, 5.0, relative=False, of_material=False),
}  # fmt: skip
"""All of them; `relaxation` is a factor on the shares of the series, E∞ being as it is."""

MOST = 3
SIDES = ("", "against.")


@dataclasses.dataclass(frozen=True)
class Constant:
    """One of what meets.

    Attributes:
        name: That of `KINDS_OF_CONSTANTS`, after "against." of the second.
        start: Where the search begins.
        given: Whether the user has said so.
    """

    name: str
    start: float
    given: bool

    @property
    def kind(self) -> Kind:
        """Its kind."""
        return KINDS_OF_CONSTANTS[self.own]

    @property
    def own(self) -> str:
        """Its name without the side."""
        return self.name.removeprefix(SIDES[1])

    @property
    def second(self) -> bool:
        """Whether it is of what is met."""
        return self.name.startswith(SIDES[1])

    @property
    def low(self) -> float:
        """The lowest value that is tried."""
        return self.kind.low * (self.start if self.kind.relative else 1.0)

    @property
    def high(self) -> float:
        """The highest."""
        return self.kind.high * (self.start if self.kind.relative else 1.0)


@dataclasses.dataclass(frozen=True)
class Meeting:
    """What meets, and with which friction. `against` is 'same' where both are one body."""

    body: Body
    against: Against | str
    friction: float | None = None

    def value(self, name: str) -> float | None:
        """A constant as it is here; None where there is none."""
        own = name.removeprefix(SIDES[1])
        if own == "friction":
            return self.friction
        if own == "relaxation":
            return 1.0
        solid: Any = self.against if name.startswith(SIDES[1]) else self.body
        holder = solid.material if KINDS_OF_CONSTANTS[own].of_material else solid
        found = getattr(solid, own, None) or getattr(holder, own, None)
        return float(found) if found else None

    def changed(self, values: Mapping[str, float]) -> Meeting:
        """The same with other constants."""
        first = {name: value for name, value in values.items() if not name.startswith(SIDES[1]) and name != "friction"}
        second = {name.removeprefix(SIDES[1]): value for name, value in values.items() if name.startswith(SIDES[1])}
        against: Any = _changed(self.against, second) if second else self.against
        return Meeting(_changed(self.body, first), against, values.get("friction", self.friction))


def _changed(solid: Any, values: Mapping[str, float]) -> Any:
    """A body with other constants: made anew, as what it has of its material is another then."""
    if not values:
        return solid
    material = _changed_material(
        solid.material, {name: values[name] for name in values if KINDS_OF_CONSTANTS[name].of_material}
    )
    own = {each.name: getattr(solid, each.name) for each in KINDS[solid._kind].parameters if not each.of_material}
    given = {name: value for name, value in own.items() if value and name not in LOSSES}
    if has_own_losses(solid) and not set(values) & set(LOSSES):
        given |= losses_in(solid)
    given |= {
        name: value for name, value in values.items() if name in given or not KINDS_OF_CONSTANTS[name].of_material
    }
    extra = {name: getattr(solid, name) for name in ("plane", "rigid") if getattr(solid, name, None)}
    return type(solid)(**given, **extra, material=material)


def has_own_losses(solid: Any) -> bool:
    """Whether a body loses otherwise than its material."""
    return {name: getattr(solid, name) for name in LOSSES} != losses_of(solid.material)


def _changed_material(material: Material, values: Mapping[str, float]) -> Material:
    words = material._words()
    for name, value in values.items():
        if name == "relaxation":
            words |= _relaxed_more(words, value)
        elif name in LOSSES:
            words = {key: its for key, its in words.items() if key not in LOSSES} | {name: value}
        else:
            words[name] = value
    if "quality" not in words:
        words.pop("frequency", None)
    return Material(**words)


def _relaxed_more(words: Mapping[str, Any], factor: float) -> dict[str, Any]:
    """Terms that are larger by a factor, E∞ being as it is."""
    growth = 1.0 + (factor - 1.0) * sum(share for share, _ in words["relaxation"])
    return {
        "young": words["young"] * growth,
        "relaxation": tuple((share * factor / growth, time) for share, time in words["relaxation"]),
    }


def unknowns_of(given: Unknowns, meeting: Meeting) -> list[Constant]:
    """What is unknown, with values to begin with. Refuses what the bodies do not have."""
    if isinstance(given, str):
        given = [given]
    if not isinstance(given, (Mapping, Sequence)):
        raise refusal("unknown", given, "names of constants")
    names = given if isinstance(given, Mapping) else dict.fromkeys(given)
    if not 1 <= len(names) <= MOST:
        raise refusal("unknown", list(names), f"one to {MOST} names")
    return [_unknown(name, start, meeting) for name, start in names.items()]


def _unknown(name: Any, start: Any, meeting: Meeting) -> Constant:
    if (
        not isinstance(name, str)
        or name.removeprefix(SIDES[1]) not in KINDS_OF_CONSTANTS
        or name == SIDES[1] + "friction"
    ):
        allowed = ", ".join(KINDS_OF_CONSTANTS)
        raise InvalidInput.out_of_range(
            "unknown", repr(name), allowed, "of what is met after 'against.', as 'against.young'"
        )
    own, second = name.removeprefix(SIDES[1]), name.startswith(SIDES[1])
    solid: Any = meeting.against if second else meeting.body
    if own != "friction":
        _require_has(name, own, solid)
    begin = number(f"unknown {name}", start) if start is not None else meeting.value(name)
    begin = KINDS_OF_CONSTANTS[own].usual if begin is None else begin
    found = Constant(name, begin, start is not None)
    if not (begin > 0.0 and found.low <= begin <= found.high):
        raise InvalidInput.out_of_range(
            f"unknown {name}", f"{begin:g}", f"{found.low:g} to {found.high:g}", "a value to begin with"
        )
    return found


def _require_has(name: str, own: str, solid: Any) -> None:
    if isinstance(solid, str):
        raise InvalidInput.out_of_range("unknown", name, "a constant of the body", "both are the same")
    if getattr(solid, "material", None) is None:
        raise InvalidInput.out_of_range("unknown", name, "a constant of a body with a material", "this has none")
    if own == "relaxation" and not solid.material.relaxation:
        raise InvalidInput.out_of_range("unknown", name, "with a series of relaxation to begin with")
    kind = KINDS.get(getattr(solid, "_kind", ""))
    has = kind is not None and any(each.name == own for each in kind.parameters)
    if not has and own not in ("relaxation", "young", "density") or getattr(solid, "layers", None):
        raise InvalidInput.out_of_range("unknown", name, "a number that the body has")
