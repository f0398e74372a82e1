"""What stoss says of the impacts that a law is to come near."""

from __future__ import annotations

import functools
from typing import Union

import numpy as np

from stoss._errors import NotConverged
from stoss.bodies._bodies import Sphere
from stoss.bodies._walls import HalfSpace, HardWall
from stoss.laws._law import Array, Impacts, Pair
from stoss.results._restitution import restitution
from stoss.results._oblique import oblique

Met = Union[Sphere, HalfSpace, HardWall]
"""What a ball can meet here."""

SPEEDS = 9
"""In a range, equally spaced in their logarithm."""

TOLERANCE = 3e-3
"""Error of the loss 1 − ε²: few laws come so near."""

SLIDING = np.array([0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0])
"""Sliding velocities over μv: from about 6 on all slides to the end."""


def pair_of(body: Sphere, against: Met) -> Pair:
    """The two bodies, with the numbers that laws use."""
    second = against if isinstance(against, Sphere) else None

    def mass(ball: Sphere) -> float:
        return 4.0 * np.pi / 3.0 * ball.density * ball.radius**3

    parts = [each for each in (body, second) if each is not None]
    return Pair(
        mass=1.0 / sum(1.0 / mass(each) for each in parts),
        radius=1.0 / sum(1.0 / each.radius for each in parts),
        first_radius=body.radius,
        second_radius=second.radius if second else None,
        first_density=body.density,
        second_density=second.density if second else None,
    )


@functools.lru_cache(maxsize=8)  # several laws are fitted to the same impacts
def impacts_of(
    body: Sphere, against: Met, slowest: float, fastest: float, friction: float, threads: int, progress: bool
) -> Impacts:
    """Impacts along the normal and, with friction, at angles, in the units in which the bodies were given.

    Speeds are in m/s, or in c of a body without a material, and those of the result in its own units.
    """
    speeds = np.geomspace(slowest, fastest, SPEEDS)
    head_on = restitution(
        body, against=against, speed=speeds, tolerance=TOLERANCE, threads=threads, progress=progress
    )  # fmt: skip
    tangential: Array = np.zeros((SPEEDS, 0))
    if friction > 0.0:
        along = friction * speeds[:, None] * SLIDING
        angled = oblique(
            body, against=against, speed=speeds[:, None], tangential=along, friction=friction, threads=threads,
            progress=progress,
        )  # fmt: skip
        tangential = np.asarray(angled.tangential_restitution)
    c = body.scales.speed if body.material else (body.young / body.density) ** 0.5
    sliding = SLIDING if friction > 0.0 else np.zeros(0)
    epsilon, times = np.asarray(head_on.restitution), np.asarray(head_on.contact_time) * body.radius / c
    speeds = speeds if body.material else speeds * c
    for name, values in (("ε", epsilon), ("contact time", times), ("ε_t", tangential)):
        if missing := values.size - int(np.count_nonzero(np.isfinite(values))):
            raise NotConverged(f"fit: {missing} of {values.size} impacts have no {name} (are the bodies too lossy?)")
    for each in (speeds, times, sliding, tangential):
        each.flags.writeable = False
    return Impacts(pair_of(body, against), speeds, epsilon, times, friction, sliding, tangential)
