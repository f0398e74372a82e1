"""Balls of steel, glass, ice and rubber on a rigid wall: the loss to vibrations alone, and
one bounce.

Run:     python examples/07_balls.py [FOLDER]        (default: out/)
Expect:  a table of restitution, contact time, maximum force and pressure at 0.01 to 3 m/s;
         balls.csv and balls.png with 1 − ε² against speed, and the stress inside a rubber ball.
         Eight seconds.

    p₀ = 3F/(2πa²),    a³ = 3FR/(4E*),    E* = E/(1 − ν²)        (Hertz)

A ball loses far less than a disk: 1 − ε² is of the order of v/c times a wave that never settles.
A hardened steel ball yields on a rigid wall from 0.13 m/s, where its rows and its line end; the
others crack or tear at a pressure that nobody knows well.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

MATERIALS = ("bearing steel", "glass", "ice", "rubber")
RADIUS = 0.01  # m
SPEEDS = np.array([0.01, 0.1, 1.0, 3.0])  # m/s
COLUMNS = "material,speed_m_s,speed_c,lost_fraction,lost_fraction_error,contact_time_s,force_N,pressure_Pa"


def greatest_pressure(ball: stoss.Sphere, force):
    """Hertz's pressure in the middle of the contact for a force in N, Pa."""
    stiffness = ball.young / (1 - ball.poisson**2)
    contact_radius = np.cbrt(0.75 * force * ball.radius / stiffness)
    return 1.5 * force / (np.pi * contact_radius**2)


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
    lines = [COLUMNS]
    print("material        m/s       v/c      1 - eps^2                   time/us      force/N     pressure/MPa")
    for name in MATERIALS:
        ball = stoss.Sphere(radius=RADIUS, material=stoss.materials[name], loss_time=0)
        yields = stoss.quasistatic.yield_speed(ball) or np.inf
        curve = stoss.restitution(ball, speed=SPEEDS[SPEEDS < yields])
        pressure = greatest_pressure(ball, curve.max_force_si)
        for k, speed in enumerate(curve.speed_si):
            loss, error = curve.lost_fraction[k], curve.lost_fraction_error[k]
            time, force = curve.contact_time_si[k], curve.max_force_si[k]
            print(f"{name:13} {speed:6g}  {curve.speed[k]:8.2e}  {loss:.4e} ± {error:.0e}", end="  ")
            print(f"{time * 1e6:12.5g} {force:12.4g} {pressure[k] / 1e6:12.4g}")
            values = (speed, curve.speed[k], loss, error, time, force, pressure[k])
            lines.append(",".join([name, *(f"{value:.9g}" for value in values)]))
        fine = stoss.restitution(ball, speed=np.geomspace(SPEEDS[0], min(SPEEDS[-1], 0.99 * yields), 160))
        stoss.plot.restitution(fine, left, quantity="lost_fraction", label=name)
    (folder / "balls.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    left.set_title(f"radius {RADIUS * 1000:g} mm, rigid wall")

    hit = stoss.impact(stoss.Sphere(radius=RADIUS, material=stoss.materials["rubber"], loss_time=0), speed=5.0)
    stoss.plot.stress(hit.field(time=hit.contact_time / 2), right)
    figure.savefig(folder / "balls.png", dpi=150)
    print(f"written: {folder / 'balls.csv'}, {folder / 'balls.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
