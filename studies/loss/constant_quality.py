"""ε of a slow ball whose material has the same quality Q at all frequencies: the origin of src/quasistatic/lossy_motion.cpp.

Hertz' contact is a row of independent springs at x, -a … a, of the elongation u = δ(t) − x²/R. Each has the memory of
the material, its relaxation E(t) as a sum of Maxwell branches, and lets go when its force is zero: Ting's solution, on
the way in and on the way out. Q is constant where E(t) ~ t^-α with α = (2/π) atan(1/Q), as then M(iω) ~ (iω)^α has the
angle πα/2 at every ω. The branches are the trapezium rule, in the logarithm of the rate s, of

    t^-α = 1/Γ(α) ∫ s^α e^(-st) d ln s,

with positive weights; what relaxes more slowly than the impact by 10⁷ is one spring. The law has no time of its own, so
ε depends on Q alone.

constant_quality.py [STEPS] prints (1 − ε²)Q and its numerical error: by the same code of Kelvin and Voigt's material,
Q at ω = π/T of Hertz' impact, which Ting's law gives in closed form (3.5443 at small loss); of each constant Q, and by
how much the fit of the core differs; and of two constant Q by a second program without branches and without a grid of
springs. 2400 steps, as the fit has them, take three minutes.
"""

import math
import sys
from functools import partial

import numpy as np

HERTZ_TIME = 3.218063
"""T of Hertz' impact in (m/k)^{2/5} v^{-1/5}."""

FIT = (2.40946699, -3.79729105, 1.49946465, 0.65837084, -1.18349334, 0.42733878)
"""(1 − ε²)Q as a polynomial in α, by least squares: that of the core."""

QUALITIES = (300, 200, 100, 70, 50, 40, 30, 25, 20, 15, 12, 10, 8, 7, 6, 5, 4, 3.5, 3, 2.5, 2, 1.7, 1.5, 1.3, 1.2, 1,
             0.9, 0.8, 0.7, 0.6, 0.5)  # fmt: skip


def constant_quality(quality):
    """Rates and weights of Maxwell branches of t^-α from 10⁻⁷ to 10; rate 0 is a spring."""
    alpha = 2 / math.pi * math.atan(1 / quality)
    step = 0.7
    powers = np.arange(math.floor(math.log(1e-7) / step), math.ceil(math.log(1e9) / step))
    rates = np.exp(step * powers)
    weights = step * rates**alpha / math.gamma(alpha)
    slower = weights[0] / math.expm1(step * alpha)  # of all rates below, a geometric series
    return np.append(rates, 0.0), np.append(weights, slower)


def kelvin_voigt(quality):
    """A spring, and a dashpot of its loss time at ω = π/T, as a branch that relaxes at once."""
    at_once = 1e9
    return np.array([at_once, 0.0]), np.array([at_once * HERTZ_TIME / (math.pi * quality), 1.0])


def restitution(branches, steps):
    """ε of a ball with m = k = R = v = 1, F = ¾·2∫ E∗du dx: leapfrog in time, midpoints in x."""
    rates, weights = branches
    weights = weights / (weights * np.exp(-rates)).sum()  # E(1) = 1: the impact lasts about 3
    length = 2.0 / steps
    start = ((np.arange(steps) + 0.5) * length) ** 2
    time = 4.0 / steps
    shrink = np.exp(-rates * time)
    memory = np.zeros((steps, rates.size))  # ∫ e^(-s(t − t′)) u̇ dt′ of each spring and branch
    holds = np.ones(steps, dtype=bool)
    depth, speed, touched = 0.0, 1.0, 0

    def grown(duration):
        """∫ e^(-st) dt over a duration."""
        return np.where(rates > 0.0, -np.expm1(-rates * duration) / np.where(rates > 0.0, rates, 1.0), duration)

    while True:
        memory[:touched] = memory[:touched] * shrink + speed * grown(time)
        depth += speed * time
        while start[touched] < depth:  # within this step
            memory[touched] = speed * grown((depth - start[touched]) / speed)
            touched += 1
        forces = memory[:touched] @ weights
        holds[:touched] &= forces > 0.0
        force = 1.5 * length * forces[holds[:touched]].sum()
        if touched and not holds[:touched].any():
            return -speed
        speed -= force * time


def restitution_directly(quality, steps):
    """The same without branches: springs that begin at the steps, and sums of t^-α itself over all earlier ones."""
    alpha = 2 / math.pi * math.atan(1 / quality)
    time = 4.0 / steps
    powers = np.arange(2 * steps + 1.0) ** (1 - alpha)
    stress = np.diff(powers) * time**-alpha / (1 - alpha)  # of a unit of elongation, k steps later
    depth, speed, grown, touched = [0.0], 1.0, [], 0
    while True:
        grown.append(speed * time)
        depth.append(depth[-1] + grown[-1])
        forces = np.cumsum((stress[: len(grown)][::-1] * grown)[::-1])[::-1]  # of the spring of each step
        if speed > 0.0:
            touched = len(grown)
        else:
            while touched and forces[touched - 1] <= 0.0:
                touched -= 1
        if not touched:
            return -speed
        at = np.sqrt(depth[: touched + 1])
        values = np.append(forces[:touched], 0.0)
        speed -= 1.5 * time * (0.5 * (values[1:] + values[:-1]) * np.diff(at)).sum()


def loss(how, most):
    """1 − ε² and its error, from as many steps, half and a quarter of them: the first and second powers of the step."""
    values = [1 - how(most // part) ** 2 for part in (4, 2, 1)]
    first, second = 2 * values[1] - values[0], 2 * values[2] - values[1]
    best = (4 * second - first) / 3
    return best, abs(best - second)


def fitted(quality):
    """1 − ε² as the core has it."""
    return np.polynomial.polynomial.polyval(2 / math.pi * math.atan(1 / quality), FIT) / quality


def main(most):
    def say(what, quality, how, more=""):
        value, error = loss(how, most)
        more = f"  fit {fitted(quality) / value - 1:+.1e}" if more is None else more
        print(f"{what:12} Q = {quality:<5g} {value * quality:.5f} ± {error * quality:.5f}{more}", flush=True)

    for quality in (300, 30):
        say("Kelvin–Voigt", quality, partial(restitution, kelvin_voigt(quality)))
    for quality in (100, 10):
        say("directly", quality, partial(restitution_directly, quality))
    for quality in QUALITIES:
        say("constant", quality, partial(restitution, constant_quality(quality)), None)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 2400)
