"""Curves of restitution, and of the quasi-static theory: what is drawn is what the results hold."""

import dataclasses

import numpy as np
import pytest
import stoss
from matplotlib import pyplot
from matplotlib.container import ErrorbarContainer
from stoss import quasistatic


pytestmark = pytest.mark.usefixtures("closed")

SPEEDS = np.geomspace(1e-3, 0.2, 5)


@pytest.fixture(scope="module")
def curve():
    return stoss.restitution(poisson=0.33, speed=SPEEDS)


@pytest.fixture(scope="module")
def curves():
    return stoss.restitution(poisson=[[-0.2], [0.33]], speed=SPEEDS)


def drawn(ax):
    return [each for each in ax.containers if isinstance(each, ErrorbarContainer)]


def bars(container):
    return np.array([[segment[0, 1], segment[1, 1]] for segment in container.lines[2][0].get_segments()])


@pytest.mark.parametrize(
    "quantity, label", [("restitution", "restitution ε"), ("lost_fraction", "lost fraction 1 − ε²")]
)
def test_values_and_errors(curve, quantity, label):
    ax = stoss.plot.restitution(curve, quantity=quantity)
    (only,) = drawn(ax)
    value, error = getattr(curve, quantity), getattr(curve, f"{quantity}_error")
    assert np.array_equal(only.lines[0].get_xdata(), SPEEDS)
    assert np.array_equal(only.lines[0].get_ydata(), value)
    np.testing.assert_allclose(bars(only), np.column_stack((value - error, value + error)), rtol=1e-12)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("speed v / c", label)
    assert ax.get_xscale() == "log"
    assert ax.get_yscale() == ("log" if quantity == "lost_fraction" else "linear")
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["ν = 0.33"]


def test_a_curve_for_each_poisson_number(curves):
    ax = stoss.plot.restitution(curves, label="hard wall")
    for k, (each, name) in enumerate(zip(drawn(ax), ("ν = −0.2", "ν = 0.33"))):
        assert np.array_equal(each.lines[0].get_ydata(), curves.restitution[k])
        assert each.get_label() == f"hard wall, {name}"
    one, two = (each.lines[0] for each in drawn(ax))
    for look in ("get_color", "get_marker", "get_linestyle"):
        assert getattr(one, look)() != getattr(two, look)()


def test_only_curves_of_few_points_have_markers(curve):
    dense = stoss.restitution(poisson=0.33, speed=np.geomspace(0.01, 0.2, 60), tolerance=1e-2)
    marked, line = (drawn(each.plot())[0] for each in (curve, dense))
    assert marked.lines[0].get_marker() == "o" and len(marked.lines[1]) == 2  # with caps
    assert line.lines[0].get_marker() == "none" and len(line.lines[1]) == 0
    assert len(bars(line)) == 60
    asked = drawn(stoss.plot.restitution(dense, marker="s", capsize=2))[0]
    assert asked.lines[0].get_marker() == "s" and len(asked.lines[1]) == 2


def test_missing_and_doubtful_values(curve):
    value, error, converged = curve.restitution.copy(), curve.restitution_error.copy(), curve.converged.copy()
    value[1] = error[1] = np.nan
    converged[[1, 3]] = False
    ax = stoss.plot.restitution(
        dataclasses.replace(curve, restitution=value, restitution_error=error, converged=converged)
    )
    (only,) = drawn(ax)
    assert np.array_equal(only.lines[0].get_xdata(), SPEEDS[[0, 2, 3, 4]])
    (hollow,) = [line for line in ax.lines if line.get_label() == "not converged"]
    assert np.array_equal(hollow.get_xydata(), [[SPEEDS[3], value[3]]])
    assert hollow.get_markerfacecolor() == "white"


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("unknown", [slice(1, 3), slice(None)])
def test_an_unknown_error_leaves_the_value(curve, unknown):
    error = curve.restitution_error.copy()
    error[unknown] = np.nan
    (only,) = drawn(stoss.plot.restitution(dataclasses.replace(curve, restitution_error=error)))
    assert np.array_equal(only.lines[0].get_ydata(), curve.restitution)
    assert len(bars(only)) == np.isfinite(error).sum()


def test_single_value():
    value = stoss.restitution(poisson=0.33, speed=0.1)
    ax = value.plot()
    assert np.array_equal(drawn(ax)[0].lines[0].get_xydata(), [[0.1, value.restitution]])
    ax.figure.canvas.draw()


def test_metres_per_second():
    steel = stoss.Disk(radius=0.01, material=stoss.materials["structural steel"])
    ax = stoss.restitution(steel, speed=[1.0, 10.0]).plot()
    np.testing.assert_allclose(drawn(ax)[0].lines[0].get_xdata(), [1.0, 10.0])
    assert ax.get_xlabel() == "speed v / (m/s)"


def test_against_poisson_if_there_is_one_speed():
    result = stoss.restitution(poisson=[0.4, 0.0, 0.2], speed=0.1)
    ax = result.plot()
    assert ax.get_xlabel() == "2-D Poisson's ratio ν" and ax.get_xscale() == "linear"
    assert np.array_equal(drawn(ax)[0].lines[0].get_xdata(), [0.0, 0.2, 0.4])
    assert np.array_equal(drawn(ax)[0].lines[0].get_ydata(), result.restitution[[1, 2, 0]])
    assert drawn(ax)[0].get_label() == "v = 0.1 c"


def test_many_poisson_numbers_have_few_names():
    several = stoss.restitution(poisson=np.linspace(0.0, 0.4, 9)[:, None], speed=[0.1, 0.2])
    ax = several.plot()
    assert len(drawn(ax)) == 9
    assert len(ax.get_legend().get_texts()) <= 7
    assert len({tuple(each.lines[0].get_color()) for each in drawn(ax)}) == 9


def test_new_figures_fit_a_column(curve):
    ax = curve.plot()
    assert ax.figure.get_figwidth() == 3.4
    texts = [*ax.get_xticklabels(), *ax.get_legend().get_texts(), ax.xaxis.label]
    sizes = {text.get_size() for text in texts}
    stoss.plot.restitution(curve, ax)
    assert sizes == {7.0, 8.0} and ax.get_legend().get_texts()[0].get_size() == 7.0


def test_failure_leaves_no_figure(curve):
    with pytest.raises(AttributeError):
        stoss.plot.restitution(curve, colour="red")
    assert pyplot.get_fignums() == []


FALLING = np.array([1e-3, 1e-8, 0.05, 1e-100, 0.01])


@pytest.fixture(scope="module")
def estimate():
    with pytest.warns(stoss.StossWarning):
        return quasistatic.rayleigh(poisson=[[0.33], [0.0]], speed=FALLING, cutoff=12)


def legend(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


def test_contact_time():
    slow = quasistatic.slow_impact(poisson=[[0.33], [-0.5]], speed=FALLING)
    ax = slow.plot()
    assert (ax.get_xlabel(), ax.get_ylabel(), ax.get_xscale()) == ("speed v / c", "contact time τ / (R/c)", "log")
    order = np.argsort(FALLING)
    for line, row, name in zip(ax.lines, (1, 0), ("ν = −0.5", "ν = 0.33")):
        assert np.array_equal(line.get_xdata(), FALLING[order])
        assert np.array_equal(line.get_ydata(), slow.contact_time[row, order])
        assert line.get_label() == name
    assert len(ax.lines) == 2 and legend(ax) == ["ν = −0.5", "ν = 0.33"]
    ax.figure.canvas.draw()


def test_lost_fraction(estimate):
    ax = estimate.plot()
    assert (ax.get_ylabel(), ax.get_yscale()) == ("lost fraction 1 − ε²", "log")
    order = np.argsort(FALLING)
    full, hollow = ax.lines[0::2], ax.lines[1::2]
    for k, row in enumerate((1, 0)):
        assert np.array_equal(full[k].get_xdata(), FALLING[order])
        assert np.array_equal(full[k].get_ydata(), estimate.lost_fraction[row, order])
        assert np.array_equal(hollow[k].get_xydata(), [[0.05, estimate.lost_fraction[row, 2]]])
        assert hollow[k].get_markerfacecolor() == "white" and hollow[k].get_color() == full[k].get_color()
    assert legend(ax) == ["ν = 0", "beyond perturbation theory", "ν = 0.33"]
    ax.figure.canvas.draw()


def test_band_is_the_error(estimate):
    ax = estimate.plot()
    known = np.argsort(FALLING)[:-1]  # all but the one beyond perturbation theory
    for band, row in zip(ax.collections, (1, 0)):
        ends = band.get_paths()[0].vertices
        lost, error = estimate.lost_fraction[row, known], estimate.lost_fraction_error[row, known]
        for k, v in enumerate(FALLING[known]):
            y = ends[ends[:, 0] == v, 1]
            assert y.max() == pytest.approx(lost[k] + error[k], rel=1e-12)
            assert y.min() == pytest.approx(max(lost[k] - error[k], 1e-3 * lost[k]), rel=1e-12)


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
