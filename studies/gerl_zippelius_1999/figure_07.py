"""Figure 7: the loss against the softness of the wall, extrapolated to the hard one.

The paper shows 1 − ε² after impacts on the wall V₀ e^{αx} (eqs. 40 and 41) against 1/α, with N =
940 modes and ν = 0.33, and regression lines that end at the hard wall, 1/α = 0; for v ≤ 0.1 c only
the three most significant points carry the line. It does not print which α it took, so the walls
are chosen here, in two series:

* scaled: αv/c = 25, 33.3, 50, 100, the same for all speeds and even in 1/α. On these walls the
  lines hold. On harder ones the edge, which lacks its high modes, begins to bounce.
* common: αR = 200 … 2000, the same walls for all speeds, as far as αv ≤ 200 c/R. This is the choice
  of a hand that does not follow the speed.

Both keep the 940 lowest modes, where the paper keeps those that rank first by average energy in a
preliminary run (figure 8 has the difference). Intercepts and slopes are those of plain regressions;
their errors are the standard errors times Student's factor for 95 %, 12.7 for three points, 4.3 for
more: these deviate from the line by curvature, and further points on a curve are no independent
witnesses.
"""

from __future__ import annotations

import matplotlib
import numpy as np
import stoss
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from gerl_zippelius_1999.common import (
    BLACK, GREY, NONE, PAGE, PRINT, Row, Table, Tables, axes_of, legend, measured, power, written,
)  # fmt: skip
from gerl_zippelius_1999.two_limits import POISSON, SCALED, SLOW, SPEEDS, colour, cutoff, line, lost_fraction, name_curve

TITLE = "Figure 7: the loss against the softness of the wall"
CAPTION = (
    "Lost fraction 1 − ε² after impacts on exponential walls V₀ exp(αx), against the softness of the wall; ν = 0.33, "
    "v/c = 0.005, 0.01, 0.02, 0.04, 0.06, …, 0.30, the N = 940 lowest modes (the paper ranks modes by their energy in "
    "a preliminary run; Figure 8 (b) shows what that changes). The paper does not print its values of α, so the walls "
    "are chosen here, in two ways. Left: one set of walls for all speeds, on the axis of the paper. Right: walls as "
    "hard as the speed demands, the same αv for all. Crosses: the walls with all modes, N → ∞, converged, at αR = 500 "
    "on the left; their pressure acts on the projected area (weights cos φ dφ), that of the paper along the edge "
    "(dφ), for which 1 − ε² is 0.2 % more at v = 0.1 c. Lines: regressions through the filled points, for v ≤ 0.1 c "
    "the three hardest walls. Hollow points are left out. Black bars: converged values, hard wall and all modes; what "
    "the lines miss on the right is mostly the effect of the missing modes (Figure 8)."
)

ALT = (
    "Two plots of seventeen nearly straight, falling lines each, one for each speed; they end at the hard wall a few "
    "per cent above black bars. On the left the lines of the slowest impacts are steep and cross. Crosses, the walls "
    "with all modes, lie a few per cent below the lines and point to the bars."
)

MODES = 940
COMMON = (200.0, 300.0, 500.0, 1000.0, 2000.0)  # α, 1/R
SOFT = 500.0  # of them, at which all modes are computed too
WITH_ALL_MODES = (0.02, 0.1, 0.2, 0.3)  # c
HARDEST = 200.0  # αv, c/R; beyond it 940 modes bounce
QUICK = (0.005, 0.01, 0.02, 0.04, 0.1, 0.2, 0.3)


def compute(quick: bool) -> Tables:
    speeds, at = QUICK if quick else SPEEDS, cutoff(MODES)
    impacts: dict[str, list[object]] = {}
    lines: dict[str, list[object]] = {}
    for series in ("scaled", "common"):
        for v in speeds:
            alphas = np.array(SCALED) / v if series == "scaled" else np.array([a for a in COMMON if a * v <= HARDEST])
            lost = np.array([lost_fraction(v, at, a) for a in alphas])
            used = np.arange(len(alphas)) >= (len(alphas) - 3 if v <= SLOW else 0)
            for a, loss, carries in zip(alphas, lost, used):
                wall = {"series": series, "speed[c]": v, "hardness[1/R]": a}
                _append(impacts, wall | {"lost_fraction": loss, "used": carries})
            fit = line(1.0 / alphas[used], lost[used])
            row = {"lost_fraction": fit.value, "lost_fraction_error": fit.error, "slope[1/R]": fit.slope}
            _append(lines, {"series": series, "speed[c]": v} | row)
    converged = stoss.restitution(poisson=POISSON, speed=speeds, tolerance=1e-3 if quick else 3e-4)
    hard = {name: np.asarray(getattr(converged, name)) for name in ("lost_fraction", "lost_fraction_error")}
    wall = stoss.ExponentialWall(hardness=SOFT)
    soft = stoss.restitution(poisson=POISSON, speed=speeds, against=wall, tolerance=1e-3 if quick else 3e-4)
    hard |= {f"soft_{name}": np.asarray(getattr(soft, name)) for name in ("lost_fraction", "lost_fraction_error")}
    return {
        "impacts": _arrays(impacts),
        "lines": _arrays(lines),
        "converged": {"speed[c]": np.array(speeds)} | hard,
        "all_modes": _all_modes(1e-3 if quick else 3e-4),
    }


def _all_modes(tolerance: float) -> Table:
    """N → ∞ on the scaled walls, where the paper has 940 modes."""
    columns: dict[str, list[object]] = {}
    for v in WITH_ALL_MODES:
        for scaled in SCALED:
            wall = stoss.ExponentialWall(hardness=scaled / v)
            found = stoss.restitution(poisson=POISSON, speed=v, against=wall, tolerance=tolerance)
            row = {"speed[c]": v, "hardness[1/R]": scaled / v}
            _append(columns, row | {n: getattr(found, n) for n in ("lost_fraction", "lost_fraction_error")})
    return _arrays(columns)


def _append(columns: dict[str, list[object]], row: dict[str, object]) -> None:
    for name, value in row.items():
        columns.setdefault(name, []).append(value)


def _arrays(columns: dict[str, list[object]]) -> Table:
    return {name: np.array(values) for name, values in columns.items()}


def _of(table: Table, series: str, speed: float | None = None) -> Table:
    kept = table["series"] == series
    if speed is not None:
        kept &= table["speed[c]"] == speed
    return {name: values[kept] for name, values in table.items()}


def draw(tables: Tables) -> Figure:
    with matplotlib.rc_context(PRINT):
        figure, (left, right) = axes_of(PAGE, 4.0, 1, 2, sharey=True)
        speeds, hard = tables["converged"]["speed[c]"], tables["converged"]["lost_fraction"]
        for axes, series, name in (
            (left, "common", "(a) the same walls for all speeds"),
            (right, "scaled", "(b) walls as hard as the speed demands"),
        ):
            reach = max(_draw_speed(axes, tables, series, v) for v in speeds)
            axes.axvline(0.0, color=GREY, linewidth=0.6, zorder=0)
            label = "converged: hard wall, all modes"
            axes.plot(
                np.zeros_like(hard), hard, "_", color=BLACK, markersize=10, markeredgewidth=1.1, zorder=4, label=label
            )
            axes.set_title(name, loc="left")
            axes.set_xlim(-0.035 * reach, 1.25 * reach)
            axes.locator_params(axis="x", nbins=6)
        _draw_all_modes(left, right, tables)
        left.set_xlabel("softness of the wall 1/(αR)")
        right.set_xlabel("softness times speed c/(αv)")
        left.set_ylabel("lost fraction 1 − ε²")
        left.set_ylim(-0.008, 0.335)  # with room for the legend
        legend(right, loc="upper right")
    return figure


def _draw_all_modes(left: Axes, right: Axes, tables: Tables) -> None:
    """The exponential walls with all modes."""
    style = {"color": BLACK, "markersize": 4.5, "markeredgewidth": 0.8, "zorder": 5}
    soft, walls = tables["converged"]["soft_lost_fraction"], tables["all_modes"]
    left.plot(np.full_like(soft, 1.0 / SOFT), soft, "x", **style)
    softness = 1.0 / (walls["speed[c]"] * walls["hardness[1/R]"])
    right.plot(softness, walls["lost_fraction"], "x", label="converged: these walls, all modes", **style)


def _draw_speed(axes: Axes, tables: Tables, series: str, v: float) -> float:
    points, fit = _of(tables["impacts"], series, v), _of(tables["lines"], series, v)
    scale = v if series == "scaled" else 1.0  # of the softness, for the axis
    x, y, used = 1.0 / (scale * points["hardness[1/R]"]), points["lost_fraction"], points["used"].astype(bool)
    ends = np.array([0.0, x[used].max()])
    axes.plot(ends, fit["lost_fraction"] + fit["slope[1/R]"] * scale * ends, color=colour(v), linewidth=0.9)
    axes.plot(x[used], y[used], "o", color=colour(v), markersize=2.8)
    axes.plot(x[~used], y[~used], "o", color=colour(v), markersize=2.8, markerfacecolor="white", markeredgewidth=0.7)
    last = int(np.argmax(x))
    if v in (0.1, 0.2, 0.3) or (v in (0.005, 0.04) and series == "common"):
        name_curve(axes, f"v = {v:g} c" if v == 0.3 else f"{v:g}", x[last], y[last])
    if v == 0.01 and series == "scaled":  # the slowest four are too close to have names of their own
        name_curve(axes, "≤ 0.04", x[last], y[last])
    return float(x.max())


def numbers(tables: Tables) -> list[Row]:
    rows: list[Row] = []
    limit, soft = tables["converged"], _of(tables["lines"], "common")
    fits = _of(tables["lines"], "scaled")
    for v in QUICK:
        k = int(np.flatnonzero(fits["speed[c]"] == v)[0])
        for fit, walls_are in ((fits, ""), (soft, ", the same walls for all speeds")):
            if v < 0.1 or fit is fits:
                protocol = measured(fit["lost_fraction"][k], fit["lost_fraction_error"][k])
                all_modes = measured(limit["lost_fraction"][k], limit["lost_fraction_error"][k])
                name = f"1 − ε² at v = {written(v)} c for α → ∞ with 940 modes{walls_are}"
                rows.append((name, NONE, protocol, f"{all_modes} (all modes)"))
    for v in QUICK:
        points = _of(tables["impacts"], "common", v)
        with_modes = points["lost_fraction"][points["hardness[1/R]"] == SOFT][0]
        k = int(np.flatnonzero(limit["speed[c]"] == v)[0])
        found = measured(limit["soft_lost_fraction"][k], limit["soft_lost_fraction_error"][k])
        name = f"1 − ε² at v = {written(v)} c on the wall αR = {SOFT:g}, with 940 modes"
        rows.append((name, NONE, f"{with_modes:.4f}", f"{found} (N → ∞)"))
    for v in WITH_ALL_MODES:
        walls, k = tables["all_modes"], int(np.flatnonzero(limit["speed[c]"] == v)[0])
        used = (walls["speed[c]"] == v) & (walls["hardness[1/R]"] >= SCALED[-3 if v <= SLOW else 0] / v)
        y, errors = walls["lost_fraction"][used], walls["lost_fraction_error"][used]
        fit = line(1.0 / walls["hardness[1/R]"][used], y, errors)
        all_modes = measured(limit["lost_fraction"][k], limit["lost_fraction_error"][k])
        name = f"1 − ε² at v = {written(v)} c for α → ∞, the line through the same walls with all modes"
        rows.append((name, NONE, measured(fit.value, fit.error), f"{all_modes} (hard wall)"))
    deviation = f"at most {power(_deviation(tables))} of 1 − ε²"
    rows.append(("largest deviation of points from their lines (b)", "“scales nicely with 1/α”", deviation, NONE))
    order = "yes" if np.all(np.diff(limit["lost_fraction"]) > 0) else "no, v = 0.005 c lies above 0.01 c"
    ordered = f"for αR ≤ {_ordered(tables):g}"
    rows.append(("curves from bottom to top in the order of speed", "“from bottom to top” (caption)", ordered, order))
    return rows


def _deviation(tables: Tables) -> float:
    """Largest relative deviation of a point from its line, on the walls that follow the speed."""
    fits, worst = _of(tables["lines"], "scaled"), 0.0
    for v, value, slope in zip(fits["speed[c]"], fits["lost_fraction"], fits["slope[1/R]"]):
        points = _of(tables["impacts"], "scaled", v)
        off = np.abs(points["lost_fraction"] - value - slope / points["hardness[1/R]"]) / points["lost_fraction"]
        worst = max(worst, float(off[points["used"].astype(bool)].max()))
    return worst


def _ordered(tables: Tables) -> float:
    """The hardest of the common walls on which a faster disk always loses the larger part, αR."""
    points = _of(tables["impacts"], "common")
    hardness = np.unique(points["hardness[1/R]"])
    # In a table the speeds ascend.
    in_order = [bool(np.all(np.diff(points["lost_fraction"][points["hardness[1/R]"] == a]) > 0)) for a in hardness]
    return float(hardness[in_order].max()) if any(in_order) else 0.0


def meaning(tables: Tables) -> str:
    limit = tables["converged"]["lost_fraction"]
    slow, fit = (_of(tables["lines"], series, 0.005) for series in ("common", "scaled"))
    same, scaled = (measured(each["lost_fraction"][0], each["lost_fraction_error"][0]) for each in (slow, fit))
    at = int(np.flatnonzero(tables["converged"]["speed[c]"] == 0.1)[0])
    missing = 100.0 * (_of(tables["lines"], "scaled", 0.1)["lost_fraction"][0] / limit[at] - 1.0)
    return (
        "The straight lines of the paper are real, but α has to follow the speed: a wall is hard when αv ≫ c, whatever "
        "α is. The paper does not print the α of this figure; both sets of walls are chosen here. On the same walls "
        f"for all speeds, as on the left, v = 0.005 c extrapolates to {same}, on walls that follow it to {scaled}; and "
        f"up to αR = {_ordered(tables):g} the curves lie in the order of speed, from bottom to top, as the caption of "
        "the paper has them. In the limit they do not: the slowest disk of the figure loses more "
        f"({limit[0]:.4f}) than the next ones. What remains between line and bar on the right, {missing:.1f} % at v = "
        "0.1 c, is mostly the effect of the modes above the 940th. All of this is with the lowest modes; the paper "
        "takes those that rank first in a preliminary run (Figure 8 (b))."
    )
