"""One impact in time: force, velocity, energies, contact; with friction where it sticks and slips."""

from __future__ import annotations

from typing import Any, Callable, Protocol

from matplotlib.axes import Axes
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.patches import Patch
import numpy as np
from numpy.typing import NDArray

from stoss.bodies._bodies import PARTNERS, Disk, Sphere
from stoss.plot import _style
from stoss.results._computed_impact import ComputedImpact
from stoss.results._field import Trajectory
from stoss.results._oblique_impact import ObliqueTrajectory

TIME = "time t / (R/c)"


class Curve(Protocol):
    """Draws one column of a trajectory."""

    def __call__(
        self, trajectory: Trajectory, ax: Axes | None = None, *, label: str | None = None, **style: Any
    ) -> Axes: ...


def _curve(name: str, column: str, label_of: Callable[[ComputedImpact], str], said: str, *, method: str = "") -> Curve:
    """The function of that name, which draws a column against time."""

    def drawn(trajectory: Trajectory, ax: Axes | None = None, *, label: str | None = None, **style: Any) -> Axes:
        with _style.canvas(ax, xlabel=TIME, ylabel=label_of(trajectory.impact)) as axes:
            n = sum(line.get_gid() == column for line in axes.lines) % len(_style.COLORS)
            if column == "velocity" and n == 0:
                axes.axhline(0.0, color=_style.GREY, linewidth=0.6)
            look = {"color": _style.COLORS[n], "linestyle": _style.LINES[n], "gid": column}
            axes.plot(trajectory.time, getattr(trajectory, column), label=label, **look | style)
            if label is not None:
                _style.legend(axes)
        return axes

    drawn.__name__ = drawn.__qualname__ = name
    drawn.__doc__ = f"""{said}

    Examples:
        >>> path = stoss.impact(poisson=0.33, speed=0.1, cutoff=12.5).trajectory()
        >>> ax = stoss.plot.{name}(path, color="black")
    """
    return _style.picture_of(Trajectory, method=method)(drawn)


force = _curve(
    "force", "force", lambda impact: f"force F / ({'πRE' if isinstance(impact.body, Disk) else 'mc²/R'})",
    "Force of the contact against time.", method="plot",
)  # fmt: skip
velocity = _curve(
    "velocity", "velocity",
    lambda impact: f"velocity {'of approach' if isinstance(impact.against, PARTNERS) else 'towards the wall'} / c",
    "Velocity of the centre of mass towards the wall, or of approach of two bodies, against time.",
)  # fmt: skip
half_width = _curve(
    "half_width", "contact_half_width",
    lambda impact: f"contact {'radius' if isinstance(impact.body, Sphere) else 'half-width'} / R",
    "Half-width of the contact, of spheres its radius, against time.",
)  # fmt: skip


@_style.picture_of(Trajectory, ObliqueTrajectory)
def energies(trajectory: Trajectory | ObliqueTrajectory, ax: Axes | None = None) -> Axes:
    """Where the energy is against time, as shares of the initial energy, and their sum.

    *Translation* is that of the centre of mass, *vibration* that of the kept modes, *stored* what
    the wall's potential or the static modes above the cutoff hold, *dissipated* what a lossy
    material and *unresolved* what the modes above the cutoff have taken. The sum differs from 1 by
    the numerical error. In an oblique impact *across* is the motion along the surface, *rotation*
    the spins, *elastic* all that went into the bodies, and *friction* the heat.

    Examples:
        >>> ax = stoss.plot.energies(stoss.impact(poisson=0.33, speed=0.1, cutoff=12.5).trajectory())
        >>> [line.get_label() for line in ax.lines]
        ['translation', 'vibration', 'stored', 'unresolved', 'sum']
    """
    shares = _shares(trajectory)
    look = {"xlabel": TIME, "ylabel": "energy / initial energy"}
    with _style.canvas(ax, size=(_style.COLUMN, 2.7), **look) as axes:
        for k, (name, values) in enumerate(shares.items()):
            axes.plot(trajectory.time, values, color=_style.COLORS[k], linestyle=_style.LINES[k], label=name)
        total: NDArray[Any] = sum(shares.values(), start=0.0 * trajectory.time)
        axes.plot(trajectory.time, total, color=_style.BLACK, linewidth=0.8, label="sum")
        axes.set_ylim(-0.04, max(1.25, 1.05 * float(total.max())))
        _style.legend(axes, loc="upper center", ncol=3, columnspacing=1.0, handlelength=1.8)
    return axes


def _shares(trajectory: Trajectory | ObliqueTrajectory) -> dict[str, NDArray[Any]]:
    """Shares of the energy by the names under which they are drawn."""
    if isinstance(trajectory, ObliqueTrajectory):
        spins = trajectory.rotation + trajectory.second_rotation
        own = {"translation": trajectory.translation, "across": trajectory.across, "rotation": spins}
        return own | {"elastic": trajectory.elastic, "friction": trajectory.friction_loss}
    lossy = ("dissipated",) if trajectory.dissipated.any() else ()
    return {name: getattr(trajectory, name) for name in ("translation", "vibration", "stored", *lossy, "unresolved")}


Array = NDArray[np.float64]

# By the numbers of ObliqueTrajectory.grip, as light as they are far from each other.
BACKWARD, STICK, FORWARD, OPEN = _style.BLUE, "0.12", _style.ORANGE, "white"
GRIPS = {0: (STICK, "sticks"), 1: (FORWARD, "slips along +y"), -1: (BACKWARD, "slips along −y")}
AROUND = 0.06  # of the time in contact, shown before and after it


@_style.picture_of(ObliqueTrajectory)
def grip(trajectory: ObliqueTrajectory, ax: Axes | None = None) -> Axes:
    """Where the contact sticks and slips: places along the surface against time.

    Black sticks, orange slips along +y and blue along −y, what is white is open. For spheres places
    are the radii of rings.

    Examples:
        >>> ball = stoss.Sphere(poisson=0.3)
        >>> ax = stoss.plot.grip(stoss.oblique_impact(ball, speed=0.05, angle=40, friction=0.3).trajectory())
    """
    with _style.canvas(ax, xlabel=TIME) as axes:
        draw_grip(axes, trajectory)
    return axes


@_style.picture_of(ObliqueTrajectory, method="plot")
def oblique_impact(trajectory: ObliqueTrajectory, ax: Axes | None = None) -> Axes:
    """One oblique impact in time, in three pictures inside the Axes, its `child_axes`.

    Velocities: v along the normal, v_t along the surface, ΩR of the spins, all in c. Forces: F, and
    friction Q over μ, which never leaves ±F; where it is within, something sticks. Below, where the
    contact sticks and slips, as `grip` draws it.

    Examples:
        >>> ball = stoss.Sphere(poisson=0.3)
        >>> ax = stoss.plot.oblique_impact(stoss.oblique_impact(ball, speed=0.05, angle=40, friction=0.3).trajectory())
        >>> len(ax.child_axes)
        3
    """
    with _style.canvas(ax, size=(_style.COLUMN, 4.9)) as axes:
        panels = _style.panels(axes, {"velocity": (0.73, 0.27), "force": (0.37, 0.27), "grip": (0.0, 0.28)})
        _draw_velocities(panels[0], trajectory)
        _draw_forces(panels[1], trajectory)
        draw_grip(panels[2], trajectory)
        for panel in panels[:2]:
            panel.set_xlim(panels[2].get_xlim())
        panels[2].set_xlabel(TIME)
    return axes


def draw_grip(axes: Axes, trajectory: ObliqueTrajectory) -> None:
    """The map of stick and slip, with a legend of what is in it."""
    colors = ListedColormap([BACKWARD, STICK, FORWARD, OPEN])
    norm = BoundaryNorm([-1.5, -0.5, 0.5, 1.5, 2.5], 4)
    place, touched = trajectory.place, np.flatnonzero((trajectory.grip != 2).any(axis=0))
    times = _edges(trajectory.time)
    axes.pcolormesh(times, _edges(place), trajectory.grip.T, cmap=colors, norm=norm, rasterized=True)
    half = 1.25 * float(np.abs(place[touched]).max(initial=float(np.abs(place).min())))
    axes.set_xlim(*_span(trajectory))
    axes.set_ylim(-half if place[0] < 0.0 else 0.0, half)
    axes.set_ylabel("y / R" if place[0] < 0.0 else "radius of ring / R")
    seen = [look for number, look in GRIPS.items() if (trajectory.grip == number).any()]
    patches = [Patch(facecolor=color, label=said) for color, said in seen]
    _above(axes, handles=patches, handlelength=1.0)


def _above(axes: Axes, **options: Any) -> None:
    """A legend in a row above the picture, where no curve is."""
    look = {"loc": "lower right", "bbox_to_anchor": (1.02, 0.98), "ncol": 4, "columnspacing": 1.2}
    _style.above(axes, **look | options)


def _draw_velocities(axes: Axes, trajectory: ObliqueTrajectory) -> None:
    axes.axhline(0.0, color=_style.GREY, linewidth=0.6)
    curves = {"$v_n$": trajectory.velocity, "$v_t$": trajectory.tangential}
    if trajectory.second_spin.any():
        curves |= {"$\\Omega_1R$": trajectory.spin, "$\\Omega_2R$": trajectory.second_spin}
    else:
        curves["$\\Omega R$"] = trajectory.spin
    for k, (name, values) in enumerate(curves.items()):
        axes.plot(trajectory.time, values, color=_style.COLORS[k], linestyle=_style.LINES[k], label=name)
    axes.set_ylabel("velocity / c")
    _above(axes)


def _draw_forces(axes: Axes, trajectory: ObliqueTrajectory) -> None:
    impact = trajectory.impact
    unit = "πRE" if isinstance(impact.body, Disk) else "mc²/R"
    axes.fill_between(trajectory.time, -trajectory.force, trajectory.force, color="0.9", linewidth=0.0)
    axes.plot(trajectory.time, trajectory.force, color="0.55", linewidth=2.2, label="$F$")
    along = trajectory.friction / impact.friction if impact.friction else trajectory.friction
    axes.plot(trajectory.time, along, color=_style.COLORS[1], linestyle=_style.LINES[1], label="$Q/\\mu$")
    axes.set_ylabel(f"force / ({unit})")
    _above(axes)


def _span(trajectory: ObliqueTrajectory) -> tuple[float, float]:
    """The time in contact, with something around it."""
    touching = trajectory.time[trajectory.touching > 0]
    first, last = (touching[0], touching[-1]) if touching.size else (trajectory.time[0], trajectory.time[-1])
    more = AROUND * (last - first) or 0.5
    return float(first - more), float(last + more)


def _edges(middles: Array) -> Array:
    """Between values, and as far beyond the ends."""
    if middles.size < 2:
        return np.concatenate((middles - 0.5, middles + 0.5))
    between = 0.5 * (middles[1:] + middles[:-1])
    ends = np.array([2.0 * middles[0] - between[0], 2.0 * middles[-1] - between[-1]])
    return np.concatenate((ends[:1], between, ends[1:]))
