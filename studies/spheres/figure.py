"""Draws the loss of a sphere against its speed, and that loss over the speed: figure.py SPHERES DISKS PICTURE."""

import csv
import sys

from matplotlib import pyplot
from matplotlib.ticker import NullLocator

COLORS = {0.0: "#009E73", 0.2: "#56B4E9", 0.3: "#0072B2", 0.45: "#D55E00", 0.49: "#CC79A7"}
DISK = 0.33  # Poisson's ratio of the disk that is drawn next to the spheres
SLOWEST, FASTEST = 1e-6, 0.5
ZOOM = (1e-6, 2.2e-6)


def table(name):
    """The rows of a CSV file by Poisson's ratio; None where a number is missing."""
    with open(name, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    groups = {}
    for row in rows:
        row = {key: float(text) if text else None for key, text in row.items() if key != "converged"}
        groups.setdefault(row["poisson"], []).append(row)
    return groups


def columns(rows, name, divisor=None):
    """Speeds, and a quantity at them, over another one if so wished."""
    there = [row for row in rows if row[name] is not None and row["speed[c]"] >= SLOWEST]
    values = [row[name] / (row[divisor] if divisor else 1) for row in there]
    return [row["speed[c]"] for row in there], values


def draw_loss(axes, spheres, disks):
    """1 − ε² of spheres and of a disk."""
    for poisson, rows in spheres.items():
        axes.plot(*columns(rows, "lost_fraction"), color=COLORS[poisson], label=f"sphere, ν = {poisson:g}")
    axes.plot(*columns(disks[DISK], "lost_fraction"), color="0.35", linestyle="--", label=f"disk, ν = {DISK}")
    ends = (SLOWEST, 1e-2)
    axes.plot(ends, [v / 25 for v in ends], color="0.35", linestyle=":", label="Rayleigh, one mode: v / 25 c")
    axes.set(xscale="log", xlim=(SLOWEST, FASTEST), xlabel="speed v / c")
    axes.set(yscale="log", ylim=(2e-8, 1), ylabel="1 − ε²")
    axes.legend(frameon=False, fontsize=7, ncols=2, loc="lower right")


def draw_wave(axes, rows, marker):
    """(1 − ε²)/v as computed and by the quasi-static theory, and its mean over the phases."""
    factor = rows[0]["mean_loss_factor"]
    color = COLORS[rows[0]["poisson"]]
    mean = axes.axhline(factor, color="0.6", linewidth=0.8)
    (full,) = axes.plot(*columns(rows, "lost_fraction", "speed[c]"), color=color, marker=marker, markersize=2)
    speeds, values = columns(rows, "quasistatic_lost_fraction", "speed[c]")
    (slow,) = axes.plot(speeds, values, color="black", linewidth=0.7, linestyle=(0, (3, 1.5)))
    axes.set(xscale="log", ylim=(0, None))
    return full, slow, mean


def draw(spheres, disks):
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2})
    figure = pyplot.figure(figsize=(7, 8.8), dpi=150, layout="constrained")
    grid = figure.add_gridspec(len(spheres) + 1, 2, width_ratios=(3.4, 1), height_ratios=(2.5, *len(spheres) * [1]))
    draw_loss(figure.add_subplot(grid[0, :]), spheres, disks)
    for place, (poisson, rows) in enumerate(spheres.items(), start=1):
        whole = figure.add_subplot(grid[place, 0])
        near = figure.add_subplot(grid[place, 1], sharey=whole)
        handles = draw_wave(whole, rows, None)
        draw_wave(near, [row for row in rows if row["speed[c]"] <= 1.1 * ZOOM[1]], "o")
        whole.set(xlim=(SLOWEST, FASTEST), ylabel="(1 − ε²) c / v")
        whole.set_title(f"ν = {poisson:g}", fontsize=8, loc="left", pad=2)
        near.set(xlim=ZOOM, xticks=[1e-6, 1.5e-6, 2e-6])
        near.set_xticklabels(["1", "1.5", "2"])
        near.xaxis.set_minor_locator(NullLocator())
        near.tick_params(labelleft=False)
        if place == 1:
            whole.legend(handles, ["computed", "quasi-static", "mean c(ν)"], frameon=False, fontsize=7, ncols=3,
                         loc="lower right", bbox_to_anchor=(1.01, 0.96), borderpad=0)  # fmt: skip
        if place < len(spheres):
            whole.tick_params(labelbottom=False)
            near.tick_params(labelbottom=False)
    whole.set_xlabel("speed v / c")
    near.set_xlabel("v / $10^{-6}$ c")
    return figure


def main():
    draw(table(sys.argv[1]), table(sys.argv[2])).savefig(sys.argv[3])


if __name__ == "__main__":
    main()
