"""Figure 4: the model.

The paper illustrates an elastic disk that hits a rigid wall at x = 0: its centre of mass x₀ < 0,
the edge point at the angle φ with the position x(φ) of eq. (39), whose undeformed place is
x₀ + R cos φ, and the wall's potential V₀ e^{αx} at its right. Here the disk is a solution: the
impact at v = 0.2 c and ν = 0.33 at closest approach, on the paper's own exponential wall (αR = 500,
940 modes). So the sketch is to scale, except for the potential, which is drawn far softer.

The text (with figure 7) says that the energy "stored in the wall potential at closest approach" is
∝ 1/α. The same impact at a wall twice as hard tests it. That energy is the wall's force over α, and
the force of a finite number of modes swings, with a period near 0.1 R/c; so the ratio is also given
for means over several swings.
"""

from __future__ import annotations

import matplotlib
import numpy as np
import stoss
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Rectangle

from gerl_zippelius_1999.common import BLACK, BLUE, GREY, NONE, VERMILION, Row, Tables, axes_of, written

TITLE = "Figure 4: the model"
CAPTION = (
    "The model: an elastic disk, coming from the left, meets a rigid wall at x = 0. Blue: its edge at closest "
    "approach, computed (ν = 0.33, v = 0.2 c, exponential wall with αR = 500, 940 modes). Grey: the undeformed disk "
    "of radius R around the same centre of mass x₀. The edge point that would be at x₀ + R cos φ is at x(φ); the wall "
    "repels it by the potential V₀ exp(αx), drawn below 100 times softer than it is. All modes are symmetric about "
    "the x axis."
)
ALT = "A flattened disk against a wall, with its centre of mass, the radius R, the angle φ and the edge point x(φ)."

POISSON, SPEED, HARDNESS, MODES = 0.33, 0.2, 500.0, 940
ANGLE = 1.25  # of the point that is shown, radians
DRAWN_HARDNESS = 5.0
AROUND = 0.2  # R/c before and after the closest approach, of the means


def compute(quick: bool) -> Tables:
    """The edge and the energy in the wall at closest approach. The same quick or not."""
    omega = np.sort(stoss.modes(poisson=POISSON, cutoff=60.0).omega)
    cutoff = float(0.5 * (omega[MODES - 1] + omega[MODES]))
    angle = np.sort(np.append(np.linspace(-np.pi, np.pi, 361), ANGLE))
    edges, rows = [], []
    for hardness in (HARDNESS, 2.0 * HARDNESS):
        wall = stoss.ExponentialWall(hardness=hardness)
        hit = stoss.impact(poisson=POISSON, speed=SPEED, cutoff=cutoff, against=wall, tail="none")
        path = hit.trajectory()
        turn = np.argmax(path.center)
        closest = float(path.time[turn])
        edges.append(hit.field(time=closest, radius=[1.0], angle=angle))
        mean = np.interp(closest + np.linspace(-AROUND, AROUND, 2001), path.time, path.stored).mean()
        lengths = (path.center[turn], hit.max_compression)
        rows.append((hardness, closest, *lengths, path.stored[turn], mean, hit.lost_fraction))
    names = (
        "hardness[1/R]", "time[R/c]", "center[R]", "compression[R]", "stored", "stored_around", "lost_fraction",
    )  # fmt: skip
    return {
        "edge": {"angle[rad]": angle, "x[R]": edges[0].x[0], "y[R]": edges[0].y[0]},
        "impact": dict(zip(names, np.array(rows).T)),
    }


def draw(tables: Tables) -> Figure:
    """The sketch."""
    table, center = tables["edge"], tables["impact"]["center[R]"][0]
    figure, (axes,) = axes_of(4.4, 4.3)
    axes.add_patch(Rectangle((0.0, -1.6), 0.32, 3.2, facecolor="0.85", edgecolor="none", zorder=1))
    axes.plot((0.0, 0.0), (-1.6, 1.6), color=BLACK, linewidth=1.2)
    axis = {"arrowstyle": "-|>", "color": BLACK, "linewidth": 0.6}
    axes.annotate("", (0.62, 0.0), (-2.1, 0.0), arrowprops=axis, zorder=1)
    axes.text(0.64, 0.0, "x", va="center", fontstyle="italic")
    axes.text(0.0, 1.66, "wall, x = 0", va="bottom", ha="center")

    around = np.linspace(0.0, 2.0 * np.pi, 361)
    axes.plot(center + np.cos(around), np.sin(around), color=GREY, linewidth=0.9, linestyle="--")
    axes.plot(table["x[R]"], table["y[R]"], color=BLUE, linewidth=1.6)
    axes.fill(table["x[R]"], table["y[R]"], color=BLUE, alpha=0.08, linewidth=0)

    axes.plot(center, 0.0, "o", color=BLACK, markersize=3.5)
    axes.text(center, -0.1, "$x_0$", va="top", ha="center")
    back = 2.45
    axes.plot((center, center + np.cos(back)), (0.0, np.sin(back)), color=GREY, linewidth=0.9)
    axes.text(center + 0.5 * np.cos(back) + 0.08, 0.5 * np.sin(back) + 0.1, "R", fontstyle="italic")
    _edge_point(axes, tables, center)

    # The potential, as a curve above the x axis far below the disk.
    x = np.linspace(-1.6, 0.3, 100)
    base = -1.55
    axes.plot(x, base + 0.12 * np.exp(DRAWN_HARDNESS * x), color=VERMILION, linewidth=1.2)
    axes.plot((-1.6, 0.32), (base, base), color=BLACK, linewidth=0.4)
    axes.text(-0.72, base + 0.08, "$V_0\\,e^{\\alpha x}$", color=VERMILION, va="bottom", ha="right")
    arrow = {"arrowstyle": "-|>", "color": BLACK, "linewidth": 1.0, "mutation_scale": 10}
    axes.annotate("", (-1.55, 1.35), (-2.05, 1.35), arrowprops=arrow)
    axes.text(-1.8, 1.42, "$v_\\mathrm{i}$", ha="center")
    axes.set(aspect="equal", xlim=(-2.15, 0.75), ylim=(-1.65, 1.85))
    axes.set_axis_off()
    return figure


def _edge_point(axes: matplotlib.axes.Axes, tables: Tables, center: float) -> None:
    """φ, the point there before and now, and its distance from the wall."""
    table = tables["edge"]
    k = int(np.argmin(np.abs(table["angle[rad]"] - ANGLE)))
    x, y = table["x[R]"][k], table["y[R]"][k]
    there = (center + np.cos(ANGLE), np.sin(ANGLE))
    axes.plot((center, there[0]), (0.0, there[1]), color=GREY, linewidth=0.9)
    axes.add_patch(Arc((center, 0.0), 0.5, 0.5, theta1=0.0, theta2=np.degrees(ANGLE), linewidth=0.8))
    axes.text(center + 0.33 * np.cos(0.5 * ANGLE), 0.33 * np.sin(0.5 * ANGLE), "φ", ha="center", va="center")
    axes.plot(*there, "o", color="white", markeredgecolor="0.4", markersize=4, zorder=3)
    axes.plot(x, y, "o", color=BLUE, markersize=4, zorder=3)
    axes.annotate("", (x, y), there, arrowprops={"arrowstyle": "-|>", "color": BLUE, "mutation_scale": 7, "shrinkB": 2})
    axes.annotate("", (0.0, y), (x, y), arrowprops={"arrowstyle": "<->", "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0})
    axes.text(0.6 * x, y + 0.05, "x(φ)", ha="center", va="bottom", fontstyle="italic")


def numbers(tables: Tables) -> list[Row]:
    """How hard the wall is at closest approach."""
    table, edge = tables["impact"], tables["edge"]
    stored, deepest = written(table["stored"][0], 2), written(edge["x[R]"].max(), 3)
    energy, hard = "energy in the wall’s potential at closest approach", HARDNESS
    ratio = f"{energy} at αR = {hard:g} over that at αR = {2 * hard:g}"
    at_once, mean = (written(each, 3) for each in _ratios(tables))
    return [
        ("position of the centre of mass at closest approach, x₀ in R", NONE, written(table["center[R]"][0]), NONE),
        (f"share of the {energy}, αR = {hard:g}", NONE, stored, "0"),
        (ratio, "∝ 1/α: 2", at_once, NONE),
        (f"{ratio}, means over ±{AROUND:g} R/c", "∝ 1/α: 2", mean, NONE),
        ("foremost point of the edge at closest approach, x in R", NONE, deepest, "0"),
    ]


def _ratios(tables: Tables) -> tuple[float, float]:
    """Energy in the wall over that at twice the hardness: at closest approach, and on average."""
    soft, hard = (tables["impact"]["stored"][k] for k in (0, 1))
    soft_mean, hard_mean = (tables["impact"]["stored_around"][k] for k in (0, 1))
    return float(soft / hard), float(soft_mean / hard_mean)


def meaning(tables: Tables) -> str:
    """What the figure says."""
    deepest = tables["edge"]["x[R]"].max()
    at_once, mean = _ratios(tables)
    return (
        "Only the x position of the edge enters the wall’s potential, so a mode acts on the wall through its two "
        f"edge amplitudes C and S and its frequency alone. On the exponential wall with αR = {HARDNESS:g} the edge "
        f"comes to rest {abs(deepest):.3f} R {'before' if deepest < 0 else 'behind'} the plane where V₀ exp(αx) = 1: "
        "a wall that is hard only within that distance. The energy in the wall’s potential is the force over α; at a "
        f"wall twice as hard it is smaller by a factor of {at_once:.2f} at closest approach, where the force swings "
        f"with the modes that are kept, and of {mean:.2f} on average around it: ∝ 1/α, as the text says."
    )
