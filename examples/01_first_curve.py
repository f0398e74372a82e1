"""The first curve: ε(v) of an elastic disk for two Poisson's ratios, with error bars.

Run:     python examples/01_first_curve.py [FOLDER]        (default: out/)
Expect:  a table of ε ± error; first_curve.png, with 1 − ε² falling in waves towards small speeds
         and error bars narrower than the lines; first_curve.csv, the same numbers with all digits.
         Two seconds.

    ε = v_after / v_before,    1 − ε² = energy left in vibrations (here the only loss) / initial energy

v is the speed of one disk against a wall, in units of the bar speed c = √(E/ρ). Two equal disks
that each move at v towards each other are the same problem.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)

    # Two Poisson's ratios and 43 speeds broadcast to a table of 2 × 43 values.
    curve = stoss.restitution(poisson=[[0.33], [0.9]], speed=np.geomspace(1e-4, 0.09, 43))
    print(curve)

    print("Poisson  speed / c      restitution          contact time / (R/c)")
    for row in range(2):
        for k in range(0, 43, 7):
            value, error = curve.restitution[row, k], curve.restitution_error[row, k]
            speed, time = curve.speed[row, k], curve.contact_time[row, k]
            print(f"{curve.poisson[row, k]:7.2f}  {speed:9.3e}  {value:.6f} ± {error:.6f}  {time:8.3f}")

    greatest = (curve.lost_fraction_error / curve.lost_fraction).max()
    print(f"maximum relative error of 1 - eps^2: {greatest:.1e} (asked for: {curve.tolerance:.0e})")

    curve.to_csv(folder / "first_curve.csv")
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    figure.get_layout_engine().set(w_pad=0.1, h_pad=0.1)  # inches around the axes
    stoss.plot.restitution(curve, left)
    stoss.plot.restitution(curve, right, quantity="lost_fraction")
    figure.savefig(folder / "first_curve.png", dpi=150)
    print(f"written: {folder / 'first_curve.csv'}, {folder / 'first_curve.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
