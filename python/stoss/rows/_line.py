"""Bodies on a line, and what stands at its ends."""

from __future__ import annotations

import json
from typing import Any, NamedTuple, Union

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import numbers, refusal
from stoss._errors import InvalidInput
from stoss.bodies._bodies import BODIES, PARTNERS, Body, shown
from stoss.bodies._encounter import named
from stoss.bodies._faces import has_rate, is_rough
from stoss.bodies._kinds import Specification
from stoss.bodies._state import FIELDS, State, choose_state
from stoss.bodies._walls import UNBOUNDED, HardWall, Unbounded

Standing = Union[HardWall, Unbounded]


class Line(NamedTuple):
    """A row as it was given, checked."""

    bodies: tuple[Body, ...]
    before: HardWall | None
    against: Standing | None
    gaps: NDArray[np.float64] | None
    state: NDArray[Any] | None

    def given(self) -> _core.GivenRow:
        """The same for the core."""
        return _core.given_row(json.dumps(self._document()))

    def speed_unit(self) -> float:
        """How many of the unit of speeds are c."""
        return 1.0 if self.bodies[0].material is None else float(self.bodies[0].scales.speed)

    def _document(self) -> Specification:
        document: Specification = {"format": "stoss row 1", "bodies": [_words(each) for each in self.bodies]}
        if self.before is not None:
            document["before"] = "wall"
        if self.against is not None:
            document["after"] = "wall" if isinstance(self.against, HardWall) else _words(self.against)
        if self.gaps is not None:
            document["gaps"] = self.gaps.tolist()
        if self.state is not None:
            document["vibration"] = [dict(zip(FIELDS, mode)) for mode in self.state[list(FIELDS)].tolist()]
        return document

    def warnings(self, contacts: NDArray[Any]) -> list[str]:
        """All that the core says of the materials of neighbours that press each other so in any case."""
        if self.bodies[0].material is None:
            return []
        work = contacts["max_force"] * contacts["max_compression"]
        hardest = np.fmax.reduce(work.reshape(-1, work.shape[-1]), axis=0, initial=0.0)
        return list(self.given().material_warnings(hardest))


def choose_line(bodies: Any, before: Any, against: Any, gaps: Any, vibration: State) -> Line:
    """The row that was meant."""
    several = list(bodies) if isinstance(bodies, (list, tuple, np.ndarray)) else []
    if not several:
        raise refusal("bodies", bodies, "a list of bodies, from left to right")
    for each in several:
        if not isinstance(each, BODIES):
            allowed = " or ".join(f"a stoss.{kind.__name__}" for kind in BODIES)
            raise refusal("bodies", each, allowed)
    first = several[0]
    left, right = _wall("before", before, (HardWall,)), _wall("against", against, (HardWall, *UNBOUNDED))
    if isinstance(right, UNBOUNDED):
        right = right._beside(first) if hasattr(first, "poisson") else right
    for name, each in [*(("bodies", each) for each in several), ("against", right)]:
        if isinstance(each, PARTNERS) and (each.material is None) != (first.material is None):
            raise refusal(name, each, "all with a material, or all without")
        if isinstance(each, PARTNERS) and getattr(each, "plane", None) != getattr(first, "plane", None):
            raise refusal(name, each, "bodies of one kind and plane")
    modes = choose_state(vibration, "vibration")
    for name in ("energy", "phase"):  # no document has others
        for each in modes[name][~np.isfinite(modes[name])].tolist():
            raise refusal(name, each, "a finite number")
    between = None
    if gaps is not None:
        between = numbers("gaps", gaps)
        wanted = len(several) - 1 + (left is not None) + (right is not None)
        if between.ndim == 0:
            between = np.full(wanted, float(between))
        if between.ndim != 1 or not np.isfinite(between).all():
            raise refusal("gaps", gaps, "one finite number, or one for each contact from left to right")
        between.flags.writeable = False
    line = Line(tuple(several), left, right, between, modes if modes.size else None)
    line.given()  # refuses what the core refuses
    return line


def _wall(name: str, given: Any, kinds: tuple[type, ...]) -> Any:
    """What stands at an end."""
    if given is None:
        return None
    chosen = HardWall() if isinstance(given, str) and given == "wall" else given
    if not isinstance(chosen, kinds) or isinstance(chosen, HardWall) and is_rough(chosen):
        others = "".join(f", a stoss.{kind.__name__}" for kind in kinds[1:])
        raise refusal(name, given, f"None, 'wall'{others} or a smooth stoss.HardWall")
    return chosen


def choose_speeds(line: Line, speed: Any) -> NDArray[np.float64]:
    """Speeds of all bodies as they were given, with those of the others that rest: cases × bodies, or of one case."""
    given = numbers("speed", speed)
    if given.ndim == 0:
        given = given.reshape(1)
    count = len(line.bodies)
    if given.ndim > 2 or not 1 <= given.shape[-1] <= count:
        got = f"{given.shape[-1]} values" if given.ndim == 1 else f"an array of shape {given.shape}"
        hint = "to the right, from the first body on; the others rest"
        raise InvalidInput.out_of_range("speed", got, f"1 to {count} of them, or cases × these", hint)
    whole = np.zeros((*given.shape[:-1], count))
    whole[..., : given.shape[-1]] = given
    whole.flags.writeable = False
    return whole


def fastest(line: Line, speeds: NDArray[np.float64]) -> NDArray[np.float64]:
    """The greatest difference of speeds of each case, walls and blocks included, in the unit of the speeds."""
    stands = line.before is not None or line.against is not None
    more = np.zeros((*speeds.shape[:-1], 1)) if stands else speeds[..., :0]
    return np.asarray(np.ptp(np.concatenate((speeds, more), axis=-1), axis=-1))


def shown_line(line: Line) -> str:
    """The bodies on one line, equal neighbours together."""
    groups: list[list[Body]] = []
    for each in line.bodies:
        if groups and groups[-1][0] == each:
            groups[-1].append(each)
        else:
            groups.append([each])
    said = ", ".join(f"{len(group)} × {shown(group[0])}" if len(group) > 1 else shown(group[0]) for group in groups)
    if len(said) > 70:
        said = f"{len(line.bodies)} bodies"
    said = f"wall, {said}" if line.before is not None else said
    if isinstance(line.against, HardWall):
        return f"{said}, wall"
    return said if line.against is None else f"{said} against {_short(line.against)}"


def _short(standing: Unbounded) -> str:
    text = shown(standing)
    return text if len(text) <= 50 else type(standing).__name__


def _words(solid: Any) -> Specification:
    """As a document of a row has it: in SI with a material."""
    if solid.material is not None or has_rate(solid):
        return named(solid)
    return solid._numbers()  # type: ignore[no-any-return]
