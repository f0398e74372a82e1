"""One impact in time: force, velocity, energies, contact."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
from numpy.typing import NDArray

from stoss._arguments import instance
from stoss.bodies._bodies import PARTNERS, Disk, Sphere
from stoss.plot import _style
from stoss.results._motion import Trajectory


def force(trajectory: Trajectory, ax: Axes | None = None, *, label: str | None = None, **style: Any) -> Axes:
    """Force of the contact against time.

    Parameters
    ----------
    trajectory : Trajectory
        From `Impact.trajectory`.
    ax : Axes, optional
        Where to draw.
    label : str, optional
        Name of the curve; if there is one, there is a legend.
    **style
        Handed on to `matplotlib.axes.Axes.plot`: color, linestyle, …

    Examples
    --------
    >>> path = stoss.impact(poisson=0.33, speed=0.1, cutoff=12.5).trajectory()
    >>> ax = stoss.plot.force(path)
    >>> ax.get_ylabel()
    'force F / (πRE)'
    """
    instance("trajectory", trajectory, (Trajectory,))
    named = "force F / (πRE)" if isinstance(trajectory.impact.body, Disk) else "force F / (mc²/R)"
    return _against_time(trajectory, "force", named, ax, label, style)


def velocity(trajectory: Trajectory, ax: Axes | None = None, *, label: str | None = None, **style: Any) -> Axes:
    """Velocity of the centre of mass towards the wall, or of approach of two bodies, against time.

    Parameters
    ----------
    trajectory : Trajectory
        From `Impact.trajectory`.
    ax : Axes, optional
        Where to draw.
    label : str, optional
        Name of the curve; if there is one, there is a legend.
    **style
        Handed on to `matplotlib.axes.Axes.plot`: color, linestyle, …

    Examples
    --------
    >>> path = stoss.impact(poisson=0.33, speed=0.1, cutoff=12.5).trajectory()
    >>> ax = stoss.plot.velocity(path, color="black")
    >>> ax.get_ylabel()
    'velocity towards the wall / c'
    """
    instance("trajectory", trajectory, (Trajectory,))
    pair = isinstance(trajectory.impact.against, PARTNERS)
    name = "velocity of approach / c" if pair else "velocity towards the wall / c"
    return _against_time(trajectory, "velocity", name, ax, label, style, zero=True)


def half_width(trajectory: Trajectory, ax: Axes | None = None, *, label: str | None = None, **style: Any) -> Axes:
    """Half-width of the contact, of spheres its radius, against time.

    Parameters
    ----------
    trajectory : Trajectory
        From `Impact.trajectory`.
    ax : Axes, optional
        Where to draw.
    label : str, optional
        Name of the curve; if there is one, there is a legend.
    **style
        Handed on to `matplotlib.axes.Axes.plot`: color, linestyle, …

    Examples
    --------
    >>> path = stoss.impact(poisson=0.33, speed=0.1, cutoff=12.5).trajectory()
    >>> ax = stoss.plot.half_width(path)
    >>> ax.get_ylabel()
    'contact half-width / R'
    """
    instance("trajectory", trajectory, (Trajectory,))
    named = "contact radius / R" if isinstance(trajectory.impact.body, Sphere) else "contact half-width / R"
    return _against_time(trajectory, "contact_half_width", named, ax, label, style)


def energies(trajectory: Trajectory, ax: Axes | None = None) -> Axes:
    """Where the energy is against time, as shares of the initial energy, and their sum.

    *Translation* is that of the centre of mass, *vibration* that of the kept modes, *stored* what
    the wall's potential or the static modes above the cutoff hold, *dissipated* what a lossy
    material and *unresolved* what the modes above the cutoff have taken. The sum differs from 1 by
    the numerical error.

    Parameters
    ----------
    trajectory : Trajectory
        From `Impact.trajectory`.
    ax : Axes, optional
        Where to draw.

    Examples
    --------
    >>> ax = stoss.plot.energies(stoss.impact(poisson=0.33, speed=0.1, cutoff=12.5).trajectory())
    >>> [line.get_label() for line in ax.lines]
    ['translation', 'vibration', 'stored', 'unresolved', 'sum']
    """
    instance("trajectory", trajectory, (Trajectory,))
    lossy = ("dissipated",) if trajectory.dissipated.any() else ()
    names = ("translation", "vibration", "stored", *lossy, "unresolved")
    shares = {name: getattr(trajectory, name) for name in names}
    with _style.canvas(ax, size=(_style.COLUMN, 2.7)) as axes:
        for k, (name, values) in enumerate(shares.items()):
            axes.plot(trajectory.time, values, color=_style.COLORS[k], linestyle=_style.LINES[k], label=name)
        total: NDArray[Any] = sum(shares.values(), start=0.0 * trajectory.time)
        axes.plot(trajectory.time, total, color=_style.BLACK, linewidth=0.8, label="sum")
        axes.set_ylim(-0.04, max(1.25, 1.05 * float(total.max())))
        _label_time(axes)
        axes.set_ylabel("energy / initial energy")
        _style.legend(axes, loc="upper center", ncol=3, columnspacing=1.0, handlelength=1.8)
    return axes


def _against_time(
    trajectory: Trajectory,
    name: str,
    named: str,
    ax: Axes | None,
    label: str | None,
    style: dict[str, Any],
    zero: bool = False,
) -> Axes:
    instance("trajectory", trajectory, (Trajectory,))
    with _style.canvas(ax) as axes:
        n = sum(line.get_gid() == name for line in axes.lines) % len(_style.COLORS)
        if zero and n == 0:
            axes.axhline(0.0, color=_style.GREY, linewidth=0.6)
        look = {"color": _style.COLORS[n], "linestyle": _style.LINES[n], "gid": name}
        axes.plot(trajectory.time, getattr(trajectory, name), label=label, **look | style)
        _label_time(axes)
        axes.set_ylabel(named)
        if label is not None:
            _style.legend(axes)
    return axes


def _label_time(axes: Axes) -> None:
    axes.set_xlabel("time t / (R/c)")
