"""Impacts by power laws, F = k δⁿ + g δ^q δ̇, along the normal and with a spring along the surface.

In units of the impact, L = (m v²/k)^{1/(n+1)} and L/v with the reduced mass m, the overlap x = δ/L obeys
x″ = −xⁿ − d x^q x′ from x = 0, x′ = 1, with the one number d. Along the surface s is the sliding velocity over μv. The
spring has the stiffness κ n x^{n−1}, κ times that along the normal, and its force f stays within the normal force:
s′ = −(7/2) f for solid spheres.
"""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

STEPS = 1000
"""In a time of π: ε has an error of at most 2e-6, and of 5e-5 where 0 < q < ½ and its dashpot begins abruptly."""

LONGEST = 6
"""What lasts longer, in π, has not ended: ε is 0."""

STIFFEST = 500.0
"""Largest d that these steps can follow."""

TURN = 3.5
"""1 + m R²/I of solid spheres: what a force at the surface does to its velocity, over what it does to the centre's."""


@dataclasses.dataclass(frozen=True)
class Spring:
    """How a program integrates its contacts.

    `tension`: a contact ends where the bodies part, and pulls before; else where its force is gone. `rising`: the
    tangential force is what has been added to it, by the stiffness of each moment; else the path times today's.
    """

    tension: bool = False
    rising: bool = False


class Approach(NamedTuple):
    """An impact along the normal: ε, its duration, and overlap and force at each step, step by step."""

    restitution: Array
    duration: Array
    overlap: Array
    force: Array


def along_normal(n: float, q: float, damping: Array, spring: Spring) -> Approach:
    """Impacts with these numbers d, by the method of Runge and Kutta."""
    d, h = np.asarray(damping, dtype=np.float64), np.pi / STEPS

    def force(x: Array, u: Array) -> Array:
        x = np.maximum(x, 0.0)
        return x**n + d * x**q * u

    def left(x: Array, u: Array) -> Array:
        """What becomes negative at the end: the overlap, or the force over x^q."""
        return x if spring.tension or q >= n else np.maximum(x, 0.0) ** (n - q) + d * u

    x, u = np.zeros_like(d), np.ones_like(d)
    restitution, duration = np.full_like(d, np.nan), np.full_like(d, np.nan)
    overlaps, forces = [x], [force(x, u)]
    before = np.full_like(d, np.inf)
    for step in range(1, LONGEST * STEPS):
        k1 = -force(x, u)
        k2 = -force(x + h / 2 * u, u + h / 2 * k1)
        k3 = -force(x + h / 2 * u + h * h / 4 * k1, u + h / 2 * k2)
        k4 = -force(x + h * u + h * h / 2 * k2, u + h * k3)
        x, u, old = x + h * u + h * h / 6 * (k1 + k2 + k3), u + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), u
        after = left(x, u)
        ends = np.isnan(duration) & (u < 0.0) & (after <= 0.0)
        share = np.where(ends, before / np.where(ends, before - after, 1.0), 0.0)
        duration = np.where(ends, (step - 1 + share) * h, duration)
        restitution = np.where(ends, -(old + share * (u - old)), restitution)
        before, going = after, np.isnan(duration)
        overlaps.append(np.where(going, np.maximum(x, 0.0), 0.0))
        forces.append(np.where(going, force(x, u), 0.0))
        if not going.any():
            break
    restitution, duration = np.nan_to_num(restitution), np.where(np.isnan(duration), np.inf, duration)
    return Approach(restitution, duration, np.array(overlaps), np.array(forces))


def along_surface(n: float, approach: Approach, ratio: float, spring: Spring, sliding: Array) -> Array:
    """ε_t = −s′/s for each impact (rows) and each sliding velocity at first, over μv (columns)."""
    h = np.pi / STEPS
    velocity = np.broadcast_to(sliding, (approach.duration.size, sliding.size)).copy()
    start, kept, force = velocity.copy(), np.zeros_like(velocity), np.zeros_like(velocity)
    stiffness = ratio * n * np.maximum(approach.overlap, 1e-300) ** (n - 1.0)
    middle = 0.5 * (stiffness[1:] + stiffness[:-1])
    for stiff, rise, limit in zip(stiffness[1:, :, None], middle[:, :, None], np.abs(approach.force[1:, :, None])):
        if spring.rising:
            force = np.clip(force + rise * h * velocity, -limit, limit)
        else:
            force = np.clip(stiff * (kept + h * velocity), -limit, limit)
            kept = force / stiff
        velocity -= TURN * h * force
    return -velocity / start
