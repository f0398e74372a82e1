"""The coefficient of restitution with its error."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, boolean, broadcast, integer, number, numbers
from stoss._documentation import documented
from stoss.bodies._bodies import Body, Disk
from stoss.bodies._encounter import choose_against, choose_bodies, choose_body, refinable
from stoss.bodies._solid import own_units
from stoss.bodies._state import State, choose_state
from stoss.bodies._walls import UNBOUNDED, HardWall, Unbounded
from stoss.results._progress import bar
from stoss.results._restitution import Restitution
from stoss.results._result import columns
from stoss.results._si import finished


def empty_rows(shape: int | tuple[int, ...], kind_of_row: np.dtype[Any] = _core.restitution_row) -> NDArray[Any]:
    """Rows of curves that nothing has been computed of: NaN, 0 and False."""
    rows = np.zeros(shape, dtype=kind_of_row)
    for name, (kind, *_) in (rows.dtype.fields or {}).items():
        if kind.kind == "f":
            rows[name] = np.nan
    return rows


@documented
def restitution(
    body: Body | Sequence[Body] | NDArray[np.object_] | None = None,
    *,
    speed: ArrayLike,
    against: HardWall | Body | Unbounded | str | None = None,
    poisson: ArrayLike | None = None,
    tolerance: float = 1e-3,
    absolute: float = 1e-6,
    state: State = None,
    threads: int = 0,
    progress: bool = False,
) -> Restitution:
    """Compute the coefficient of restitution ε = −v_f/v_i of a body at a wall or of two bodies.

    Cutoff, time step and contact grid are refined together until the estimated error of 1 − ε² is
    below ``tolerance * (1 − ε²)`` or below ``absolute``. If that cannot be met, a single value raises
    `NotConverged`; in arrays such values are marked, and a `StossWarning` says how many there are.
    A value of a disk takes 1.5 ms in the median, 20 ms or more in one case of a hundred.

    Parameters:
        body (Disk, Sphere, Rod or ModalBody, or a list or an array of disks or of spheres): The first
            body, in whose units all results are. Several broadcast with `speed`, and have no material.
        state (Oscillation, sequence of them or ndarray, optional): How the bodies vibrate before
            the impact, with the same shares of energy and phases at every speed; ε may then exceed
            1. Default: they are unexcited.

    Examples:
        >>> stoss.restitution(poisson=0.33, speed=0.1)
        Restitution(poisson=0.33, speed=0.1 c: restitution 0.947042 ± 0.000038)
        >>> curve = stoss.restitution(poisson=0.33, speed=np.geomspace(1e-4, 0.3, 50))
        >>> curve.restitution.max().round(4)
        0.9974
        >>> balls = [[stoss.Sphere(poisson=nu)] for nu in (0.0, 0.3)]
        >>> stoss.restitution(balls, speed=[0.01, 0.1]).lost_fraction.round(4)
        array([[0.0014, 0.0234],
               [0.0028, 0.0173]])
        >>> disk = stoss.Disk(poisson=0.33)
        >>> stoss.restitution(disk, against=stoss.Disk(poisson=0.33, radius=2), speed=0.2)
        Restitution(Disk(poisson=0.33) against Disk(poisson=0.33, radius=2), speed=0.2 c: restitution 0.79480 ± 0.00016)
        >>> ringing = stoss.Oscillation(order=2, index=0, energy=0.1, phase=2.0)
        >>> stoss.restitution(stoss.Sphere(poisson=0.3), speed=0.01, state=ringing).restitution > 1
        True
    """
    speeds = numbers("speed", speed)
    if body is None and poisson is not None:
        poissons, speeds = broadcast(22, poisson=numbers("poisson", poisson), speed=speeds)
        bodies: list[Body] = [Disk(poisson=value) for value in np.unique(poissons)]
        places = [np.flatnonzero(poissons == each.poisson) for each in bodies if isinstance(each, Disk)]
    elif isinstance(body, (list, tuple, np.ndarray)) and poisson is None:
        bodies, which = choose_bodies(body)
        which, speeds = broadcast(22, body=which, speed=speeds)
        poissons = np.array([getattr(each, "poisson") for each in bodies])[which.astype(np.intp)]
        places = [np.flatnonzero(which == k) for k in range(len(bodies))]
    else:
        bodies = [choose_body(body, poisson, rigid=True)]
        nu = np.full((), getattr(bodies[0], "poisson", np.nan))
        poissons, speeds = broadcast(22, poisson=nu, speed=speeds)
        places = [np.arange(speeds.size)]
    met = [choose_against(each, against, (HardWall,)) for each in bodies or [Disk(poisson=0.0)]]
    limit, enough, count = number("tolerance", tolerance), number("absolute", absolute), integer("threads", threads)
    modes = choose_state(state)
    if bodies:
        (speeds,) = own_units(bodies[0], "restitution", speed=speeds)
    _core.check_curve(speeds.ravel(), limit, enough, count)

    table, reasons, done = empty_rows(speeds.size), np.full(speeds.size, "interrupted", dtype=object), 0
    stopped = False
    with bar(speeds.size, boolean("progress", progress)) as seen:
        tick = None if seen is None else seen.update
        try:
            for each, partner, where in zip(bodies, met, places):
                own, rows, why = speeds.ravel()[where], empty_rows(where.size), list[str]()
                try:
                    contact = refinable(each, partner)
                    _core.restitution_curve(contact, own, limit, enough, count, modes, rows, why, tick)
                finally:
                    table[where], reasons[where[: len(why)]] = rows, why
                    done += len(why)
        except KeyboardInterrupt:
            stopped = True
    one = bodies[0] if len(bodies) == 1 else None
    # Each of several bodies meets these in its own form.
    shared = against if one is None and isinstance(against, (str, *UNBOUNDED)) else met[0]
    values = {"poisson": poissons, "speed": speeds, "reason": reasons, **columns(table)}
    shaped = {name: arranged(column, speeds.shape) for name, column in values.items()}
    state_before = modes if modes.size else None
    result = Restitution(one, tuple(bodies), shared, tolerance=limit, absolute=enough, state=state_before, **shaped)
    return finished(result, done if stopped else None)
