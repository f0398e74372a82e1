"""How bodies vibrate before an impact."""

from __future__ import annotations

import dataclasses
from typing import Any, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import integer, number, refusal

FIELDS = ("body", "order", "index", "energy", "phase")
FEW = 4  # modes that a line can name


@dataclasses.dataclass(frozen=True)
class Oscillation:
    """A mode that vibrates before an impact, Q = A cos(ωt + φ).

    Time t is 0 when the bodies would touch if they were unexcited.

    Parameters:
        order, index (int): n and l of the mode; of a rod, 0 and the number of the mode from 0.
        energy (float): ½ m ω² A², as a share of the translational energy before the impact; 0 or
            more.
        phase (float, optional): φ, radians.
        of ({0, 1}, optional): The body that vibrates: the first, or the second.

    Examples:
        >>> ringing = stoss.Oscillation(order=2, index=0, energy=0.1, phase=2.0)
        >>> stoss.impact(stoss.Sphere(poisson=0.3), speed=0.01, cutoff=25, state=ringing).restitution > 1
        True
    """

    order: int
    index: int
    energy: float
    phase: float = 0.0
    of: int = 0

    def __post_init__(self) -> None:
        for name in ("order", "index", "of"):
            object.__setattr__(self, name, integer(name, getattr(self, name)))
        for name in ("energy", "phase"):
            object.__setattr__(self, name, number(name, getattr(self, name)))


State = Union[Oscillation, Sequence[Oscillation], NDArray[Any], None]


def choose_state(given: Any, name: str = "state") -> NDArray[Any]:
    """The modes that vibrate, as the core takes them, read-only; without any where the bodies are unexcited."""
    if given is None:
        modes: Any = []
    elif isinstance(given, Oscillation):
        modes = [given]
    elif isinstance(given, (list, tuple)):
        modes = given
    elif isinstance(given, np.ndarray) and given.ndim == 1 and set(FIELDS) <= set(given.dtype.names or ()):
        modes = [Oscillation(each[1], each[2], each[3], each[4], each[0]) for each in given[list(FIELDS)].tolist()]
    else:
        modes = [given]
    state = np.zeros(len(modes), dtype=_core.oscillation)
    for k, each in enumerate(modes):
        if not isinstance(each, Oscillation):
            hint = f"a stoss.Oscillation, a sequence of them, or an array with the fields {', '.join(FIELDS)}"
            raise refusal(name, each, hint)
        state[k] = (each.of, each.order, each.index, each.energy, each.phase)
    state.flags.writeable = False
    return state


def shown_state(state: NDArray[Any]) -> str:
    """A state on one line."""
    if state.size > FEW:
        return f"{state.size} modes with energy {state['energy'].sum():.6g}"
    return "; ".join(
        f"mode ({each['order']}, {each['index']}) of the {('first', 'second')[each['body']]} body with energy "
        f"{each['energy']!r} and phase {each['phase']!r}"
        for each in (dict(zip(FIELDS, row)) for row in state[list(FIELDS)].tolist())
    )
