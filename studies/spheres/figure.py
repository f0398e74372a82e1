"""Draws the loss of a sphere against its speed, and that loss over the speed: figure.py SPHERES DISKS PICTURE."""

import csv
import sys

from matplotlib import pyplot

COLORS = {0.0: "#009E73", 0.2: "#56B4E9", 0.3: "#0072B2", 0.45: "#D55E00", 0.49: "#CC79A7"}
DISK = 0.33  # Poisson's ratio of the disk that is drawn next to the spheres
SLOWEST, FASTEST = 1e-6, 0.5
SHOWN = 0.3  # Poisson's ratio of the sphere whose wave is drawn


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


def draw_wave(axes, rows):
    """(1 − ε²)/v as computed and by the quasi-static theory, and its mean over the phases."""
    factor = rows[0]["mean_loss_factor"]
    color = COLORS[rows[0]["poisson"]]
    mean = axes.axhline(factor, color="0.6", linewidth=0.8)
    (full,) = axes.plot(*columns(rows, "lost_fraction", "speed[c]"), color=color)
    speeds, values = columns(rows, "quasistatic_lost_fraction", "speed[c]")
    (slow,) = axes.plot(speeds, values, color="black", linewidth=0.7, linestyle=(0, (3, 1.5)))
    axes.set(xscale="log", ylim=(0, None))
    return full, slow, mean


def draw(spheres, disks):
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2})
    figure, (upper, lower) = pyplot.subplots(2, 1, figsize=(7, 4.6), dpi=150, layout="constrained", height_ratios=(1.5, 1))
    draw_loss(upper, spheres, disks)
    handles = draw_wave(lower, spheres[SHOWN])
    lower.axhline(2 * spheres[SHOWN][0]["mean_loss_factor"], color="0.6", linewidth=0.8, linestyle=":")
    lower.set(xlim=(SLOWEST, 1e-2), ylim=(0, 0.5), ylabel="(1 − ε²) c / v", xlabel="speed v / c")
    lower.set_title(f"sphere, ν = {SHOWN:g}", fontsize=8, loc="left", pad=2)
    lower.legend(handles, ["computed", "quasi-static", "mean c(ν), and twice it"], frameon=False, fontsize=7, ncols=3,
                 loc="upper right")  # fmt: skip
    return figure


def main():
    draw(table(sys.argv[1]), table(sys.argv[2])).savefig(sys.argv[3])


if __name__ == "__main__":
    main()
