"""Draws bodies that vibrate before they meet: figure.py TABLES PICTURES, both of them folders."""

import math
import sys
from pathlib import Path

from matplotlib import pyplot

sys.path.insert(0, str(Path(__file__).parents[1]))
from tables import having, table  # noqa: E402

BLUE, VERMILION, GREEN, PURPLE, SKY, BLACK = "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "black"
BODIES = {"sphere": (BLUE, "o"), "disk": (VERMILION, "s")}
ENERGIES = {0.01: (BLUE, "o"), 0.1: (GREEN, "s"), 1.0: (VERMILION, "^")}
DAMPING = {"none": (BLUE, "-"), "partial": (GREEN, "--"), "complete": (VERMILION, "-.")}
POISSON = {"sphere": 0.3, "disk": 0.33}


def column(rows, name):
    return [row[name] for row in rows]


def named(damping):
    return "no damping" if damping == "none" else f"{damping} damping"


def at(body, rows):
    """What a picture of a body at one speed is called."""
    return f"{body}, ν = {POISSON[body]:g}, v = {rows[0]['speed']:g} c"


def draw_phases(axes, rows, body):
    its = having(rows, body=body)
    for energy, (color, marker) in ENERGIES.items():
        curve = having(its, energy=energy)
        degrees = [math.degrees(phase) for phase in column(curve, "phase")]
        axes.plot(degrees, column(curve, "sinusoid"), color=color, linewidth=0.8)
        axes.plot(degrees, column(curve, "restitution"), color=color, linestyle="none", marker=marker, markersize=3,
                  label=f"E = {energy:g}")  # fmt: skip
    axes.axhline(1.0, color="0.6", linewidth=0.6)
    axes.set(xlim=(0, 360), xticks=range(0, 361, 90), xlabel="phase φ of mode (2,0) / °", ylabel="ε")
    axes.set_title(at(body, its), fontsize=8)
    axes.legend(frameon=False, fontsize=6.5, ncols=3, loc="upper center", handletextpad=0, columnspacing=0.4)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.16 * (high - low))


def draw_amplitudes(axes, rows):
    styles = {("sphere", 0.001): (BLACK, "D"), ("sphere", 0.01): (BLUE, "o"), ("sphere", 0.1): (SKY, "v"),
              ("disk", 0.01): (VERMILION, "s"), ("disk", 0.1): (PURPLE, "^")}  # fmt: skip
    ends = (4e-4, 0.5)
    axes.plot(ends, ends, color="0.4", linewidth=0.8)
    for (body, speed), (color, marker) in styles.items():
        its = having(rows, body=body, speed=speed)
        axes.plot(column(its, "amplitude_from_share"), column(its, "amplitude"), color=color, marker=marker,
                  linestyle="none", markersize=3.5, markerfacecolor="none", label=f"{body}, {speed:g} c")  # fmt: skip
    axes.set(xscale="log", yscale="log", xlim=ends, ylim=ends)
    axes.set(xlabel="$\\sqrt{e_k}\\;/\\;ε_0$", ylabel="amplitude $a_k$")
    axes.legend(frameon=False, fontsize=7, loc="upper left", handletextpad=0.1)


def draw_spread(axes, summaries):
    for body, (color, marker) in BODIES.items():
        its = having(summaries, body=body)
        axes.plot(column(its, "temperature"), column(its, "law"), color=color)
        axes.plot(column(its, "temperature"), column(its, "standard_deviation"), color=color, linestyle="none",
                  marker=marker, label=at(body, its))  # fmt: skip
    axes.plot([], [], color="0.3", label="law of small T")
    axes.set(xscale="log", yscale="log", xlabel="temperature T / ½mv²", ylabel="standard deviation of ε")
    axes.legend(frameon=False, fontsize=7)


def draw_heat(axes, rows):
    axes.axhline(0.0, color="0.6", linewidth=0.6)
    axes.axvline(1.0, color="0.6", linewidth=0.6)
    for body, (color, marker) in BODIES.items():
        its = having(rows, body=body)
        axes.errorbar(column(its, "ratio"), column(its, "gain"), column(its, "gain_error"), color=color, marker=marker,
                      markersize=3, linestyle="none", linewidth=0.8, label=body)  # fmt: skip
        (equal,) = having(its, ratio=1.0)
        around = (0.5, 1.5)
        axes.plot(around, [equal["half_mean_square"] * (ratio - 1) for ratio in around], color=color)
    axes.plot([], [], color="0.3", label="linear law")
    axes.set(xlabel="temperatures, vibration / translation", ylabel="mean gain of translation ⟨ΔK⟩ / T")
    axes.set_title("translation as warm as at 0.1 c", fontsize=8)
    axes.legend(frameon=False, fontsize=7)


def draw_bounces(axes, rows):
    names = {"none": "no_damping", "partial": "partial_damping", "complete": "complete_damping"}
    for damping in ("none", "partial", "complete"):
        color, line = DAMPING[damping]
        its = [row for row in rows if row[names[damping]] != ""]
        axes.plot(column(its, "number"), column(its, names[damping]), color=color, linestyle=line, linewidth=0.7,
                  label=named(damping))  # fmt: skip
    axes.axhline(1 / 19, color="0.5", linestyle=":", label="1/(N + 1)")
    axes.set(xscale="log", yscale="log", ylim=(1e-5, 1.5), xlim=(1, 6000))
    axes.set(xlabel="impact", ylabel="share of translation")
    axes.set_title("a disk that bounces, ν = 0.33, v = 0.1 c at first", fontsize=8)
    axes.legend(frameon=False, fontsize=7, loc="lower left")


def draw_shares(axes, rows):
    whole = sum(column(rows, "impacts"))
    width = rows[0]["to"]
    axes.stairs([row["impacts"] / whole / width for row in rows[:-1]], column(rows, "from"), color=BLUE, fill=True,
                alpha=0.4, label="without damping")  # fmt: skip
    share = [0.003 * k for k in range(101)]
    axes.plot(share, [18 * (1 - x) ** 17 for x in share], color="black", label="18 (1 − x)¹⁷")
    axes.set(yscale="log", ylim=(0.01, 40), xlim=(0, 0.3), xlabel="share x of translation", ylabel="density")
    axes.set_title("its impacts 2001 to 6000, eight times", fontsize=8)
    axes.legend(frameon=False, fontsize=7)


def draw_chain(axes, rows):
    for damping, (color, line) in DAMPING.items():
        its = having(rows, damping=damping)
        axes.plot(column(its, "time"), column(its, "translation"), color=color, linestyle=line,
                  label=named(damping))  # fmt: skip
    begin = next(row for row in its if row["time"] > 1e6)
    times = (1e5, 3e8)
    law = [0.1 * begin["translation"] * (begin["time"] / time) ** 2 for time in times]
    axes.plot(times, law, color="0.4", linewidth=0.8, label="∝ t⁻²")
    axes.set(xscale="log", yscale="log", xlim=(100, 1e9), ylim=(1e-13, 2))
    axes.set(xlabel="time / (L/c)", ylabel="kinetic energy")
    axes.set_title("a ring of 40 rods, velocities of 0.01 c at first", fontsize=8)
    axes.legend(frameon=False, fontsize=7, loc="lower left")


def draw_chain_restitution(axes, rows):
    for damping, (color, line) in DAMPING.items():
        its = having(rows, damping=damping)[:-1]
        whole = sum(row["collisions"] for row in having(rows, damping=damping))
        width = its[0]["to"]
        density = [max(row["collisions"], 0.1) / whole / width for row in its]
        axes.stairs(density, [0.0, *column(its, "to")], color=color, linestyle=line, baseline=None, label=named(damping))
    axes.set(yscale="log", xlim=(0, 3), ylim=(5e-3, 200), xlabel="ε", ylabel="density")
    axes.set_title("its collisions 501 to 2500", fontsize=8)
    axes.legend(frameon=False, fontsize=7)


def main():
    tables, pictures = map(Path, sys.argv[1:3])
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2, "lines.markersize": 4})

    phases = table(tables, "phases")
    figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(7.4, 2.8), dpi=150, layout="constrained")
    draw_phases(left, phases, "sphere")
    draw_phases(middle, phases, "disk")
    draw_amplitudes(right, table(tables, "modes"))
    figure.savefig(pictures / "vibration_phase.png")

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(7, 2.8), dpi=150, layout="constrained")
    draw_spread(left, table(tables, "temperatures"))
    draw_heat(right, table(tables, "heat"))
    figure.savefig(pictures / "vibration_temperature.png")

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(7, 2.8), dpi=150, layout="constrained")
    draw_bounces(left, table(tables, "bounces"))
    draw_shares(right, table(tables, "shares"))
    figure.savefig(pictures / "vibration_sequences.png")

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(7, 2.8), dpi=150, layout="constrained")
    draw_chain(left, table(tables, "chain"))
    draw_chain_restitution(right, table(tables, "chain_restitution"))
    figure.savefig(pictures / "vibration_chain.png")


if __name__ == "__main__":
    main()
