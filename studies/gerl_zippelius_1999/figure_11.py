"""Figure 11: contact time and maximum compression against the speed.

The paper integrates m δ̈ = −F(δ) with the force of eq. (56), shows τ c/R and (δ_max/R)(c/v), and
for τ also points of the full calculation; in the text δ_max ≃ v (R/c) √ln(4c/v) and τ ∝ (R/c)
√ln(4c/v) (eq. 60). Here the same with `stoss.quasistatic.slow_impact`, for the printed law and for
that of the centre of mass (docs/theory/errata.md, E8), next to the full solution at the hard wall
with its errors (`stoss.restitution`). It goes down to v = 1e-8 c; the paper had to stop at 0.005 c.

The exact asymptotes are δ_max = v√Λ and τ = π√Λ, Λ = ln(c/v) − (3 + ν)/4 for the centre
(docs/theory/quasistatic.md, "Slow impacts").

The paper does not say at which wall its points were computed. Here they are at αR = 500, as in
figure 10 and table 1, and at walls that are harder the slower the disk (αv = 50 c/R, equal at 0.1
c), both with the 940 modes of figure 7. At an exponential wall the contact has no beginning: its
contact time here is the time in which the force exceeds 1 % of its maximum. Its compression counts
as in figure 10.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import stoss
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray
from stoss import quasistatic

from .common import BLACK, BLUE, GREEN, GREY, NONE, ORANGE, PAGE, PURPLE
from .common import Row, Table, Tables, axes_of, legend, measured, power, written
from .printed_law import law_and_unit
from .soft_impacts import HARDNESS, MODES, POISSON, SCALED, soft

TITLE = "Figure 11: contact time and maximum compression against the speed"
CAPTION = (
    "(a) Contact time τ and (b) maximum compression δ_max, divided by the speed v, for ν = 0.33: quasi-static with "
    "eq. (56), the paper’s law of force against compression, and with the law of the centre of mass, and the full "
    "solution at the hard wall (points, larger than their errors). Diamonds: full solution in the paper’s way with 940 "
    "modes, at the wall αR = 500 and at walls αv = 50 c/R, which are choices made here; there, contact is counted "
    "while the force exceeds 1 % of its maximum (at the hard wall this would shorten it by 2 % at 0.2 c, Figure 5), "
    "and compression from the plane where the wall’s pressure is 0.1 E. Grey: √ln(4c/v) of eq. (60), small speeds, in "
    "(a) times π. The curves end where the laws end. (c), (d) The same as deviations from the full solution; the "
    "slowest at αR = 500 lie beyond the axes."
)
ALT = "Contact time and maximum compression over speed fall slowly with ln v; quasi-static curves follow the points."

LAWS = ("printed", "center")
MARKS = (1e-8, 1e-6, 1e-4, 0.01, 0.04, 0.1)  # of the table, c
PAPER_SPEEDS = (0.005, 0.01, 0.02, 0.04, 0.06, 0.1, 0.2, 0.3)  # c
CLAIM = (
    "“agree well with the numerical simulations of the full dynamic problem in the range of velocities were both "
    "methods apply”"
)
STYLES = {"printed": (GREEN, "-", "the paper’s eq. (56)"), "center": (PURPLE, "--", "law of the centre (E8)")}


def speeds_of(per_decade: int) -> NDArray[np.float64]:
    """1e-8 … 0.1 c evenly, which has most marks in it, and a few more."""
    even = 10.0 ** (np.arange(-8 * per_decade, -per_decade + 1) / per_decade)
    return np.sort(np.concatenate([even, (0.005, 0.04, 0.2, 0.3)]))


def quasi_static(speeds: NDArray[np.float64]) -> Table:
    """By both laws; NaN beyond their ends."""
    table = {"speed[c]": speeds}
    for law in LAWS:
        own, scale = law_and_unit(law, POISSON)
        within = speeds <= scale * float(quasistatic.limit_speed(law=own, poisson=POISSON))
        impact = quasistatic.slow_impact(law=own, poisson=POISSON, speed=speeds[within] / scale)
        for name, unit, factor in (("contact_time", "R/c", 1.0), ("max_compression", "R", scale)):
            column = np.full(speeds.size, np.nan)
            column[within] = factor * getattr(impact, name)
            table[f"{law}_{name}[{unit}]"] = column
    return table


def dynamic(speeds: NDArray[np.float64], tolerance: float) -> Table:
    curve = stoss.restitution(poisson=POISSON, speed=speeds, tolerance=tolerance)
    return {
        "speed[c]": speeds,
        "contact_time[R/c]": curve.contact_time,
        "contact_time_error[R/c]": curve.contact_time_error,
        "max_compression[R]": curve.max_compression,
        "max_compression_error[R]": curve.max_compression_error,
    }


def compute(quick: bool) -> Tables:
    speeds = (0.005, 0.01, 0.1, 0.3) if quick else PAPER_SPEEDS
    return {
        "quasistatic": quasi_static(np.unique(np.concatenate([speeds_of(48), np.geomspace(0.1, 0.28, 40)]))),
        "dynamic": dynamic(speeds_of(2 if quick else 4), 1e-3 if quick else 2e-4),
        "soft": soft(speeds, scaled=False),
        "soft_scaled": soft(speeds, scaled=True),
    }


def printed_formula(speed: NDArray[np.float64]) -> NDArray[np.float64]:
    """Eq. (60) for δ_max c/(R v)."""
    return np.sqrt(np.log(4.0 / speed))


def draw_panel(above: Axes, below: Axes, tables: Tables, name: str, unit: str, *, reduced: bool, factor: float) -> None:
    """A quantity, over the speed if `reduced`; below it deviations from the full solution."""
    quasi, full = tables["quasistatic"], tables["dynamic"]
    v, points = quasi["speed[c]"], full["speed[c]"]
    per = (lambda speed: speed) if reduced else np.ones_like
    true = full[f"{name}[{unit}]"]
    here = quasi_at(tables, points)
    label = ("π " if factor != 1.0 else "") + "√ln(4c/v)"
    above.semilogx(v, factor * printed_formula(v), color=GREY, lw=0.8, label=label)
    below.semilogx(points, 100 * (factor * printed_formula(points) * per(points) / true - 1), color=GREY, lw=0.8)
    for law in LAWS:
        color, style, text = STYLES[law]
        curve = quasi[f"{law}_{name}[{unit}]"]
        above.plot(v, curve / per(v), style, color=color, label=text)
        below.plot(points, 100 * (here[f"{law}_{name}[{unit}]"] / true - 1), style, color=color)
    error = full[f"{name}_error[{unit}]"]
    dots: dict[str, Any] = {"fmt": "o", "ms": 3, "color": BLUE, "lw": 0.8}
    above.errorbar(points, true / per(points), error / per(points), label="full, hard wall", **dots)
    below.errorbar(points, np.zeros_like(points), 100 * error / true, **dots)
    for table, color, text in (("soft", ORANGE, f"αR = {HARDNESS:g}"), ("soft_scaled", BLACK, f"αv = {SCALED:g} c/R")):
        wall, speed = tables[table], tables[table]["speed[c]"]
        column = wall[next(key for key in wall if key.startswith(name))]
        style: dict[str, Any] = {"ls": "none", "marker": "D", "ms": 3.5, "mfc": "none", "mew": 0.8, "color": color}
        above.plot(speed, column / per(speed), **style, label=f"full, {text}, {MODES} modes")
        nearest = np.exp(np.interp(np.log(speed), np.log(points), np.log(true)))
        below.plot(speed, 100 * (column / nearest - 1), **style)


def quasi_at(tables: Tables, speeds: NDArray[np.float64]) -> Table:
    """The quasi-static columns at other speeds, linear in ln v once divided by the speed."""
    table = tables["quasistatic"]
    known, found = table["speed[c]"], Table()
    for key, column in table.items():
        power_of = 1 if "compression" in key else 0
        found[key] = np.interp(np.log(speeds), np.log(known), column / known**power_of) * speeds**power_of
    return found


def draw(tables: Tables) -> Figure:
    options: dict[str, Any] = {"sharex": "col", "gridspec_kw": {"height_ratios": (1.7, 1.0)}}
    figure, (time, depth, time_off, depth_off) = axes_of(PAGE, 4.6, 2, 2, **options)
    draw_panel(time, time_off, tables, "contact_time", "R/c", reduced=False, factor=np.pi)
    draw_panel(depth, depth_off, tables, "max_compression", "R", reduced=True, factor=1.0)
    time.set_ylabel("contact time τ (R/c)")
    depth.set_ylabel("δ$_{max}$ c / (R v)")
    for axes, label in zip((time, depth, time_off, depth_off), "abcd"):
        axes.set_title(f"({label})", loc="left")
    for axes in (time_off, depth_off):
        axes.set(xlabel="speed v (c)", ylabel="off by (%)", ylim=(-11, 11), xlim=(6e-9, 0.45))
        axes.axhline(0.0, color=BLACK, lw=0.5)
    legend(time, loc="lower left")
    time.set_ylim(3.5, 14.8)
    depth.set_ylim(0.0, 4.8)
    return figure


def row_at(table: Table, speed: float) -> dict[str, float]:
    """The row of a speed of the table; the nearest one."""
    i = int(np.argmin(np.abs(np.log(table["speed[c]"] / speed))))
    return {key: float(column[i]) for key, column in table.items()}


def deviation(tables: Tables, law: str, lowest: float, highest: float, full: str = "dynamic") -> tuple[float, float]:
    """The maximum deviation of the contact time from a full solution, per cent, and its speed."""
    speeds, key = tables[full]["speed[c]"], "contact_time[R/c]"
    off = 100.0 * (quasi_at(tables, speeds)[f"{law}_{key}"] / tables[full][key] - 1.0)
    off[(speeds < 0.999 * lowest) | (speeds > 1.001 * highest)] = np.nan
    worst = int(np.nanargmax(np.abs(off)))
    return float(off[worst]), float(speeds[worst])


def numbers(tables: Tables) -> list[Row]:
    rows: list[Row] = []
    for v in MARKS:
        quasi, full = row_at(tables["quasistatic"], v), row_at(tables["dynamic"], v)
        words = "{}; law of the centre {}"
        time, depth = (
            words.format(*(written(quasi[f"{law}_{name}"] / per) for law in LAWS))
            for name, per in (("contact_time[R/c]", 1.0), ("max_compression[R]", v))
        )
        at = "v = " + (f"{v:g}" if v >= 1e-3 else power(v, 0).removeprefix("1·")) + " c"
        rows += [
            (f"τ c/R at {at}", NONE, time, measured(full["contact_time[R/c]"], full["contact_time_error[R/c]"])),
            (f"δ_max c/(R v) at {at}", f"{written(float(printed_formula(np.array(v))))} (eq. 60)", depth,
             measured(full["max_compression[R]"] / v, full["max_compression_error[R]"] / v)),
        ]  # fmt: skip
    for v in (0.005, 0.01, 0.1):
        walls, full = (row_at(tables[name], v) for name in ("soft", "soft_scaled")), row_at(tables["dynamic"], v)
        each = (f"{written(wall['contact_time[R/c]'])} at αR = {wall['hardness[1/R]']:g}" for wall in walls)
        words = "; ".join(dict.fromkeys(each))
        true = measured(full["contact_time[R/c]"], full["contact_time_error[R/c]"])
        rows.append((f"τ c/R at v = {v:g} c: full solution, 940 modes", NONE, words, true))
    for ends in ((0.005, 0.04), (0.005, 0.3)):
        worst = (deviation(tables, "printed", *ends, full) for full in ("soft", "soft_scaled", "dynamic"))
        soft, scaled, hard = (f"{off:+.1f} % (at {v:g} c)".replace("-", "−") for off, v in worst)
        name = "maximum deviation of the quasi-static τ from the full one, v = {:g} to {:g} c".format(*ends)
        rows.append((name, CLAIM, f"{soft} for αR = {HARDNESS:g}; {scaled} for αv = {SCALED:g} c/R", hard))
    slowest, full = row_at(tables["quasistatic"], MARKS[0]), row_at(tables["dynamic"], MARKS[0])
    root = float(printed_formula(np.array(MARKS[0])))
    for name, per, paper, limit in (
        ("contact_time[R/c]", 1.0, "a constant (eq. 60)", "π for v → 0"),
        ("max_compression[R]", MARKS[0], "1 (eq. 60)", "1 for v → 0"),
    ):
        quantity = "τ c/R" if per == 1.0 else "δ_max c/(R v)"
        protocol = f"{written(slowest[f'printed_{name}'] / per / root)} at 10⁻⁸ c; {limit}"
        error = full[name.replace("[", "_error[")] / per / root
        rows.append((f"{quantity} / √ln(4c/v)", paper, protocol, measured(full[name] / per / root, error)))
    return rows


def meaning(tables: Tables) -> str:
    slow, fast = row_at(tables["dynamic"], 1e-8), row_at(tables["dynamic"], 0.1)
    printed, center = (abs(deviation(tables, law, 0.0, 0.01)[0]) for law in LAWS)
    printed_slow, center_slow = (abs(deviation(tables, law, 0.0, 1e-4)[0]) for law in LAWS)
    up_to, at = (deviation(tables, "printed", *ends)[0] for ends in ((0.005, 0.04), (0.1, 0.1)))
    soft, full = (" and ".join(f"{row_at(tables[name], v)['contact_time[R/c]']:.2f}" for v in (0.01, 0.005))
                  for name in ("soft", "dynamic"))  # fmt: skip
    return (
        f"Seven decades of speed change the contact time only from {written(fast['contact_time[R/c]'], 3)} to "
        f"{written(slow['contact_time[R/c]'], 3)} R/c: it grows as the square root of a logarithm. Up to v = 0.01 c "
        f"the quasi-static time deviates from the full solution by at most {center:.1f} % with the law of the centre "
        f"and {printed:.1f} % with the printed law, up to 10⁻⁴ c by {center_slow:.1f} % and {printed_slow:.1f} %. The "
        "paper’s statement of good agreement holds on walls that are hard enough for the speed, and as long as the "
        f"impact is slow: from 0.005 to 0.04 c the printed law is at most {abs(up_to):.1f} % off the hard wall, at "
        f"0.1 c {written(at, 2)} %. With αR = {HARDNESS:g} for all speeds slow impacts last far longer: {soft} R/c at "
        f"0.01 and 0.005 c, at the hard wall {full}. The factor that the paper leaves open in τ is π: π√ln(4c/v) is "
        f"{written(np.pi * np.sqrt(np.log(4e8)))} R/c at 10⁻⁸ c. That it fits so well down there is chance, because "
        "the 4 has no meaning to this order."
    )
