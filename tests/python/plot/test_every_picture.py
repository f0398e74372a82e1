"""Every function of stoss.plot: it draws in the axes that it is given and nowhere else, says at them what it shows, and
refuses in one line what it cannot draw, and other numbers."""

import inspect

import matplotlib
import numpy as np
import pytest
import stoss
from every_result import BALL, computed
from matplotlib import pyplot
from wrong_values import nan


pytestmark = [pytest.mark.usefixtures("closed"), pytest.mark.filterwarnings("ignore::stoss.StossWarning")]


def middle():
    hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=10)
    return hit.field(time=hit.contact_time / 2)


def below():
    points = np.linspace(0, 9, 28)
    return stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.1, cutoff=4).wave(
        time=[4, 8], distance=points, depth=points
    )


def ball():
    hit = stoss.impact(BALL, speed=1.0, cutoff=8)
    return hit.field(time=hit.contact_time / 2)


# What each draws, with which arguments, and what stands at it.
PICTURES = {
    "bounces": (lambda: computed("bounce"), {}, ("restitution ε", "impact", "unexcited")),
    "cooling": (lambda: computed("chain"), {}, ("time (s)", "energy / initial energy", "translation")),
    "disk": (middle, {}, ("x / R", "y / R")),
    "distribution": (lambda: computed("distribution"), {}, ("mean 0.9447", "samples")),
    "energies": (lambda: computed("trajectory of a disk"), {}, ("energy / initial energy", "time t / (R/c)", "stored",
     "sum")),
    "force": (lambda: computed("trajectory of a disk"), {"label": "one", "color": "black"}, ("time t / (R/c)",
     "force F / (πRE)", "one")),
    "function": (lambda: computed("function"), {}, ("speed of approach v / (m/s)",)),
    "grip": (lambda: computed("oblique trajectory"), {}, ("y / R",)),
    "half_width": (lambda: computed("trajectory of a disk"), {}, ("contact half-width / R",)),
    "ledger": (lambda: computed("impact-static"), {}, ("angular order n", "energy after impact / initial")),
    "master_curve": (lambda: stoss.relaxation_of_measurement([1, 10, 100], [1e6, 1.2e6, 1.5e6], [1e5, 2e5, 1e5]), {},
     ("frequency ω / (rad/s)", "modulus / Pa", "E′", "E″")),
    "mode_shape": (lambda: computed("modes"), {"order": 2, "index": 0}, ("x / R", "(n, l) = (2, 0), ω = 1.439 c/R")),
    "oblique": (lambda: stoss.oblique(BALL, speed=1.0, angle=[10, 30], friction=0.3), {}, ("$\\varepsilon_n$",
     "$\\varepsilon_t$")),
    "oblique_impact": (lambda: computed("oblique trajectory"), {}, ()),
    "oblique_ledger": (lambda: computed("oblique impact"), {}, ()),
    "pair_table": (lambda: computed("pair table"), {"ratio": [1, 1.5]}, ("speed of approach v / c", "restitution ε",
     "ratio 1", "ratio 1.5")),
    "calibration": (lambda: computed("calibrate"), {}, ("contact time, s", "speed of impact, m/s", "stoss", "measured")),
    "prediction": (lambda: computed("predict-block"), {}, ()),
    "pulse": (lambda: computed("pulse"), {}, ("force F / kN", "Hertz")),
    "pulse_spectrum": (lambda: computed("pulse"), {}, ("amplitude / impulse", "corner", "first null")),
    "rayleigh": (lambda: computed("rayleigh-ball"), {}, ("lost fraction 1 − ε²", "speed v / (m/s)")),
    "restitution": (lambda: computed("curve"), {"quantity": "lost_fraction"}, ("speed v / c", "lost fraction 1 − ε²",
     "ν = 0.2", "ν = 0.33")),
    "restitution_histogram": (lambda: computed("chain"), {}, ("coefficient of restitution ε", "probability density",
     "mean")),
    "row": (lambda: computed("row"), {}, ("velocity / (m/s)", "body", "before", "after")),
    "row_impact": (lambda: computed("row motion"), {}, ("velocity / c", "body", "time t / (R/c)", "body 0")),
    "seismogram": (lambda: computed("seismogram"), {}, ("normal", "radial")),
    "sequence": (lambda: stoss.impact(poisson=0.33, speed=0.2, cutoff=12.5), {"count": 3}, ("t = −0.80 R/c", "3.97",
     "8.74")),
    "slow_impact": (lambda: computed("slow impacts"), {}, ("speed v / c", "contact time τ / (R/c)")),
    "spectrum": (lambda: computed("modes-ball"), {}, ("degree n", "frequency ω / (c/R)")),
    "sphere": (ball, {}, ("x / R",)),
    "static_contact": (lambda: computed("static contact"), {}, ("pressure p / E", "Hertz")),
    "stress": (middle, {"quantity": "fringes", "fringe": 0.03}, ("intensity sin²(π (σ₁ − σ₂)/f), f = 0.03 E",)),
    "velocity": (lambda: computed("trajectory of a disk"), {}, ("velocity towards the wall / c",)),
    "wave": (below, {}, ("t = 3.99 R/c", "$c_p t$", "2 R")),
}  # fmt: skip
# Of arguments other than what is drawn and where.
WRONG = {
    "quantity": ["heat", "", 1], "scale": [3], "label": [], "when": ["before"], "over": ["speed"], "limit": [0.0,
     np.inf, nan],
    "fringe": [0.0, -1, nan], "frame": [7], "circles": [0], "spokes": [0], "count": [1], "columns": [0], "orders": [0,
     2.5],
    "indices": [2.5], "of": [7, "x"], "amplitude": [2, nan], "times": [[], "now"], "ratio": [nan],
    "order": [99], "index": [99], "bins": [], "color": [],
}  # fmt: skip


def words(figure):
    for axes in [each for whole in figure.axes for each in (whole, *whole.child_axes)]:
        yield from (axes.get_xlabel(), axes.get_ylabel(), axes.get_title())
        yield from (text.get_text() for text in axes.texts)
        yield from axes.get_legend_handles_labels()[1]


def test_all_are_here():
    assert {*PICTURES} == {*stoss.plot.__all__} - {"animate"} and stoss.animate is stoss.plot.animate


@pytest.mark.parametrize("name", PICTURES)
def test_is_drawn_where_it_should_be_and_says_what_it_shows(name):
    make, given, expected = PICTURES[name]
    draw, what = getattr(stoss.plot, name), make()
    figure, (left, right) = pyplot.subplots(1, 2)
    assert draw(what, left, **given) is left
    assert pyplot.get_fignums() == [figure.number] and not right.has_data() and right.get_xlabel() == right.get_title() == ""
    shown = set(words(figure))
    assert set(expected) <= shown, shown
    alone = matplotlib.figure.Figure()  # without pyplot
    if name != "bounces":  # which asks for axes of subplots
        draw(what, alone.add_subplot(), **given)
        alone.canvas.draw()
    assert pyplot.get_fignums() == [figure.number]
    assert draw(what, **given).figure.number != figure.number


@pytest.mark.parametrize("name", PICTURES)
def test_refuses_what_it_cannot_draw(name):
    make, given, _ = PICTURES[name]
    draw, what = getattr(stoss.plot, name), make()
    first, _, *others = inspect.signature(draw).parameters
    for wrong in (3, None, stoss.Disk(poisson=0.3), np.arange(3)):
        with pytest.raises(stoss.InvalidInput, match=rf"^{first}: got .*, allowed (a|one) "):
            draw(wrong, **given)
    for ax in (3, np.array([None, None])):
        with pytest.raises(stoss.InvalidInput, match="^ax: got .*, allowed one matplotlib Axes"):
            draw(what, ax, **given)
    for each in others:
        for value in WRONG.get(each, []):
            with pytest.raises(stoss.InvalidInput, match=r"^\w+: got .*, allowed .*") as caught:
                draw(what, **{**given, each: value})
                pytest.fail(f"{each}={value!r} is taken")
            assert str(caught.value).isprintable()
    assert pyplot.get_fignums() == []


def test_methods_draw_the_same():
    for name in ("bounce", "chain", "distribution", "function", "modes", "pair table", "curve", "static contact",
     "slow impacts",
                 "trajectory of a disk", "oblique trajectory", "oblique impact", "impact", "predict-block",
                  "rayleigh-ball", "row", "rows", "row motion", "pulse", "seismogram of a plate"):  # fmt: skip
        figure, ax = pyplot.subplots()
        assert computed(name).plot(ax) is ax and any(words(figure)), name
    computed("empty").plot().figure.canvas.draw()
    assert computed("chain").histogram().get_ylabel() == "probability density"
