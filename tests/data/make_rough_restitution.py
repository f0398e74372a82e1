"""Makes rough_restitution.csv: what balls and disks lose at a rough wall, by spectral finite elements of their own.

    python3 make_rough_restitution.py > rough_restitution.csv

A ball (axisymmetric) or a disk in plane stress, R = ρ = E = 1, meets a rigid plane at rest with the pressure e^(−g/u₀)
on the projected area, g the gap along the axis. It starts unexcited at g = 18 u₀ and ends as far away. Elements in
polar coordinates of the meridian, polynomials of degree 5 in both directions, integrals by Gauss' rule; in time the
trapezium rule, with the forces on all Gauss points of the surface by Newton's method in ln f. The values of two steps
in time, of which the error falls with the square, are extrapolated. No modes, no cutoff, no law of the edge.
"""

import sys

import numpy as np
from numpy.polynomial.legendre import Legendre, leggauss
from scipy import sparse
from scipy.sparse.linalg import splu

DEGREE = 5
FRONT, BACK = 0.9, 16  # angle to which elements are short, and number of those behind
LAYERS = (0.0, 0.3, 0.55, 0.72, 0.84, 0.92, 0.97, 1.0)  # R
START = 18.0  # u₀
ROWS = (
    ("ball", 0.3, 0.1, 0.02, 0.1), ("ball", 0.3, 0.1, 0.005, 0.1), ("ball", 0.3, 0.02, 0.005, 0.1),
    ("disk", 0.33, 0.1, 0.01, 0.1), ("disk", 0.3, 0.1, 0.01, 0.1),
    ("disk", 0.33, 0.1, 0.002, 0.05), ("disk", 0.3, 0.1, 0.002, 0.05),
)  # fmt: skip  # body, ν, v, u₀, length of elements near the contact


def lagrange(points):
    """Values and slopes of the polynomials through the Gauss and Lobatto points."""
    inner = np.sort(Legendre.basis(DEGREE).deriv().roots().real)
    nodes = np.concatenate([[-1.0], inner, [1.0]])
    basis = [np.poly1d(np.poly(np.delete(nodes, j))) / np.prod(nodes[j] - np.delete(nodes, j)) for j in range(DEGREE + 1)]
    values = np.array([each(points) for each in basis]).T
    return values, np.array([each.deriv()(points) for each in basis]).T


class Body:
    """Stiffness, mass, and the Gauss points of the surface, of the free displacements u_r and u_z."""

    def __init__(self, ball, poisson, length):
        angles = np.concatenate([np.arange(0.0, FRONT + 1e-9, length), np.linspace(FRONT, np.pi, BACK + 1)[1:]])
        across, along = (len(angles) - 1) * DEGREE + 1, (len(LAYERS) - 1) * DEGREE + 1
        self.nodes = 1 + across * (along - 1)  # all of the innermost row are the centre

        def number(i, j):
            return 0 if j == 0 else 1 + i + across * (j - 1)

        self.number, self.across, self.along, self.angles, self.ball = number, across, along, angles, ball
        second = poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson) if ball else 1.0 - poisson**2)
        shear = 0.5 / (1.0 + poisson)
        rows, stiffness, mass = [], [], []
        for a in range(len(angles) - 1):
            for b in range(len(LAYERS) - 1):
                ids = np.array([number(a * DEGREE + i, b * DEGREE + j) for i in range(DEGREE + 1) for j in range(DEGREE + 1)])
                own = self.element(angles[a : a + 2], LAYERS[b : b + 2], second, shear)
                rows.append(np.concatenate([ids, ids + self.nodes]))
                stiffness.append(own[0].ravel())
                mass.append(own[1].ravel())
        first = np.concatenate([np.repeat(each, len(each)) for each in rows])
        other = np.concatenate([np.tile(each, len(each)) for each in rows])
        fixed = [0] + [number(i, j) for j in range(1, along) for i in (0, across - 1)]  # u_r on the axis
        free = np.setdiff1d(np.arange(2 * self.nodes), fixed)
        self.axial = free >= self.nodes
        shape = (2 * self.nodes, 2 * self.nodes)
        self.stiffness, self.mass = (
            sparse.csc_matrix((np.concatenate(each), (first, other)), shape=shape)[free][:, free].tocsc()
            for each in (stiffness, mass)
        )
        self.surface = self.points()[free].tocsc()

    def element(self, angle, layer, second, shear):
        points, weights = leggauss(DEGREE + 2)
        values, slopes = lagrange(points)
        half_angle, half_layer = 0.5 * (angle[1] - angle[0]), 0.5 * (layer[1] - layer[0])
        theta, s = np.meshgrid(
            angle[0] + half_angle * (1 + points), layer[0] + half_layer * (1 + points), indexing="ij"
        )
        theta, s = theta.ravel(), s.ravel()
        r = s * np.sin(theta)
        size = (len(points) ** 2, -1)
        shape = np.einsum("gi,hj->ghij", values, values).reshape(size)
        by_angle = np.einsum("gi,hj->ghij", slopes / half_angle, values).reshape(size) / s[:, None]
        by_layer = np.einsum("gi,hj->ghij", values, slopes / half_layer).reshape(size)
        by_r = np.sin(theta)[:, None] * by_layer + np.cos(theta)[:, None] * by_angle
        by_z = np.sin(theta)[:, None] * by_angle - np.cos(theta)[:, None] * by_layer
        around = 2.0 * np.pi * r if self.ball else 2.0
        volume = (np.outer(weights, weights).ravel() * half_angle * half_layer * s * around)[:, None]
        hoop = shape / r[:, None] if self.ball else 0.0 * shape
        none = 0.0 * shape
        strains = [np.hstack(pair) for pair in ((by_r, none), (none, by_z), (hoop, none), (by_z, by_r))]
        dilatation = strains[0] + strains[1] + strains[2]
        stiffness = dilatation.T @ (second * volume * dilatation) + strains[3].T @ (shear * volume * strains[3])
        for normal in strains[:3]:
            stiffness += normal.T @ (2.0 * shear * volume * normal)
        return stiffness, np.kron(np.eye(2), shape.T @ (volume * shape))

    def points(self):
        """Axial displacements at the Gauss points of the front; their angles and projected areas."""
        places, weights = leggauss(DEGREE + 4)
        values, _ = lagrange(places)
        rows, columns, entries, phi, area = [], [], [], [], []
        for a, start in enumerate(self.angles[:-1]):
            half = 0.5 * (self.angles[a + 1] - start)
            if start > 1.4:
                break
            for q, place in enumerate(places):
                angle = start + half * (1 + place)
                rows += [self.nodes + self.number(a * DEGREE + i, self.along - 1) for i in range(DEGREE + 1)]
                columns += [len(phi)] * (DEGREE + 1)
                entries += values[q].tolist()
                phi.append(angle)
                width = 2.0 * np.pi * np.sin(angle) if self.ball else 2.0
                area.append(weights[q] * half * np.cos(angle) * width)
        self.recess, self.area = 1.0 - np.cos(phi), np.array(area)
        return sparse.csr_matrix((entries, (rows, columns)), shape=(2 * self.nodes, len(phi)))


def impact(body, speed, length, step):
    """1 − ε², the maximum force and the time with more than a thousandth of it."""
    effective = splu((body.stiffness + 4.0 / step**2 * body.mass).tocsc())
    answer = effective.solve(body.surface.toarray())
    compliance = body.surface.T @ answer
    upward = body.axial.astype(float)
    momentum = body.mass @ upward
    gap = START * length + body.recess
    free = np.log(body.area)  # ln f of no gap
    log_force = free - gap / length
    u, velocity = 0.0 * upward, -speed * upward
    acceleration = splu(body.mass).solve(body.surface @ np.exp(log_force))
    before, forces = log_force, []
    while True:
        alone = effective.solve(body.mass @ (4.0 / step**2 * u + 4.0 / step * velocity + acceleration))
        placed = gap + body.surface.T @ alone
        log_force, before = 2.0 * log_force - before, log_force
        for _ in range(60):
            force = np.exp(log_force)
            rest = length * (log_force - free) + placed + compliance @ force
            change = np.linalg.solve(length * np.eye(len(free)) + compliance * force, -rest)
            log_force = log_force + np.clip(change, -2.0, 2.0)
            if np.abs(change).max() < 1e-9:
                break
        force = np.exp(log_force)
        moved = alone + answer @ force
        faster = 4.0 / step**2 * (moved - u) - 4.0 / step * velocity - acceleration
        velocity = velocity + 0.5 * step * (acceleration + faster)
        u, acceleration = moved, faster
        forces.append(force.sum())
        rebound = momentum @ velocity / (momentum @ upward)
        if rebound > 0.0 and forces[-1] < np.exp(-START) * length:
            break
    forces = np.array(forces)
    return np.array([1.0 - (rebound / speed) ** 2, forces.max(), step * np.count_nonzero(forces > 1e-3 * forces.max())])


def main():
    print("# What balls and disks lose at a rough wall with p = e^(-g/u0) on the projected area, R = rho = E = 1:")
    print("# spectral finite elements, make_rough_restitution.py. max_force in E R^2, of disks E R per thickness.")
    print("body,poisson,speed,asperities,lost_fraction,uncertainty,max_force,contact_time")
    for name, poisson, speed, asperities, length in ROWS:
        body = Body(name == "ball", poisson, length)
        step = min(0.01, 2.0 * asperities / speed * 0.1)
        coarse, fine = (impact(body, speed, asperities, each) for each in (step, 0.5 * step))
        value = (4.0 * fine - coarse) / 3.0
        uncertainty = 0.1 * abs(value[0] - fine[0]) + 1e-6 * value[0]
        numbers = f"{value[0]:.9f},{uncertainty:.1e},{value[1]:.6f},{fine[2]:.3f}"
        print(f"{name},{poisson:g},{speed:g},{asperities:g},{numbers}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
