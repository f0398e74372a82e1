"""Leeb's hardness of steel from its yield strength: a ball of tungsten carbide with a hammer behind it.

Run:     python examples/24_leeb_hardness.py [FOLDER]        (default: out/)
Expect:  HLD = 1000 ε at 2.05 m/s for steels that yield at 0.5 to 3 GPa, 380 to 810; what the ball would show without
         the hammer, and without the growth of the strength with the rate of strain: leeb.csv, leeb.png. Some seconds.

The impact body of type D is a ball of 3 mm on a hammer of 5.45 g in all (ISO 16859). The mass is 26 times that of
the ball, so the blow is as deep as that of a steel ball of 11 mm at the radius of a ball of 3 mm. The modes of the
hammer are not computed. Where the law of yield leaves ε open by more than the symbols, bars show by how much.
"""

import argparse
import warnings
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

RADIUS, MASS, SPEED = 1.5e-3, 5.45e-3, 2.05  # m, kg, m/s
CARBIDE = stoss.materials["tungsten carbide"]
STEEL = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
STRENGTHS = np.array([0.5e9, 0.75e9, 1e9, 1.5e9, 2e9, 3e9])
RATE = 0.014  # of the strength of steel, G. R. Johnson and W. H. Cook (1983)
HAMMER = MASS - 4 / 3 * np.pi * RADIUS**3 * CARBIDE.density


def hardness(hammer: float, rate: float) -> tuple[np.ndarray, np.ndarray]:
    """HLD, and what the law of yield leaves open, for each strength."""
    ball = stoss.Sphere(radius=RADIUS, material=CARBIDE, extra_mass=hammer)
    blocks = [stoss.HalfSpace(material=STEEL, yield_strength=each, yield_rate=rate) for each in STRENGTHS]
    hits = [stoss.restitution(ball, against=each, speed=SPEED) for each in blocks]
    return np.array([1000 * each.restitution for each in hits]), np.array([1000 * each.restitution_error for each in hits])


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    warnings.simplefilter("ignore", stoss.StossWarning)  # of yield, which is what is asked for
    cases = {"with the hammer": (HAMMER, RATE), "at any rate the same": (HAMMER, 0.0), "the ball alone": (0.0, RATE)}
    found = {name: hardness(*given) for name, given in cases.items()}
    figure, axes = plt.subplots(figsize=(5.2, 3.6), layout="constrained")
    print("strength/GPa  " + "  ".join(f"{name:>21s}" for name in found))
    lines = ["strength_Pa," + ",".join(f"{name.replace(' ', '_')},{name.replace(' ', '_')}_error" for name in found)]
    for i, strength in enumerate(STRENGTHS):
        print(f"{strength / 1e9:12.2f}  " + "  ".join(f"{stoss.with_error(v[i], e[i]):>21s}" for v, e in found.values()))
        lines.append(f"{strength:g}," + ",".join(f"{v[i]:.6g},{e[i]:.3g}" for v, e in found.values()))
    for (name, (value, error)), style in zip(found.items(), ("o-", "s--", "^:")):
        axes.errorbar(STRENGTHS / 1e9, value, error, fmt=style, markersize=5, capsize=2, label=name)
    axes.set(xlabel="yield strength / GPa", ylabel="HLD = 1000 ε", ylim=(300, 1000))
    axes.legend(frameon=False)
    figure.savefig(folder / "leeb.png", dpi=150)
    (folder / "leeb.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(f"written: {folder / 'leeb.csv'}, {folder / 'leeb.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
