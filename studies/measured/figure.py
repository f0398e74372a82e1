"""Measured against predicted loss of energy: figure.py STOSS PICTURE (docs/understand/measured.md)."""

import re
import sys

from compare import lines

COLOURS = {"alumina": "#0072B2", "frosted": "#56B4E9", "the same": "#009E73", "rough": "#E69F00", "ice": "#CC79A7",
           "granite": "#D55E00"}  # fmt: skip


def main(program, picture):
    from matplotlib import pyplot

    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6})
    figure, axes = pyplot.subplots(figsize=(4.6, 3.6), dpi=150, layout="constrained")
    labels = set()
    for what, _, measured, predicted, _, _, constants, *_ in lines(program):
        if "sticks" in measured:
            continue
        value = float((re.search(r"mean ([\d.]+)", measured) or re.match(r"([\d.]+)", measured))[1])
        restitution, by_constants = float(predicted), float(constants)
        lost = [1 - each**2 for each in (restitution, restitution + by_constants, max(restitution - by_constants, 0))]
        bar = [[min(lost[0] - max(lost[1], 1e-4), 0.999 * lost[0])], [lost[2] - lost[0]]]
        name = next(each for each in COLOURS if what.startswith(each))
        label = {"the same": "compacted frost", "frosted": "frosted ice", "rough": "rough ice"}.get(name, name)
        axes.errorbar(lost[0], 1 - value**2, xerr=bar, fmt="o", color=COLOURS[name], markersize=4, linewidth=0.8,
                      label=None if label in labels else label)  # fmt: skip
        labels.add(label)
    axes.plot([1e-3, 1], [1e-3, 1], "k-", linewidth=0.8, label="measured = predicted")
    axes.plot([1e-3, 0.1], [1e-2, 1], "k:", linewidth=0.8, label="ten times, a hundred times")
    axes.plot([1e-3, 1e-2], [0.1, 1], "k:", linewidth=0.8)
    axes.set(xscale="log", yscale="log", xlim=(1e-3, 1), ylim=(0.01, 1.1))
    axes.set(xlabel="predicted loss of energy, $1-\\varepsilon^2$", ylabel="measured loss of energy")
    axes.legend(fontsize=7, loc="lower right")
    figure.savefig(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
