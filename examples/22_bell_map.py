"""A bounce map: ε of a ball that hits a bell, all over its surface, with an error at each point.

Run:     python examples/22_bell_map.py [FOLDER]        (default: out/)
Expect:  how many points have a value and why others have none; where ε is least and greatest; whether points of one
         height agree, as they must on a body of revolution: by how much of their errors they differ; ε of the bell and
         of a plate with 45 of their modes and Hertz' contact alone, beside that of all; bell_map.png, ε outside,
         unrolled, over the height with errors, and over the number of modes. Some seconds.

The file examples/any_body/bell_map.csv is what one run wrote, of the modes of two meshes at all points at once:

    python -m stoss.modal bell.geo --map bell_map.vtu --speed 0.1,1 --against 'sphere,radius=0.008,...' ...

with bell_map.vtu, the same on triangles for ParaView, and a picture. A game or an animation takes ε of the point that
is hit from such a table (J.-H. Wang, R. Setaluri, D. L. James and D. K. Pai, Bounce Maps, ACM Trans. Graph. 36, 150,
2017). They have no errors, and 45 modes of any body. Of a bell that is enough; of a wide plate it is not. An infinite plate,
in closed form, has the value to which more modes tend, as the ball leaves before waves are back from the rim.
"""

import argparse
import dataclasses
import warnings
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

FILES = Path(__file__).resolve().parent / "any_body"
COLORS = ("#0072B2", "#D55E00")
STEEL, BEARING = stoss.materials["structural steel"], stoss.materials["bearing steel"]
STRUCK = {"bell": (8e-3, 0.1), "plate": (5e-3, 0.1)}  # radius of the ball in m, its speed in m/s
MODES = 45


def lowest(body: stoss.ModalBody, count: int) -> stoss.ModalBody:
    """The body as if it had no other modes: beside them it yields as a half-space, by Hertz."""
    cut = {name: getattr(body, name)[:count] for name in ("frequency", "displacement", "displacement_curvature")}
    others = [name for name in dir(body) if name.startswith("tangential_")]
    rest = dict.fromkeys(("frequency_error", "displacement_error", "tangent", *others))
    taken = np.sum((cut["displacement"] / (2 * np.pi * cut["frequency"])) ** 2)
    return dataclasses.replace(
        body, **cut, **rest, compliance=taken, compliance_error=0, complete_to=cut["frequency"][-1]
    )


def over_modes(axis: plt.Axes) -> None:
    """ε of both bodies with their lowest modes alone."""
    for (name, (radius, speed)), color in zip(STRUCK.items(), COLORS):
        body, ball = (
            stoss.ModalBody.read(FILES / f"{name}.json"),
            stoss.Sphere(radius=radius, material=BEARING, loss_time=0),
        )
        counts = np.unique(np.geomspace(4, body.frequency.size, 16).astype(int))
        found = [stoss.restitution(ball, against=lowest(body, n), speed=[speed], tolerance=0.01) for n in counts]
        whole = stoss.restitution(ball, against=body, speed=[speed], tolerance=0.01)
        value, error = whole.restitution[0], whole.restitution_error[0]
        few = stoss.restitution(ball, against=lowest(body, MODES), speed=[speed], tolerance=0.01).restitution[0]
        print(f"{name}, ball of Ø {2e3 * radius:g} mm at {speed:g} m/s: {few:.4f} by its lowest {MODES} modes alone, "
              f"{stoss.with_error(value, error)} by its file")  # fmt: skip
        axis.plot(
            counts, [each.restitution[0] for each in found], ".-", color=color, label=f"{name}, Ø {2e3 * radius:g} mm"
        )
        axis.errorbar(1.12 * counts[-1], value, yerr=error, fmt="s", color=color, markersize=4, capsize=3)
        if name == "plate":
            endless = stoss.Plate(thickness=5e-3, material=STEEL, loss_time=0)
            exact = stoss.restitution(ball, against=endless, speed=speed)
            print(f"  and {stoss.with_error(exact.restitution, exact.restitution_error)} of an infinite plate")
            axis.axhline(exact.restitution, color=color, linestyle=":", label="infinite plate")
    axis.axvline(MODES, color="0.6", linewidth=0.8)
    axis.set(xscale="log", ylim=(0.7, 1.0), xlabel="modes of its file", title="few modes; squares: all, with c₀")
    axis.legend(fontsize=8)


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    warnings.simplefilter("ignore", stoss.StossWarning)  # values that have large errors are shown with them
    table = stoss.read_csv(FILES / "bell_map.csv")
    speeds = np.unique(table["speed"])
    figure, axes = plt.subplots(1, 3, figsize=(12.0, 3.9), layout="constrained")
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
        print(
            f"  outside, points of one height: {np.median(off):.2f} errors apart in the median, {off.max():.1f} at most"
        )
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
    over_modes(axes[2])
    figure.savefig(folder / "bell_map.png", dpi=150)
    for name, said in table.inputs.items():
        if name.startswith("reason"):
            print(f"no value: {said}")
    print(f"written: {folder / 'bell_map.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
