"""Figure 8: the loss against the number of modes, extrapolated to all of them.

The paper takes the hard-wall limits of figure 7 for N = 300, 400, 600, 940 modes and extends them
along lines in 1/√N to N → ∞; that is its result, the points of figure 1. The modes left out would
let the edge yield by 2/(πω_c) per pressure and impedance, and ω_c ∝ √N; so it is for the N lowest
modes, with which the left picture is made (`two_limits`, walls as in figure 7).

The paper selects differently: the modes are ranked by their average energy in a preliminary run,
and the first N are kept. The right picture does that for two speeds, with preliminary runs of 1600
modes, as many as Table 1 has, and of 4500. One ranking serves all walls of a speed; its preliminary
run is on the second hardest of them. The walls, with the same αv for all speeds, are a choice made
here: the paper does not print its α.
"""

from __future__ import annotations

import matplotlib
import numpy as np
import stoss
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from gerl_zippelius_1999.common import BLACK, BLUE, GREEN, GREY, NONE, PAGE, PRINT, VERMILION
from gerl_zippelius_1999.common import Row, Table, Tables, axes_of, legend, measured, written
from gerl_zippelius_1999.two_limits import (
    COUNTS, POISSON, SPEEDS, Line, colour, cutoff, line, lost_fraction, name_curve, ranked_intercepts, two_limits,
    walls,
)  # fmt: skip

TITLE = "Figure 8: the loss against the number of modes"
CAPTION = (
    "Left: lost fraction 1 − ε² at an infinitely hard wall, the intercepts as in Figure 7 (b), against 1/√N for the "
    "N = 300, 400, 600 and 940 lowest modes, with regression lines; ν = 0.33, v/c = 0.005, 0.01, 0.02, 0.04, …, 0.30. "
    "Black bars: converged values. The paper ranks modes by their energy in a preliminary run and does not print its "
    "values of α; the lowest modes and the walls, with the same αv for all speeds, are chosen here. Right: how much "
    "the intercepts exceed the converged value, for the N lowest modes (open: more modes than the paper has) and for "
    "the N modes that rank first by energy in a preliminary run with 1600 or 4500 modes, the choice of the paper. "
    "Lines: regressions through the paper’s four N. The errors of the points, not drawn, are up to a few per cent, as "
    "large as many of the differences between the series."
)

ALT = (
    "Left: seventeen nearly level lines over one over root N, one for each speed, that end at black bars. Right: six "
    "series of points with lines; the ranked modes lie lower than the lowest ones, on flatter or lower lines, which "
    "miss zero."
)

MORE = (1900, 3760)
POOLS = (1600, 4500)  # modes of the preliminary run
STUDIED = (0.1, 0.3)  # c, right picture


def compute(quick: bool) -> Tables:
    speeds = (0.005, 0.02, 0.1, 0.3) if quick else SPEEDS
    intercepts: list[tuple[object, ...]] = []
    limits: list[tuple[object, ...]] = []
    for v in speeds:
        lowest: list[tuple[object, ...]] = [
            (v, "lowest", n, *at[:2]) for n, at in zip(COUNTS, two_limits(POISSON, v, walls(v)).hard_wall)
        ]
        limits.append((v, "lowest", *_limit(lowest)))
        intercepts += lowest
    for v in STUDIED[1:] if quick else STUDIED:
        if not quick:
            lost = {n: [lost_fraction(v, cutoff(n), alpha) for alpha in walls(v)] for n in MORE}
            further: list[tuple[object, ...]] = [(v, "more", n, *_hard(v, lost[n])) for n in MORE]
            last = [row for row in intercepts if row[:3] == (v, "lowest", COUNTS[-1])] + further
            limits.append((v, "more", *_limit(last)))
            intercepts += further
        for pool in (600,) if quick else POOLS:
            first = (150, 200, 300) if quick else COUNTS
            found_ranked = ranked_intercepts(POISSON, v, pool, first)
            chosen = [(v, f"first of {pool}", n, *at) for n, at in zip(first, found_ranked)]
            intercepts += chosen
            limits.append((v, f"first of {pool}", *_limit(chosen)))
    converged = stoss.restitution(poisson=POISSON, speed=speeds, tolerance=1e-3 if quick else 3e-4)
    hard = {name: np.asarray(getattr(converged, name)) for name in ("lost_fraction", "lost_fraction_error")}
    hard["speed[c]"] = np.array(speeds)
    names = ("speed[c]", "modes_are", "modes", "lost_fraction", "lost_fraction_error")
    fits = ("speed[c]", "modes_are", "lost_fraction", "lost_fraction_error", "slope", "slope_error")
    return {"hard_wall": _table(names, intercepts), "limits": _table(fits, limits), "converged": hard}


def _table(names: tuple[str, ...], rows: list[tuple[object, ...]]) -> Table:
    return {name: np.array(column) for name, column in zip(names, zip(*rows))}


def _limit(intercepts: list[tuple[object, ...]]) -> Line:
    n, value, error = (np.array([row[k] for row in intercepts], dtype=float) for k in (2, 3, 4))
    return line(n**-0.5, value, error)


def _hard(speed: float, lost: object) -> tuple[float, float]:
    return line(1.0 / walls(speed), np.asarray(lost, dtype=float))[:2]


def _of(table: Table, speed: float, which: str) -> Table:
    kept = (table["speed[c]"] == speed) & (table["modes_are"] == which)
    return {name: values[kept] for name, values in table.items()}


def draw(tables: Tables) -> Figure:
    with matplotlib.rc_context(PRINT):
        figure, (left, right) = axes_of(PAGE, 3.8, 1, 2, width_ratios=(1.0, 1.0))
        speeds, hard = tables["converged"]["speed[c]"], tables["converged"]["lost_fraction"]
        for v in speeds:
            points, fit = _of(tables["hard_wall"], v, "lowest"), _of(tables["limits"], v, "lowest")
            x = points["modes"] ** -0.5
            ends = np.array([0.0, x.max()])
            left.plot(ends, fit["lost_fraction"] + fit["slope"] * ends, color=colour(v), linewidth=0.9)
            left.plot(x, points["lost_fraction"], "o", color=colour(v), markersize=2.8)
            if v in (0.01, 0.06, 0.1, 0.2, 0.3):
                text = {0.3: "v = 0.3 c", 0.01: "0.005 … 0.04"}.get(v, f"{v:g}")
                name_curve(left, text, x.max(), points["lost_fraction"][0] + (0.003 if v == 0.01 else 0.0))
        bars = {"color": BLACK, "markersize": 10, "markeredgewidth": 1.1, "zorder": 4}
        left.plot(np.zeros_like(hard), hard, "_", label="converged: hard wall, all modes", **bars)
        left.set_title("(a) the N lowest modes", loc="left")
        left.set_ylabel("lost fraction 1 − ε², hard wall")
        left.set_xlim(-0.0025, 0.079)
        left.set_ylim(0.0, 0.345)
        legend(left, loc="upper right")
        _draw_excess(right, tables)
        for axes in (left, right):
            axes.axvline(0.0, color=GREY, linewidth=0.6, zorder=0)
            axes.set_xlabel("1/√N")
    return figure


def _draw_excess(axes: Axes, tables: Tables) -> None:
    """Relative excess over the converged value: a colour for each series, a marker for a speed."""
    series = np.unique(tables["limits"]["modes_are"])
    first = [str(name) for name in series if name.startswith("first")]
    colours = dict(zip(("lowest", *first), (BLUE, VERMILION, GREEN)))
    for v, marker, style in zip(STUDIED, ("s", "o"), ("--", "-")):
        if not np.any((tables["limits"]["speed[c]"] == v) & (tables["limits"]["modes_are"] != "lowest")):
            continue
        true = tables["converged"]["lost_fraction"][tables["converged"]["speed[c]"] == v]
        for name, color in colours.items():
            parts = (("limits", name), ("hard_wall", name), ("hard_wall", "more"))
            fit, points, more = (_of(tables[t], v, w) for t, w in parts)
            x = points["modes"] ** -0.5
            ends = np.array([0.0, x.max()])
            excess = 100.0 * ((fit["lost_fraction"] + fit["slope"] * ends) / true - 1.0)
            axes.plot(ends, excess, style, color=color, linewidth=0.9)
            excess = 100.0 * (points["lost_fraction"] / true - 1.0)
            axes.plot(x, excess, marker, color=color, label=f"{name}{' modes' * (name == 'lowest')}, v = {v:g} c")
            if name == "lowest" and len(more["modes"]):
                excess = 100.0 * (more["lost_fraction"] / true - 1.0)
                open_ones = {"markerfacecolor": "white", "markeredgewidth": 0.7}
                axes.plot(more["modes"] ** -0.5, excess, marker, color=color, **open_ones)
    axes.axhline(0.0, color=BLACK, linewidth=0.8)
    axes.set_title("(b) which modes are kept", loc="left")
    axes.set_ylabel("excess over the converged 1 − ε² / %")
    axes.set_xlim(-0.0025, 0.062)
    legend(axes, loc="upper left")


NAMES = {"lowest": "lowest modes", "more": "940, 1900 and 3760 lowest modes"}


def numbers(tables: Tables) -> list[Row]:
    rows, limits, hard = list[Row](), tables["limits"], tables["converged"]
    columns = (limits[each] for each in ("speed[c]", "modes_are", "lost_fraction", "lost_fraction_error"))
    for v, which, value, error in zip(*columns):
        if which == "lowest" and v not in (0.005, 0.01, 0.02, 0.04, 0.1, 0.2, 0.3):
            continue
        k = int(np.flatnonzero(hard["speed[c]"] == v)[0])
        chosen = NAMES.get(str(which), f"highest energy, {which}")
        converged = measured(hard["lost_fraction"][k], hard["lost_fraction_error"][k])
        rows.append((f"1 − ε² at v = {written(v)} c for N → ∞, {chosen}", NONE, measured(value, error), converged))
    rising = _rising(tables)
    within = ", where it rises by less than the errors" * (max(rising.values(), default=0.0) < 1.0)
    falls = f"all but {', '.join(f'{v:g}' for v in rising)} c{within}"
    paper = "“Raising the number of modes has the opposite effect”"
    rows.append(("speeds at which 1 − ε² falls from each N to the next", paper, falls if rising else "all", NONE))
    paper = "“The more violent collisions need a higher number of modes for the 1/√N regime to appear”"
    for v, slope, error, beyond, its_error in _slopes(tables):
        found = f"{measured(slope, error)} and {measured(beyond, its_error)}"
        rows.append((f"slope in 1/√N at v = {v:g} c, up to and beyond the 940 lowest modes", paper, found, NONE))
    return rows


def _rising(tables: Tables) -> dict[float, float]:
    """Speeds at which more modes lose more, with the maximum rise over its error."""
    points = {float(v): _of(tables["hard_wall"], v, "lowest") for v in tables["converged"]["speed[c]"]}
    errors = {v: each["lost_fraction_error"] for v, each in points.items()}
    rises = {v: np.diff(points[v]["lost_fraction"]) / np.hypot(errors[v][1:], errors[v][:-1]) for v in points}
    return {v: float(rise.max()) for v, rise in rises.items() if rise.max() >= 0.0}


def _slopes(tables: Tables) -> list[tuple[float, ...]]:
    """Speed, slope of the line through the paper's four N, slope beyond them, with errors."""
    fits = [(v, _of(tables["limits"], v, "lowest"), _of(tables["limits"], v, "more")) for v in STUDIED]
    return [(v, *(float(fit[name][0]) for fit in pair for name in ("slope", "slope_error")))
            for v, *pair in fits if len(pair[1]["slope"])]  # fmt: skip


def _end(tables: Tables, speed: float, which: str) -> str:
    """How far a line ends from the converged value, with its own error."""
    end, hard = _of(tables["limits"], speed, which), tables["converged"]
    value, error = (100.0 * end[name][0] / hard["lost_fraction"][hard["speed[c]"] == speed][0]
                    for name in ("lost_fraction", "lost_fraction_error"))  # fmt: skip
    off = f"{value - 100.0:+.1f} ± {error:.1f} %".replace("-", "−")
    return f"{off} ({'' if which == 'lowest' else which + ', '}v = {speed:g} c)"


def meaning(tables: Tables) -> str:
    limits, hard = tables["limits"], tables["converged"]
    off, sure = (limits[name][limits["modes_are"] == "lowest"] / hard["lost_fraction"]
                 for name in ("lost_fraction", "lost_fraction_error"))  # fmt: skip
    off = np.abs(off - 1.0)
    pairs = [(v, str(w)) for v, w in zip(limits["speed[c]"], limits["modes_are"]) if str(w).startswith("first")]
    drops, errors = [], []  # from the lowest modes to as many ranked ones, %
    for v, which in pairs:
        plain, chosen = (_of(tables["hard_wall"], v, each) for each in ("lowest", which))
        _, i, k = np.intersect1d(plain["modes"], chosen["modes"], return_indices=True)
        drops += list(100.0 * (1.0 - chosen["lost_fraction"][k] / plain["lost_fraction"][i]))
        both = np.hypot(plain["lost_fraction_error"][i], chosen["lost_fraction_error"][k])
        errors += list(100.0 * both / plain["lost_fraction"][i])
    text = (
        f"The two limits of the paper lead to the converged loss, within {100 * off.max():.0f} % at all speeds and "
        f"{100 * np.median(off):.1f} % at half of them, but with an uncertainty of {100 * np.median(sure):.0f} %. This "
        "is with the lowest modes and on walls chosen here: the paper ranks the modes, and does not print its α. "
        f"Ranked modes lose {min(drops):.1f} to {max(drops):.1f} % less than as many lowest ones, at "
        f"{np.sum(np.array(drops) > errors)} of {len(drops)} points by more than the errors. But a ranking in one "
        "preliminary run cannot follow 1/√N to the limit: with all modes of that run kept, they are again the lowest "
        f"ones. Their lines end {', '.join(_end(tables, *pair) for pair in pairs)} from the converged values, those of "
        f"the lowest modes {', '.join(_end(tables, v, 'lowest') for v in sorted({v for v, _ in pairs}))}."
    )
    for v, slope, error, beyond, its_error in _slopes(tables):
        ratio = f"{beyond / slope:.1f} times that of the line, {measured(slope, error)}"
        text += f" At v = {v:g} c the slope in 1/√N beyond N = 940, {measured(beyond, its_error)}, is {ratio}"
        text += "." if abs(beyond - slope) > np.hypot(error, its_error) else ", the same within the errors."
    return text
