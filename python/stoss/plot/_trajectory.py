"""One impact in time: force, velocity, energies, contact."""

from __future__ import annotations

from typing import Any, Callable, Protocol

from matplotlib.axes import Axes
from numpy.typing import NDArray

from stoss.bodies._bodies import PARTNERS, Disk, Sphere
from stoss.plot import _style
from stoss.results._field import Trajectory
from stoss.results._computed_impact import ComputedImpact
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
    the numerical error. Of an oblique impact *across* is the motion along the surface, *rotation*
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
