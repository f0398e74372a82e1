"""Slips that a code after the paper could contain, and what each does to Table 1.

The paper's own scheme, apart from stoss: eqs. (43), with the sign of erratum E6, (44) and (39) by
the Runge-Kutta method of 4th order in the interaction picture, 256 angles in the upper quadrant.
Only modes and amplitudes come from stoss.
"""

from __future__ import annotations

from typing import Callable, NamedTuple

import numpy as np
import stoss
from numpy.typing import NDArray

from gerl_zippelius_1999.two_limits import POISSON

Array = NDArray[np.float64]
ANGLES, REACH = 256, 0.9  # in the upper quadrant; radians beyond which the wall of αR = 500 is never felt at v = 0.1 c
STEP = 0.4  # of 1/√(αvω), the time in which the edge answers the wall
FLIGHT = 0.1  # R; a run begins and ends this far from the wall


class Modes(NamedTuple):
    order: NDArray[np.int64]
    index: NDArray[np.int64]
    omega: Array
    radial: Array
    tangential: Array

    def where(self, chosen: NDArray[np.bool_]) -> Modes:
        return Modes(*(column[chosen] for column in self))

    def scaled(self, factor: Array) -> Modes:
        return self._replace(radial=factor * self.radial, tangential=factor * self.tangential)


class Outcome(NamedTuple):
    """Energies of the modes as shares of the initial energy; times in R/c."""

    average: Array  # over the contact
    potential: Array  # the part of it that is ½mω²Q²
    after: Array
    lost: float  # 1 − ε²
    contact_time: float
    energy_error: float


def lowest(cutoff: float) -> Modes:
    modes = stoss.modes(poisson=POISSON, cutoff=cutoff)
    columns = (modes.order, modes.index, modes.omega, modes.radial, modes.tangential)
    return Modes(*(np.array(column) for column in columns))


def collide(modes: Modes, speed: float, hardness: float, step: float = STEP) -> Outcome:
    """One impact; `step` in units of 1/√(αvω) of the highest mode."""
    interval = 0.5 * np.pi / ANGLES
    angle = (np.arange(ANGLES) + 0.5) * interval
    angle = angle[angle < REACH]
    recess = 2.0 * np.sin(0.5 * angle) ** 2
    push = modes.radial[:, None] * np.cos(np.outer(modes.order, angle)) * np.cos(angle)
    push -= modes.tangential[:, None] * np.sin(np.outer(modes.order, angle)) * np.sin(angle)
    pull = np.ascontiguousarray(push.T)
    mass, omega = np.pi, modes.omega
    kinetic = 0.5 * mass * speed**2
    dt = step / np.sqrt(hardness * speed * omega.max())
    half_turn = np.exp(0.5j * omega * dt)

    def rates(q: NDArray, compression: float, phase: NDArray) -> tuple[NDArray, float]:
        force = 2.0 * interval * hardness * np.exp(hardness * (compression - recess + pull @ (q * phase).real))
        return 1j * (push @ force) / (mass * omega) * phase.conj(), -float(force.sum()) / mass

    q, phase = np.zeros(omega.size, dtype=complex), np.ones(omega.size, dtype=complex)
    compression, velocity = -np.log(np.pi / (1e-9 * kinetic)) / hardness, speed
    average, potential = np.zeros((2, omega.size))
    time = first = last = 0.0
    count = 0
    while velocity > 0.0 or compression > -FLIGHT:
        middle, end = phase * half_turn, phase * half_turn * half_turn
        dq1, a1 = rates(q, compression, phase)
        dq2, a2 = rates(q + 0.5 * dt * dq1, compression + 0.5 * dt * velocity, middle)
        dq3, a3 = rates(q + 0.5 * dt * dq2, compression + 0.5 * dt * velocity + 0.25 * dt**2 * a1, middle)
        dq4, a4 = rates(q + dt * dq3, compression + dt * velocity + 0.5 * dt**2 * a2, end)
        q = q + dt / 6.0 * (dq1 + 2.0 * dq2 + 2.0 * dq3 + dq4)
        compression += dt * velocity + dt**2 / 6.0 * (a1 + a2 + a3)
        velocity += dt / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4)
        phase, time = end, time + dt
        if not abs(velocity) < 10.0 * speed:
            raise FloatingPointError("the step is too large for the wall")
        if -a4 > 1e-3 * speed * omega.min():  # in contact, as stoss counts it
            first, last = first or time, time
            average += np.abs(omega * q) ** 2 / speed**2
            potential += (omega * (q * phase).real) ** 2 / speed**2
            count += 1
    after = np.abs(omega * q) ** 2 / speed**2
    restitution = velocity / speed
    error = 1.0 - restitution**2 - float(after.sum())
    return Outcome(average / count, potential / count, after, 1.0 - restitution**2, last - first, error)


def bessel(order: NDArray, x: Array) -> Array:
    """J_n(x) = ∫₀^π cos(nt − x sin t) dt/π by the midpoint rule, exact for n + x < 300."""
    t = (np.arange(320) + 0.5) * np.pi / 320
    return np.cos(np.multiply.outer(order, t) - np.multiply.outer(x, np.sin(t))).mean(axis=-1)


def exchanged(modes: Modes) -> Modes:
    """Amplitudes with κ and κ′ exchanged in u_φ, as eq. (26) is printed, in norm and S (E4)."""
    n = modes.order
    wave, wave_shear = modes.omega * np.sqrt(1.0 - POISSON**2), modes.omega * np.sqrt(2.0 * (1.0 + POISSON))

    def profile(r: float) -> tuple[Array, Array, Array, Array]:
        """J_n(κr)/r, dJ_n(κr)/dr and the same with κ′."""
        parts = []
        for k in (wave, wave_shear):
            value = bessel(n, k * r) / r
            parts += [value, n * value - k * bessel(n + 1, k * r)]
        return tuple(parts)  # type: ignore[return-value]

    b, a, b_shear, a_shear = at_edge = profile(1.0)
    determinant = n**2 * b * b_shear - a * a_shear
    first = -(modes.radial * a_shear + n * b_shear * modes.tangential) / determinant  # A
    second = (a * modes.tangential + n * b * modes.radial) / determinant  # B
    norm = np.zeros(n.size)
    for x, weight in zip(*np.polynomial.legendre.leggauss(60)):
        r = 0.5 * (x + 1.0)
        b, a, b_shear, _ = profile(r)
        radial, tangential = first * a + n * second * b_shear, n * first * b_shear + second * a
        norm += 0.5 * weight * r * (radial**2 + tangential**2)
    factor = np.sqrt(np.where(n == 0, 0.5, 1.0) / norm)
    printed = -(n * first * at_edge[2] + second * at_edge[1])
    return modes._replace(radial=factor * modes.radial, tangential=factor * np.where(n == 0, 0.0, printed))


def with_torsion(modes: Modes) -> Modes:
    """Adds the torsional roots, J_2(κ′) = 0, to the radial modes: all the zeros of eq. (24), n = 0.

    The added modes have C = 1.
    """
    grid = np.linspace(1.0, modes.omega.max() * np.sqrt(2.0 * (1.0 + POISSON)), 4000)
    value = bessel(np.full(grid.size, 2), grid)
    at = np.flatnonzero(value[1:] * value[:-1] < 0.0)
    zeros = grid[at] - value[at] * (grid[1] - grid[0]) / (value[at + 1] - value[at])
    added = zeros / np.sqrt(2.0 * (1.0 + POISSON))
    radial = modes.where(modes.order == 0)
    omega = np.concatenate([radial.omega, added])
    amplitude = np.concatenate([radial.radial, np.ones(added.size)])
    sorting = np.argsort(omega)
    zero = np.zeros(omega.size)
    joined = Modes(zero.astype(int), np.arange(omega.size), omega[sorting], amplitude[sorting], zero)
    return Modes(*(np.concatenate(pair) for pair in zip(joined, modes.where(modes.order > 0))))


def _factor(chosen: NDArray[np.bool_], square: float) -> Array:
    return np.where(chosen, np.sqrt(square), 1.0)


# What it is called, and what it makes of the modes of one cutoff.
SLIPS: dict[str, Callable[[Modes], Modes]] = {
    "no slip": lambda m: m,
    "modes below ω = 5 only": lambda m: m.where(m.omega <= 5.0),
    "orders 1 to 6, all n = 0": lambda m: m.where(m.order <= 6),
    "no tangential motion (S = 0)": lambda m: m._replace(tangential=0.0 * m.tangential),
    "n = 0 normalised as n ≥ 1": lambda m: m.scaled(_factor(m.order == 0, 2.0)),
    "n ≥ 1 normalised as n = 0": lambda m: m.scaled(_factor(m.order > 0, 0.5)),
    "κ, κ′ as in eq. (26)": exchanged,
    "torsional roots in n = 0": with_torsion,
    "C doubled for n = 0, l ≥ 1": lambda m: m.scaled(_factor((m.order == 0) & (m.index > 0), 4.0)),
}
