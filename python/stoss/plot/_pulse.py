"""The force of an impact in time and in frequency, and what a receiver records of it."""

from __future__ import annotations

from matplotlib.axes import Axes
import numpy as np

from stoss.bodies._bodies import Disk
from stoss.plot import _style
from stoss.results._pulse import Pulse
from stoss.results._seismogram import Seismogram

PREFIXES = {1e-12: "p", 1e-9: "n", 1e-6: "µ", 1e-3: "m", 1.0: "", 1e3: "k", 1e6: "M"}


def _prefix(largest: float) -> tuple[float, str]:
    """A unit in which a size is 1 to 1000."""
    fitting = [unit for unit in PREFIXES if unit <= largest] or [min(PREFIXES)]
    return max(fitting), PREFIXES[max(fitting)]


def _in_brackets(unit: str) -> str:
    return f"({unit})" if "/" in unit else unit


@_style.picture_of(Pulse, method="plot")
def pulse(result: Pulse, ax: Axes | None = None) -> Axes:
    """Force against time in its error band, beside the pulse of Hertz' theory.

    Examples:
        >>> ax = stoss.plot.pulse(stoss.pulse(stoss.Sphere(poisson=0.3), speed=0.01))
        >>> ax.get_xlabel()
        'time t / (R/c)'
    """
    force, error, time, hertz = result.force, result.force_error, result.time, result.hertz
    labels = ("time t / (R/c)", f"force F / ({'πRE' if isinstance(result.body, Disk) else 'mc²/R'})")
    if result.material is not None:
        per_time, seconds = _prefix(float(result.time_si[-1]))  # type: ignore[index]
        per_force, newton = _prefix(float(result.peak_force_si))
        unit_of_force = "N/m" if isinstance(result.body, Disk) else "N"
        scale = result.body.scales.force / per_force
        time = time * result.body.scales.time / per_time
        force, error, hertz = force * scale, error * scale, hertz * scale
        labels = (f"time t / {seconds}s", f"force F / {_in_brackets(newton + unit_of_force)}")
    with _style.canvas(ax, xlabel=labels[0], ylabel=labels[1]) as axes:
        band = {"color": _style.BLUE, "alpha": 0.3, "linewidth": 0.0}
        axes.fill_between(time, force - error, force + error, label="error", **band)
        axes.plot(time, force, color=_style.BLUE, label="computed")
        if np.isfinite(hertz).all():
            axes.plot(time, hertz, color=_style.BLACK, linestyle="--", linewidth=0.8, label="Hertz")
        axes.set_xlim(time[0], time[-1])
        axes.set_ylim(bottom=0.0)
        _style.legend(axes)
    return axes


@_style.picture_of(Pulse, method="spectrum")
def pulse_spectrum(result: Pulse, ax: Axes | None = None) -> Axes:
    """Amplitude of the force against frequency, over the impulse, with the corner and the first null.

    Examples:
        >>> ax = stoss.plot.pulse_spectrum(stoss.pulse(stoss.Sphere(poisson=0.3), speed=0.01))
        >>> ax.get_ylabel()
        'amplitude / impulse'
    """
    unit, label = 1.0, "frequency ω / (c/R)"
    if result.material is not None:
        per, name = _prefix(float(result.first_null_si) / (2.0 * np.pi))
        unit, label = result.body.scales.frequency / (2.0 * np.pi * per), f"frequency / {name}Hz"
    frequency = result.frequency * unit
    with _style.canvas(ax, xlabel=label, ylabel="amplitude / impulse") as axes:
        band = (result.amplitude - result.amplitude_error, result.amplitude + result.amplitude_error)
        axes.fill_between(frequency, *band, color=_style.BLUE, alpha=0.3, linewidth=0.0)
        axes.plot(frequency, result.amplitude, color=_style.BLUE)
        for each, said, style in ((result.corner_frequency, "corner", "--"), (result.first_null, "first null", ":")):
            axes.axvline(each * unit, color=_style.GREY, linestyle=style, linewidth=0.8, label=said)
        axes.set_yscale("log")
        axes.set_xlim(0.0, frequency[-1])
        axes.set_ylim(1e-4, 1.5)
        _style.legend(axes)
    return axes


@_style.picture_of(Seismogram, method="plot")
def seismogram(result: Seismogram, ax: Axes | None = None, quantity: str = "displacement") -> Axes:
    """Displacement of a receiver, or its velocity, along the normal and the surface against time, with errors.

    Parameters:
        quantity ({'displacement', 'velocity'}, optional): What is drawn.

    Examples:
        >>> hit = stoss.pulse(stoss.Sphere(poisson=0.3), speed=1e-3, against=stoss.HalfSpace(poisson=0.3))
        >>> ax = stoss.plot.seismogram(hit.at(20.0))
        >>> ax.get_ylabel()
        'displacement / R'
    """
    _style.choice("quantity", quantity, ("displacement", "velocity"))
    ending = "_velocity" if quantity == "velocity" else ""
    si = result.material is not None
    per_time, seconds = _prefix(float(result.time_si[-1])) if si else (1.0, "")  # type: ignore[index]
    own = "m/s" if ending else "m"
    scale = getattr(result.body.scales, "speed" if ending else "length") if si else 1.0
    most = max(float(np.abs(getattr(result, name + ending)).max()) for name in ("normal", "radial")) * scale
    per, prefix = _prefix(most) if si else (1.0, "")
    unit = _in_brackets(prefix + own) if si else "c" if ending else "R"
    labels = (f"time t / {seconds}s" if si else "time t / (R/c)", f"{quantity} / {unit}")
    time = result.time * (result.body.scales.time / per_time if si else 1.0)
    with _style.canvas(ax, xlabel=labels[0], ylabel=labels[1]) as axes:
        for direction, color, line in (("normal", _style.BLUE, "-"), ("radial", _style.VERMILION, "--")):
            value, error = (getattr(result, f"{direction}{ending}{each}") * scale / per for each in ("", "_error"))
            axes.fill_between(time, value - error, value + error, color=color, alpha=0.3, linewidth=0.0)
            axes.plot(time, value, color=color, linestyle=line, label=direction)
        axes.set_xlim(time[0], time[-1])
        _style.legend(axes)
    return axes
