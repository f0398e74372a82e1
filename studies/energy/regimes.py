"""Which channel takes most energy, pair by pair and speed by speed: regimes.py STOSS CSV PICTURE
(docs/understand/when_elasticity_decides.md)."""

import csv
import subprocess
import sys

from figure import CHANNELS, COLOURS, write

PAIRS = {  # material, radius in m, what it meets
    "bearing steel on a block of glass": "bearing steel|0.005|half-space,material=glass",
    "bearing steel on 1 cm of glass": "bearing steel|0.005|plate,material=glass,thickness=0.01",
    "two balls of bearing steel": "bearing steel|0.005|same",
    "structural steel on a block of it": "structural steel|0.005|half-space,material=structural steel",
    "brass on a block of steel": "brass|0.005|half-space,material=bearing steel",
    "two balls of glass": "glass|0.005|same",
    "rubber on a block of granite": "rubber|0.02|half-space,material=granite",
    "two grains of ice, R = 1 µm": "ice|1e-6|same",
}
SPEEDS = "log:0.001:10:33"  # m/s


def rows(program):
    for name, pair in PAIRS.items():
        material, radius, against = pair.split("|")
        words = [program, "predict", "--body", "sphere", "--material", material, "--radius", radius]
        words += ["--against", against, "--speed", SPEEDS, "--format", "csv", "--quiet"]
        lines = subprocess.run(words, check=False, capture_output=True, text=True).stdout.splitlines()
        for row in csv.DictReader(line for line in lines if not line.startswith("#")):
            sticks = float(row["restitution"]) == 0
            yield {"pair": name, "speed[m/s]": f"{float(row['speed[m/s]']):.4g}",
                   "restitution": f"{float(row['restitution']):.4f}",
                   "dominant": "adhesion" if sticks else row["dominant"]}  # fmt: skip


def draw(table, file):
    from matplotlib import pyplot

    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6})
    figure, axes = pyplot.subplots(figsize=(7.2, 2.9), dpi=150, layout="constrained")
    step = (10 / 0.001) ** (1 / 32)
    for row in table:
        speed, channel = float(row["speed[m/s]"]), row["dominant"]
        colour = COLOURS[CHANNELS.index(channel)]
        axes.barh(row["pair"], speed * (step**0.5 - step**-0.5), left=speed * step**-0.5, color=colour)
        if float(row["restitution"]) == 0:
            axes.barh(row["pair"], speed * (step**0.5 - step**-0.5), left=speed * step**-0.5, color="none",
                      hatch="////", edgecolor="white", linewidth=0)  # fmt: skip
    patches = [pyplot.Rectangle((0, 0), 1, 1, color=colour) for colour in COLOURS]
    patches.append(pyplot.Rectangle((0, 0), 1, 1, facecolor=COLOURS[-1], hatch="////", edgecolor="white"))
    axes.set(xscale="log", xlim=(0.001, 10), xlabel="speed, m/s")
    axes.invert_yaxis()
    figure.suptitle(" ")  # room for the legend
    figure.legend(patches, [*CHANNELS, "sticks"], loc="upper center", ncol=6, frameon=False)
    figure.savefig(file)


def main(program, table, picture):
    found = list(rows(program))
    write(table, "The channel that takes most energy (docs/understand/when_elasticity_decides.md)", found)
    draw(found, picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
