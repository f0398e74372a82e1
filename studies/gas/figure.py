"""Draws how a gas cools by three laws of ε, and where its disks are then: figure.py ENERGIES DISKS
PICTURE."""

import csv
import sys

from matplotlib import pyplot
from matplotlib.collections import EllipseCollection
from matplotlib.ticker import NullLocator

LAWS = {
    "constant": ("constant ε", "#D55E00"),
    "power": ("1 − ε ∝ $v^{1/5}$", "#009E73"),
    "stoss": ("ε(v, ratio) of stoss", "#0072B2"),
}
SPREADS = (0.2, 0.5, 1, 2, 5, 10)  # where the variance has ticks
LINES = {"constant": 2.0, "power": 5 / 3}  # exponents of the homogeneous gas


def rows(name):
    """The rows of a CSV file."""
    with open(name, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def column(table, law, name):
    return [float(row[name]) for row in table if row["law"] == law]


def cooling_time(time, energy, exponent):
    """τ of E = (1 + t/τ)^(−exponent), from where half of the energy is left."""
    half = next(k for k, left in enumerate(energy) if left < 0.5)
    return time[half] / (energy[half] ** (-1 / exponent) - 1)


def draw(table, disks):
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2})
    figure, (cooling, clusters, places) = pyplot.subplots(1, 3, figsize=(9.6, 3.3), dpi=150, layout="constrained")
    for law, (name, color) in LAWS.items():
        time, energy = column(table, law, "time[R/c]"), column(table, law, "energy")
        cooling.plot(time, energy, color=color, label=name)
        clusters.plot(column(table, law, "collisions"), column(table, law, "fluctuation"), color=color)
        if law in LINES:
            tau = cooling_time(time, energy, LINES[law])
            homogeneous = [(1 + t / tau) ** -LINES[law] for t in time]
            cooling.plot(time, homogeneous, color=color, linestyle=":", linewidth=0.9)
    cooling.plot([], [], color="0.4", linestyle=":", linewidth=0.9, label="$(1 + t/τ)^{-2}$, $(1 + t/τ)^{-5/3}$")
    cooling.set(xscale="log", yscale="log", xlabel="time / (R/c)", ylabel="energy / initial energy", ylim=(1e-4, 2))
    cooling.legend(frameon=False, fontsize=7, loc="lower left")
    clusters.set(yscale="log", xlabel="collisions of a disk", ylabel="disks in a square, variance / mean")
    clusters.set_yticks(SPREADS, [f"{each:g}" for each in SPREADS])
    clusters.yaxis.set_minor_locator(NullLocator())
    cooling.set_title("ν = 0.33, radii R to 2R", fontsize=8)
    side = float(disks[0]["side"])
    size = [2 * float(row["radius"]) for row in disks]
    centres = [(float(row["x"]) % side, float(row["y"]) % side) for row in disks]
    round_ones = EllipseCollection(size, size, [0] * len(size), units="xy", offsets=centres,
                                   offset_transform=places.transData, facecolor="#D55E00", linewidth=0)  # fmt: skip
    places.add_collection(round_ones)
    places.set(xlim=(0, side), ylim=(0, side), aspect="equal", xticks=[], yticks=[])
    places.set_title("constant ε, at the end", fontsize=8)
    return figure


def main():
    draw(rows(sys.argv[1]), rows(sys.argv[2])).savefig(sys.argv[3])


if __name__ == "__main__":
    main()
