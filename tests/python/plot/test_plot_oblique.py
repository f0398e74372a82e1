"""Oblique impacts: the picture shows what the result holds."""

import numpy as np
import pytest
import stoss

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib.container import ErrorbarContainer  # noqa: E402

pytestmark = pytest.mark.usefixtures("closed")
BALL = stoss.Sphere(poisson=0.3)


def drawn(ax):
    return [each for each in ax.containers if isinstance(each, ErrorbarContainer)]


def words(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


def test_tangential_and_normal_restitution_against_the_angle():
    fan = stoss.oblique(BALL, speed=0.05, angle=[60, 5, -30], friction=0.2)
    ax = fan.plot()
    (curve,) = drawn(ax)
    assert curve.lines[0].get_xdata() == pytest.approx([-30, 5, 60])
    assert curve.lines[0].get_ydata().tolist() == fan.tangential_restitution[[2, 1, 0]].tolist()
    normal = next(line for line in ax.lines if line.get_label() == "$\\varepsilon_n$")
    assert normal.get_ydata().tolist() == fan.restitution.tolist()
    assert words(ax) == ["$\\varepsilon_n$", "$\\varepsilon_t$"] and "degrees" in ax.get_xlabel()


def test_a_curve_for_each_speed_friction_and_spin():
    fan = stoss.oblique(BALL, speed=[[0.02], [0.05]], tangential=[0.01, 0.02], friction=0.2)
    ax = stoss.plot.oblique(fan, over="sliding")
    assert [curve.lines[0].get_xdata().tolist() for curve in drawn(ax)] == [
        pytest.approx([0.01 / 0.004, 0.02 / 0.004]), pytest.approx([0.01 / 0.01, 0.02 / 0.01])
    ]  # fmt: skip
    assert words(ax)[1:] == ["$\\varepsilon_t$, v = 0.02 c", "$\\varepsilon_t$, v = 0.05 c"]
    steel = stoss.Sphere(radius=0.01, material=stoss.Material(young=2.1e11, poisson=0.3, density=7850))
    spins = stoss.oblique(steel, speed=1.0, angle=30, spin=[0, 100], friction=[[0.1], [0.2]]).plot()
    assert words(spins)[2] == "$\\varepsilon_t$, μ = 0.1, Ω = 100 rad/s" and len(drawn(spins)) == 4


def test_where_nothing_slides_there_is_no_tangential_restitution():
    ax = stoss.oblique(BALL, speed=0.05, tangential=[0.0, 0.01], friction=0.2).plot()
    assert drawn(ax)[0].lines[0].get_xdata().size == 1
    smooth = stoss.plot.oblique(stoss.oblique(BALL, speed=0.05, tangential=0.01, friction=0.0), over="sliding")
    assert drawn(smooth)[0].lines[0].get_xdata().size == 0


def test_doubtful_values_are_hollow():
    with pytest.warns(stoss.StossWarning):
        fan = stoss.oblique(BALL, speed=0.1, tangential=[0.02, 0.5], friction=0.2, tolerance=1e-5)
    ax = fan.plot()
    (hollow,) = [line for line in ax.lines if line.get_markerfacecolor() == "white"]
    assert hollow.get_ydata().tolist() == [fan.tangential_restitution[0]]


def test_refused():
    with pytest.raises(stoss.InvalidInput, match="over: got 'speed', allowed 'angle' or 'sliding'"):
        stoss.plot.oblique(stoss.oblique(BALL, speed=0.1, tangential=0.1, friction=0.1), over="speed")
    with pytest.raises(stoss.InvalidInput, match="result: got"):
        stoss.plot.oblique(np.arange(3))
