"""Where the energy of some real balls goes: figure.py STOSS CSV PICTURE (docs/understand/energy.md)."""

import csv
import subprocess
import sys

CASES = {
    "bearing steel on a glass block, 1 m/s": 'bearing steel|0.005|half-space,material=glass|1',
    "bearing steel on 1 cm of glass, 1 m/s": 'bearing steel|0.005|plate,material=glass,thickness=0.01|1',
    "structural steel on a block of it, 1 m/s": 'structural steel|0.005|half-space,material=structural steel|1',
    "glass marbles, 1 m/s": 'glass|0.008|same|1',
    "rubber on a granite block, 3 m/s": 'rubber|0.02|half-space,material=granite|3',
    "two grains of ice, R = 1 µm, 2 m/s": 'ice|1e-6|same|2',
}  # fmt: skip
CHANNELS = ("ringing", "radiation", "material", "yield", "adhesion")
COLOURS = ("#009E73", "#0072B2", "#E69F00", "#D55E00", "#CC79A7")


def predicted(program):
    """A row for each case: ε, its three uncertainties and the shares of the channels."""
    for name, case in CASES.items():
        material, radius, against, speed = case.split("|")
        words = [program, "predict", "--body", "sphere", "--material", material, "--radius", radius]
        words += ["--against", against, "--speed", speed, "--format", "csv", "--quiet"]
        lines = subprocess.run(words, check=True, capture_output=True, text=True).stdout.splitlines()
        (row,) = csv.DictReader(line for line in lines if not line.startswith("#"))
        names = ("restitution", "restitution_error", "by_models", "by_constants", *CHANNELS)
        yield {"case": name} | {each: f"{float(row[each]):.3g}" if each != "restitution" else f"{float(row[each]):.5f}"
                                for each in names}  # fmt: skip


def draw(rows, file):
    from matplotlib import pyplot

    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6})
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(7.6, 2.6), dpi=150, layout="constrained", sharey=True)
    names = [row["case"] for row in rows]
    for axes, whole in ((left, False), (right, True)):
        starts = [0.0] * len(rows)
        for channel, colour in zip(CHANNELS, COLOURS, strict=True):
            shares = [float(row[channel]) for row in rows]
            lost = [sum(float(row[each]) for each in CHANNELS) if whole else 1.0 for row in rows]
            shares = [100 * share / part for share, part in zip(shares, lost, strict=True)]
            axes.barh(names, shares, left=starts, color=colour, label=channel)
            starts = [start + share for start, share in zip(starts, shares, strict=True)]
        axes.set_xlim(0, 100)
    left.set_xlabel("lost, % of the energy before")
    right.set_xlabel("share of the loss, %")
    left.invert_yaxis()
    figure.suptitle(" ")  # room for the legend
    figure.legend(*left.get_legend_handles_labels(), loc="upper center", ncol=5, frameon=False)
    figure.savefig(file)


def write(table, about, rows):
    with open(table, "w", encoding="utf-8", newline="") as file:
        file.write(f"# {about}; made by `make results`.\n")
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main(program, table, picture):
    rows = list(predicted(program))
    write(table, "Where the energy of real balls goes (docs/understand/energy.md)", rows)
    draw(rows, picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
