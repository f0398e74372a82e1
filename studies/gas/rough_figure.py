"""Draws how gases of rough particles cool, and how rotation and translation share the energy:
rough_figure.py FILE PICTURE."""

import csv
import sys

from matplotlib import pyplot

RULES = {
    "stoss": ("rule of stoss", "#0072B2", "-"),
    "constant": ("constant ε and $ε_t$", "#D55E00", "-"),
    "mean field": ("these in mean-field theory", "#000000", ":"),
}


def rows(name):
    """The rows of a CSV file."""
    with open(name, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def columns(table, body, rule, *names):
    return [[float(row[name]) for row in table if row["body"] == body and row["rule"] == rule] for name in names]


def draw(table):
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2})
    figure, axes = pyplot.subplots(2, 2, figsize=(7.2, 5.4), dpi=150, layout="constrained", sharey="row")
    for (cooling, sharing), body in zip(axes.T, ("disks", "spheres")):
        for rule, (name, color, style) in RULES.items():
            time, count, moving, turning = columns(
                table, body, rule, "time[R/c]", "collisions", "translation", "rotation"
            )
            start = moving[0]
            cooling.plot(time, [each / start for each in moving], color=color, linestyle=style, label=name)
            if rule != "mean field":
                cooling.plot(time, [each / start for each in turning], color=color, linestyle="--", linewidth=0.9)
            sharing.plot(count, [b / a for a, b in zip(moving, turning)], color=color, linestyle=style)
        cooling.set(xscale="log", yscale="log", xlabel="time / (R/c)", title=body)
        sharing.set(xlabel="collisions of a particle", ylim=(0, 1.05))
    axes[0, 0].plot([], [], color="0.4", linestyle="--", linewidth=0.9, label="of rotation")
    axes[0, 0].set_ylabel("temperature / initial one")
    axes[0, 0].legend(frameon=False, fontsize=7, loc="lower left")
    axes[1, 0].set_ylabel("temperature, rotation / translation")
    return figure


def main():
    draw(rows(sys.argv[1])).savefig(sys.argv[2])


if __name__ == "__main__":
    main()
