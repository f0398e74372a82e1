"""Published laws of the quasi-static coefficient of restitution of an elastic, perfectly plastic sphere.

Speeds are over the speed at the onset of yield, V_y.
"""

import math


def thornton(speed):
    """ε of Thornton and Ning (Powder Technology 99, 1998): Hertz until yield, then a constant pressure at the edge,
    and an elastic unloading of larger curvature."""
    if speed <= 1:
        return 1.0
    r = 1 / speed
    bracket = r / (r + 2 * math.sqrt(1.2 - r * r / 5))
    return math.sqrt(6 * math.sqrt(3) / 5) * math.sqrt(1 - r * r / 6) * bracket**0.25


def thornton_derived(speed):
    """The same from its contact law: f = d^{3/2} up to d = 1, then the tangent f = (3 d − 1)/2, and unloading by Hertz
    with the contact area of the largest depth, which is that of the tangent law, a² = (2 F/F_y + 1)/3: the released
    energy is 2 F²/5 a in units of the onset. Solved for the depth by bisection."""
    if speed <= 1:
        return 1.0
    wanted = 0.4 * speed**2
    low, high = 1.0, 10 * speed + 10
    for _ in range(200):
        depth = 0.5 * (low + high)
        done = 0.4 + 0.75 * (depth**2 - 1) - 0.5 * (depth - 1)
        low, high = (depth, high) if done < wanted else (low, depth)
    force = (3 * depth - 1) / 2
    radius = math.sqrt((2 * force + 1) / 3)
    return math.sqrt(0.4 * force**2 / radius / wanted)


def johnson(speed, pressure=3.0, onset=1.6):
    """ε by Johnson (Contact Mechanics, §11.5) at speeds far above yield: a constant mean pressure `pressure`·Y while
    a² = 2Rδ, and an elastic release F²·3/(10 a E*) of the plastic impression, with V_y at the maximum pressure
    `onset`·Y: 2.28 (V/V_y)^{−1/4} for the constants 3 and 1.6.

    ½mV² = π p a⁴/4R and W = 3(πa²p)²/(10 a E*), so ε² = (3π²p²a³/10E*) / ½mV² with a⁴ = 4R(½mV²)/(πp).
    """
    young, radius, strength = 1.0, 1.0, 1.0
    edge = math.pi * onset * strength / (2 * young)  # of the contact at onset, R = 1
    energy = 8 / 15 * edge**5 * speed**2  # E* a⁵/R², a² = Rδ
    mean = pressure * strength
    a = (4 * radius * energy / (math.pi * mean)) ** 0.25
    return math.sqrt(0.3 * (math.pi * mean) ** 2 * a**3 / young / energy)
