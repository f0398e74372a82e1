"""What oblique impacts have in common: how bodies move along their surfaces before, and where the energy is after."""

from __future__ import annotations

import dataclasses
from typing import Any, Callable, ClassVar, TypeVar

import numpy as np
from numpy.typing import NDArray

from stoss._arguments import arranged, broadcast, numbers
from stoss._documentation import documented
from stoss.bodies._bodies import Body
from stoss.bodies._solid import alone
from stoss.export._tables import span
from stoss.results._quantities import Number, ObliqueLedgerQuantities, Si
from stoss.results._result import ArrayResult
from stoss.results._si import MayYield

EITHER = ("tangential", "angle")
MOTION = ("speed", "tangential", "spin", "second_spin", "friction")
PARAMETERS = {
    "speed": "Of approach along the normal, 1e-8 to 1, c (with a material: m/s).",
    "tangential": "Velocity of the centre of the body along the surface, relative to what it meets, −1 to 1, c (with a"
    " material: m/s). Default: 0.",
    "angle": "In its place, the angle between the velocity of the centre and the normal, above −90 and below 90"
    " degrees.",
    "friction": "Coefficient of Coulomb's law, 0 to 5.",
    "spin": "Of the body, −1 to 1, c/R (with a material: rad/s); positive moves its foremost point as a positive"
    " `tangential` does.",
    "second_spin": "Of the second body, in the same units and with the same sign of sliding.",
}

Function = TypeVar("Function", bound=Callable[..., Any])


def explained(function: Function) -> Function:
    """The function with the words of the motion in its docstring."""
    return documented(function, **PARAMETERS)


class Oblique(MayYield):
    """Bodies that meet at an angle, with spin and friction.

    x points along the normal, from the first body to what it meets, and y along the surface. The
    point of the first body that touches slides at s = v_t + Ω₁R₁ + Ω₂R₂.

    Attributes:
        speed: v_n, of approach along the normal, c.
        tangential, tangential_after: v_t, velocity of the centre of the first body along y relative
            to the second, before and after, c.
        spin, spin_after: Ω₁ of the first body, c/R; positive moves its foremost point along +y.
        second_spin, second_spin_after: Ω₂ of the second, c/R of the first; positive moves its
            foremost point along −y.
        friction: Coefficient μ of Coulomb's law.
        sliding, sliding_after: s before and s′ after, c.
        energy: Where the energy is after the impact.
    """

    _given: ClassVar[dict[str, str]] = {
        "speed": "speed", "tangential": "speed", "spin": "frequency", "second_spin": "frequency", "friction": "",
    }  # fmt: skip
    tangential_si = Si("Velocity along the surface before, m/s.")
    spin_si = Si("Spin of the first body before, rad/s.")
    second_spin_si = Si("Spin of the second body before, rad/s.")

    tangential: Any

    @property
    def angle(self) -> Number:
        """Angle between the velocity of the centre and the normal before, degrees."""
        angles = np.array(np.degrees(np.arctan2(self.tangential, self.speed)))
        return arranged(angles, angles.shape)  # type: ignore[no-any-return]


def choose_motion(body: Body, kept: int, **given: Any) -> tuple[NDArray[np.float64], tuple[int, ...]]:
    """Collisions in units of the body, in the order of MOTION, and the shape to which they broadcast.

    Parameters:
        kept: Numbers that are kept of each.
        given: By the names of `PARAMETERS`; what is None is not given.
    """
    told = {name: numbers(name, each) for name, each in given.items() if each is not None or name not in EITHER}
    arrays = dict(zip(told, broadcast(kept, **told)))
    return alone(body).collisions({name: each.ravel() for name, each in arrays.items()}), arrays["speed"].shape


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ObliqueLedger(ObliqueLedgerQuantities, ArrayResult):
    """Where the energy is after oblique impacts, as shares of the energy before.

    That is of all motion relative to the common centre of mass, of the spins and of the vibration.
    Numbers, or arrays of the shape of the impacts.
    """

    _name: ClassVar[str] = "oblique ledger"
    _first = "translation"


    @property
    def total(self) -> Number:
        """The sum: 1 but for the numerical error."""
        return sum(self.entries().values(), start=0.0)

    def entries(self) -> dict[str, Number]:
        """All shares by their names."""
        return {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}

    def __repr__(self) -> str:
        told = (f"{name} {span(share)}" for name, share in self.entries().items() if np.any(share))
        return f"ObliqueLedger({', '.join(told)})"
