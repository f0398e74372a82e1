"""Figure 5: a disk with v = 0.2 c hits the wall and leaves it vibrating.

The paper shows the deformed disk at several times and remarks that the deformations remaining after
the impact can be clearly identified. ν is not given; the paper's runs have 0.33. Here the wall is
hard (Signorini), with the modes up to ω = 50 c/R; deformations have their true size. The lower
panel shows continuously how much the diameters along and across the path differ from 2R.

The protocol of the paper is the exponential wall with αR = 500 and the 940 lowest modes, and for ε
the two extrapolations. Contact and compression at that wall are those of figures 10 and 11: contact
while the force is above 1 % of its maximum (for comparison also at the hard wall), compression from
the plane where the wall's pressure is 0.1 E. The force of so few modes swings with a period near
0.1 R/c, and its maximum is a spike; so the maximum mean over 0.2 R/c is given as well.
"""

from __future__ import annotations

import matplotlib
import numpy as np
import stoss
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from gerl_zippelius_1999.common import (
    BLACK, BLUE, GREY, NONE, PAGE, PRINT, VERMILION, Row, Tables, legend, measured, small_ticks, written,
)  # fmt: skip
from gerl_zippelius_1999.soft_impacts import HARDNESS, MODES, PRESSURE, SHARE, cutoff_of, soft
from gerl_zippelius_1999.two_limits import SCALED, two_limits

TITLE = "Figure 5: a disk with v = 0.2 c hits the wall"
CAPTION = (
    "Time sequence of a disk with ν = 0.33 that hits the wall at x = 0 (grey band) with v = 0.2 c; time in R/c from "
    "first contact. The arrow is the velocity of the centre of mass. Radii and circles were even before; deformations "
    "have their true size. Thin grey: radius R around the centre of mass. Below: change of the diameters along and "
    "across the path, with the times of the pictures marked; the shading is the contact. After it the disk goes on "
    "vibrating, mostly as a quadrupole."
)
ALT = (
    "Eight pictures of a disk: round before the wall, pressed flat and wide against it, then leaving it as an oval "
    "that is now long and now wide; below, its two diameters against time, which oscillate in opposite directions "
    "after the contact."
)

POISSON, SPEED = 0.33, 0.2
CIRCLES, SPOKES = 6, 24
AFTER = 9.0  # R/c after the contact that are shown
WINDOW = 0.2  # R/c, of the mean force


def compute(quick: bool) -> Tables:
    """The impact, its pictures, and the same by the paper's protocol."""
    hit = stoss.impact(poisson=POISSON, speed=SPEED, cutoff=25.0 if quick else 50.0)
    end = hit.contact_time
    period = 2.0 * np.pi / hit.mode_energies["omega"].min()
    path = hit.trajectory()
    closest = float(path.time[np.argmax(path.center)])
    # Even until the disk leaves, then the extremes of the quadrupole.
    free = np.linspace(end, end + 0.75 * period, 200)
    ends = hit.field(time=free, radius=[1.0], angle=[0.0, np.pi]).x[:, 0]
    shortest = free[np.argmin(ends[:, 0] - ends[:, 1])]
    later = shortest + np.array([0.0, 0.5, 1.0]) * period
    times = np.array([-1.0, 0.5 * closest, closest, 0.5 * (closest + end), end, *later])

    circles, around = np.arange(1, CIRCLES + 1) / CIRCLES, np.linspace(-np.pi, np.pi, 121)
    rings = hit.field(time=times, radius=circles, angle=around)
    along, spokes = np.linspace(0.0, 1.0, 21), -np.pi + 2.0 * np.pi * np.arange(SPOKES) / SPOKES
    rays = hit.field(time=times, radius=along, angle=spokes)
    lines = [_lines(rings.x, rings.y, 0), _lines(rays.x.swapaxes(1, 2), rays.y.swapaxes(1, 2), CIRCLES)]
    moments = np.sort(np.concatenate((np.linspace(-1.5, end + AFTER, 160 if quick else 400), times)))
    edge = hit.field(time=moments, radius=[1.0], angle=[0.0, 0.5 * np.pi, np.pi])
    after = hit.mode_energies[np.argsort(-hit.mode_energies["after"], kind="stable")[:5]]

    wall = stoss.ExponentialWall(hardness=HARDNESS)
    protocol = stoss.impact(poisson=POISSON, speed=SPEED, cutoff=cutoff_of(MODES), against=wall, tail="none")
    contact = soft((SPEED,), scaled=False)
    value = stoss.restitution(poisson=POISSON, speed=SPEED, tolerance=1e-3 if quick else 1e-4)
    limit = two_limits(POISSON, SPEED, np.array(SCALED) / SPEED)
    energies = protocol.mode_energies
    names = ("restitution", "lost_fraction", "contact_time", "max_compression", "max_force")
    at_wall = {
        **{name: getattr(protocol, name) for name in names}, "contact_time": np.nan,
        "max_compression": contact["max_compression_from_pressure_plane[R]"][0],
        "pressed_time": contact["contact_time[R/c]"][0], "mean_force": _mean_force(protocol.trajectory()),
        "quadrupole": energies["after"][(energies["order"] == 2) & (energies["index"] == 0)][0],
    }  # fmt: skip
    pressed = path.time[path.force > SHARE * path.force.max()]
    at_hard_wall = [pressed[-1] - pressed[0], _mean_force(path), after["after"][0]]
    return {
        "lines": {name: np.concatenate([each[name] for each in lines]) for name in lines[0]},
        "pictures": {
            "time[R/c]": times, "center[R]": np.asarray(rings.center),
            "velocity[c]": _velocity(path, times, hit.restitution),
        },
        "diameters": {
            "time[R/c]": moments, "along[R]": edge.x[:, 0, 0] - edge.x[:, 0, 2], "across[R]": 2.0 * edge.y[:, 0, 1],
        },
        "modes_after": {name: after[name] for name in ("order", "index", "omega", "after")},
        "values": {
            "quantity": np.array(list(at_wall)),
            "converged": np.array([getattr(value, name) for name in names] + at_hard_wall),
            "error": np.array([getattr(value, f"{name}_error") for name in names] + [np.nan] * len(at_hard_wall)),
            "soft_wall": np.array(list(at_wall.values())),
        },
        "limit": {
            f"{name}{error}": np.array([getattr(limit, f"{name}{error}")])
            for name in ("restitution", "lost_fraction") for error in ("", "_error")
        },
    }  # fmt: skip


def _mean_force(path: stoss.Trajectory) -> float:
    """The maximum mean of the force over a window of time."""
    time = np.linspace(path.time[0], path.time[-1], 20001)
    impulse = np.append(0.0, np.cumsum(np.interp(0.5 * (time[1:] + time[:-1]), path.time, path.force)))
    impulse *= time[1] - time[0]
    return float(np.max(np.interp(time + WINDOW, time, impulse) - impulse)) / WINDOW


def _lines(x: np.ndarray, y: np.ndarray, first: int) -> dict[str, np.ndarray]:
    """times × lines × points as columns, to six digits: more than a picture shows."""
    time, line, _ = np.indices(x.shape)
    places = {"x[R]": np.round(x.ravel(), 6), "y[R]": np.round(y.ravel(), 6)}
    return {"picture": time.ravel(), "line": line.ravel() + first} | places


def _velocity(path: stoss.Trajectory, times: np.ndarray, restitution: float) -> np.ndarray:
    inside = np.interp(times, path.time, path.velocity)
    return np.where(times <= 0.0, SPEED, np.where(times >= path.time[-1], -restitution * SPEED, inside))


def draw(tables: Tables) -> Figure:
    """Eight disks, and the diameters."""
    figure = Figure(figsize=(PAGE, 5.2), layout="constrained")
    above, below = figure.subfigures(2, 1, height_ratios=(3.4, 1.8))
    panels = above.subplots(2, 4, sharex=True, sharey=True)
    lines, pictures = tables["lines"], tables["pictures"]
    left = lines["x[R]"].min() - 0.1
    for k, axes in enumerate(panels.flat):
        here = lines["picture"] == k
        drawn, widths = [], []
        for number in range(CIRCLES + SPOKES):
            where = here & (lines["line"] == number)
            drawn.append(np.column_stack((lines["x[R]"][where], lines["y[R]"][where])))
            widths.append(1.1 if number == CIRCLES - 1 else 0.45)
        axes.add_collection(LineCollection(drawn, colors=BLUE, linewidths=widths, capstyle="round", zorder=2))
        angle, center = np.linspace(0.0, 2.0 * np.pi, 181), pictures["center[R]"][k]
        round_x = center + np.cos(angle)
        axes.plot(np.where(round_x <= 0.0, round_x, np.nan), np.sin(angle), color=GREY, linewidth=0.7, zorder=1.5)
        axes.add_patch(Rectangle((0.0, -2.0), 0.3, 4.0, facecolor="0.8", edgecolor="none", zorder=1))
        axes.axvline(0.0, color=BLACK, linewidth=1.0, zorder=1.8)
        speed = pictures["velocity[c]"][k]
        if abs(speed) > 0.02:
            look = {"arrowstyle": "-|>", "color": VERMILION, "mutation_scale": 9, "shrinkA": 0, "shrinkB": 0}
            axes.annotate("", (center + 3.0 * speed, 1.36), (center, 1.36), arrowprops=look)
        axes.set(aspect="equal", xlim=(left, 0.16), ylim=(-1.28, 1.5))
        axes.set_xticks([-3, -2, -1, 0])
        axes.set_yticks([-1, 0, 1])
        axes.set_title(f"{'abcdefgh'[k]}   t = {written(round(pictures['time[R/c]'][k], 2))}", loc="left", pad=3)
        axes.label_outer()
        small_ticks(axes)
        axes.set(xlabel="x / R" if k > 3 else "", ylabel="y / R" if k % 4 == 0 else "")
    _diameters(below.subplots(), tables)
    return figure


def _diameters(axes: matplotlib.axes.Axes, tables: Tables) -> None:
    table, pictures = tables["diameters"], tables["pictures"]
    time = table["time[R/c]"]
    contact = tables["values"]["converged"][list(tables["values"]["quantity"]).index("contact_time")]
    axes.axvspan(0.0, contact, facecolor="0.93", edgecolor="none")
    axes.axhline(0.0, color=GREY, linewidth=0.7)
    for name, color, line in (("across", BLUE, "-"), ("along", VERMILION, "--")):
        axes.plot(time, table[f"{name}[R]"] - 2.0, color=color, linestyle=line, label=f"{name} the path")
    high = max((table[name] - 2.0).max() for name in ("across[R]", "along[R]"))
    for name, at in zip("abcdefgh", pictures["time[R/c]"]):
        axes.axvline(at, color=GREY, linewidth=0.5, linestyle=":")
        axes.text(at, 1.22 * high, f" {name}", ha="left", va="center", fontsize=PRINT["legend.fontsize"])
    axes.set(xlim=(time[0], time[-1]), ylim=(None, 1.4 * high))
    axes.set(xlabel="time t / (R/c)", ylabel="change of diameter / R")
    legend(axes, loc="lower right", ncol=2)
    small_ticks(axes)


def numbers(tables: Tables) -> list[Row]:
    """ε and what else the impact is."""
    table, limit = tables["values"], tables["limit"]
    value = dict(zip(table["quantity"], zip(table["converged"], table["error"], table["soft_wall"])))
    rows = []
    for name, what in (("restitution", "ε"), ("lost_fraction", "1 − ε²")):
        protocol = measured(limit[name][0], limit[f"{name}_error"][0])
        rows.append((f"{what} at v = 0.2 c; protocol: both extrapolations", NONE, protocol, measured(*value[name][:2])))
    wall = f"protocol: αR = {HARDNESS:g}, {MODES} modes"
    named = {
        "pressed_time": f"time in R/c while the force is above {100 * SHARE:g} % of its maximum; {wall}",
        "max_compression": f"maximum compression in R; {wall}, from the plane where the pressure is {PRESSURE:g} E",
        "max_force": f"maximum force in πRE; {wall} (a spike of the truncated modes)",
        "mean_force": f"maximum mean force over {WINDOW:g} R/c, in πRE; {wall}",
        "quadrupole": f"share of the energy left in (2, 0); {wall}",
    }
    rows.append(("contact time in R/c", NONE, NONE, measured(*value["contact_time"][:2])))
    for name, what in named.items():
        found, error, at_wall = value[name]
        if np.isnan(error):
            rows.append((what, NONE, written(at_wall, 3), written(found, 3)))
        else:
            rows.append((what, NONE, written(at_wall), measured(found, error)))
    what = "maximum change of the diameter across the path after the impact, in R"
    rows.append((what, "“clearly identified”", NONE, written(_left(tables), 2)))
    return rows


def _left(tables: Tables) -> float:
    """Amplitude of the vibration that is left."""
    table = tables["diameters"]
    after = table["time[R/c]"] > tables["pictures"]["time[R/c]"][4]
    return float(np.abs(table["across[R]"][after] - 2.0).max())


def meaning(tables: Tables) -> str:
    """What the figure says."""
    after = tables["modes_after"]["after"]
    lost = tables["values"]["converged"][1]
    return (
        f"At 0.2 c the disk keeps {100 * (1 - lost):.1f} % of its energy as translation. Of the {100 * lost:.1f} % "
        f"that vibrate, {100 * after[0] / lost:.0f} % are in the quadrupole (2, 0), enough to be seen with the eye: "
        f"the diameters go on changing by up to {_left(tables):.2f} R. Energy is not lost in this model; on a later "
        "impact it may come back."
    )
