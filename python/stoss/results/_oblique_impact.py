"""One oblique impact with friction at a fixed resolution."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import boolean, integer, optional_number
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body, shown, speeds_in_si
from stoss.bodies._encounter import Against, choose_against, choose_body, choose_cutoff, contact
from stoss.bodies._state import State, choose_state
from stoss.bodies._walls import HardWall, Unbounded
from stoss.results import _oblique_trajectory
from stoss.results._oblique_ledger import ObliqueLedger
from stoss.results._obliquity import MOTION, Oblique, choose_motion, explained
from stoss.results._progress import waiting
from stoss.results._si import ImpactsInSi, warn_of_materials


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class ObliqueImpact(Oblique, ImpactsInSi):
    """One oblique impact at a fixed resolution, with the inputs that made it.

    x points along the normal, from the first body to what it meets, and y along the surface. The
    point of the first body that touches slides at s = v_t + Ω₁R₁ + Ω₂R₂.

    Attributes:
        restitution: ε_n = −v_n′/v_n.
        tangential_restitution: ε_t = −s′/s: −1 without friction, 1 of a perfect superball; NaN
            where s = 0.
        half_width: Of the contact grid, R.
        steps: Time steps.
        momentum_error, angular_momentum_error: What is missing, over that of the motion before.
    """

    _name: ClassVar[str] = "oblique impact"
    _kind = "oblique impact"
    _told = ("body", "against", "state")

    trajectory = _oblique_trajectory.trajectory

    body: Body
    against: Against
    speed: float
    tangential: float
    spin: float
    second_spin: float
    friction: float
    restitution: float
    tangential_restitution: float
    sliding: float
    sliding_after: float
    tangential_after: float
    spin_after: float
    second_spin_after: float
    contact_time: float
    max_force: float
    max_compression: float
    max_half_width: float
    cutoff: float
    step: float
    nodes: int
    half_width: float
    steps: int
    energy_error: float
    momentum_error: float
    angular_momentum_error: float
    stays: bool
    strain: float
    beyond_small_strain: bool
    turned: float
    beyond_small_turn: bool
    energy: ObliqueLedger
    state: NDArray[Any] | None
    _handle: _core.ObliqueImpact = dataclasses.field(repr=False)

    def __repr__(self) -> str:
        spin = f", spin={self.spin:.6g} c/R" if self.spin else ""
        motion = f"speed={self.speed:.6g} c, tangential={self.tangential:.6g} c{spin}, friction={self.friction:.6g}"
        found = f"restitution {self.restitution:.5f}, tangential {self.tangential_restitution:.4f}"
        return f"ObliqueImpact({shown(self.body, self.against)}, {motion}: {found})"

    def plot(self, ax: Any = None) -> Any:
        """Velocities, forces, and where points stick. See `stoss.plot.oblique_impact`."""
        return self.trajectory().plot(ax)

    def _contact(self) -> _core.Contact:
        return contact(self.body, self.against, self.cutoff, self.speed)

    @classmethod
    def _made(
        cls, body: Body, against: Against, motion: tuple[float, ...], cutoff: float,
        resolution: tuple[float | None, int | None, float | None], state: Any,
    ) -> ObliqueImpact:  # fmt: skip
        """The impact with these inputs, checked before; a resolution is step, nodes and half-width."""
        modes, (speed, *along) = choose_state(state), motion
        met = contact(body, against, cutoff, speed)
        handle = _core.oblique_impact(met, speed, np.array(along), *resolution, modes)
        values: dict[str, Any] = {**dict(zip(MOTION, motion)), **handle.numbers()}
        return cls(
            body=body, against=against, energy=ObliqueLedger(**handle.ledger()), state=modes if modes.size else None,
            _handle=handle, **values,
        )  # fmt: skip

    def __reduce__(self) -> tuple[Any, ...]:
        # Repeated, which gives the same bits, rather than written.
        motion = tuple(getattr(self, name) for name in MOTION)
        resolution = (self.step, self.nodes, self.half_width)
        return ObliqueImpact._made, (self.body, self.against, motion, self.cutoff, resolution, self.state)


@explained
def oblique_impact(
    body: Body,
    *,
    speed: float,
    tangential: float | None = None,
    angle: float | None = None,
    friction: float,
    spin: float = 0.0,
    second_spin: float = 0.0,
    against: HardWall | Body | Unbounded | str | None = None,
    cutoff: float | None = None,
    step: float | None = None,
    nodes: int | None = None,
    half_width: float | None = None,
    state: State = None,
    progress: bool = False,
) -> ObliqueImpact:
    """One oblique impact with friction at a fixed resolution, with its ledger and its course in time.

    For values with errors, and for many angles, use `oblique`.

    Parameters:
        body (Disk or Sphere): The first body, in whose units all results are.
        cutoff: Highest frequency of the modes that are kept, c/R. Default: that of `impact`.

    Examples:
        >>> hit = stoss.oblique_impact(stoss.Sphere(poisson=0.3), speed=0.05, angle=40, friction=0.3)
        >>> hit
        ObliqueImpact(Sphere(poisson=0.3), speed=0.05 c, tangential=0.041955 c, friction=0.3: ...
        >>> hit.energy
        ObliqueLedger(...
        >>> hit.trajectory().grip.shape[1] == hit.nodes
        True
    """
    chosen = choose_body(body, None, rigid=True)
    met = choose_against(chosen, against, (HardWall,))
    given: dict[str, Any] = {
        "speed": speed, "tangential": tangential, "angle": angle, "spin": spin, "second_spin": second_spin,
        "friction": friction,
    }  # fmt: skip
    motion = choose_motion(chosen, **given, kept=1)
    if motion[0].shape:
        name, several = next((each, np.size(value)) for each, value in given.items() if np.shape(value))
        raise InvalidInput(f"{name}: got {several} of them, allowed one impact (use stoss.oblique for several)")
    highest = choose_cutoff(cutoff, chosen, met, float(motion[0]))
    count = None if nodes is None else integer("nodes", nodes)
    resolution = optional_number("step", step), count, optional_number("half_width", half_width)
    with speeds_in_si(chosen), waiting(boolean("progress", progress), "oblique_impact"):
        result = ObliqueImpact._made(
            chosen, met, tuple(float(each) for each in motion), highest, resolution, state
        )
    warn_of_materials(result, 2)
    return result
