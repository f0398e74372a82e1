"""Rows of equal elastic disks from nothing of stoss: eigenmodes by Bessel functions up to a cutoff, what the others do at
once by the static disk, and one active set for all contacts. Of first order in the cutoff, as nothing radiates."""

import numpy as np
from numpy.polynomial.legendre import leggauss
from scipy.optimize import brentq
from scipy.special import jv, jvp

NU = 0.3
LAME, SHEAR = NU / (1 - NU**2), 0.5 / (1 + NU)  # plane stress, E = rho = R = 1
FAST, SLOW = np.sqrt(LAME + 2 * SHEAR), np.sqrt(SHEAR)
MASS = np.pi


def edge(n, omega):
    """Stresses (rr, rt) at the edge by the two potentials."""
    k, q = omega / FAST, omega / SLOW
    a = [-LAME * k**2 * jv(n, k) + 2 * SHEAR * k**2 * jvp(n, k, 2), SHEAR * (-2 * n * k * jvp(n, k) + 2 * n * jv(n, k))]
    b = [2 * SHEAR * n * (q * jvp(n, q) - jv(n, q)),
         SHEAR * (-(n**2) * jv(n, q) - q**2 * jvp(n, q, 2) + q * jvp(n, q))]
    return a, b


def determinant(n, omega):
    a, b = edge(n, omega)
    return a[0] if n == 0 else a[0] * b[1] - a[1] * b[0]


def moved(n, omega, a, b, r):
    """Radial and tangential amplitudes at r."""
    k, q = omega / FAST, omega / SLOW
    return (a * k * jvp(n, k * r) + b * n * jv(n, q * r) / r, -a * n * jv(n, k * r) / r - b * q * jvp(n, q * r))


def modes(n, highest):
    """Frequencies of an order, and amplitudes at the edge for the modal mass of the disk."""
    at = np.arange(0.05 if n != 1 else 0.3, highest, 0.02)
    values = np.sign(determinant(n, at))
    found = []
    x, weight = leggauss(120 + int(highest))
    r, weight = 0.5 * (x + 1), 0.5 * weight
    for left, right, one, other in zip(at, at[1:], values, values[1:]):
        if one * other >= 0:
            continue
        omega = brentq(lambda w: determinant(n, w), left, right, xtol=1e-13)
        a, b = edge(n, omega)
        of = 1 if abs(b[1]) + abs(a[1]) > abs(b[0]) + abs(a[0]) else 0
        mix = (1.0, 0.0) if n == 0 else (b[of], -a[of])
        u, v = moved(n, omega, *mix, r)
        norm = np.sum(weight * r * (u**2 + v**2)) * (2 if n == 0 else 1) * np.pi
        scale = np.sqrt(MASS / norm)
        u, v = moved(n, omega, *mix, 1.0)
        found.append((omega, scale * u, scale * v))
    return found


def static(n):
    """Amplitudes (u, v) at the edge by stresses (rr, rt) there of an order of 2 or more: of r^(n-1) and r^(n+1)."""
    ratio = (LAME + 2 * SHEAR) / SHEAR
    stress, shown = np.zeros((2, 2)), np.zeros((2, 2))
    for j, (a, b, m) in enumerate(((1.0, -1.0, n - 1), (n + 2 - ratio * n, ratio * (n + 2) - n, n + 1))):
        stress[:, j] = LAME * (m * a + a + n * b) + 2 * SHEAR * m * a, SHEAR * (-n * a + m * b - b)
        shown[:, j] = a, b
    return shown @ np.linalg.inv(stress)


class Disk:
    """Modes up to a cutoff, at points of the edge around its right pole, and what the others do at once."""

    def __init__(self, cutoff, width, count):
        self.angle = (np.arange(count) + 0.5) * width / count
        self.recess = 1 - np.cos(self.angle)
        cell = width / count
        omegas, shapes, parities = [], [], []
        near, far = np.zeros((count, count)), np.zeros((count, count))

        def shape(n, u, v):
            faded = np.sinc(n * cell / (2 * np.pi))  # mean over a cell
            return faded * (u * np.cos(n * self.angle) * np.cos(self.angle)
                            - v * np.sin(n * self.angle) * np.sin(self.angle))

        last = int(12 / cell)
        for n in range(last + 1):
            # Of the orders 0 and 1 the static answer is that of many modes, and of what is left of them.
            highest = 400.0 if n < 2 else cutoff
            found = modes(n, highest) if 0.5 * n * SLOW < highest else []
            if n >= 2:
                # half of a pair of forces along x at both signs of the angle: that of one order over pi
                loads = np.array([shape(n, 1.0, 0.0), shape(n, 0.0, 1.0)])
                whole = loads.T @ static(n) @ loads / np.pi
                near += whole
                far += (-1) ** n * whole
            for omega, u, v in found:
                s = shape(n, u, v)
                part = np.outer(s, s) / (MASS * omega**2)
                if omega <= cutoff:
                    omegas.append(omega), shapes.append(s), parities.append((-1) ** n)
                if n >= 2:
                    near -= part
                    far -= (-1) ** n * part
                elif omega > cutoff:
                    near += part
                    far += (-1) ** n * part
        self.omega, self.shape = np.array(omegas), np.array(shapes)
        self.parity, self.near, self.far = np.array(parities), near, far


def solve(compliance, place, active):
    """Forces f >= 0 with gaps W f - place >= 0, one of both 0."""
    for _ in range(200):
        force = np.zeros(place.size)
        if active.any():
            force[active] = np.linalg.solve(compliance[np.ix_(active, active)], place[active])
        gap = compliance @ force - place
        wrong = (active & (force < -1e-13)) | (~active & (gap < -1e-13))
        if not wrong.any():
            return force, active
        active = active ^ wrong
    raise RuntimeError("no active set")


def row(speeds, cutoff, wall=False, end=30.0, count=24):
    """Velocities after, from left to right, over the first."""
    bodies, fastest = len(speeds), max(speeds)
    width = min(1.2, 3.0 * np.sqrt(fastest))
    disk = Disk(cutoff, width, count)
    step = 0.2 / cutoff
    joints = bodies - 1 + wall
    size = joints * count
    compliance = np.zeros((size, size))
    for k in range(joints):
        here = slice(k * count, (k + 1) * count)
        compliance[here, here] = disk.near * (1 if wall and k == joints - 1 else 2)
        if k > 0:  # body k has its left face in joint k - 1 and its right one in k
            before = slice((k - 1) * count, k * count)
            compliance[here, before] = compliance[before, here] = disk.far
    x, v = np.zeros(bodies), np.array(speeds, dtype=float)
    q, p = np.zeros((bodies, disk.omega.size)), np.zeros((bodies, disk.omega.size))
    cosine, sine = np.cos(disk.omega * step), np.sin(disk.omega * step)
    active = np.zeros(size, dtype=bool)
    for _ in range(int(end / step)):
        x = x + v * step
        q, p = q * cosine + p / disk.omega * sine, p * cosine - disk.omega * q * sine
        place = np.zeros(size)
        for k in range(joints):
            mine = x[k] - disk.recess + q[k] @ disk.shape
            if k + 1 < bodies:
                mine = mine - x[k + 1] - disk.recess + (q[k + 1] * disk.parity) @ disk.shape
            place[k * count : (k + 1) * count] = mine
        force, active = solve(compliance, place, active)
        force = force.reshape(joints, count)
        for k in range(joints):
            total, on_modes = 2 * force[k].sum(), 2 * disk.shape @ force[k]
            v[k] -= total / MASS * step
            p[k] -= on_modes / MASS * step
            if k + 1 < bodies:
                v[k + 1] += total / MASS * step
                p[k + 1] -= disk.parity * on_modes / MASS * step
    return v / max(speeds)
