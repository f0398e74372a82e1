"""Rows of point balls that push each other by Hertz's law: what rows of slow elastic balls tend to."""

import numpy as np
from scipy.integrate import solve_ivp


def chain(speeds, *, masses=None, stiffness=None, wall=False, gaps=None, until=None, dense=False, restitution=None):
    """Velocities after all contacts, or the whole solution: m ẍ = F_left − F_right, F = k δ^{3/2}, with the mass and the
    stiffness of equal balls as units. A pair's ε gives the force a dashpot, F = k δ^{3/2} (1 + a δ̇/v)."""
    count = len(speeds)
    masses = np.ones(count) if masses is None else np.asarray(masses, float)
    joints = count - 1 + wall
    stiffness = np.ones(joints) if stiffness is None else np.asarray(stiffness, float)
    gaps = np.zeros(joints) if gaps is None else np.asarray(gaps, float)
    fastest = np.ptp(np.append(speeds, 0.0))
    damping = 0.0 if restitution is None else dashpot(restitution) / fastest

    def forces(place, velocity):
        following, faster = (np.append(each, 0.0) if wall else each for each in (place, velocity))
        pressed = np.clip(following[:-1] - following[1:] - gaps, 0.0, None)
        rate = faster[:-1] - faster[1:]
        return np.clip(stiffness * pressed**1.5 * (1 + damping * rate), 0.0, None)

    def slope(_, state):
        place, velocity = state[:count], state[count:]
        force = forces(place, velocity)
        push = np.zeros(count)
        push[: joints] -= force[:count]
        push[1:] += force[: count - 1]
        return np.concatenate([velocity, push / masses])

    single = 3.3 * fastest**-0.2
    until = until or 3 * single * (count + 2) + 3 * gaps.sum() / fastest
    start = np.concatenate([np.zeros(count), np.asarray(speeds, float)])
    found = solve_ivp(slope, (0, until), start, rtol=1e-10, atol=1e-14 * fastest, max_step=single / 20, dense_output=dense)
    return (found, forces) if dense else found.y[count:, -1]


def wave(count=40, middle=20):
    """Speed over the sixth root of the greatest force, in balls, and width at half of it, in balls, of the wave in the
    middle of a row of equal balls of which the first moves."""
    found, forces = chain([1.0] + [0.0] * (count - 1), until=3.3 * 0.6 * count, dense=True)
    times = np.linspace(0, found.t[-1], 40001)
    states = found.sol(times)
    each = np.array([forces(*np.split(state, 2)) for state in states.T])[:, middle - 1 : middle + 2]
    peaks = times[each.argmax(axis=0)]
    above = times[each[:, 1] > 0.5 * each[:, 1].max()]
    speed = 2 / (peaks[2] - peaks[0])
    return speed / each[:, 1].max() ** (1 / 6), (above[-1] - above[0]) * speed


def dashpot(restitution):
    """a of F = k δ^{3/2} (1 + a δ̇/v) that gives a pair this ε."""
    low, high = 0.0, 50.0
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if pair(middle) > restitution else (low, middle)
    return 0.5 * (low + high)


def pair(damping):
    def slope(_, state):
        depth, rate = state
        return [rate, -max(0.0, max(depth, 0.0) ** 1.5 * (1 + damping * rate))]

    def parts(_, state):
        return state[0]

    parts.terminal, parts.direction = True, -1
    found = solve_ivp(slope, (0, 50), [1e-12, 1.0], rtol=1e-10, atol=1e-13, events=parts)
    return -found.y[1, -1]


def pairwise(speeds, restitution, masses=None, wall=False):
    """Velocities after collisions one after the other, each with the ε of its pair, as event-driven codes have them:
    of touching balls the pair that meets fastest is next."""
    speeds = list(map(float, speeds))
    masses = [1.0] * len(speeds) if masses is None else list(masses)
    ends = list(range(len(speeds) - 1)) + ([len(speeds) - 1] if wall else [])
    least = 1e-9 * (max(speeds) - min(min(speeds), 0.0))
    while True:
        approach = {b: speeds[b] - (speeds[b + 1] if b + 1 < len(speeds) else 0.0) for b in ends}
        b = max(approach, key=approach.get)
        if approach[b] <= least:
            return speeds
        own = restitution(b) if callable(restitution) else restitution
        if b + 1 == len(speeds):
            speeds[b] -= (1 + own) * approach[b]
            continue
        mass = masses[b] * masses[b + 1] / (masses[b] + masses[b + 1])
        impulse = (1 + own) * mass * approach[b]
        speeds[b] -= impulse / masses[b]
        speeds[b + 1] += impulse / masses[b + 1]
