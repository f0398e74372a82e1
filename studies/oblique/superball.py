"""Draws why superballs are fast, from the table of the maximum of ε_t: superball.py TABLE PICTURE."""

import csv
import sys

import numpy as np
from matplotlib import pyplot

# What is thrown at 3 m/s: name, ν, √(E/ρ) in m/s of stoss.materials, and where its name stands.
THROWN, SPEED = (("rubber", 0.49, 42.6, (-6, 6)), ("glass", 0.2, 5292.0, (0, -16))), 3.0


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(line for line in file if line[0] != "#") if row["bodies"] == "sphere"]
    figure, axes = pyplot.subplots(figsize=(5.2, 3.6), dpi=130, layout="constrained")
    for poisson, color in ((0.49, "#d55e00"), (0.3, "#0072b2"), (0.2, "#009e73")):
        curve = [(float(row["speed[c]"]), float(row["tangential_restitution"])) for row in rows
                 if float(row["poisson"]) == poisson]  # fmt: skip
        speed, value = np.array(curve).T
        axes.semilogx(speed, value, "o-", color=color, markersize=3)
        axes.annotate(f"ν = {poisson:g}", (speed[0], value[0]), (0, 7 if poisson == 0.3 else -13), textcoords="offset points", color=color, fontsize=9)
        for name, of, c, shift in THROWN:
            if of == poisson:
                there = SPEED / c, np.interp(np.log(SPEED / c), np.log(speed), value)
                axes.plot(*there, "*", color=color, markersize=15)
                side = {"ha": "right" if shift[0] < 0 else "left", "fontsize": 9, "color": color}
                axes.annotate(f"{name} at {SPEED:g} m/s", there, shift, textcoords="offset points", **side)
    axes.axhline(1.0, color="0.3", linestyle=":")
    axes.annotate("perfect superball", (1e-4, 1.0), (0, -12), textcoords="offset points", fontsize=9, color="0.3")
    axes.set(xlabel="speed / c", ylabel="largest ε$_t$ of an elastic sphere", ylim=(0.4, 1.04))
    figure.savefig(sys.argv[2])


if __name__ == "__main__":
    main()
