"""A table-tennis ball: how much of its rebound its ringing takes, from which speed it dents, and how it spins.

Run:     python examples/20_table_tennis_ball.py [FOLDER]        (default: out/)
Expect:  ε of a ball of 40 mm with a wall of 0.4 mm at a rigid wall, elastic and with a material of Q = 40, and of a
         solid ball of the same material, against the speed: table_tennis_ball.csv and table_tennis_ball.png, with the
         speeds from which its wall gives way by more than its thickness, and from which it buckles. Ten seconds.

    F/δ = 4Eh²/(R √(3(1 − ν²)))

A shell under a force at a point is a spring (E. Reissner 1946). From δ = h on it deforms by more than linear
elasticity knows, and near 2h it buckles inward (L. Pauchard and S. Rica 1998), as a ball that is hit hard does. Below,
ε is high: a ball that is dropped keeps 97 % of its speed and more, and what its shell keeps as vibration is a tenth of
what is measured to be lost. The material takes the rest.
"""

import argparse
import csv
import math
import warnings
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

RADIUS, WALL = 20e-3, 0.4e-3  # m
CELLULOID = {"young": 2.5e9, "poisson": 0.35, "density": 1400.0}
QUALITY = 40.0  # of such a polymer, some tens
SPEEDS = np.geomspace(0.05, 1.6, 7)  # m/s
# ε on parquet by sound, speed of the first impact (docs/understand/measured.md).
MEASURED = ((1.25, 0.9754), (1.40, 0.9716), (1.72, 0.9620), (1.88, 0.9589), (2.43, 0.9426))


def linear_limit() -> tuple[float, float]:
    """Force and speed at which the wall gives way by its thickness."""
    young, poisson = CELLULOID["young"], CELLULOID["poisson"]
    stiffness = 4 * young * WALL**2 / (RADIUS * math.sqrt(3 * (1 - poisson**2)))
    mass = 4 / 3 * math.pi * CELLULOID["density"] * (RADIUS**3 - (RADIUS - WALL) ** 3)
    return stiffness * WALL, WALL * math.sqrt(stiffness / mass)


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    warnings.simplefilter("ignore", stoss.StossWarning)
    elastic, lossy = (stoss.Material(**CELLULOID), stoss.Material(**CELLULOID, quality=QUALITY))
    hollow = {"radius": RADIUS, "inner": 1 - WALL / RADIUS}
    force, speed = linear_limit()
    print(f"linear up to some {force:.1f} N, {speed:.2f} m/s; buckles from about {2 * speed:.1f} m/s on")
    curves = {
        "shell, elastic": stoss.restitution(stoss.HollowSphere(**hollow, material=elastic), speed=SPEEDS),
        f"shell, Q = {QUALITY:g}": stoss.restitution(stoss.HollowSphere(**hollow, material=lossy), speed=SPEEDS),
        "solid, elastic": stoss.restitution(stoss.Sphere(radius=RADIUS, material=elastic), speed=SPEEDS),
    }
    with open(folder / "table_tennis_ball.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["speed_m_s", "shell", "shell_error", "shell_lossy", "solid"])
        shell, real, solid = curves.values()
        for row in zip(SPEEDS, shell.restitution, shell.restitution_error, real.restitution, solid.restitution):
            writer.writerow([f"{value:.9g}" for value in row])
    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    for (name, curve), color in zip(curves.items(), ("#0072B2", "#D55E00", "#009E73")):
        axes.plot(SPEEDS, 1 - curve.restitution**2, "o-", color=color, label=name)
    axes.plot([v for v, _ in MEASURED], [1 - e**2 for _, e in MEASURED], "kx", label="measured, on parquet")
    axes.axvspan(speed, 2 * speed, color="0.92", label="large deflection")
    axes.axvspan(2 * speed, 3 * speed, color="0.82", label="buckles")
    axes.set(xscale="log", yscale="log", xlabel="speed / (m/s)", ylabel="1 − ε²", xlim=(0.04, 3 * speed))
    axes.set_ylim(1e-6, 0.3)
    axes.legend(fontsize=8, ncols=2, loc="lower left")
    figure.savefig(folder / "table_tennis_ball.png", dpi=150)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", default=Path("out"), type=Path)
    main(parser.parse_args().folder)
