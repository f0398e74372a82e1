"""A ring of elastic rods that cool as they collide: how much they remember decides how fast.

Run:     python examples/10_rod_chain.py [FOLDER]        (default: out/)
Expect:  for three dampings of the vibration between collisions the kinetic energy that is left,
         and mean and spread of ε; rod_chain.png with the energy against time and the distribution
         of ε. Some seconds.

Rods of two lengths, L and 0.9 L, are unexcited at first. With complete damping every collision
of two unequal rods has ε = 0.9, so that the energy falls as

    dE/dt ∝ −E^(3/2),    E → t⁻² .

Without damping the energy stays in the rods. Then ε differs from collision to collision and often
exceeds one, and translation ends with its equal share among some fifty modes of each rod.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

RODS, OTHER_LENGTH, GAP = 40, 0.9, 2.0
COLLISIONS = 3000
DAMPING = {"no": None, "partial": 3e4, "complete": 0.0}  # decay time of vibrational energy, L/c
COLORS, LINES = ("#0072B2", "#009E73", "#D55E00"), ("-", "--", "-.")


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    rods = [stoss.Rod(length=OTHER_LENGTH if k % 2 else 1.0) for k in range(RODS)]
    ring = sum(rod.length + GAP for rod in rods)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    print("damping   time        energy left  mean eps  spread    share above 1")
    for (name, decay_time), color, line in zip(DAMPING.items(), COLORS, LINES):
        gas = stoss.rod_chain(rods, circumference=ring, temperature=1e-4, seed=10, collisions=COLLISIONS,
                              decay_time=decay_time, tail="static")  # fmt: skip
        energy = gas.translation / gas.translation[0]
        eps = gas.restitution[COLLISIONS // 6 : COLLISIONS // 2]
        numbers = (gas.time[-1], energy[-1], eps.mean(), eps.std(), np.mean(eps > 1))
        print("{:8}  {:.4e}  {:.4e}   {:.6f}  {:.6f}  {:.3f}".format(name, *numbers))
        left.loglog(gas.time, energy, color=color, linestyle=line, label=f"{name} damping")
        right.hist(eps, np.linspace(0.0, 2.5, 51), density=True, histtype="step", color=color, linestyle=line)
    times = np.array([1e5, 1e8])
    left.loglog(times, 3e-5 * (times / 1e5) ** -2, color="0.5", label="∝ t⁻²")
    left.set(xlabel="time / (L/c)", ylabel="kinetic energy", xlim=(100, None))
    left.legend()
    right.set(xlabel=f"ε of collisions {COLLISIONS // 6 + 1} to {COLLISIONS // 2}", ylabel="density", yscale="log")
    figure.savefig(folder / "rod_chain.png", dpi=150)
    print(f"written: {folder / 'rod_chain.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
