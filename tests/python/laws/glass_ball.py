"""A ball of glass, and each law that is fitted to two of them, once."""

import functools

import stoss

BALL = stoss.Sphere(radius=5e-3, material=stoss.materials["glass"])
RANGE = (0.01, 0.1)


@functools.cache
def fitted(law):
    return stoss.fit(BALL, against="same", law=law, speed=RANGE)
