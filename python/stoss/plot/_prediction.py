"""What a drop test shows: ε with its three uncertainties, and where the energy goes."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
from matplotlib.patches import Patch
import numpy as np
from numpy.typing import NDArray

from stoss._errors import InvalidInput
from stoss.plot import _style
from stoss.results._prediction import CHANNELS, MODELS, Prediction

Array = NDArray[np.float64]

LOOKS = {
    "ringing": (_style.GREEN, ""), "radiation": (_style.BLUE, ""), "material": (_style.ORANGE, ""),
    "yield": (_style.VERMILION, "/////"), "adhesion": (_style.PURPLE, "xxxxx"),
}  # fmt: skip
"""Colour and hatch of each channel: models are hatched, and dashed as lines."""

BAND = "0.8"
LEAST = 1e-9  # what takes less everywhere is left out
DECADES = 6.0  # below the largest loss that are shown


@_style.picture_of(Prediction, method="plot")
def prediction(result: Prediction, ax: Axes | None = None) -> Axes:
    """What a drop test shows against speed, in three pictures inside the Axes, its `child_axes`.

    Above, ε and dashed that without yield and adhesion, with its three uncertainties: the spread of
    the models shaded, what uncertain constants do as bars, and the numerical error as thin lines on
    both sides, all as far as ε can be, from 0 to 1. In the middle the lost energy, and what each channel takes of the energy before.
    Below, the channels as shares of what is lost, one above the other. Computed channels are solid,
    models dashed and hatched. A dotted line is the speed at which yielding begins.

    Examples:
        >>> ball = stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"])
        >>> block = stoss.HalfSpace(material=stoss.materials["bearing steel"])
        >>> ax = stoss.plot.prediction(stoss.predict(ball, against=block, speed=[0.1, 0.2]))
        >>> [each.get_ylabel() for each in ax.child_axes]
        ['restitution ε', 'energy / energy before', 'share of the loss']
    """
    order = np.argsort(np.ravel(result.speed), kind="stable")
    order = order[np.isfinite(np.ravel(result.restitution)[order])]
    speed = np.ravel(result.speed)[order]
    if np.unique(speed).size < 2:
        raise InvalidInput.out_of_range("result", f"{np.unique(speed).size} speeds with a value", "two or more")
    shares = {name: np.ravel(getattr(result, field))[order] for name, field in CHANNELS.items()}
    shares = {name: share for name, share in shares.items() if share.max() > LEAST}
    with _style.canvas(ax, size=(_style.COLUMN, 5.2)) as axes:
        panels = _style.panels(axes, {"restitution": (0.74, 0.26), "energy": (0.39, 0.28), "shares": (0.0, 0.28)})
        for panel in panels:
            panel.set_xscale("log")
            panel.set_xlim(speed[0], speed[-1])
        _draw_restitution(panels[0], result, order, speed)
        _draw_energies(panels[1], speed, shares)
        _draw_shares(panels[2], speed, shares)
        begins = result.yield_speed
        for panel in panels:
            if begins is not None and speed[0] < begins < speed[-1]:
                panel.axvline(begins, color=_style.BLACK, linestyle=":", linewidth=0.8)
        panels[2].set_xlabel(_style.speed_label(result.body.material))
    return axes


def _draw_restitution(axes: Axes, result: Prediction, order: NDArray[np.intp], speed: Array) -> None:
    def values(name: str) -> Array:
        return np.ravel(getattr(result, name))[order]

    value, error = values("restitution"), values("restitution_error")
    alone, constants = values("restitution_without_models"), values("by_constants")
    axes.fill_between(speed, values("models_low"), values("models_high"), color=BAND, linewidth=0.0, label="models")
    axes.plot(speed, value, color=_style.BLACK, label="ε")
    axes.plot(speed, alone, color=_style.BLUE, linestyle="--", linewidth=0.9, label="without models")
    for edge, said in ((value - error, "numerical"), (value + error, None)):
        axes.plot(speed, np.clip(edge, 0.0, 1.0), color=_style.BLACK, linewidth=0.3, label=said)
    reach = np.stack([np.minimum(constants, value), np.minimum(constants, 1.0 - value)])  # ε is 0 to 1
    look = {"fmt": "none", "ecolor": _style.VERMILION, "elinewidth": 0.8, "capsize": 1.5}
    axes.errorbar(speed, value, yerr=reach, label="constants", **look)
    axes.ticklabel_format(axis="y", useOffset=False)
    axes.set_ylabel("restitution ε")
    _above(axes)


def _draw_energies(axes: Axes, speed: Array, shares: dict[str, Array]) -> None:
    lost = np.asarray(sum(shares.values(), np.zeros_like(speed)))
    axes.plot(speed, _above_zero(lost), color=_style.BLACK, linewidth=1.6, label="1 − ε²")
    for name, share in shares.items():
        dash = "--" if name in MODELS else "-"
        axes.plot(speed, _above_zero(share), color=LOOKS[name][0], linestyle=dash, linewidth=0.9)
    axes.set_yscale("log")
    most = float(lost.max(initial=LEAST))
    positive = [float(share[share > 0.0].min()) for share in shares.values() if (share > 0.0).any()]
    axes.set_ylim(max(0.5 * min(positive, default=most), most * 10.0**-DECADES), 2.0 * most)
    axes.set_ylabel("energy / energy before")
    _above(axes)


def _above_zero(share: Array) -> Array:
    """What a logarithmic axis can show."""
    return np.where(share > 0.0, share, np.nan)


def _draw_shares(axes: Axes, speed: Array, shares: dict[str, Array]) -> None:
    lost = np.asarray(sum(shares.values(), np.zeros_like(speed)))
    whole = np.where(lost > 0.0, lost, 1.0)
    _style.stacked(axes, speed, ((share / whole, *LOOKS[name], name) for name, share in shares.items()))
    axes.set_ylabel("share of the loss")
    _above(axes, handles=[_key(name) for name in shares], handlelength=1.4)


def _key(name: str) -> Patch:
    color, hatch = LOOKS[name]
    said = f"{name} (model)" if name in MODELS else name
    return Patch(facecolor=color, hatch=hatch, edgecolor="white", linewidth=0.0, label=said)


def _above(axes: Axes, **options: Any) -> None:
    """A legend in a row above the picture, where no curve is."""
    look = {"loc": "lower left", "bbox_to_anchor": (-0.02, 0.98), "ncol": 3, "columnspacing": 0.8}
    _style.above(axes, **look | options)
