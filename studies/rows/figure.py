"""Rows of balls: figure.py FOLDER DIAGRAM PICTURES draws rows.png and rows_wave.png
(docs/understand/findings/rows.md)."""

import sys
from pathlib import Path

import numpy as np
from matplotlib import colors, pyplot

sys.path.append(str(Path(__file__).parents[1]))
from tables import having, table  # noqa: E402 (beside the other studies)

COLOURS = ("#0072B2", "#E69F00", "#009E73", "#CC79A7", "#D55E00")
pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6})


def draw_slow(folder, file):
    rows = table(folder, "slow")
    figure, panels = pyplot.subplots(1, 2, figsize=(7.6, 2.9), dpi=150, layout="constrained")
    for axes, balls in zip(panels, (3, 5)):
        for body in range(balls - 1):
            of = having(rows, balls=balls, body=body)
            hertz, moving = of[0], of[1:]
            colour = COLOURS[body]
            axes.semilogx([row["speed"] for row in moving], [row["velocity"] for row in moving], ".-", color=colour, lw=1,
                          ms=4, label=f"ball {body + 1}")  # fmt: skip
            axes.axhline(hertz["velocity"], color=colour, lw=0.7, ls=":")
        axes.set_title(f"{balls} balls", fontsize=8)
        axes.set_xlabel("v / c")
        axes.legend(frameon=False)
    panels[0].set_ylabel("velocity after / v")
    figure.savefig(file)


def draw_wave(folder, diagram, file):
    forces = np.loadtxt(diagram, delimiter=",")
    figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(7.6, 2.9), dpi=150, layout="constrained")
    time, force = forces[:, 0], forces[:, 1:] / forces[:, 1:].max()
    shown = left.pcolormesh(np.arange(1, force.shape[1] + 1), time, np.clip(force, 1e-4, None), shading="nearest",
                            norm=colors.LogNorm(1e-4, 1), cmap="viridis", rasterized=True)  # fmt: skip
    figure.colorbar(shown, ax=left, label="force / greatest")
    left.set_xlabel("contact")
    left.set_ylabel("time, R/c")
    rows = table(folder, "waves")
    cases = {(row["material"], row["speed"]): None for row in rows}
    for (material, speed), colour in zip(cases, COLOURS):
        of = [row for row in having(rows, material=material, speed=speed) if row["max_force"] > 0]
        middle.plot([row["contact"] + 1 for row in of], [row["max_force"] / of[0]["max_force"] for row in of], color=colour,
                        lw=1, label=f"{material}, {speed:g} c")  # fmt: skip
    middle.set_ylim(0.6, 1.02)
    middle.set_xlabel("contact")
    middle.set_ylabel("greatest force / that of the first")
    middle.legend(frameon=False, fontsize=6)
    of = table(folder, "speeds")
    right.loglog([row["max_force"] for row in of], [row["wave_speed"] for row in of], ".-", color=COLOURS[0], lw=1)
    slow = of[0]
    line = np.array([slow["max_force"], of[-1]["max_force"]])
    right.loglog(line, slow["wave_speed"] * (line / line[0]) ** (1 / 6), color="0.5", lw=0.8, ls=":", label="∝ F$^{1/6}$")
    right.set_xlabel("F, mc²/R")
    right.set_ylabel("speed of the wave / c")
    right.legend(frameon=False)
    figure.savefig(file)


def main(folder, diagram, pictures):
    folder, pictures = Path(folder), Path(pictures)
    draw_slow(folder, pictures / "rows.png")
    draw_wave(folder, diagram, pictures / "rows_wave.png")


if __name__ == "__main__":
    main(*sys.argv[1:])
