"""Finds the two constants of the edge law (src/contact/edge/edge_law.cpp) again: python3 validate/edge_law.py

A parabola of curvature 1 is pressed on a half-plane of softness D = 1 that is only touched at nodes
x = ±½, ±3/2, … (spacing h = 1), as docs/developer/numerics.md, section 3, explains. Needs numpy.
"""

import numpy as np

EULER = 0.5772156649015329
FAR = np.log(1e3)  # where the half-plane is held fixed: of no influence beyond the contact


def kernel(largest):
    """G(m) = Ci(πm) − ln m + const: −ln x of a line force at distance m, without wave numbers above π/h."""
    roots, weights = np.polynomial.legendre.leggauss(40 + 2 * largest)
    k = 0.5 * np.pi * (roots + 1.0)
    m = np.arange(largest + 1)[:, None]
    return FAR + np.log(np.pi) + EULER + np.sum((np.cos(m * k) - 1.0) / k * 0.5 * np.pi * weights, axis=1)


def compliance(nodes):
    """Displacement of node i by a unit force shared by node j and its mirror image."""
    g = kernel(2 * nodes)
    i, j = np.indices((nodes, nodes))
    return (g[abs(i - j)] + g[i + j + 1]) / np.pi


def positions(nodes):
    return np.arange(nodes) + 0.5


def exact_compression(force):
    """δ of Hertz, for the same logarithm: a² = 4F/π, δ = (2F/π)(½ − ln(a/2) + const)."""
    a = np.sqrt(4.0 * force / np.pi)
    return 2.0 * force / np.pi * (0.5 - np.log(0.5 * a) + FAR)


def shift(nodes):
    """By how much the line F_k(δ) of k rigid nodes is that of an exact contact closer to the body.

    F_k = s (δ − ⟨x²⟩/2), s and ⟨x²⟩ under a flat punch. A continuous punch as stiff has the half-width
    a, ln(a/2) = const − π/2s, and ⟨x²⟩ = a²/2.
    """
    x = positions(nodes)
    pressure = np.linalg.solve(compliance(nodes), np.ones(nodes))
    stiffness = pressure.sum()
    a = 2.0 * np.exp(FAR - 0.5 * np.pi / stiffness)
    return a - nodes, 0.25 * a * a - 0.5 * (pressure @ x**2) / stiffness


def force_of_law(matrix, compression, force_scale, gap_scale, start):
    """Newton's method for W f = q + g, f = f* t², g = g* (1 − t)². Also gives the closures t."""
    q = compression - 0.5 * positions(len(matrix)) ** 2

    def rest(t):
        return matrix @ (force_scale * np.maximum(t, 0.0) ** 2) - q - gap_scale * np.maximum(1.0 - t, 0.0) ** 2

    t = start.copy()
    for _ in range(100):
        r = rest(t)
        if np.linalg.norm(r) < 1e-11 * compression:
            return force_scale @ np.maximum(t, 0.0) ** 2, t
        slope = matrix * (2.0 * force_scale * np.maximum(t, 0.0)) + np.diag(2.0 * gap_scale * np.maximum(1.0 - t, 0.0))
        change = -np.linalg.solve(slope, r)
        share = 1.0
        while np.linalg.norm(rest(t + share * change)) > np.linalg.norm(r) and share > 1e-6:
            share *= 0.5
        t = t + share * change
    raise RuntimeError("the law has not been solved")


def compressions(touching, samples):
    """Over which the edge passes one node, evenly in the half-width."""
    a = touching + (np.arange(samples) + 0.5) / samples
    return exact_compression(0.25 * np.pi * a * a)


def deviation(touching, constants, samples=16):
    """Compression that each F of the law lacks of the envelope, and half the sum of closures beyond the edge."""
    nodes = touching + 8
    matrix, x = compliance(nodes), positions(nodes)
    opening = 2.0 * np.sqrt(2.0) / 3.0 * np.sqrt(x)
    lacks, excess = [], []
    for a, delta in zip(touching + (np.arange(samples) + 0.5) / samples, compressions(touching, samples)):
        start = 1.0 + 0.7 * (a - x)
        force, t = force_of_law(matrix, delta - 1.0 / 24.0, constants[0] * opening, constants[1] * opening,
                                np.where(start > 0, np.sqrt(np.maximum(start, 0)), start))
        lacks.append(delta - exact_compression(force))
        excess.append(np.clip(t, 0.0, 1.0).sum() - np.sqrt(4.0 * force / np.pi))
    return np.array(lacks), np.array(excess)


def fit(touching):
    """The constants for which the deviation is least, by Gauss' and Newton's method."""
    constants = np.array([0.7, 0.6])
    for _ in range(6):
        lacks, _ = deviation(touching, constants)
        slopes = np.stack([(deviation(touching, constants + 1e-4 * unit)[0] - lacks) / 1e-4 for unit in np.eye(2)], axis=1)
        constants = constants - np.linalg.lstsq(slopes, lacks, rcond=None)[0]
    return constants


def rms(values):
    return np.sqrt(np.mean(np.square(values)))


if __name__ == "__main__":
    print("touching  a/h − k   shift·24/h²   f*       g*     rms of δ/h²: law, fitted, 0.7145 and 0.6177   excess")
    for k in (6, 12, 24, 48, 96):
        constants = fit(k)
        wide, off = shift(k)
        lacks, excess = deviation(k, np.array([0.7145, 0.6177]))
        print(f"{k:8d} {wide:9.4f} {24 * off:12.4f} {constants[0]:9.4f} {constants[1]:8.4f}"
              f" {rms(deviation(k, constants)[0]):22.1e} {rms(lacks):18.1e} {excess.mean():14.3f}")
