"""The picture of a predicted drop test shows its band and channels, and which of them are models."""

import warnings

import numpy as np
import pytest
import stoss


pytestmark = pytest.mark.usefixtures("closed")

STEEL = stoss.materials["bearing steel"]
SPEEDS = [0.01, 10.0, 0.1, 1.0, 3.0]


@pytest.fixture(scope="module")
def drop():
    ball, block = stoss.Sphere(radius=5e-3, material=STEEL), stoss.HalfSpace(material=STEEL)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", stoss.StossWarning)
        return stoss.predict(ball, against=block, speed=SPEEDS, adhesion=0.5, tolerance=1e-2)


def words(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


def upper(band):
    """The upper end of an area at each of its places."""
    corners = band.get_paths()[0].vertices
    return {x: max(y for at, y in corners if at == x) for x in {at for at, _ in corners}}


def test_restitution_with_its_three_uncertainties(drop):
    ax = drop.plot().child_axes[0]
    order = np.argsort(drop.speed)
    value, elastic, below, above = ax.lines[:4]
    assert value.get_xdata().tolist() == sorted(SPEEDS)
    assert value.get_ydata().tolist() == drop.restitution[order].tolist()
    assert elastic.get_ydata().tolist() == drop.restitution_without_models[order].tolist()
    assert elastic.get_linestyle() == "--"
    assert below.get_ydata().tolist() == (drop.restitution - drop.restitution_error)[order].tolist()
    assert above.get_ydata().tolist() == (drop.restitution + drop.restitution_error)[order].tolist()
    band, bars = ax.collections
    ends = np.array([segment[:, 1] for segment in bars.get_segments()])
    reach = np.minimum(drop.restitution + drop.by_constants, 1.0) - np.maximum(drop.restitution - drop.by_constants, 0.0)
    assert np.diff(ends).ravel() == pytest.approx(reach[order])
    assert upper(band) == dict(zip(drop.speed, drop.models_high))
    assert words(ax) == ["models", "ε", "without models", "numerical", "constants"] and ax.get_xscale() == "log"


def test_nothing_is_drawn_that_cannot_be():
    glass = stoss.materials["glass"]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", stoss.StossWarning)
        slow = stoss.predict(stoss.Sphere(radius=5e-3, material=glass), speed=[0.01, 0.02], adhesion=0, tolerance=1e-2)
    assert (slow.restitution + slow.by_constants > 1).all()
    ax = slow.plot().child_axes[0]
    bars = ax.collections[-1]
    assert max(segment[:, 1].max() for segment in bars.get_segments()) == 1.0
    assert all(np.max(line.get_ydata()) <= 1.0 for line in ax.lines)


def test_models_are_dashed_and_hatched(drop):
    _, energies, shares = drop.plot().child_axes
    total, *channels = energies.lines[:-1]  # the last says where yielding begins
    order = np.argsort(drop.speed)
    assert total.get_ydata() == pytest.approx(1 - drop.restitution[order] ** 2, rel=1e-6)
    # What rings is too little to be seen here.
    assert words(shares) == ["ringing", "radiation", "material", "yield (model)", "adhesion (model)"]
    assert [line.get_linestyle() for line in channels] == ["-", "-", "-", "--", "--"]
    assert [bool(area.get_hatch()) for area in shares.collections] == [False, False, False, True, True]
    assert channels[1].get_ydata().tolist() == drop.radiation[order].tolist()
    assert np.isnan(channels[3].get_ydata()[:2]).all()  # nothing yields at low speed
    assert list(upper(shares.collections[-1]).values()) == pytest.approx([1] * 5)
    assert energies.get_yscale() == "log" and shares.get_ylim() == (0, 1)


def test_where_yielding_begins_and_one_axis_of_speeds(drop):
    ax = drop.plot()
    for panel in ax.child_axes:
        assert panel.get_xlim() == (0.01, 10)
        assert panel.lines[-1].get_xdata() == [drop.yield_speed] * 2 and panel.lines[-1].get_linestyle() == ":"
    assert ax.child_axes[2].get_xlabel() == "speed v / (m/s)"
    ax.figure.canvas.draw()  # labels of no picture reach into another
    boxes = [each.get_tightbbox() for each in ax.child_axes]
    assert boxes[0].y0 > boxes[1].y1 and boxes[1].y0 > boxes[2].y1
    assert all(box.x0 >= 0 and box.x1 <= ax.figure.bbox.width for box in boxes)
    slow = drop[drop.speed < 0.5].plot()
    assert slow.child_axes[0].lines[-1].get_linestyle() != ":"  # not within these speeds


def test_channels_that_take_nothing_are_left_out():
    hard = stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=1e12, loss_time=1e-9)
    ax = stoss.predict(stoss.Sphere(radius=5e-3, material=hard), speed=[[0.1], [1.0]], tolerance=1e-2).plot()
    assert words(ax.child_axes[2]) == ["ringing", "material"]


def test_one_speed_is_no_curve(drop):
    with pytest.raises(stoss.InvalidInput, match="^result: got 1 speeds with a value, allowed two or more"):
        drop[0].plot()
    with pytest.raises(stoss.InvalidInput, match="^result: got .*, allowed a stoss.Prediction"):
        stoss.plot.prediction(STEEL)
