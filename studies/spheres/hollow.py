"""Where a hollow sphere loses most: 1 - eps^2 against the hole, at several speeds, nu = 0.3; draws hollow.png.

Run: build/venv/bin/python studies/spheres/hollow.py; a minute.
"""

import warnings
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

HOLES = np.concatenate([np.arange(0.1, 0.9, 0.05), np.arange(0.9, 0.98, 0.01), [0.98]])
SPEEDS = (1e-5, 1e-4, 1e-3, 1e-2)
COLORS = ("#0072B2", "#009E73", "#E69F00", "#D55E00")
POISSON = 0.3
FILE = Path(__file__).parents[2] / "docs/images/hollow.png"


def linear_up_to(hole: np.ndarray) -> np.ndarray:
    """Speed at which the shell gives way by its thickness, c."""
    thickness = 1 - hole
    stiffness = 4 * thickness**2 / np.sqrt(3 * (1 - POISSON**2))
    return thickness * np.sqrt(stiffness / (4 / 3 * np.pi * (1 - hole**3)))


def main() -> None:
    warnings.simplefilter("ignore", stoss.StossWarning)
    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    for speed, color in zip(SPEEDS, COLORS):
        values = [stoss.restitution(stoss.HollowSphere(poisson=POISSON, inner=b), speed=speed) for b in HOLES]
        lost = np.array([float(1 - each.restitution**2) for each in values])
        error = 2 * np.array([float(each.restitution_error) for each in values])
        most = int(np.argmax(lost))
        print(f"v = {speed:g} c: most at b = {HOLES[most]:.2f}, {lost[most]:.4g} +- {error[most]:.1g}")
        linear = linear_up_to(HOLES) > speed
        axes.plot(HOLES[linear], lost[linear], "-", color=color, label=f"v = {speed:g} c")
        axes.plot(HOLES[~linear], lost[~linear], ":", color=color)
        axes.plot(HOLES[most], lost[most], "o", color=color)
    axes.set(yscale="log", xlabel="b, radius of the hole over R", ylabel="1 − ε²")
    axes.legend()
    figure.savefig(FILE, dpi=150)


if __name__ == "__main__":
    main()
