"""Figure 9: the quasi-static approach.

The paper illustrates a disk pressed against the wall over the contact −a ≤ y ≤ a by Hertz's pressure
p(y) = (2P/πa²)√(a² − y²) with a² = 4PR/πE (eq. 45), balanced by its own inertia, that is, by a
uniform body force. Here both are computed: the static contact of a disk with a hard wall, by
complementarity with the compliance of all modes (`stoss.quasistatic.static_contact`), and from its
pressure the displacement of the whole disk, order by order, in closed form (docs/theory/modes.md).
"""

from __future__ import annotations

import numpy as np
import stoss
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from numpy.typing import NDArray

from gerl_zippelius_1999.common import (
    BLACK, BLUE, GREY, NONE, PAGE, VERMILION, Row, Tables, axes_of, legend, measured, written,
)  # fmt: skip
from gerl_zippelius_1999.printed_law import force_by

TITLE = "Figure 9: the quasi-static approach"
CAPTION = (
    "A disk with ν = 0.33 whose centre of mass is held at the distance R − δ from a hard wall, δ = 0.1 R, balanced by "
    "a uniform body force as in a slow impact. Left: its deformation in true size, the radius R in grey, the contact "
    "from −a to a, and the pressure (arrows). Right: the pressure on the contact for three compressions, against "
    "Hertz’s semi-ellipse (line), in units of the half-width and the maximum pressure that Hertz gives for the same "
    "force."
)
ALT = "Left: a disk pressed against a wall, with arrows for the pressure. Right: pressures that follow a semi-ellipse."

POISSON = 0.33
SHOWN, COMPRESSIONS = 0.1, (0.01, 0.03, 0.1)
CIRCLES, SPOKES = 6, 24
HIGHEST_ORDER = 200


def compute(quick: bool) -> Tables:
    """Contacts at three compressions, and the field of one. The same quick or not."""
    contacts = [stoss.quasistatic.static_contact(poisson=POISSON, compression=delta) for delta in COMPRESSIONS]
    pressure = {name: [] for name in ("compression[R]", "position[R]", "pressure[E]", "y_over_a", "share_of_greatest")}
    for delta, contact in zip(COMPRESSIONS, contacts):
        half, greatest = _hertz(contact.force)
        y = np.concatenate((-contact.position[::-1], contact.position))
        p = np.concatenate((contact.pressure[::-1], contact.pressure))
        pressure["compression[R]"].append(np.full(len(y), delta))
        pressure["position[R]"].append(y)
        pressure["pressure[E]"].append(p)
        pressure["y_over_a"].append(y / half)
        pressure["share_of_greatest"].append(p / greatest)
    shown = contacts[COMPRESSIONS.index(SHOWN)]
    along, around = np.linspace(0.0, 1.0, 41), np.linspace(-np.pi, np.pi, 241)
    rings = _lines(shown, np.arange(1, CIRCLES + 1) / CIRCLES, around, 0, across=False)
    rays = _lines(shown, along, -np.pi + 2.0 * np.pi * np.arange(SPOKES) / SPOKES, CIRCLES, across=True)
    by_law = [stoss.quasistatic.compression_force(poisson=POISSON, compression=delta) for delta in COMPRESSIONS]
    printed = force_by("printed", POISSON, np.array(COMPRESSIONS))
    return {
        "pressure": {name: np.concatenate(values) for name, values in pressure.items()},
        "lines": {name: np.concatenate((rings[name], rays[name])) for name in rings},
        "contacts": {
            "compression[R]": np.array(COMPRESSIONS),
            "force[piRE]": np.array([each.force for each in contacts]),
            "force_error[piRE]": np.array([each.force_error for each in contacts]),
            "half_width[R]": np.array([each.half_width for each in contacts]),
            "greatest_pressure[E]": np.array([each.pressure.max() for each in contacts]),
            "force_center_law[piRE]": np.array(by_law), "force_printed_law[piRE]": printed,
        },
    }  # fmt: skip


def _hertz(force: float) -> tuple[float, float]:
    """a and p(0) of eq. (45), Hertz’s pressure, R and E, for a force in πRE."""
    half = 2.0 * np.sqrt(force)
    return half, 0.5 * half


def _lines(
    contact: stoss.quasistatic.StaticContact, radius: NDArray, angle: NDArray, first: int, across: bool
) -> dict[str, NDArray]:
    """The displaced grid as columns, to six digits."""
    u_r, u_phi = _displacement(contact, radius, angle)
    out, along = radius[:, None] + u_r, u_phi
    x = contact.compression - 1.0 + out * np.cos(angle) - along * np.sin(angle)
    y = out * np.sin(angle) + along * np.cos(angle)
    if across:
        x, y = x.T, y.T
    line = np.indices(x.shape)[0].ravel() + first
    return {"line": line, "x[R]": np.round(x.ravel(), 6), "y[R]": np.round(y.ravel(), 6)}


def _displacement(contact: stoss.quasistatic.StaticContact, r: NDArray, angle: NDArray) -> tuple[NDArray, NDArray]:
    """u_r and u_φ on radii × angles: Michell's fields of each order, inertia relief for n = 1."""
    nu, r = POISSON, r[:, None]
    force = 2.0 * contact.spacing * contact.pressure / np.pi  # of each node and its mirror image, in πRE
    phi = contact.position
    u_r, u_phi = np.zeros((2, r.size, angle.size))
    for n in range(HIGHEST_ORDER + 1):
        p = -np.sum(force * np.cos(n * phi) * np.cos(phi))
        t = np.sum(force * np.sin(n * phi) * np.sin(phi))
        if n == 0:
            radial, around = (1.0 - nu) * 0.5 * p * r, 0.0 * r
        elif n == 1:
            b, g = 0.25 * (p + t), p - t
            out, along = (1 - 3 * nu) * b + 0.25 * (1 + nu) * g, (5 + nu) * b - 0.75 * (1 + nu) * g
            shift = 0.25 * (along - out)
            radial, around = out * r**2 + shift, along * r**2 - shift
        else:
            a, b = ((2 - n) * t - n * p) / (2 * n * (n - 1)), (p + t) / (2 * (n + 1))
            inner = (1 + nu) * n * a * r ** (n - 1)
            radial = -inner - ((n - 2) + nu * (n + 2)) * b * r ** (n + 1)
            around = inner + (n + 4 + nu * n) * b * r ** (n + 1)
        u_r += radial * np.cos(n * angle)
        u_phi += around * np.sin(n * angle)
    return u_r, u_phi


def draw(tables: Tables) -> Figure:
    """The pressed disk, and the pressures."""
    figure, (left, right) = axes_of(PAGE, 3.3, 1, 2, width_ratios=(1.0, 1.15))
    lines, contacts = tables["lines"], tables["contacts"]
    half = contacts["half_width[R]"][-1]
    left.add_patch(Rectangle((0.0, -1.4), 0.7, 2.8, facecolor="0.88", edgecolor="none"))
    left.plot((0.0, 0.0), (-1.4, 1.4), color=BLACK, linewidth=1.0)
    center, around = SHOWN - 1.0, np.linspace(0.0, 2.0 * np.pi, 361)
    round_x = center + np.cos(around)
    left.plot(np.where(round_x <= 0.0, round_x, np.nan), np.sin(around), color=GREY, linewidth=0.8)
    each = [lines["line"] == k for k in range(CIRCLES + SPOKES)]
    drawn = [np.column_stack((lines["x[R]"][k], lines["y[R]"][k])) for k in each]
    widths = [1.4 if k == CIRCLES - 1 else 0.45 for k in range(CIRCLES + SPOKES)]
    left.add_collection(LineCollection(drawn, colors=BLUE, linewidths=widths, zorder=2))
    for y in np.linspace(-0.9, 0.9, 9) * half:
        length = 0.36 * np.sqrt(1.0 - (y / half) ** 2)
        arrow = {"arrowstyle": "-|>", "color": VERMILION, "mutation_scale": 6, "shrinkA": 0, "shrinkB": 0}
        left.annotate("", (0.0, y), (length, y), arrowprops=arrow, zorder=3)
    ellipse = np.linspace(-1.0, 1.0, 101)
    left.plot(0.36 * np.sqrt(1.0 - ellipse**2), half * ellipse, color=VERMILION, linewidth=0.8)
    left.text(0.4, 0.0, "p(y)", color=VERMILION, fontstyle="italic", ha="left", va="center")
    for sign, name in ((1, "a"), (-1, "−a")):
        left.text(0.12, sign * (half + 0.07), name, ha="left", va="center", fontstyle="italic")
        left.plot((-0.05, 0.1), (sign * half,) * 2, color=BLACK, linewidth=0.8, zorder=4)
    left.set(aspect="equal", xlim=(-2.02, 0.65), ylim=(-1.25, 1.25), xlabel="x / R", ylabel="y / R")
    left.set_yticks([-1, 0, 1])

    table, ring = tables["pressure"], np.linspace(-1.0, 1.0, 201)
    right.plot(ring, np.sqrt(1.0 - ring**2), color=BLACK, linewidth=0.9, label="Hertz")
    looks = (("o", "0.35", 22), ("s", BLUE, 22), ("^", VERMILION, 22))
    for delta, (marker, color, every) in zip(COMPRESSIONS, looks):
        k = np.flatnonzero((table["compression[R]"] == delta) & (table["pressure[E]"] > 0.0))
        k = k[every // 2 :: every]
        style = {"linestyle": "none", "marker": marker, "markersize": 3.5, "color": color, "fillstyle": "none"}
        right.plot(table["y_over_a"][k], table["share_of_greatest"][k], label=f"δ = {delta:g} R", **style)
    right.set(xlabel="y / a (Hertz)", ylabel="p / p(0) (Hertz)", ylim=(0.0, 1.12))
    legend(right, loc="lower center")
    return figure


def numbers(tables: Tables) -> list[Row]:
    """Half-width and maximum pressure against Hertz, force against the laws."""
    rows = []
    for delta, force, error, half, p, _, printed in zip(*tables["contacts"].values()):
        hertz_half, hertz_p = _hertz(force)
        at = f"at δ = {delta:g} R"
        what = f"force in πRE {at}; protocol: eq. (56), force against compression, as printed"
        rows.append((what, NONE, written(printed, 4), measured(force, error)))
        what = f"half-width a in R {at}; protocol: a² = 4PR/πE for the converged force"
        rows.append((what, NONE, written(hertz_half, 4), written(half, 4)))
        what = f"maximum pressure in E {at}; protocol: 2P/πa for the converged force"
        rows.append((what, NONE, written(hertz_p, 4), written(p, 4)))
    return rows


def meaning(tables: Tables) -> str:
    """What the figure says."""
    table = tables["contacts"]
    off = [abs(_hertz(force)[1] / p - 1.0) for force, p in zip(table["force[piRE]"], table["greatest_pressure[E]"])]
    law = table["force_center_law[piRE]"] / table["force[piRE]"] - 1.0
    printed = table["force_printed_law[piRE]"] / table["force[piRE]"] - 1.0
    return (
        f"Locally the contact is that of Hertz: his maximum pressure is off by {100 * off[0]:.1f} % at δ = 0.01 R "
        "and by "
        f"{100 * off[-1]:.0f} % at 0.1 R. What Hertz cannot give in the plane is the compression, which depends on "
        f"the whole disk: the law of the centre of mass gives the force to {100 * law[0]:.1f} %, {100 * law[1]:.1f} % "
        f"and {100 * law[2]:.0f} % at these three compressions, the printed one is {100 * abs(printed[0]):.0f} %, "
        f"{100 * abs(printed[1]):.0f} % and {100 * abs(printed[2]):.0f} % too small."
    )
