"""Draws the table of steel balls that make.py writes: figure.py FOLDER IMAGES (docs/understand/findings/rough.md)."""

import sys
from pathlib import Path

from make import HEIGHTS, PARTNERS
from matplotlib import pyplot

sys.path.insert(0, str(Path(__file__).parents[1]))
from tables import having, table  # noqa: E402 (beside the other studies)

COLOURS = ("black", "#0072B2", "#E69F00", "#D55E00")
MARKS = "os^D"
TITLES = {"wall": "at a rigid wall: ringing", "block": "on a block of steel: radiation"}
RANGES = {"wall": (1e-9, 1e-3), "block": (2e-5, 1e-2)}


def main(folder, images):
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2})
    rows = table(Path(folder), "steel")
    figure, both = pyplot.subplots(1, 2, figsize=(7.2, 3.0), dpi=150, layout="constrained")
    for axes, partner in zip(both, PARTNERS, strict=True):
        for height, colour, mark in zip(HEIGHTS, COLOURS, MARKS, strict=True):
            its = having(rows, partner=partner, roughness=height)
            name = f"{1e9 * height:g} nm" if height else "smooth"
            lost = [max(row["lost_fraction"], RANGES[partner][0] / 100) for row in its]  # below the picture
            axes.plot([row["speed"] for row in its], lost, color=colour, marker=mark, markersize=3, label=name)
        yields = having(rows, partner=partner)[0]["yield_speed"]
        axes.axvspan(yields, 2, color="0.9", linewidth=0)
        axes.text(yields * 1.08, RANGES[partner][0] * 1.4, "yields", color="0.4")
        axes.set(xscale="log", yscale="log", xlim=(8e-4, 1.3), ylim=RANGES[partner], xlabel="speed, m/s")
        axes.set_title(TITLES[partner], fontsize=8)
    both[0].set_ylabel("1 − ε²")
    both[0].legend(frameon=False, loc="upper left", title="rms roughness")
    figure.savefig(Path(images) / "rough.png")


if __name__ == "__main__":
    main(*sys.argv[1:])
