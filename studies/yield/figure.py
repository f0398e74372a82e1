"""Draws ε beyond yield beside published laws, and the curves behind it: figure.py docs/images/yield_restitution.png."""

import sys
from pathlib import Path

import numpy as np
from matplotlib import pyplot

import published

HERE = Path(__file__).parent


def table(name):
    return np.genfromtxt(HERE / f"{name}.csv", delimiter=",", names=True, comments="#", skip_header=1)


def draw_restitution(axes, rows):
    speeds = np.geomspace(1, 5000, 300)
    for poisson, color, marker in ((0.3, "#0072B2", "o"), (0.2, "#56B4E9", "^"), (0.45, "#D55E00", "v")):
        of = rows[rows["nu"] == poisson]
        line = "-" if poisson == 0.3 else "none"
        axes.plot(of["V_over_V_y"], of["restitution"], marker, color=color, linestyle=line, markersize=3.5, linewidth=1,
                  label=f"finite elements, ν = {poisson:g}")
    axes.plot(speeds, [published.thornton(v) for v in speeds], "--", color="0.4", linewidth=1, label="Thornton and Ning 1998")
    fast = speeds[speeds > 25]
    axes.plot(fast, [published.johnson(v) for v in fast], ":", color="black", linewidth=1.2, label="Johnson, p = 3Y")
    axes.set(xscale="log", yscale="log", xlabel="V / V$_y$", ylabel="ε", xlim=(1, 5000), ylim=(0.1, 1.1))
    axes.set_yticks([0.1, 0.2, 0.3, 0.5, 0.7, 1], ["0.1", "0.2", "0.3", "0.5", "0.7", "1"])
    axes.minorticks_off()
    axes.legend(frameon=False, fontsize=7, loc="lower left")


def draw_curves(axes, loading, unloading, restitution):
    of = restitution[restitution["nu"] == 0.3]
    axes.plot(loading["d"], loading["f"], color="black", linewidth=1, label="loading")
    axes.plot(loading["d"], loading["d"] ** 1.5, color="0.6", linewidth=0.8, linestyle="--", label="Hertz")
    for depth in (3, 5, 8, 13, 20):
        rows, force = unloading[unloading["d_max"] == depth], of["f_max"][of["d_max"] == depth][0]
        axes.plot(rows["d_over_d_max"] * depth, rows["f_over_f_max"] * force, color="#0072B2", linewidth=0.9,
                  label="unloading" if depth == 3 else None)
    axes.set(xlim=(0, 21), ylim=(0, 70), xlabel="δ / δ$_y$", ylabel="F / F$_y$")
    axes.legend(frameon=False, fontsize=7, loc="upper left")


def main():
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6})
    figure, axes = pyplot.subplots(1, 2, figsize=(7, 3.2), dpi=110, layout="constrained")
    restitution = table("restitution")
    draw_restitution(axes[0], restitution)
    draw_curves(axes[1], table("loading"), table("unloading"), restitution)
    figure.savefig(sys.argv[1])


if __name__ == "__main__":
    main()
