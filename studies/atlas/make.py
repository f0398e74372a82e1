"""Makes the atlas that the Python package ships of the stores of two sweeps.

    stoss sweep studies/atlas/spheres.toml --store build/atlas/spheres
    stoss sweep studies/atlas/disks.toml --store build/atlas/disks
    python3 studies/atlas/make.py build/atlas python/stoss/atlas.npz

The error of interpolation is measured, axis by axis, at every second node from the others, whose
distance is twice that of the atlas. What is stored is the sum over the axes of the largest one near
by: far more than a cubic of half the distance errs where ε is smooth, and no less than at a bend,
which the nodes that are held out may miss.
"""

import sys

import numpy as np

import stoss
from stoss.results._atlas import stencil

def held_out_error(values, axis):
    """How far each second node is from the cubic through the others; at these the larger one of its
    neighbours."""
    lines = np.moveaxis(values, axis, 0)
    kept = lines[::2]
    first, weights = stencil(np.arange(len(kept) - 1) + 0.5, len(kept))
    guess = np.einsum("ij,ij...->i...", weights, kept[first[:, None] + np.arange(4)])
    error = np.zeros_like(lines)
    error[1::2] = np.abs(guess - lines[1::2])
    error[2:-1:2] = np.maximum(error[1:-2:2], error[3::2])
    error[0], error[-1] = error[1], error[-2]
    return np.moveaxis(error, 0, axis)


def nearby(error):
    """The largest one within one node along each axis."""
    for axis in range(error.ndim):
        lines = np.moveaxis(error, axis, 0)
        wide = np.concatenate([lines[:1], lines, lines[-1:]])
        error = np.moveaxis(np.maximum(np.maximum(wide[:-2], wide[1:-1]), wide[2:]), 0, axis)
    return error


def tables(kind, result):
    """The arrays of one kind of body: at a wall, at a block, and in pairs."""
    assert result.complete and result.converged.all()
    parts = {"wall": 0, "block": 1, "pair": slice(2, None)}
    for name, part in parts.items():
        values = result.restitution[:, part]
        yield f"{kind}_{name}", values
        yield f"{kind}_{name}_error", result.restitution_error[:, part]
        yield f"{kind}_{name}_interpolation_error", sum(nearby(held_out_error(values, axis)) for axis in range(values.ndim))


def main(stores, target):
    arrays = {}
    for kind in ("sphere", "disk"):
        result = stoss.open_sweep(f"{stores}/{kind}s")
        arrays |= tables(kind, result)
        arrays[f"{kind}_poisson"] = np.array([body.poisson for body in result.grid.bodies])
        arrays["speed"] = result.grid.speed
        arrays["ratio"] = np.array([each["radius"] for each in result.grid.against[2:]])
    axes = ("speed", "ratio", "sphere_poisson", "disk_poisson")
    np.savez_compressed(target, **{name: each if name in axes else np.float32(each) for name, each in arrays.items()})


if __name__ == "__main__":
    main(*sys.argv[1:])
