"""Draws 1 − ε² of balls on a half-space and at a rigid wall against speed: figure.py CSV PICTURE."""

import csv
import sys

from matplotlib import pyplot

KINDS = {"elastic": ("elastic ball", "#0072B2", "o"), "rigid": ("rigid ball", "#D55E00", "s")}
WALL = "#009E73"
FAILS = 0.1  # relative error of the slow theory beyond which it is not drawn


def columns(table, kind, *names):
    """Columns of one kind of ball, as numbers."""
    rows = [row for row in table if row["ball"] == kind]
    return [[float(row[name]) for row in rows] for name in names]


def draw(table):
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2})
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(7, 2.9), dpi=150, layout="constrained")
    for kind, (label, color, marker) in KINDS.items():
        speed, lost, law, theory, error = columns(
            table, kind, "speed[c]", "lost_fraction", "power_law", "slow_theory", "slow_theory_error"
        )
        left.plot(speed, lost, color=color, label=f"{label}, half-space")
        left.plot(speed, law, color=color, linestyle=":")
        ratio = [each / power for each, power in zip(lost, law)]
        right.plot(speed, ratio, color=color, marker=marker, markersize=3, linestyle="none", label=label)
        good = [k for k in range(len(speed)) if error[k] < FAILS * theory[k]]
        right.plot([speed[k] for k in good], [theory[k] / law[k] for k in good], color=color)
    left.plot(*columns(table, "at_wall", "speed[c]", "lost_fraction"), color=WALL, label="elastic ball, rigid wall")
    left.plot([], [], color="0.3", linestyle=":", label="$k\\,(v/c)^{3/5}$")
    right.plot([], [], color="0.3", label="theory of slow impacts")
    right.axhline(1.0, color="0.3", linestyle=":")
    for axes in (left, right):
        axes.set(xscale="log", xlabel="v / c", xlim=(1e-6, 0.3))
        axes.set_title("ν = 0.3 of ball and half-space", fontsize=8)
    left.set(yscale="log", ylim=(5e-8, 1.0), ylabel="1 − ε²")
    right.set(ylim=(0.5, 1.2), ylabel="$(1 − ε^2)\\;/\\;k\\,(v/c)^{3/5}$")
    for kind, place, name in (("elastic", 1e-4, "block"), ("at_wall", 1e-4, "wall")):
        speed, lost = columns(table, kind, "speed[c]", "lost_fraction")
        near = min(range(len(speed)), key=lambda k: abs(speed[k] - place))
        left.annotate(name, (speed[near], lost[near]), (0, 14), textcoords="offset points", ha="right", fontsize=7)
    left.legend(frameon=False, fontsize=7, loc="lower right")
    right.legend(frameon=False, fontsize=7, loc="lower left")
    return figure


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        table = list(csv.DictReader(line for line in file if not line.startswith("#")))
    draw(table).savefig(sys.argv[2])


if __name__ == "__main__":
    main()
