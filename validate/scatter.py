"""Stated against true errors of 1 − ε²: the points of docs/developer/validation.md as CSV and as a picture.

    python3 validate/scatter.py docs/developer/validation.md docs/results/validation.csv docs/images/validation.png
"""

import csv
import re
import sys
from pathlib import Path

SETS = {
    "All points at the default tolerance": "disk at a wall",
    "All unseen points at the default tolerance": "disk at a wall",
    "All pairs at the default tolerance": "two disks",
    "All spheres at the default tolerance": "sphere at a wall",
    "All hollow spheres at the default tolerance": "sphere at a wall",
    "All impacts on half-spaces at the default tolerance": "half-space",
    "All lossy bodies at the default tolerance": "lossy",
    "All bodies that relax at the default tolerance": "relaxing",
    "All rough and coated faces at the default tolerance": "rough or coated",
    "All vibrating bodies at the error 10⁻³": "vibrating",
    "Balls on plates": "plate",
    "Bodies by their modes at a point": "by its modes",
}
COLUMNS = ["1−ε², reference", "uncertainty", "1−ε²", "error", "ratio"]
COLOURS = ["#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#000000", "#999999", "#F0E442", "#8C510A"]


def points(text):
    """Set, 1 − ε² of the reference, its uncertainty, 1 − ε², stated error, and the true one over it."""
    for section in text.split("\n## ")[1:]:
        title = section.partition("\n")[0]
        for table in re.findall(r"(?:^\|.*\n)+", section, re.MULTILINE) if title in SETS else ():
            head, _, *lines = [[cell.strip() for cell in line.split("|")[1:-1]] for line in table.splitlines()]
            if set(COLUMNS) <= set(head):
                for cells in lines:
                    row = dict(zip(head, cells, strict=True))
                    yield SETS[title], *(row[name].removesuffix(" u") for name in COLUMNS)


def draw(rows, file):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.4, 4.8), layout="constrained")
    for name, colour in zip(dict.fromkeys(SETS.values()), COLOURS, strict=True):
        its = [(float(error), max(float(ratio), 0.005)) for each, _, _, _, error, ratio in rows if each == name]
        axes.loglog([e for e, _ in its], [e * r for e, r in its], ".", color=colour, markersize=5, label=name)
    ends = [2e-10, 5e-3]
    axes.plot(ends, ends, "k-", linewidth=1, label="true = stated")
    axes.plot(ends, [3 * end for end in ends], "k:", linewidth=1, label="three times")
    axes.set(xlabel="stated error of $1-\\varepsilon^2$", ylabel="true error of $1-\\varepsilon^2$", xlim=ends, ylim=[1e-12, 1.5e-2])
    axes.legend(fontsize=8, loc="lower right")
    figure.savefig(file, dpi=120, metadata={"Software": None})


def main(page, table, picture):
    rows = list(points(Path(page).read_text(encoding="utf-8")))
    with open(table, "w", encoding="utf-8", newline="") as file:
        file.write("# Stated and true errors of 1-eps^2 (docs/understand/accuracy.md); made by `make validate`.\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["set", "reference", "uncertainty", "lost_fraction", "lost_fraction_error", "true_over_stated"])
        writer.writerows(rows)
    draw(rows, picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
