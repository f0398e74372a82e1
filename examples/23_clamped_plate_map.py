"""A bounce map of a plate that is clamped at its rim: it takes most in its middle, and hardly anything near the rim.

Run:     python examples/23_clamped_plate_map.py [FOLDER]        (default: out/)
Expect:  of both speeds the greatest and the least share of its speed with which a steel ball of Ø 20 mm comes back,
         and where; how far values are from a smooth function of |x| and |y|, as the plate is alike on all sides, over
         their errors;
         clamped_plate_map.png, the share over the upper face, and its error. Some seconds.

The plate, of steel, 120 × 80 × 10 mm, cannot move at its rim, so ε is the speed of the ball, after over before. Its
lowest mode moves the middle most, and keeps energy as its period is not far from the time of contact. The file examples/any_body/clamped_plate_map.csv is what
`python -m stoss.modal clamped_plate.geo --map … --clamp rim` wrote. Near the rim there are no values: the mesh does
not tell the local compliance there.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

FILE = Path(__file__).resolve().parent / "any_body" / "clamped_plate_map.csv"


def unlike(x: np.ndarray, y: np.ndarray, value: np.ndarray, error: np.ndarray) -> np.ndarray:
    """How far values are from a smooth function of |x| and |y| through all of them, over their errors."""
    u, v = (x / np.max(np.abs(x))) ** 2, (y / np.max(np.abs(y))) ** 2
    terms = np.stack([u**i * v**j for i in range(4) for j in range(4 - i)], axis=1)
    smooth = terms @ np.linalg.lstsq(terms, value, rcond=None)[0]
    return np.abs(value - smooth) / error


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    table = stoss.read_csv(FILE)
    known = np.isfinite(table["restitution"])
    speeds = np.unique(table["speed"])
    figure, axes = plt.subplots(len(speeds), 2, figsize=(9.0, 3.1 * len(speeds)), layout="constrained", squeeze=False)
    for row, speed in zip(axes, speeds):
        face = table[known & (table["speed"] == speed) & (np.abs(table["normal_z"]) > 0.9)]
        x, y, value, error = 1e3 * face["x"], 1e3 * face["y"], face["restitution"], face["restitution_error"]
        high, low = np.argmax(value), np.argmin(value)
        off = unlike(x, y, value, error)
        print(f"{speed:g} m/s, {face.size} points on both faces: {stoss.with_error(value[high], error[high])} at "
              f"({x[high]:.0f}, {y[high]:.0f}) mm, {stoss.with_error(value[low], error[low])} at "
              f"({x[low]:.0f}, {y[low]:.0f}) mm; from a smooth one {np.median(off):.2f} errors")  # fmt: skip
        upper = face["normal_z"] > 0
        for axis, shown, name in ((row[0], value, "ε"), (row[1], error, "error of ε")):
            drawn = axis.tricontourf(x[upper], y[upper], shown[upper], levels=14, cmap="viridis")
            axis.plot(x[upper], y[upper], "k.", markersize=2)
            axis.set(xlim=(-60, 60), ylim=(-40, 40), aspect="equal", title=f"{name}, {speed:g} m/s")
            figure.colorbar(drawn, ax=axis)
    figure.supxlabel("mm")
    figure.savefig(folder / "clamped_plate_map.png", dpi=150)
    print(f"written: {folder / 'clamped_plate_map.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
