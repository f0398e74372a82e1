"""What decides a rebound, pair by pair and speed by speed: the channel that takes most energy, where bodies stick and where
asperities count. regimes.py CSV PICTURE (docs/understand/what_decides.md)."""

import sys
import warnings

import numpy as np
import stoss
from figure import CHANNELS, COLOURS, write

SPEEDS = np.geomspace(1e-3, 10.0, 33)  # m/s


def ball(material, radius=5e-3):
    return stoss.Sphere(radius=radius, material=stoss.materials[material])


def block(material):
    return stoss.HalfSpace(material=stoss.materials[material])


PAIRS = {
    "bearing steel on a block of glass": (ball("bearing steel"), block("glass")),
    "bearing steel on 1 cm of glass": (
        ball("bearing steel"),
        stoss.Plate(thickness=0.01, material=stoss.materials["glass"]),
    ),
    "two balls of bearing steel": (ball("bearing steel"), "same"),
    "structural steel on a block of it": (ball("structural steel"), block("structural steel")),
    "brass on a block of steel": (ball("brass"), block("bearing steel")),
    "aluminium on a block of granite": (ball("aluminium"), block("granite")),
    "two balls of glass": (ball("glass"), "same"),
    "POM on a block of steel": (ball("POM"), block("bearing steel")),
    "rubber on a block of granite, R = 20 mm": (ball("rubber", 0.02), block("granite")),
    "two grains of ice, R = 1 µm": (ball("ice", 1e-6), "same"),
}


def rows():
    """What decides: of smooth faces the channel that takes most, below `rough_speed` of a bearing ball's finish roughness."""
    warnings.simplefilter("ignore", stoss.StossWarning)
    for name, (body, against) in PAIRS.items():
        found = stoss.predict(body, against=against, speed=SPEEDS)
        for speed, value, channel in zip(SPEEDS, found.restitution, found.dominant):
            rough = "yes" if speed < found.rough_speed else "no"
            yield {"pair": name, "speed[m/s]": f"{speed:.4g}", "restitution": f"{value:.4f}",
                   "dominant": "adhesion" if value == 0 else channel, "rough": rough}  # fmt: skip


def draw(table, file):
    from matplotlib import pyplot

    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6})
    figure, axes = pyplot.subplots(figsize=(7.2, 3.4), dpi=150, layout="constrained")
    step = (10 / 0.001) ** (1 / 32)
    for row in table:
        speed, channel = float(row["speed[m/s]"]), row["dominant"]
        colour = COLOURS[CHANNELS.index(channel)]
        axes.barh(row["pair"], speed * (step**0.5 - step**-0.5), left=speed * step**-0.5, color=colour)
        if float(row["restitution"]) == 0:
            axes.barh(row["pair"], speed * (step**0.5 - step**-0.5), left=speed * step**-0.5, color="none",
                      hatch="////", edgecolor="white", linewidth=0)  # fmt: skip
        elif row["rough"] == "yes":
            axes.barh(row["pair"], speed * (step**0.5 - step**-0.5), left=speed * step**-0.5, color="none", height=0.8,
                      hatch="......", edgecolor="black", linewidth=0)  # fmt: skip
    patches = [pyplot.Rectangle((0, 0), 1, 1, color=colour) for colour in COLOURS]
    patches.append(pyplot.Rectangle((0, 0), 1, 1, facecolor=COLOURS[-1], hatch="////", edgecolor="white"))
    patches.append(pyplot.Rectangle((0, 0), 1, 1, facecolor="white", hatch="......", edgecolor="black"))
    axes.set(xscale="log", xlim=(0.001, 10), xlabel="speed, m/s")
    axes.invert_yaxis()
    figure.suptitle(" ")  # room for the legend
    figure.legend(patches, [*CHANNELS, "sticks", "rough"], loc="upper center", ncol=7, frameon=False)
    figure.savefig(file)


def main(table, picture):
    found = list(rows())
    write(table, "What decides a rebound (docs/understand/what_decides.md)", found)
    draw(found, picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
