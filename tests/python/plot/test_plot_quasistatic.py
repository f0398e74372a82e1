"""Pictures of the quasi-static theory: what is drawn is what the results hold."""

import numpy as np
import pytest

import stoss
from stoss import quasistatic

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

pytestmark = pytest.mark.usefixtures("closed")

SPEEDS = np.array([1e-3, 1e-8, 0.05, 1e-100, 0.01])


@pytest.fixture(scope="module")
def estimate():
    with pytest.warns(stoss.StossWarning):
        return quasistatic.rayleigh(poisson=[[0.33], [0.0]], speed=SPEEDS, cutoff=12)


def legend(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


def test_contact_time():
    slow = quasistatic.slow_impact(poisson=[[0.33], [-0.5]], speed=SPEEDS)
    ax = slow.plot()
    assert (ax.get_xlabel(), ax.get_ylabel(), ax.get_xscale()) == ("speed v / c", "contact time τ / (R/c)", "log")
    order = np.argsort(SPEEDS)
    for line, row, name in zip(ax.lines, (1, 0), ("ν = −0.5", "ν = 0.33")):
        assert np.array_equal(line.get_xdata(), SPEEDS[order])
        assert np.array_equal(line.get_ydata(), slow.contact_time[row, order])
        assert line.get_label() == name
    assert len(ax.lines) == 2 and legend(ax) == ["ν = −0.5", "ν = 0.33"]
    ax.figure.canvas.draw()


def test_lost_fraction(estimate):
    ax = estimate.plot()
    assert (ax.get_ylabel(), ax.get_yscale()) == ("lost fraction 1 − ε²", "log")
    order = np.argsort(SPEEDS)
    full, hollow = ax.lines[0::2], ax.lines[1::2]
    for k, row in enumerate((1, 0)):
        assert np.array_equal(full[k].get_xdata(), SPEEDS[order])
        assert np.array_equal(full[k].get_ydata(), estimate.lost_fraction[row, order])
        assert np.array_equal(hollow[k].get_xydata(), [[0.05, estimate.lost_fraction[row, 2]]])
        assert hollow[k].get_markerfacecolor() == "white" and hollow[k].get_color() == full[k].get_color()
    assert legend(ax) == ["ν = 0", "beyond perturbation theory", "ν = 0.33"]
    ax.figure.canvas.draw()


def test_band_is_the_error(estimate):
    ax = estimate.plot()
    known = np.argsort(SPEEDS)[:-1]  # all but the one beyond perturbation theory
    for band, row in zip(ax.collections, (1, 0)):
        ends = band.get_paths()[0].vertices
        lost, error = estimate.lost_fraction[row, known], estimate.lost_fraction_error[row, known]
        for k, v in enumerate(SPEEDS[known]):
            y = ends[ends[:, 0] == v, 1]
            assert y.max() == pytest.approx(lost[k] + error[k], rel=1e-12)
            assert y.min() == pytest.approx(max(lost[k] - error[k], 1e-3 * lost[k]), rel=1e-12)


def test_metres_per_second():
    steel = stoss.Disk(radius=0.01, material=stoss.materials["structural steel"])
    for result in (quasistatic.slow_impact(steel, speed=[1.0, 10.0]),
                   quasistatic.rayleigh(steel, speed=[1.0, 10.0], cutoff=6)):  # fmt: skip
        ax = result.plot()
        np.testing.assert_allclose(ax.lines[0].get_xdata(), [1.0, 10.0])
        assert ax.get_xlabel() == "speed v / (m/s)"


def test_single_and_no_values():
    ax = quasistatic.slow_impact(poisson=0.3, speed=0.01).plot()
    assert ax.lines[0].get_marker() == "o" and ax.lines[0].get_xdata() == [0.01]
    assert quasistatic.rayleigh(poisson=0.3, speed=0.01, cutoff=6).plot(ax) is ax
    for make in (quasistatic.slow_impact, quasistatic.rayleigh):
        make(poisson=0.3, speed=[]).plot().figure.canvas.draw()


def test_pressure():
    contact = quasistatic.static_contact(poisson=0.33, compression=0.03)
    ax = contact.plot()
    mine, hertz = ax.lines
    n = contact.contact_nodes
    assert np.array_equal(mine.get_xdata()[n:], contact.position[:n])
    assert np.array_equal(mine.get_ydata()[n:], contact.pressure[:n])
    assert np.array_equal(mine.get_ydata(), mine.get_ydata()[::-1])
    expected = 0.5 * np.sqrt(np.maximum(4 * contact.force - contact.position[:n] ** 2, 0))
    assert hertz.get_ydata()[n:] == pytest.approx(expected, abs=1e-9)
    inner = np.abs(mine.get_xdata()) < 0.8 * contact.half_width
    off = np.abs(mine.get_ydata() - hertz.get_ydata())[inner]
    assert off.max() < 0.02 * contact.pressure.max()


def test_given_axes_are_the_only_ones_touched():
    figure, (left, right) = pyplot.subplots(1, 2)
    slow = quasistatic.slow_impact(poisson=0.33, speed=SPEEDS)
    assert stoss.plot.slow_impact(slow, left) is left
    assert quasistatic.slow_impact(poisson=0.9, speed=SPEEDS).plot(left) is left
    assert left.lines[0].get_color() != left.lines[1].get_color() and not right.has_data()
    assert pyplot.get_fignums() == [figure.number]


@pytest.mark.parametrize("name", ["slow_impact", "rayleigh", "static_contact"])
def test_refusals(name):
    with pytest.raises(stoss.InvalidInput, match="^result: got 0.9, allowed a stoss"):
        getattr(stoss.plot, name)(0.9)
    given = {"static_contact": {"compression": 0.01}}.get(name, {"speed": 0.01})
    result = getattr(quasistatic, name)(poisson=0.3, **given)
    with pytest.raises(stoss.InvalidInput, match="^ax: got 3, allowed one matplotlib Axes"):
        result.plot(3)
    assert pyplot.get_fignums() == []
