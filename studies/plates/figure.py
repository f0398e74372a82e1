"""Draws balls on plates: figure.py FOLDER_OF_TABLES FOLDER_OF_PICTURES."""

import csv
import sys
from pathlib import Path

import numpy as np
from matplotlib import pyplot

COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00")
SHOWN = ("bearing steel", "glass")  # ball and plate
SPEEDS = {"0.01": COLORS[0], "0.1": COLORS[2], "0.5": COLORS[1]}
TOO_FAR = 0.3  # deflection over thickness beyond which a plate is no longer linear


def table(folder, name):
    with open(folder / name, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def column(rows, name):
    return np.array([float(row[name]) for row in rows])


def materials(rows):
    """ε and 1 − ε² of steel on glass against thickness, Zener's theory beside them, and the block."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(7.4, 3), dpi=150, layout="constrained")
    for speed, color in SPEEDS.items():
        its = [row for row in rows if (row["ball"], row["plate"], row["speed[m/s]"]) == (*SHOWN, speed)]
        plates, block = its[:-1], its[-1]
        thickness = 1e3 * column(plates, "thickness[m]")
        left.plot(thickness, column(plates, "restitution"), color=color, label=f"{speed} m/s")
        left.plot(thickness, column(plates, "zener"), color=color, linestyle=":")
        right.plot(thickness, column(plates, "lost_fraction"), color=color)
        right.plot(thickness, 1 - column(plates, "zener") ** 2, color=color, linestyle=":")
        right.plot([100, 500], 2 * [float(block["lost_fraction"])], color=color, linewidth=3, alpha=0.4)
    for place, words in ((4, "window pane"), (10, "shop window"), (25, "table top")):
        left.axvline(place, color="0.8", linewidth=0.8, zorder=0)
        left.text(1.03 * place, 0.03, words, rotation=90, fontsize=6, color="0.4", va="bottom")
    left.plot([], [], color="0.3", linestyle=":", label="Zener's theory")
    left.plot([], [], color="0.3", linewidth=3, alpha=0.4, label="block")
    left.legend(frameon=False, fontsize=7, loc="upper left")
    left.set(xscale="log", xlim=(1, 40), ylim=(0, 1), ylabel="restitution ε")
    left.set_xticks((1, 2, 5, 10, 20, 40), labels=("1", "2", "5", "10", "20", "40"))
    left.minorticks_off()
    right.set(xscale="log", yscale="log", ylim=(1e-4, 1.5), xlim=(1, 500), ylabel="lost energy 1 − ε²")
    for axes in (left, right):
        axes.set_xlabel("thickness of the glass, mm")
        axes.grid(alpha=0.3)
    return figure


def finer(place, times=8):
    """A logarithmic grid with more places, and the indices of these among the given ones."""
    index = np.linspace(0, len(place) - 1, times * (len(place) - 1) + 1)
    return np.exp(np.interp(index, np.arange(len(place)), np.log(place))), index


def between(values, rows, columns):
    """Values at indices that are no integers."""
    along = np.array([np.interp(columns, np.arange(values.shape[1]), row) for row in values])
    return np.array([np.interp(rows, np.arange(values.shape[0]), column) for column in along.T]).T


def label(axes, lines, words, size):
    for text in axes.clabel(lines, fmt=words.format, fontsize=size, inline=False):
        text.set_bbox({"facecolor": "white", "edgecolor": "none", "pad": 0.5, "alpha": 0.8})


def zener(rows):
    """Where Zener's theory is off by 1, 10 and 50 %: of the lost energy, and of ε."""
    thickness, speed = (np.unique(column(rows, name)) for name in ("thickness[R]", "speed[c]"))
    shape = (len(thickness), len(speed))
    value, theory, lost = (column(rows, name).reshape(shape) for name in ("restitution", "zener", "lost_fraction"))
    deflection = column(rows, "deflection[h]").reshape(shape)
    with np.errstate(divide="ignore", invalid="ignore"):
        errors = (1 - (1 - theory**2) / lost, theory / value - 1)
    (fine_thickness, rows), (fine_speed, columns) = finer(thickness), finer(speed)
    fine = [between(each, rows, columns).T for each in (value, deflection)]
    figure, pair = pyplot.subplots(1, 2, figsize=(7, 3.2), dpi=150, layout="constrained", sharey=True)
    for axes, error, title in zip(pair, errors, ("of the lost energy 1 − ε²: too low by", "of ε: too high by")):
        shown = between(np.where(value > 0.01, error, np.nan) if title.startswith("of ε") else error, rows, columns).T
        axes.contourf(fine_thickness, fine_speed, shown, levels=(-1, 0.01, 0.1, 0.5, 1e3),
                      colors=("#F7FBFF", "#C6DBEF", "#6BAED6", "#2171B5"))  # fmt: skip
        lines = axes.contour(fine_thickness, fine_speed, shown, levels=(0.01, 0.1, 0.5), colors="black", linewidths=0.9)
        label(axes, lines, "{:.0%}", 7)
        rebound = axes.contour(fine_thickness, fine_speed, fine[0], levels=(0.1, 0.5, 0.9), colors=COLORS[1],
                               linewidths=0.8, linestyles=":")  # fmt: skip
        label(axes, rebound, "ε = {:g}", 6)
        axes.contourf(fine_thickness, fine_speed, fine[1], levels=(TOO_FAR, 1e9), colors="none", hatches=["////"])
        axes.set(xscale="log", yscale="log", xlabel="thickness / R", facecolor="0.85")
        axes.set_title(title, fontsize=8)
    pair[0].set(ylabel="v / c")
    return figure


def block(rows):
    """The loss on plates over that on a block against thickness over c_p T/2: all pairs, one of them with colour."""
    figure, axes = pyplot.subplots(figsize=(4.8, 3.2), dpi=150, layout="constrained")
    for key in dict.fromkeys((row["pair"], row["speed[c]"]) for row in rows):
        its = [row for row in rows if (row["pair"], row["speed[c]"]) == key]
        excess = np.abs(column(its, "lost_fraction") / column(its, "on_block") - 1)
        color = COLORS[0] if key[0].endswith("nu=0.3") else COLORS[4] if key[0].endswith("nu=0.45") else "0.7"
        axes.plot(column(its, "x"), excess, color=color, linewidth=0.8, zorder=1 if color == "0.7" else 2)
    for color, words in ((COLORS[0], "ball and plate of ν = 0.3"), (COLORS[4], "of ν = 0.45"), ("0.7", "other pairs")):
        axes.plot([], [], color=color, label=words)
    axes.axhline(0.01, color="0.3", linestyle=":", linewidth=0.9)
    axes.axvline(0.8, color="0.3", linestyle="--", linewidth=0.9)
    axes.text(0.81, 2, "C = 0.8", fontsize=7)
    axes.set(yscale="log", ylim=(1e-4, 10), xlim=(0.2, 1.1), xlabel="thickness / $\\frac{1}{2}c_pT$",
             ylabel="|loss / loss on a block − 1|")  # fmt: skip
    axes.legend(frameon=False, fontsize=7, loc="lower left")
    return figure


def layers(rows):
    """Laminated glass beside glass of one piece; coated steel."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(7, 3), dpi=150, layout="constrained")
    for color, (what, between, label) in zip(COLORS, (
        ("one sheet", "0", "one sheet"), ("two sheets in one", "0", "two, in one piece"),
        ("laminated", "0.38", "two, with 0.38 mm of PVB"), ("laminated", "1.52", "two, with 1.52 mm of PVB"),
    )):  # fmt: skip
        its = [row for row in rows if (row["what"], row["other[mm]"]) == (what, between)]
        left.plot(column(its, "sheet[mm]"), column(its, "restitution"), color=color, label=label)
    left.set(xscale="log", xlabel="thickness of a glass sheet / mm", ylabel="restitution ε", ylim=(0, 1))
    left.legend(frameon=False, fontsize=7, loc="lower right")
    for color, coat in zip(COLORS, ("tungsten carbide", "aluminium", "PMMA")):
        for sheet, style in (("10", "-"), ("40", "--")):
            its = [row for row in rows if (row["what"], row["sheet[mm]"]) == (coat, sheet)]
            (bare,) = [row for row in rows if (row["what"], row["sheet[mm]"]) == ("bare steel", sheet)]
            ratio = column(its, "lost_fraction") / float(bare["lost_fraction"])
            right.plot(column(its, "other[mm]"), ratio, color=color, linestyle=style)
        right.plot([], [], color=color, label=coat + (", if elastic" if coat == "aluminium" else ""))
    for sheet, style in (("10", "-"), ("40", "--")):
        right.plot([], [], color="0.3", linestyle=style, label=f"on {sheet} mm of steel")
    right.axhline(1.0, color="0.3", linestyle=":")
    right.set(xscale="log", xlabel="thickness of the coating / mm", ylabel="loss / loss on bare steel", ylim=(0, 1.5))
    right.legend(frameon=False, fontsize=7, ncols=2, loc="upper left")
    for axes, ticks in ((left, (2, 5, 10, 20)), (right, (0.1, 0.2, 0.5, 1, 2))):
        axes.set_xticks(ticks, labels=map("{:g}".format, ticks))
        axes.minorticks_off()
        axes.grid(alpha=0.3)
    return figure


def main():
    tables, pictures = Path(sys.argv[1]), Path(sys.argv[2])
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2, "hatch.linewidth": 0.4})
    materials(table(tables, "materials.csv")).savefig(pictures / "plates.png")
    zener(table(tables, "map.csv")).savefig(pictures / "plates_zener.png")
    block(table(tables, "block.csv")).savefig(pictures / "plates_block.png")
    layers(table(tables, "layers.csv")).savefig(pictures / "plates_layers.png")


if __name__ == "__main__":
    main()
