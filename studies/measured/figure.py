"""Measured against predicted loss of energy, by channel: figure.py STOSS PICTURE (docs/understand/measured.md)."""

import re
import sys

from compare import lines

CHANNELS = ("ringing", "radiation", "material", "yield", "adhesion")
COLOURS = ("#009E73", "#0072B2", "#E69F00", "#D55E00", "#CC79A7")

MARKS = {"alumina": "D", "frosted": "v", "the same": "^", "rough": "s", "ice": "o", "granite": "P", "glass": "X", "HDPE": "*",
         "pool": "h"}  # fmt: skip
NAMES = {"the same": "compacted frost", "frosted": "frosted ice", "rough": "rough ice", "pool": "phenolic resin"}


def main(program, picture):
    from matplotlib import pyplot

    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6})
    figure, axes = pyplot.subplots(figsize=(5.6, 3.6), dpi=150, layout="constrained")
    for what, _, measured, predicted, _, _, constants, channel, *_ in lines(program):
        if "sticks" in measured:
            continue
        value = float((re.search(r"mean ([\d.]+)", measured) or re.match(r"([\d.]+)", measured))[1])
        restitution, by_constants = float(predicted), float(constants)
        lost = [
            1 - each**2
            for each in (restitution, min(restitution + by_constants, 1), max(restitution - by_constants, 0))
        ]
        bar = [[min(lost[0] - max(lost[1], 1e-4), 0.999 * lost[0])], [lost[2] - lost[0]]]
        mark = next(MARKS[each] for each in MARKS if what.startswith(each))
        axes.errorbar(
            lost[0],
            1 - value**2,
            xerr=bar,
            fmt=mark,
            color=COLOURS[CHANNELS.index(channel)],
            markersize=5,
            linewidth=0.8,
        )
    axes.plot([1e-3, 1], [1e-3, 1], "k-", linewidth=0.8)
    axes.plot([1e-3, 0.1], [1e-2, 1], "k:", linewidth=0.8)
    axes.plot([1e-3, 1e-2], [0.1, 1], "k:", linewidth=0.8)
    axes.set(xscale="log", yscale="log", xlim=(1e-3, 1), ylim=(0.01, 1.1))
    axes.set(xlabel="predicted loss of energy, $1-\\varepsilon^2$", ylabel="measured loss of energy")
    keys = [
        pyplot.Line2D([], [], linestyle="", marker=mark, color="0.3", label=NAMES.get(name, name))
        for name, mark in MARKS.items()
    ]
    keys += [
        pyplot.Line2D([], [], linewidth=4, color=colour, label=name)
        for name, colour in zip(CHANNELS, COLOURS)
        if name != "ringing"
    ]
    axes.legend(handles=keys, fontsize=7, loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)
    figure.savefig(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
