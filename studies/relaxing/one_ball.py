"""The same ball of three materials that have the same E′ and the same Q at the contact of one speed: Kelvin and
Voigt's, one of constant Q, and one whose tan δ has a peak."""

import math

import numpy as np
from commands import listed, run

CONTACT = 4.62 / (2 * math.pi)
"""Frequency of a contact times its duration T: at ω = 4.62/T a slow viscous ball loses as much as one of constant Q."""

# Young's modulus, Poisson's ratio, density in SI, and Q: that modulus and Q at the frequency of the contact.
BALLS = {"rubber": (2e6, 0.49, 1100.0, 10.0), "glass": (7e10, 0.22, 2500.0, 1000.0)}
LAWS = ("Kelvin-Voigt", "constant Q", "one peak")
RADIUS = 0.01
MATCHED, PEAK = 1.0, 0.01  # m/s: the materials are the same at the first speed, and the peak is at the second
SPEEDS = np.geomspace(1e-3, 10**0.5, 29)


def frequency(ball, speed):
    """Of the contact of an elastic ball with a hard wall, Hz."""
    young, poisson, density, _ = BALLS[ball]
    stiffness = 4 / 3 * young / (1 - poisson**2) * math.sqrt(RADIUS)
    time = 3.218063 * (4 / 3 * math.pi * RADIUS**3 * density / stiffness) ** 0.4 * speed**-0.2
    return CONTACT / time


def power(quality):
    """Of the modulus of a material of constant quality, |E| ~ ω^α."""
    return 2 / math.pi * math.atan(1 / quality)


def one_term(ball):
    """Share g and time τ: tan δ = gx/(1 − g + x²) with x = ωτ is greatest at x² = 1 − g."""
    at, top = (frequency(ball, speed) for speed in (MATCHED, PEAK))
    quality, share = BALLS[ball][3], 0.0
    for _ in range(60):
        x = at / top * math.sqrt(1 - share)
        share = (1 + x**2) / (1 + quality * x)
    return share, math.sqrt(1 - share) / (2 * math.pi * top)


def tangent(ball, law, hertz):
    """tan δ of a material at frequencies."""
    quality = BALLS[ball][3]
    if law == "Kelvin-Voigt":
        return hertz / frequency(ball, MATCHED) / quality
    if law == "constant Q":
        return np.full_like(hertz, 1 / quality)
    share, time = one_term(ball)
    x = 2 * math.pi * hertz * time
    return share * x / (1 - share + x**2)


def options(ball, law):
    """Modulus and loss as the command takes them."""
    young, _, _, quality = BALLS[ball]
    at = frequency(ball, MATCHED)
    if law == "Kelvin-Voigt":
        return young, f"--loss-time {1 / (quality * 2 * math.pi * at):.9g}"
    if law == "constant Q":  # whose modulus is given at 10 kHz
        return young * (1e4 / at) ** power(quality), f"--quality {quality:g}"
    share, time = one_term(ball)
    x2 = (2 * math.pi * at * time) ** 2
    return young / (1 - share / (1 + x2)), f"--relaxation {share:.9g}:{time:.9g}"


def impacts(program, ball, law, speeds=SPEEDS):
    _, poisson, density, _ = BALLS[ball]
    young, loss = options(ball, law)
    job = f"restitution --body sphere --poisson {poisson} --young {young:.9g} --density {density} --radius {RADIUS}"
    for row in run(program, f"{job} {loss} --speed {listed(speeds)}"):
        yield {"ball": ball, "law": law, "speed[m/s]": f"{float(row['speed_si']):.5g}",
               "restitution": f"{float(row['restitution']):.7f}",
               "restitution_error": f"{float(row['restitution_error']):.1e}",
               "lost_fraction": f"{float(row['lost_fraction']):.6g}",
               "dissipated": f"{float(row['dissipated']):.6g}", "converged": row["converged"]}  # fmt: skip
