"""Draws the tables of make.py: figure.py FOLDER IMAGES (docs/understand/findings/relaxing.md)."""

import sys
from pathlib import Path

import numpy as np
from make import CHANNELS, DROPPED, HERE, RUBBERS
from matplotlib import pyplot
from one_ball import BALLS, LAWS, SPEEDS, frequency, tangent

sys.path.insert(0, str(HERE.parent))
from tables import having, table  # noqa: E402 (beside the other studies)

COLOURS = ("#0072B2", "black", "#D55E00")
LINES = ("-", "--", "-.")
OF_CHANNELS = ("#009E73", "#0072B2", "#E69F00", "#D55E00", "#CC79A7")


def column(rows, name):
    return np.array([row[name] for row in rows])


def draw_laws(folder):
    rows = table(folder, "laws")
    figure, (left, *others) = pyplot.subplots(1, 3, figsize=(7.6, 2.7), dpi=150, layout="constrained")
    ball = "rubber"
    hertz = np.geomspace(20, 2000, 200)
    for law, colour, line in zip(LAWS, COLOURS, LINES, strict=True):
        left.plot(hertz, tangent(ball, law, hertz), color=colour, linestyle=line, label=law.replace("-", "–"))
    left.axvspan(frequency(ball, SPEEDS[0]), frequency(ball, SPEEDS[-1]), color="0.88", linewidth=0)
    left.text(np.sqrt(frequency(ball, SPEEDS[0]) * frequency(ball, SPEEDS[-1])), 0.004, "contacts", ha="center")
    left.set(xscale="log", yscale="log", ylim=(3e-3, 1), xlim=(20, 2000), xlabel="frequency, Hz", ylabel="tan δ = 1/Q")
    left.set_title("rubber", fontsize=8)
    left.legend(frameon=False, loc="upper left", handlelength=2.6)
    for axes, ball in zip(others, BALLS, strict=True):
        for law, colour, line in zip(LAWS, COLOURS, LINES, strict=True):
            its = having(rows, ball=ball, law=law)
            axes.plot(column(its, "speed"), column(its, "restitution"), color=colour, linestyle=line)
        axes.set(xscale="log", xlabel="speed, m/s", ylabel="ε")
        axes.set_title(f"{ball}, R = 1 cm, rigid wall", fontsize=8)
    return figure


def draw_rubber(folder):
    rows = table(folder, "rubber")
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(7.2, 2.9), dpi=150, layout="constrained")
    for name, colour, mark in zip(RUBBERS, ("#0072B2", "#D55E00"), "os", strict=True):
        measured = np.genfromtxt(HERE / f"{name}.csv", delimiter=",", skip_header=1)
        left.plot(measured[:, 0], measured[:, 2], color=colour, marker=mark, markersize=3, label=name)
        (at,) = having(rows, ball=name, temperature=20, height=1)
        left.plot([at["frequency"]] * 2, [0.01, at["tan_delta"]], color=colour, linestyle=":")
        for height, line in ((0.1, "--"), (1.0, "-")):
            its = having(rows, ball=name, height=height)
            right.plot(column(its, "temperature"), 100 * column(its, "rebound"), color=colour, linestyle=line,
                       marker=mark, markersize=3)  # fmt: skip
    for height, line in ((0.1, "--"), (1.0, "-")):
        right.plot([], [], color="black", linestyle=line, label=f"falls {100 * height:g} cm")
    right.text(44, 79, "happy", color="#0072B2")
    right.text(48, 44, "unhappy", color="#D55E00")
    left.set(xscale="log", yscale="log", ylim=(0.01, 3), xlabel="frequency at 20 °C, Hz", ylabel="tan δ")
    left.legend(frameon=False, loc="lower right")
    right.set(ylim=(0, 100), xlabel="temperature, °C", ylabel="rebound, % of the height")
    right.legend(frameon=False, loc="upper left")
    return figure


def draw_channels(folder):
    rows = table(folder, "channels")
    figure, all_axes = pyplot.subplots(1, len(DROPPED), figsize=(7.6, 2.6), dpi=150, layout="constrained", sharey=True)
    for axes, ball in zip(all_axes, DROPPED, strict=True):
        its = having(rows, ball=ball)
        for name, colour in zip(CHANNELS, OF_CHANNELS, strict=True):
            axes.plot(column(its, "speed"), np.maximum(column(its, name), 1e-12), color=colour, label=name)
        axes.set(xscale="log", yscale="log", ylim=(1e-6, 1), xlabel="speed, m/s", xticks=(0.01, 0.1, 1, 10))
        axes.set_title(f"{ball} on glass", fontsize=8)
    all_axes[0].set_ylabel("share of the energy")
    figure.suptitle(" ")  # room for the legend
    figure.legend(*all_axes[0].get_legend_handles_labels(), loc="upper center", ncol=5, frameon=False)
    return figure


def main(folder, images):
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2})
    draws = {"relaxing.png": draw_laws, "relaxing_rubber.png": draw_rubber, "relaxing_channels.png": draw_channels}
    for name, draw in draws.items():
        draw(Path(folder)).savefig(Path(images) / name)


if __name__ == "__main__":
    main(*sys.argv[1:])
