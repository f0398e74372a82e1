"""Draws the loss of lossy spheres against their speed, and the wave on it: figure.py LOSS
PICTURE."""

import csv
import sys

import numpy as np
from matplotlib import pyplot

LOSS_TIMES = (0.0, 0.003, 0.01, 0.03, 0.1)
SPEEDS = 120  # of each of them; single values follow
COLORS = ("black", "#0072B2", "#009E73", "#D55E00", "#CC79A7")
LINES = ("-", "--", "-.", (0, (5, 1, 1, 1, 1, 1)), (0, (2, 1)))
SLOWEST, FASTEST = 1e-3, 0.2
TERMS = 5  # of the mean law


def curves(name):
    """Speeds, 1 − ε² and its error of each loss time."""
    with open(name, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    result = {}
    for row in rows[: len(LOSS_TIMES) * SPEEDS]:
        values = [float(row[name]) for name in ("speed[c]", "lost_fraction", "lost_fraction_error")]
        result.setdefault(float(row["loss_time[R/c]"]), []).append(values)
    return {loss_time: np.array(lines).T for loss_time, lines in result.items()}


def wave(speed, loss):
    """(1 − ε²)/v without the mean law, the polynomial in v^(1/5) without constant that fits it
    best."""
    powers = np.array([speed ** (0.2 * k - 1.0) for k in range(1, TERMS + 1)]).T
    return loss / speed - powers @ np.linalg.lstsq(powers, loss / speed, rcond=None)[0]


def draw(found):
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2})
    figure, (above, below) = pyplot.subplots(2, 1, figsize=(6.4, 6.4), dpi=150, layout="constrained", sharex=True)
    below.axhline(0.0, color="0.6", linewidth=0.6)
    for (loss_time, (speed, loss, error)), color, line in zip(found.items(), COLORS, LINES):
        above.plot(speed, loss, color=color, linestyle=line, label=f"η = {loss_time:g}")
        rest = wave(speed, loss)
        below.plot(speed, rest, color=color, linestyle=line)
        below.fill_between(speed, rest - error / speed, rest + error / speed, color=color, alpha=0.25, linewidth=0)
    above.set_title("sphere at a rigid wall, ν = 0.3; η in R/c", fontsize=8)
    below.fill_between([], [], [], color="0.5", alpha=0.4, linewidth=0, label="errors of 1 − ε²")
    below.legend(frameon=False, loc="upper left")
    above.set(xscale="log", yscale="log", ylabel="1 − ε²")
    above.legend(frameon=False, loc="lower right")
    below.set(ylim=(-0.18, 0.215), xlim=(SLOWEST, FASTEST), xlabel="speed v / c", ylabel="wave of (1 − ε²) c / v")
    return figure


def main():
    draw(curves(sys.argv[1])).savefig(sys.argv[2])


if __name__ == "__main__":
    main()
