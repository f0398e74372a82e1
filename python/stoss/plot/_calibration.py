"""What measurements tell of constants: measured and computed values, with the band of the constants."""

from __future__ import annotations

from matplotlib.axes import Axes
import numpy as np

from stoss.calibration._calibration import Calibration
from stoss.plot import _style

LABELS = {
    "restitution": "loss of energy 1 − ε²", "tangential_restitution": "ε_t", "contact_time": "contact time, s",
    "peak_force": "peak force, N",
}  # fmt: skip
GAP = 0.09  # between pictures, of the height


@_style.picture_of(Calibration, method="plot")
def calibration(result: Calibration, ax: Axes | None = None) -> Axes:
    """Measured values against speed, or ε_t against angle, with what stoss computes and the band of the constants.

    A picture for each quantity inside the Axes, its `child_axes`. Bars are standard uncertainties of the data. The
    shading is that of the constants, from the data alone.

    Examples:
        >>> ball = stoss.Sphere(radius=0.01, material=stoss.materials["glass"])
        >>> data = {"speed": [0.5, 1.0], "restitution": [0.975, 0.974], "restitution_uncertainty": [0.001, 0.001]}
        >>> ax = stoss.plot.calibration(stoss.calibrate(data, ball, unknown="quality"))
        >>> [each.get_ylabel() for each in ax.child_axes]
        ['loss of energy 1 − ε²']
    """
    told = [name for name in LABELS if name in result.quantity]
    height = (1.0 - GAP * (len(told) - 1)) / len(told)
    places = {name: ((len(told) - 1 - k) * (height + GAP), height) for k, name in enumerate(told)}
    with _style.canvas(ax, size=(_style.COLUMN, 1.2 + 1.3 * len(told))) as axes:
        for name, panel in zip(told, _style.panels(axes, places)):
            _draw(panel, result, name)
            panel.set_ylabel(LABELS[name])
            panel.set_xlabel("angle, degrees" if name == "tangential_restitution" else "")
        told_last = told[-1] == "tangential_restitution"
        axes.child_axes[-1].set_xlabel("angle, degrees" if told_last else "speed of impact, m/s")
        axes.child_axes[0].legend(frameon=False)
    return axes


def _draw(axes: Axes, result: Calibration, name: str) -> None:
    where = np.flatnonzero(result.quantity == name)
    along = result.angle if name == "tangential_restitution" else result.speed
    where = where[np.argsort(along[where], kind="stable")]
    at, measured, computed = along[where], result.measured[where], result.fitted[where]
    bar, band = result.uncertainty[where], result.band[where]
    if name == "restitution":  # as energies, of which small ones are seen too
        measured, bar = 1.0 - measured**2, 2.0 * measured * bar
        computed, band = 1.0 - computed**2, 2.0 * computed * band
    axes.fill_between(at, computed - band, computed + band, color="0.8", linewidth=0.0, label="constants")
    axes.plot(at, computed, color=_style.BLUE, label="stoss")
    look = {"fmt": "o", "color": _style.BLACK, "elinewidth": 0.8, "capsize": 1.5, "markersize": 3.0}
    axes.errorbar(at, measured, yerr=bar, label="measured", **look)
