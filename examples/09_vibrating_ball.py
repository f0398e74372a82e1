"""A ball that vibrates before it meets the wall: ε against the phase, and ε of warm balls.

Run:     python examples/09_vibrating_ball.py [FOLDER]        (default: out/)
Expect:  a table of ε against the phase of one mode, which exceeds one over nearly half of the
         turn, with a sinusoid that is not fitted; then mean and spread of ε for balls at rising
         temperature; vibrating_ball.csv and vibrating_ball.png. Some seconds.

A mode that absorbs the share e of the energy in the impact from rest, where ε is ε₀, changes ε by

    ε(φ) = ε₀ + √(e E)/ε₀ · cos(φ − φ₀)        if it vibrates with the share E before,

and ε of warm balls, with the mean energy T ½mv² in each mode, spreads by √(T (1 − ε₀²)/2)/ε₀. Both
are the first order of slow impacts (docs/theory/vibration.md).
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

SPEED = 0.01  # c
ENERGY = 0.05  # of the mode, over that of translation
HIGHEST = 5.0  # c/R: up to it modes are warm
TEMPERATURES = (1e-4, 1e-3, 1e-2)


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    ball = stoss.Sphere(poisson=0.3)
    rest = stoss.impact(ball, speed=SPEED, cutoff=60)
    (quadrupole,) = rest.mode_energies[(rest.mode_energies["order"] == 2) & (rest.mode_energies["index"] == 0)]
    amplitude = np.sqrt(quadrupole["after"] * ENERGY) / rest.restitution
    print(f"from rest: eps = {rest.restitution:.6f}, mode (2,0) takes {quadrupole['after']:.6f}")

    phases = np.linspace(0.0, 2.0 * np.pi, 33)
    states = [stoss.Oscillation(order=2, index=0, energy=ENERGY, phase=phase) for phase in phases]
    found = [stoss.restitution(ball, speed=SPEED, absolute=1e-5, state=state) for state in states]
    values = np.array([each.restitution for each in found])
    errors = np.array([each.restitution_error for each in found])
    first = np.angle(np.sum((values[:-1] - np.mean(values[:-1])) * np.exp(1j * phases[:-1])))
    law = rest.restitution + amplitude * np.cos(phases - first)
    print("phase/rad   eps        error      sinusoid")
    for row in zip(phases[::4], values[::4], errors[::4], law[::4]):
        print("{:9.5f}  {:.6f}  {:.6f}  {:.6f}".format(*row))

    print("temperature  mean eps  +-        spread    law       share above 1")
    warm = []
    for temperature in TEMPERATURES:
        expected = np.sqrt(0.5 * temperature * rest.lost_fraction) / rest.restitution
        every = stoss.restitution_distribution(ball, speed=SPEED, temperature=temperature, highest=HIGHEST,
                                               samples=300, seed=9, error=0.1 * expected)  # fmt: skip
        warm.append(every)
        numbers = (temperature, every.mean, every.mean_error, every.spread, expected, every.above_one)
        print("{:11g}  {:.6f}  {:.6f}  {:.6f}  {:.6f}  {:.3f}".format(*numbers))

    lines = ["phase,restitution,restitution_error,sinusoid"]
    lines += [f"{a:.9g},{b:.9g},{c:.3g},{d:.9g}" for a, b, c, d in zip(phases, values, errors, law)]
    (folder / "vibrating_ball.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")

    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    left.plot(np.degrees(phases), law, color="0.5", label="√(eE)/ε₀ · cos")
    left.plot(np.degrees(phases), values, "o", color="#0072B2", markersize=4, label="impacts")
    left.axhline(1.0, color="0.7", linewidth=0.8)
    left.set(xlabel="phase of mode (2,0) / °", ylabel="ε", xticks=range(0, 361, 90))
    left.legend()
    for every, color, line in zip(warm, ("black", "#0072B2", "#D55E00"), ("-", "--", "-.")):
        label = f"T = {every.temperature:g}"
        right.step(np.sort(every.restitution), np.linspace(0, 1, len(every)), color=color, linestyle=line, label=label)
    right.axvline(1.0, color="0.7", linewidth=0.8)
    right.set(xlabel="ε of warm balls", ylabel="share of the balls below")
    right.legend()
    figure.savefig(folder / "vibrating_ball.png", dpi=150)
    print(f"written: {folder / 'vibrating_ball.csv'}, {folder / 'vibrating_ball.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
