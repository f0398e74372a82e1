"""Draws how rotation and translation share the energy in gases of rough particles:
rough_figure.py FILE PICTURE."""

import csv
import sys

from matplotlib import pyplot

RULES = {
    "stoss": ("rule of stoss", "#0072B2", "-"),
    "constant": ("constant ε and $ε_t$", "#D55E00", "-"),
    "mean field": ("mean-field theory for these constants", "#000000", ":"),
}


def rows(name):
    """The rows of a CSV file."""
    with open(name, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def columns(table, body, rule, *names):
    return [[float(row[name]) for row in table if row["body"] == body and row["rule"] == rule] for name in names]


def draw(table):
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2})
    figure, axes = pyplot.subplots(1, 2, figsize=(7.2, 2.9), dpi=150, layout="constrained", sharey=True)
    for sharing, body in zip(axes, ("disks", "spheres")):
        for rule, (name, color, style) in RULES.items():
            count, moving, turning = columns(table, body, rule, "collisions", "translation", "rotation")
            ratio = [b / a for a, b in zip(moving, turning)]
            sharing.plot(count, ratio, color=color, linestyle=style, label=name)
        sharing.set(xlabel="collisions of a particle", ylim=(0, 1.05), title=body)
    axes[0].set_ylabel("temperature, rotation / translation")
    axes[1].legend(frameon=False, fontsize=7, loc="upper right")
    return figure


def main():
    draw(rows(sys.argv[1])).savefig(sys.argv[2])


if __name__ == "__main__":
    main()
