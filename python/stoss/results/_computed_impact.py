"""What an impact at a fixed resolution is, for all that sees it again."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar, TypeVar

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss.bodies._bodies import Body, Rod, shown
from stoss.bodies._encounter import Against, contact
from stoss.bodies._state import choose_state
from stoss.results._quantities import ImpactQuantities
from stoss.results._si import MayYield

Made = TypeVar("Made", bound="ComputedImpact")


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ComputedImpact(ImpactQuantities, MayYield):
    """An impact as it was computed, without what is seen of it later.

    Energies are shares of the initial energy, that of translation and vibration.

    Attributes:
        max_force: Maximum mean over one step of the force, mc²/R: πRE of a disk, (4π/3)R²E of a
            sphere. Above Hertz's, at a wall by 4 % at 0.001 c and 6 % at 0.004 c, as a whole ball is
            stiffer than a point contact.
        mode_energies: Energy of each kept mode, a structured array with the fields body (0 of the
            first, 1 of the second), order, index, omega, before and after (the impact) and average
            (during contact). Those of a half-space are samples of a continuum, and their order
            counts wave numbers.
    """

    _name: ClassVar[str] = "impact"
    _told = ("body", "against", "tail", "keep", "state")
    _given = {"speed": "speed"}

    body: Body
    against: Against
    speed: float
    mode_energies: NDArray[Any]
    tail: str
    keep: NDArray[np.bool_] | None
    state: NDArray[Any] | None
    _handle: _core.Impact = dataclasses.field(repr=False)

    def __repr__(self) -> str:
        return (
            f"Impact({shown(self.body, self.against)}, speed={self.speed:.6g} c: restitution {self.restitution:.5f}, "
            f"contact time {self.contact_time:.4g} {self._unit('contact_time')}, {self.modes} modes)"
        )

    def _contact(self) -> _core.Contact:
        return contact(self.body, self.against, self.cutoff, self.speed, self.keep)

    @classmethod
    def _made(
        cls: type[Made], body: Body, against: Against, speed: float, cutoff: float, tail: str = "radiating",
        resolution: tuple[float | None, int | None, float | None] = (None, None, None),
        keep: NDArray[np.bool_] | None = None, state: Any = None,
    ) -> Made:  # fmt: skip
        """The impact with these inputs, checked before; a resolution is step, nodes and half-width."""
        modes = choose_state(state)
        handle = _core.impact(contact(body, against, cutoff, speed, keep), tail, speed, *resolution, modes)
        return cls(
            body=body, against=against, tail=tail, keep=keep, state=modes if modes.size else None,
            mode_energies=handle.modes(), _handle=handle, **handle.numbers(),
        )  # fmt: skip

    def __reduce__(self) -> tuple[Any, ...]:
        # Repeated, which gives the same bits, rather than written.
        width = None if isinstance(self.body, Rod) else self.half_width
        resolution = (self.step, self.nodes, width)
        given = (self.body, self.against, self.speed, self.cutoff, self.tail)
        return type(self)._made, (*given, resolution, self.keep, self.state)

    def _inputs(self) -> dict[str, Any]:
        kept = {} if self.keep is None else {"keep": f"{self.modes} of {self.keep.size} modes"}
        return super()._inputs() | kept
