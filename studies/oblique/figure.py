"""Draws the figures of oblique impacts: figure.py FOLDER_OF_TABLES FOLDER_OF_PICTURES."""

import math
import sys
from pathlib import Path

from matplotlib import pyplot

sys.path.insert(0, str(Path(__file__).parents[1]))
from tables import having, table  # noqa: E402

GREEN, BLUE, RED, PINK, SKY, AMBER = "#009E73", "#0072B2", "#D55E00", "#CC79A7", "#56B4E9", "#E69F00"
SPEEDS = {1e-6: (GREEN, "10⁻⁶"), 1e-4: (SKY, "10⁻⁴"), 1e-3: (BLUE, "0.001"), 1e-2: (PINK, "0.01"), 0.1: (RED, "0.1")}
OBLIQUITY = "s / μ$v_n$"
RADIUS, FRICTION, SPEED, RESTITUTION = 2.5e-3, 0.092, 3.9, 0.98  # of the measured ball, SI


def columns(rows, *names):
    return [[row[name] for row in rows] for name in names]


def two_panels(**options):
    return pyplot.subplots(1, 2, figsize=(7, 3.3), dpi=150, layout="constrained", **options)


def measured(tables):
    """What was measured of the ball of alumina, each as ε_t at its angle: from the centre, from the spin, and from the
    angle at which the contact rebounds."""
    found = {"et": [], "spin": [], "patch": []}
    for row in table(tables, "measured"):
        angle = row["at"]
        if row["quantity"] == "et":
            found["et"].append((angle, 3.5 * (1 - row["value"]) - 1))
        elif row["quantity"] == "spin":
            along = SPEED * math.sin(math.radians(angle))
            found["spin"].append((angle, 1.4 * row["value"] * RADIUS / along - 1))
        elif row["quantity"] == "patch":
            after = RESTITUTION * math.tan(math.radians(row["value"]))
            found["patch"].append((angle, -after / math.tan(math.radians(angle))))
    return found


def curves(tables):
    rows = table(tables, "curves")
    figure, (left, right) = two_panels(sharey=True)
    names = ("x", "tangential_restitution")
    for speed, (color, label) in SPEEDS.items():
        left.plot(*columns(having(rows, bodies="sphere", speed=speed), *names), color=color, label=f"v = {label} c")
        for friction, line in ((0.3, "--"), (0.1, ":")):
            right.plot(*columns(having(rows, bodies="disk", speed=speed, friction=friction), *names), color=color,
                       linestyle=line)  # fmt: skip
        pair = having(rows, bodies="equal_disks", speed=speed)
        if pair:
            right.plot(*columns(pair, *names), color=color, label=f"v = {label} c")
    left.plot(*columns(having(rows, bodies="maw"), *names), color="black", linestyle="--", label="Maw: v → 0")
    left.plot(*columns(having(rows, bodies="half_space", speed=1e-3), *names), color=BLUE, linestyle=":",
              label="0.001 c, half-space")  # fmt: skip
    published = [row for row in table(tables, "measured") if row["quantity"] == "fem" and 0.25 < row["at"] < 8]
    left.plot([row["at"] for row in published], [-row["value"] / row["at"] for row in published], "ks", markersize=3,
              fillstyle="none", label="published finite elements")  # fmt: skip
    for line, label in (("-", "two equal disks"), ("--", "at a rigid wall, μ = 0.3"), (":", "μ = 0.1")):
        right.plot([], [], color="0.3", linestyle=line, label=label)
    left.set_title("spheres, ν = 0.3", fontsize=8)
    right.set_title("disks, ν = 0.33", fontsize=8)
    for axes in (left, right):
        axes.axhline(0, color="0.7", linewidth=0.6, zorder=0)
        axes.set(xlim=(0, 8), xlabel=OBLIQUITY)
    left.set(ylim=(-0.55, 0.85), ylabel="$ε_t$")
    left.legend(frameon=False, fontsize=6.5, loc="lower left", ncols=2)
    right.legend(frameon=False, fontsize=6.5, loc="lower left", ncols=2)
    return figure


def glass(tables):
    rows = table(tables, "glass")
    figure, (left, right) = two_panels()
    angles, value, maw, added = columns(rows, "angle", "tangential_restitution", "maw", "added_by_coupling_of_disks")
    left.fill_between(angles, value, [a + b for a, b in zip(value, added)], color=SKY, alpha=0.35, linewidth=0,
                      label="with coupling of disks")  # fmt: skip
    left.plot(angles, value, color=BLUE, label="stoss")
    left.plot(angles, maw, color="black", linestyle="--", linewidth=0.9, label="Maw: v → 0")
    marks = {"et": ("o", RED, "centre"), "spin": ("^", GREEN, "spin"), "patch": ("s", PINK, "contact")}
    for name, its in measured(tables).items():
        marker, color, label = marks[name]
        left.plot(*zip(*its), marker, color=color, markersize=3.5, label=f"measured: {label}")
    right.plot(*columns(rows, "angle", "spin"), color=BLUE, label="stoss")
    spins = having(table(tables, "measured"), quantity="spin")
    right.plot(*columns(spins, "at", "value"), "^", color=GREEN, markersize=3.5, label="measured")
    left.axhline(0, color="0.7", linewidth=0.6, zorder=0)
    left.set(xlim=(0, 45), ylim=(-0.45, 0.75), xlabel="angle of impact / °", ylabel="$ε_t$")
    right.set(xlim=(0, 90), ylim=(0, 700), xlabel="angle of impact / °", ylabel="spin after / rad s⁻¹")
    left.legend(frameon=False, fontsize=6.5, loc="upper left", ncols=2, columnspacing=1)
    right.legend(frameon=False, fontsize=7, loc="lower center")
    return figure


def size(tables):
    rows = table(tables, "size")
    figure, (left, right) = two_panels()
    for psi, color in ((0.5, GREEN), (1.0, BLUE), (2.0, RED), (3.0, PINK)):
        for against, line in (("wall", "-"), ("half_space", "--")):
            its = having(rows, against=against, poisson=0.3, psi1=psi)
            radius, after, maw = columns(its, "contact_radius", "psi2", "maw")
            left.plot(radius, [(a - b) / r for r, a, b in zip(radius, after, maw)], color=color, linestyle=line,
                      marker="o", markersize=2.5, label=f"$ψ_1$ = {psi:g}" if line == "-" else None)  # fmt: skip
    left.plot([], [], color="0.3", linestyle="--", label="on a half-space")
    left.set(xscale="log", xlabel="radius of the contact a / R", ylabel="$(ψ_2$ − Maw$)\\;R/a$")
    left.legend(frameon=False, fontsize=7)
    left.set_title("ν = 0.3, at a rigid wall", fontsize=8)
    best = table(tables, "superball")
    for poisson, color in ((0.0, SKY), (0.2, GREEN), (0.3, BLUE), (0.4, PINK), (0.49, RED)):
        its = having(best, bodies="sphere", poisson=poisson)
        right.plot(*columns(its, "speed", "tangential_restitution"), color=color, marker="o", markersize=2.5,
                   label=f"ν = {poisson:g}")  # fmt: skip
        (slow,) = having(best, bodies="maw", poisson=poisson)
        right.plot([6e-5], [slow["tangential_restitution"]], "<", color=color, markersize=4)
    right.axhline(1, color="0.3", linestyle=":", linewidth=1, label="Garwin: 1")
    right.plot([], [], "k<", markersize=4, linestyle="none", label="Maw: v → 0")
    right.set(xscale="log", xlabel="v / c", ylabel="maximum of $ε_t$ over " + OBLIQUITY, ylim=(0.3, 1.03))
    right.legend(frameon=False, fontsize=6.5, loc="upper left", bbox_to_anchor=(0, 0.94))
    right.set_title("spheres", fontsize=8)
    return figure


def coupling(tables):
    """What coupling adds, at 0.003 c: between the least and the most of three Poisson's ratios."""
    rows = having(table(tables, "coupling"), speed=0.003)
    figure, axes = pyplot.subplots(figsize=(4.6, 3.2), dpi=150, layout="constrained")
    for x, color in ((0.25, GREEN), (1.0, BLUE), (2.0, RED)):
        added = {}
        for row in having(rows, x=x):
            ratio = round(row["friction"] / row["beta"], 3)
            added.setdefault(ratio, []).append(row["tangential_restitution"] - row["equal_disks"])
        ratios = sorted(ratio for ratio, values in added.items() if len(values) > 1)
        axes.fill_between(ratios, [min(added[each]) for each in ratios], [max(added[each]) for each in ratios],
                          color=color, alpha=0.45, linewidth=1, label=f"{x:g}")  # fmt: skip
    axes.axhline(0, color="0.7", linewidth=0.6, zorder=0)
    axes.axvline(2, color="0.3", linewidth=0.8, linestyle="--")
    axes.text(1.9, 0.5, "μ = 2β:\nnegligible\nabove", fontsize=7, ha="right")
    axes.set(xscale="log", xlabel="μ / β", ylabel="$ε_t$, disk at a rigid wall − two equal disks")
    axes.set_xticks((0.1, 0.2, 0.5, 1, 2), ("0.1", "0.2", "0.5", "1", "2"))
    axes.minorticks_off()
    axes.legend(frameon=False, fontsize=7, title=OBLIQUITY, title_fontsize=7, loc="upper center")
    return figure


def dem(tables):
    rows, found = table(tables, "dem"), table(tables, "curves")
    figure, (left, right) = two_panels(sharey=True)
    names = ("x", "tangential_restitution")
    for axes in (left, right):
        for speed, line in ((1e-6, "-"), (1e-3, "--"), (0.1, ":")):
            axes.plot(*columns(having(found, bodies="sphere", speed=speed), *names), color="black", linestyle=line,
                      label=f"stoss, v = {SPEEDS[speed][1]} c")  # fmt: skip
    laws = (
        (left, "history", "Mindlin spring", RED, "-"),
        (left, "rescale", "rescaled", AMBER, "-"),
        (left, "force", "in force", BLUE, "-"),
        (left, "rescale_force", "in force, rescaled", GREEN, "-"),
        (right, "linear_1", "Hooke, $k_t = k_n$", RED, "-"),
        (right, "linear_2/7", "Hooke, $k_t = 2k_n/7$", BLUE, "-"),
        (right, "history_2/7", "Hertz, $k_t = 2k_n/7$", SKY, (0, (4, 4))),
    )
    for axes, name, label, color, line in laws:
        axes.plot(*columns(having(rows, law=name), *names), color=color, linestyle=line, label=label)
    x = [0.1 * i for i in range(1, 81)]
    right.plot(x, [min(0.44, 7 / each - 1) for each in x], color=GREEN, label="Walton, $β_0$ = 0.44")
    left.set_title("Hertz–Mindlin springs with $8G^*a$", fontsize=8)
    right.set_title("fixed ratios, and Walton's three numbers", fontsize=8)
    for axes in (left, right):
        axes.set(xlim=(0, 8), xlabel=OBLIQUITY)
        axes.legend(frameon=False, fontsize=6.5, loc="lower right")
    left.set(ylim=(-1.05, 1.05), ylabel="$ε_t$")
    return figure


def main():
    tables, pictures = Path(sys.argv[1]), Path(sys.argv[2])
    pyplot.rcParams.update({"font.size": 8, "axes.linewidth": 0.6, "lines.linewidth": 1.2})
    drawn = {
        "oblique.png": curves,
        "oblique_glass.png": glass,
        "oblique_size.png": size,
        "oblique_coupling.png": coupling,
        "oblique_dem.png": dem,
    }
    for name, draw in drawn.items():
        draw(tables).savefig(pictures / name)


if __name__ == "__main__":
    main()
