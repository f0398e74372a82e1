"""What the text says about the modes: which of them matter.

The paper ranks the modes "according to their average energy content in a preliminary run" and
finds: "the purely radial modes [eq. 20] are particularly important. Typically 75 % of the most
significant modes have n = 0. Another essential class of modes has l = 0." Here the preliminary run
has all modes with ω ≤ 140 c/R, at the exponential wall (eq. 40) with αv = 50 c/R, which is the αR =
500 of the paper's table at v = 0.1 c. Of the N most energetic modes the shares with n = 0 and with
l = 0 are counted; and the share of the modes' energy that each class holds. The shares depend on
how many modes compete; "converged" are those of a preliminary run with ω ≤ 300 c/R, 40 174 modes.
"""

from __future__ import annotations

import matplotlib
import numpy as np
import stoss
from matplotlib.figure import Figure

from gerl_zippelius_1999.common import (
    BLACK, COLORS, GREY, LINES, NONE, PAGE, PRINT, Row, Table, Tables, axes_of, legend,
)  # fmt: skip
from gerl_zippelius_1999.two_limits import POISSON, ranked

TITLE = "In the text: which modes matter"
CAPTION = (
    "Share of the N modes of highest mean energy in contact that have (a) n = 0, the purely radial modes, and (b) l = "
    "0, the lowest of each order; ν = 0.33, exponential walls with αv = 50 c/R, the modes ranked in a run with all "
    "that have ω ≤ 140 c/R; black: with all below 300 c/R, v = 0.1 c. Dashed: the 75 % that the paper names for n = 0. "
    "Crosses: counted in the paper’s own Table 1 (N = 10)."
)

SPEEDS = (0.01, 0.04, 0.1, 0.2, 0.3)  # c
COUNTS = (10, 30, 100, 300, 940, 1600)
BOUNCE = 50.0  # αv, c/R
SPEED = 0.1  # c, of the paper's table
CUTOFF, QUICK_CUTOFF = 140.0, 62.0  # c/R; 8801 and 1752 modes
LARGE, QUICK_LARGE = 300.0, 90.0  # c/R; 40 174 and 3663 modes
TYPICAL = 0.75  # the paper's share for n = 0
TABLE_1 = {"order": 0.3, "index": 0.7}  # of the ten modes of the paper's table


def compute(quick: bool) -> Tables:
    cutoff, large = (QUICK_CUTOFF, QUICK_LARGE) if quick else (CUTOFF, LARGE)
    shares: dict[str, list[float]] = {
        name: [] for name in ("speed[c]", "cutoff[c/R]", "modes", "share_n0", "share_l0", "all_n0")
    }  # fmt: skip
    sums_of = ("average", "average_n0", "average_l0", "after", "after_n0", "after_l0")
    energy: dict[str, list[float]] = {name: [] for name in ("speed[c]", "cutoff[c/R]", "modes", *sums_of)}
    for speed, highest in (*((speed, cutoff) for speed in SPEEDS), (SPEED, large)):
        wall = stoss.ExponentialWall(hardness=BOUNCE / speed)
        modes = stoss.impact(poisson=POISSON, speed=speed, cutoff=highest, against=wall, tail="none").mode_energies
        best = modes[ranked(modes)]
        for count in _counts():
            radial = best["order"][:count] == 0
            exhausted = radial.sum() == np.count_nonzero(modes["order"] == 0)  # with more modes there would be more
            row = (speed, highest, count, radial.mean(), (best["index"][:count] == 0).mean(), exhausted)
            for column, value in zip(shares.values(), row):
                column.append(float(value))
        sums = [modes[when][chosen].sum() for when in ("average", "after")
                for chosen in (slice(None), modes["order"] == 0, modes["index"] == 0)]  # fmt: skip
        for column, value in zip(energy.values(), (speed, highest, len(modes), *sums)):
            column.append(float(value))
    return {"shares": _arrays(shares), "energy": _arrays(energy)}


def _counts() -> list[int]:
    """The N of the numbers, and more of them for smooth lines."""
    return sorted({*COUNTS, *(int(round(n)) for n in np.geomspace(10, 1600, 45))})


def _arrays(columns: dict[str, list[float]]) -> Table:
    return {name: np.array(values) for name, values in columns.items()}


def _share(tables: Tables, kind: str, speed: float, count: int, large: bool = False) -> float:
    """In the run of this speed, or in that in which the most modes compete."""
    table = tables["shares"]
    chosen = (table["speed[c]"] == speed) & (table["modes"] == count)
    return float(table[kind][chosen][-1 if large else 0])


def draw(tables: Tables) -> Figure:
    with matplotlib.rc_context(PRINT):
        figure, panels = axes_of(PAGE, 2.7, 1, 2, sharey=True)
        table = tables["shares"]
        for axes, kind, name, key in zip(panels, ("share_n0", "share_l0"), ("(a) n = 0", "(b) l = 0"), TABLE_1):
            low, high = table["cutoff[c/R]"].min(), table["cutoff[c/R]"].max()
            for k, speed in enumerate(SPEEDS):
                chosen = (table["speed[c]"] == speed) & (table["cutoff[c/R]"] == low)
                line = {"color": COLORS[k], "linestyle": LINES[k], "label": f"v = {speed:g} c"}
                axes.plot(table["modes"][chosen], 100.0 * table[kind][chosen], **line)
            chosen = table["cutoff[c/R]"] == high
            label = f"v = {SPEED:g} c, ω ≤ {high:g} c/R"
            axes.plot(
                table["modes"][chosen], 100.0 * table[kind][chosen], color=BLACK, linewidth=0.7, zorder=1.5, label=label
            )
            label = "the paper’s Table 1"
            axes.plot(10, 100.0 * TABLE_1[key], "x", color=BLACK, markersize=6, markeredgewidth=1.4, label=label)
            axes.set_xscale("log")
            axes.set_xlabel("number N of most energetic modes")
            axes.set_title(name, loc="left")
            axes.set_xlim(9.0, 1800.0)
        panels[0].axhline(100.0 * TYPICAL, color=GREY, linestyle="--", linewidth=1.0)
        panels[0].text(
            1600, 100.0 * TYPICAL + 1.0, "“Typically 75 %”", ha="right", va="bottom", fontsize=7.0, color="0.3"
        )
        panels[0].set_ylim(0.0, 100.0)
        panels[0].set_ylabel("share of these modes / %")
        legend(panels[1], loc="upper right")
    return figure


def numbers(tables: Tables) -> list[Row]:
    rows: list[Row] = []
    for kind, what, paper in (("share_n0", "n = 0", "“Typically 75 %”"), ("share_l0", "l = 0", "“essential class”")):
        for count in COUNTS:
            values = [100.0 * _share(tables, kind, speed, count) for speed in SPEEDS]
            here, limit = (100.0 * _share(tables, kind, SPEED, count, large) for large in (False, True))
            bound = "≥ " if kind == "share_n0" and _share(tables, "all_n0", SPEED, count, large=True) else ""
            table_1 = TABLE_1["order" if kind == "share_n0" else "index"]
            said = paper if count != 10 else f"{paper}; {10 * table_1:.0f} of 10 in Table 1"
            got = f"{here:.1f} % ({min(values):.1f} to {max(values):.1f} % for v = 0.01 to 0.3 c)"
            name = f"modes with {what} among the {count} most energetic, v = 0.1 c"
            rows.append((name, said, got, f"{bound}{limit:.1f} %"))
    table, k = tables["energy"], SPEEDS.index(0.1)
    names = (("average", "mean energy of all modes in contact"), ("after", "energy of all modes after the impact"))
    for when, name in names:
        for kind, what in (("n0", "n = 0"), ("l0", "l = 0")):
            part = 100.0 * table[f"{when}_{kind}"] / table[when]
            got = f"{part[k]:.0f} % ({part.min():.0f} to {part.max():.0f} %)"
            limit = f"{part[-1]:.0f} %"
            rows.append((f"share of modes with {what} in the {name}, v = 0.1 c", NONE, got, limit))
    return rows


def meaning(tables: Tables) -> str:
    top = 100.0 * tables["shares"]["share_n0"].max()
    energy, k = tables["energy"], SPEEDS.index(SPEED)
    radial, lowest = (100.0 * energy[name][k] / energy["average"][k] for name in ("average_n0", "average_l0"))
    plateau = 100.0 * _share(tables, "share_n0", SPEED, 300, large=True)
    ten = [100.0 * _share(tables, "share_l0", speed, 10) for speed in SPEEDS]
    more = [100.0 * _share(tables, "share_l0", SPEED, count) for count in (100, 300, 940)]
    return (
        f"No speed and no N from 10 on gives 75 % of modes with n = 0: the maximum share is {top:.0f} %, "
        f"and among hundreds of modes it is about {plateau:.0f} %, one in {100 / plateau:.0f}. The contact is so "
        "narrow that the wall drives about ten orders almost equally, and each of them has as many radial modes as n = "
        "0. The paper’s own table has three of ten. For l = 0 the number would fit, but only among the first ten: "
        f"{ten[SPEEDS.index(SPEED)]:.0f} % of them at v = 0.1 c, as in the table, and {min(ten):.0f} to {max(ten):.0f} "
        f"% over the speeds; of the first 100 to 940 it is {max(more):.0f} down to {min(more):.0f} % at v = 0.1 c. The "
        f"modes l = 0 do hold most of the mean energy in contact, {lowest:.0f} % at v = 0.1 c, against {radial:.0f} % "
        "for n = 0."
    )
