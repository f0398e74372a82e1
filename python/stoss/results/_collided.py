"""Velocities and spins after collisions by the whole collision rule, of arrays in the unit of a body."""

from __future__ import annotations


import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import numbers
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body

Array = NDArray[np.float64]
Motion = tuple[Array, Array, Array, Array]


def collided(
    rule: _core.RuleTable,
    made: _core.Encounter,
    body: Body,
    motions: tuple[ArrayLike, ArrayLike, ArrayLike, ArrayLike, ArrayLike],
    friction: Array,
    radii: tuple[Array, Array] | None,
) -> Motion:
    """Velocity and spin of the first bodies, then of the second.

    `motions` are both velocities, both spins and the normal, and broadcast with the friction and,
    of a mixture, the radii, which are in R of `body`, the first.
    """
    velocity, second_velocity, spin, second_spin, normal = motions
    moving = numbers("velocity", velocity)
    if moving.ndim == 0 or moving.shape[-1] not in (2, 3):
        raise InvalidInput.out_of_range("velocity", f"an array of shape {moving.shape}", "(..., 2) or (..., 3)")
    dimension = moving.shape[-1]
    spins = [numbers(name, each) for name, each in (("spin", spin), ("second_spin", second_spin))]
    if dimension == 2:
        spins = [each[..., np.newaxis] for each in spins]
    vectors = (moving, numbers("second_velocity", second_velocity), *spins, numbers("normal", normal))
    flags = [np.broadcast_to(each, np.broadcast_shapes(each.shape, (1,))).shape[:-1] for each in vectors]
    shape = np.broadcast_shapes(*flags, friction.shape, *(each.shape for each in radii or ()))
    turns = 3 if dimension == 3 else 1
    widths = (dimension, dimension, turns, turns, dimension)
    scales = body.scales if body.material is not None else None
    speed, turning = (1.0, 1.0) if scales is None else (scales.speed, scales.frequency)
    units = (speed, speed, turning, turning, 1.0)
    v, w, s, t, n = (_rows(each / unit, (*shape, width)) for each, unit, width in zip(vectors, units, widths))
    sizes = None if radii is None else (_rows(radii[0], shape), _rows(radii[1], shape))
    rule.collide(made, dimension, (v, w), (s, t), n, _rows(friction, shape), sizes)
    if dimension == 2:
        s, t = s[..., 0], t[..., 0]
    return v * speed, s * turning, w * speed, t * turning


def _rows(values: Array, shape: tuple[int, ...]) -> Array:
    """A copy of one's own, of a shape."""
    return np.array(np.broadcast_to(values, shape), dtype=np.float64, order="C")
