"""A bounce map: ε of a ball that hits a bell, all over its surface, with an error at each point.

Run:     python examples/22_bell_map.py [FOLDER]        (default: out/)
Expect:  how many points have a value and why others have none; where ε is least and greatest; whether points of one
         height agree, as they must on a body of revolution: by how much of their errors they differ; bell_map.png, ε
         outside, unrolled, and over the height with errors. Some seconds.

The file examples/any_body/bell_map.csv is what one run wrote, of the modes of two meshes at all points at once:

    python -m stoss.modal bell.geo --map bell_map.vtu --speed 0.1,1 --against 'sphere,radius=0.008,...' ...

with bell_map.vtu, the same on triangles for ParaView, and a picture. A game or an animation takes ε of the point that
is hit from such a table (J.-H. Wang, R. Setaluri, D. L. James and D. K. Pai, Bounce Maps, ACM Trans. Graph. 36, 150,
2017, who have no errors, and 45 modes of any body).
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

FILE = Path(__file__).resolve().parent / "any_body" / "bell_map.csv"
COLORS = ("#0072B2", "#D55E00")


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    table = stoss.read_csv(FILE)
    speeds = np.unique(table["speed"])
    figure, axes = plt.subplots(1, 2, figsize=(9.6, 4.2), layout="constrained")
    for speed, color in zip(speeds, COLORS):
        rows = table[table["speed"] == speed]
        rows = rows[np.isfinite(rows["restitution"])]
        radius, height = np.hypot(rows["x"], rows["y"]), 1e3 * rows["z"]
        outside = rows["x"] * rows["normal_x"] + rows["y"] * rows["normal_y"] > 0.3 * radius
        value, error = rows["restitution"], rows["restitution_error"]
        low, high = np.argmin(value), np.argmax(value)
        print(f"{speed:g} m/s: {rows.size} of {np.sum(table['speed'] == speed)} points; ε from "
              f"{stoss.with_error(value[low], error[low])} at a height of {height[low]:.0f} mm to "
              f"{stoss.with_error(value[high], error[high])} at {height[high]:.0f} mm")  # fmt: skip
        # Points of nearly one height, from a smooth curve through their neighbours.
        order = np.flatnonzero(outside)[np.argsort(height[outside])]
        near = np.abs(height[order][:, None] - height[order]) < 4.0
        fitted = np.array([np.polyval(np.polyfit(height[order][w] - h, value[order][w], 1), 0.0)
                           for h, w in zip(height[order], near)])  # fmt: skip
        off = np.abs(value[order] - fitted) / error[order]
        print(f"  outside, points of one height: {np.median(off):.2f} errors apart in the median, {off.max():.1f} at most")
        axes[1].errorbar(height[outside], value[outside], yerr=error[outside], fmt="o", color=color, markersize=3,
                         elinewidth=0.7, label=f"{speed:g} m/s")  # fmt: skip
    around = 1e3 * radius.max() * np.arctan2(rows["y"], rows["x"])
    drawn = axes[0].tricontourf(around[outside], height[outside], value[outside], levels=14, cmap="viridis")
    axes[0].plot(around[outside], height[outside], "k.", markersize=1.5)
    axes[0].set(xlabel="around the bell / mm, at its mouth", ylabel="height / mm", title=f"outside, {speed:g} m/s")
    figure.colorbar(drawn, ax=axes[0], label="ε")
    axes[1].set(xlabel="height above the mouth / mm", ylabel="ε", title="with errors")
    axes[1].grid(alpha=0.3)
    axes[1].legend()
    figure.savefig(folder / "bell_map.png", dpi=150)
    for name, said in table.inputs.items():
        if name.startswith("reason"):
            print(f"no value: {said}")
    print(f"written: {folder / 'bell_map.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
