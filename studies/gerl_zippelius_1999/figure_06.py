"""Figure 6: the energy in the modes (n, l) at closest approach.

The paper's caption: "Logarithm of energy (arbitrary units) in modes with low (n, l) at closest
approach. The spectrum is dominated by the quadrupolar mode (n = 2, l = 0)." The text, with Table 1:
αR = 500, v = 0.1 c, 1600 modes (eqs. 40 and 43), chosen by their mean energy in a preliminary run.
Speed and number of modes of the figure itself are not given; those of the table are taken. Closest
approach is where the centre of mass turns, x₀ largest; the energy of a mode is P²/2m + ½mω²Q²
(eq. 34; erratum E1), as a share of the initial energy. The converged values are those of all modes,
extrapolated in 1/ω_c, at the same wall.
"""

from __future__ import annotations

import matplotlib
import numpy as np
import stoss
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter
from mpl_toolkits.mplot3d import Axes3D

from gerl_zippelius_1999.common import NONE, PAGE, PRINT, Row, Table, Tables, measured, power, small_ticks
from gerl_zippelius_1999.two_limits import POISSON, place, selected_impact

TITLE = "Figure 6: energy of the modes at closest approach"
CAPTION = (
    "Energy in the modes (n, l) when the disk is closest to the wall, as a share of the initial energy, logarithmic: "
    "(a) as a landscape, in the manner of the paper, (b) the same as decimal logarithms, so that no bar hides another. "
    "ν = 0.33, v = 0.1 c, exponential wall αR = 500, the 1600 modes of highest mean energy in a run with the 4510 "
    "modes up to ω = 100 c/R. The modes with n = 0 are the purely radial ones."
)
ALT = "Bars over the plane of n and l, highest at n = 2, l = 0, falling along both axes."

SPEED, HARDNESS, MODES = 0.1, 500.0, 1600
CUTOFFS, QUICK_CUTOFFS = (70.0, 100.0, 140.0), (50.0, 60.0, 70.0)  # c/R; the middle one is the preliminary run
ORDERS, INDICES = 11, 7  # shown: n, l from 0
FLOOR = -6.0  # decimal logarithm at the foot of the bars
NAMED = ((2, 0), (3, 0), (0, 0), (4, 0), (1, 1), (5, 0), (1, 0))


def compute(quick: bool) -> Tables:
    cutoffs = QUICK_CUTOFFS if quick else CUTOFFS
    wall = stoss.ExponentialWall(hardness=HARDNESS)
    runs = [stoss.impact(poisson=POISSON, speed=SPEED, cutoff=cutoff, against=wall, tail="none") for cutoff in cutoffs]
    chosen = selected_impact(runs[1], min(MODES, runs[1].modes - 1))
    order = np.repeat(np.arange(ORDERS), INDICES)
    index = np.tile(np.arange(INDICES), ORDERS)
    landscape: Table = {"order": order, "index": index}
    instants: list[tuple[float, ...]] = []
    columns = []
    for run in (chosen, *runs):
        path = run.trajectory()
        # The centre turns between two steps; what lies between is interpolated in its velocity.
        turn = int(np.argmax(path.center)) - int(path.velocity[np.argmax(path.center)] < 0.0)
        two = path.velocity[turn : turn + 2]
        weight = np.array([-two[1], two[0]]) / (two[0] - two[1])
        energies = run.energies_at(time=path.time[turn : turn + 2])
        at = [place(energies[0], n, l) for n, l in zip(order, index)]
        landscape.setdefault("omega[c/R]", energies["omega"][0, at])
        columns.append(weight @ energies["energy"][:, at])
        shares = (weight @ each[turn : turn + 2] for each in (path.time, path.vibration, path.stored))
        instants.append((run.cutoff, run.modes, *shares))
    landscape["energy"] = columns[0]
    landscape["energy_converged"], landscape["energy_error"] = _limit(np.array(cutoffs), np.array(columns[1:]))
    names = ("cutoff[c/R]", "modes", "time[R/c]", "vibration", "stored")
    return {"landscape": landscape, "instants": {name: np.array(value) for name, value in zip(names, zip(*instants))}}


def _limit(cutoffs: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Values at 1/ω_c = 0 of parabolas through three cutoffs, and their errors.

    Errors: the distance to lines through the last two points, and 2·10⁻⁴ for the steps in time.
    """
    x = 1.0 / cutoffs
    curved = np.array([np.polyfit(x, column, 2)[-1] for column in values.T])
    straight = values[2] - x[2] * (values[1] - values[2]) / (x[1] - x[2])
    return curved, np.abs(curved - straight) + 2e-4 * curved


def draw(tables: Tables) -> Figure:
    table = tables["landscape"]
    height = np.log10(np.maximum(table["energy"], 1e-30)).reshape(ORDERS, INDICES)
    with matplotlib.rc_context(PRINT):
        figure = Figure(figsize=(PAGE, 3.5))
        _landscape(figure.add_axes((0.015, -0.04, 0.53, 1.04), projection="3d", computed_zorder=False), height)
        axes = figure.add_axes((0.58, 0.14, 0.41, 0.75))
        colours = matplotlib.colormaps["viridis"]
        axes.imshow(height.T, origin="lower", cmap=colours, vmin=FLOOR, vmax=0.0, aspect="auto")
        for n in range(ORDERS):
            for l in range(INDICES):
                light = height[n, l] > 0.4 * FLOOR
                text = f"{height[n, l]:.1f}".replace("-", "−")
                axes.text(n, l, text, ha="center", va="center", fontsize=6.0, color="black" if light else "white")
        axes.set_xticks(range(ORDERS))
        axes.set_yticks(range(INDICES))
        axes.set_xlabel("angular order n")
        axes.set_ylabel("index l")
        small_ticks(axes)
        axes.tick_params(length=0)
        axes.set_title("(b) log₁₀ of energy / initial energy", loc="left")
        figure.text(0.02, 0.915, "(a) energy / initial energy", fontsize=PRINT["axes.titlesize"])
    return figure


def _landscape(axes: Axes3D, height: np.ndarray) -> None:
    """Bars from the floor, painted from the back, in the colours of the table beside them."""
    colours = matplotlib.colormaps["viridis"]
    size = 0.62
    for l in reversed(range(INDICES)):
        for n in reversed(range(ORDERS)):
            if height[n, l] <= FLOOR:
                continue
            axes.bar3d(
                n - size / 2, l - size / 2, FLOOR, size, size, height[n, l] - FLOOR,
                color=colours(1.0 - height[n, l] / FLOOR), edgecolor="black", linewidth=0.25, shade=True,
                zorder=(INDICES - l) * ORDERS + (ORDERS - n),
            )  # fmt: skip
    axes.view_init(elev=32, azim=-118)
    axes.set_box_aspect((ORDERS, 0.95 * INDICES, 7.5), zoom=0.95)
    axes.set_zlim(FLOOR, 0.0)
    axes.set_xticks(range(0, ORDERS, 2))
    axes.set_yticks(range(0, INDICES, 2))
    axes.zaxis.set_major_locator(FixedLocator(list(range(int(FLOOR), 1, 2))))
    axes.zaxis.set_major_formatter(FuncFormatter(lambda z, _: f"$10^{{{z:.0f}}}$" if z else "1"))
    axes.tick_params(labelsize=PRINT["xtick.labelsize"], pad=-2)
    axes.tick_params(axis="z", pad=1)
    axes.set_xlabel("angular order n", labelpad=-6)
    axes.set_ylabel("index l", labelpad=-6)
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.pane.set_facecolor("white")
        axis._axinfo["grid"].update(linewidth=0.4, color="0.85")


def _ranks(table: Table) -> list[tuple[int, int]]:
    order = np.argsort(-table["energy"], kind="stable")
    return [(int(table["order"][k]), int(table["index"][k])) for k in order]


def numbers(tables: Tables) -> list[Row]:
    table, instants = tables["landscape"], tables["instants"]
    best = _ranks(table)
    rows: list[Row] = [("most energetic mode (n, l) at closest approach", "(2, 0)", f"{best[0]}", f"{best[0]}")]
    reached = place(table, *best[1])
    ratio = table["energy"].max() / table["energy"][reached]
    limit = table["energy_converged"].max() / table["energy_converged"][reached]
    rows.append(("energy of (2, 0) over that of the next mode", "“dominated”", f"{ratio:.2f}", f"{limit:.2f}"))
    rows.append(("the five most energetic, in order", NONE, ", ".join(f"({n}, {l})" for n, l in best[:5]), NONE))
    for n, l in NAMED:
        k = place(table, n, l)
        limit = measured(table["energy_converged"][k], table["energy_error"][k])
        name = f"energy of ({n}, {l}) at closest approach, over the initial energy"
        rows.append((name, NONE, f"{table['energy'][k]:.4f}", limit))
    name = "energy of all modes at closest approach, over the initial energy"
    rows.append((name, NONE, f"{instants['vibration'][0]:.4f}", NONE))
    name = "energy of the wall’s potential at closest approach, over the initial energy"
    rows.append((name, NONE, f"{instants['stored'][0]:.4f}", NONE))
    return rows


def meaning(tables: Tables) -> str:
    table, instants = tables["landscape"], tables["instants"]
    share = np.sort(table["energy"])[::-1]
    whole, soft = instants["vibration"][0], instants["stored"][0]
    lowest, radial = (table["energy"][table[name] == 0].sum() / whole for name in ("index", "order"))
    first, last = (table["energy"][place(table, 0, l)] for l in (0, INDICES - 1))
    return (
        f"When the disk turns, {100 * whole:.0f} % of its energy is in the modes and {100 * soft:.1f} % in the soft "
        f"wall. The quadrupolar mode (2, 0) holds {100 * share[0]:.0f} % of the initial energy, "
        f"{share[0] / share[1]:.1f} times as much as the next, as the paper says. The two ridges are those it names: l "
        f"= 0 holds {100 * lowest:.0f} % of the vibrational energy, the purely radial modes n = 0 hold "
        f"{100 * radial:.0f} %, and their ridge falls as 1/ω², from {power(first)} to {power(last)}."
    )
