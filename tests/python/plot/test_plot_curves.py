"""Curves: what is drawn is what the results hold."""

import dataclasses

import numpy as np
import pytest

import stoss

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402
from matplotlib.container import ErrorbarContainer  # noqa: E402

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


def test_legend_of_a_dense_curve_shows_a_line_without_bars():
    dense = stoss.restitution(poisson=0.33, speed=np.geomspace(0.05, 0.2, 26))
    handles, labels = stoss.plot.restitution(dense).get_legend_handles_labels()
    assert labels == ["ν = 0.33"] and isinstance(handles[0], matplotlib.lines.Line2D)


def test_linear_scale(curve):
    ax = stoss.plot.restitution(curve, quantity="lost_fraction", scale="linear")
    assert (ax.get_xscale(), ax.get_yscale()) == ("linear", "linear")


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


def test_order_of_speeds_does_not_matter(curve):
    mixed = stoss.restitution(poisson=0.33, speed=SPEEDS[[3, 0, 4, 1, 2]])
    (only,) = drawn(stoss.plot.restitution(mixed))
    assert np.array_equal(only.lines[0].get_ydata(), curve.restitution)


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


def test_nothing_to_draw(curve):
    nothing = np.full(SPEEDS.shape, np.nan)
    ax = stoss.plot.restitution(dataclasses.replace(curve, restitution=nothing))
    assert drawn(ax)[0].lines[0].get_xdata().size == 0
    stoss.plot.restitution(stoss.restitution(poisson=0.33, speed=[])).figure.canvas.draw()


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


@pytest.mark.filterwarnings("ignore::stoss.StossWarning")
def test_rod():
    ax = stoss.restitution(stoss.Rod(), speed=[0.1, 0.2]).plot()
    assert drawn(ax)[0].get_label() == "rod"
    assert drawn(ax)[0].lines[0].get_xdata().size == 2


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


def test_given_axes_are_the_only_ones_touched(curve, curves):
    figure, (left, right) = pyplot.subplots(1, 2)
    for _ in range(2):
        assert curve.plot(left) is left
    assert stoss.plot.restitution(curve, left, label="again", color="black", linestyle=":") is left
    assert pyplot.get_fignums() == [figure.number] and figure.axes == [left, right]
    assert not right.has_data() and right.get_xlabel() == ""
    colors = [each.lines[0].get_color() for each in drawn(left)]
    assert colors[0] != colors[1] and colors[2] == "black"


def test_new_figures_fit_a_column(curve):
    ax = curve.plot()
    assert ax.figure.get_figwidth() == 3.4
    texts = [*ax.get_xticklabels(), *ax.get_legend().get_texts(), ax.xaxis.label]
    sizes = {text.get_size() for text in texts}
    stoss.plot.restitution(curve, ax)
    assert sizes == {7.0, 8.0} and ax.get_legend().get_texts()[0].get_size() == 7.0


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({"quantity": "contact_time"}, "quantity: got 'contact_time', allowed 'restitution' or 'lost_fraction'"),
        ({"scale": 3}, "scale: got 3, allowed 'log' or 'linear'"),
        ({"ax": 3}, "ax: got 3, allowed one matplotlib Axes or None"),
        ({"result": 0.9}, "result: got 0.9, allowed a stoss.Restitution"),
    ],
)
def test_refusals(curve, arguments, message):
    with pytest.raises(stoss.InvalidInput) as caught:
        stoss.plot.restitution(**({"result": curve} | arguments))
    assert str(caught.value).startswith(message)
    assert pyplot.get_fignums() == []


def test_array_of_axes_is_refused(curve):
    _, several = pyplot.subplots(1, 2)
    with pytest.raises(stoss.InvalidInput, match="take one"):
        curve.plot(several)


def test_failure_leaves_no_figure(curve):
    with pytest.raises(AttributeError):
        stoss.plot.restitution(curve, colour="red")
    assert pyplot.get_fignums() == []
