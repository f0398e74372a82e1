"""Numbers and arrays of any shape and layout give the same."""

import dataclasses
import warnings

import numpy as np

import stoss


def test_shapes_broadcast():
    one = stoss.restitution(poisson=0.3, speed=0.1, tolerance=1e-2)
    inputs = ("body", "bodies", "against", "tolerance", "absolute", "state")
    fields = [field.name for field in dataclasses.fields(one) if field.name not in inputs]
    assert all(type(getattr(one, name)) in (float, int, bool, str) for name in fields)
    for speed in (np.array(0.1), np.float32(0.125), 1, np.int8(1)):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", stoss.StossWarning)
            assert type(stoss.restitution(poisson=0.3, speed=speed, tolerance=0.1).restitution) is float
    for poisson, speed, shape in (
        (0.3, [0.1], (1,)), ([0.3], 0.1, (1,)), (0.3, [[0.1, 0.2], [0.2, 0.1]], (2, 2)), ([], [], (0,)),
        ([[0.3], [0.5]], (0.1, 0.2, 0.1), (2, 3)), ([0.3, 0.5, 0.3], 0.1, (3,)), (np.empty((0, 3)), 0.1, (0, 3)),
    ):  # fmt: skip
        many = stoss.restitution(poisson=poisson, speed=speed, tolerance=1e-2)
        assert all(np.shape(getattr(many, name)) == shape for name in fields)
        nus, speeds = np.broadcast_arrays(poisson, speed)
        for at in np.ndindex(shape):
            alone = stoss.restitution(poisson=nus[at], speed=speeds[at], tolerance=1e-2)
            assert all(getattr(many, name)[at] == getattr(alone, name) for name in fields)


def test_any_layout_and_any_threads_give_the_same_bits():
    speeds = np.geomspace(0.01, 0.3, 12).reshape(3, 4)
    plain = stoss.restitution(poisson=0.4, speed=speeds, tolerance=1e-2).restitution
    padded = np.repeat(speeds, 2, axis=1)[:, ::2]
    frozen = speeds.copy()
    frozen.flags.writeable = False
    swapped = speeds.astype(speeds.dtype.newbyteorder())
    for same_speeds in (padded, np.asfortranarray(speeds), frozen, swapped, speeds.tolist()):
        assert np.array_equal(stoss.restitution(poisson=0.4, speed=same_speeds, tolerance=1e-2).restitution, plain)
    for threads in (0, 1, 2, 7):
        again = stoss.restitution(poisson=0.4, speed=speeds, tolerance=1e-2, threads=threads)
        assert np.array_equal(again.restitution, plain)
