"""Draws ε and 1 − ε² of two disks against the ratio of their radii: figure.py CSV PICTURE."""

import csv
import sys

from matplotlib import pyplot

COLORS = {0.01: "#009E73", 0.1: "#0072B2", 0.3: "#D55E00"}
LARGEST = 20  # ratio of the radii that is drawn


def rows_at(table, speed):
    """The rows of one speed, by rising ratio."""
    return [row for row in table if row["speed[c]"] == speed and row["radius_ratio"] <= LARGEST]


def against_ratio(rows, name):
    """Ratios from 1 on, and one column."""
    return [row["radius_ratio"] for row in rows], [row[name] for row in rows]


def draw(table):
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2})
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(7, 2.9), dpi=150, layout="constrained")
    for speed, color in COLORS.items():
        rows = rows_at(table, speed)
        left.plot(*against_ratio(rows, "restitution"), color=color, label=f"disks, v = {speed} c")
        right.plot(*against_ratio(rows, "lost_fraction"), color=color)
        right.plot(*against_ratio(rows, "lost_to_larger"), color=color, linestyle=":")
    rods = against_ratio(rows, "restitution_of_rods")
    left.plot(*rods, color="0.5", linestyle="--", label="rods, $l_1/l_2$ for $R_1/R_2$")
    right.plot(rods[0], [1 - value**2 for value in rods[1]], color="0.5", linestyle="--", label="rods")
    right.plot([], [], color="0.2", label="lost to both disks, colours as on the left")
    right.plot([], [], color="0.2", linestyle=":", label="of it lost to the larger disk")
    for axes, label in ((left, "restitution ε"), (right, "1 − ε²")):
        axes.set(xscale="log", xlim=(1, LARGEST), xlabel="$R_2/R_1$, larger over smaller disk")
        axes.set(ylim=(0, 1.02), ylabel=label)
        axes.set_xticks([1, 2, 5, 10, 20])
        axes.xaxis.set_major_formatter("{x:g}")
        axes.minorticks_off()
        axes.set_title("disks of one material, ν = 0.33", fontsize=8)
    left.legend(frameon=False, fontsize=7, loc="lower left")
    right.set_ylim(0, 1.3)
    right.set_yticks([0, 0.2, 0.4, 0.6, 0.8, 1])
    right.legend(frameon=False, fontsize=7, loc="upper left")
    return figure


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        lines = csv.DictReader(line for line in file if not line.startswith("#"))
        table = [{key: float(line[key]) for key in line if key != "converged"} for line in lines]
    draw(table).savefig(sys.argv[2])


if __name__ == "__main__":
    main()
