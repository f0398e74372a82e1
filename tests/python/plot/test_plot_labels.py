"""What stands at the axes of the pictures whose examples do not say it."""

import numpy as np
import pytest

import stoss

pytest.importorskip("matplotlib").use("Agg")
pytestmark = pytest.mark.usefixtures("closed")

RODS = [stoss.Rod(length=length) for length in (1.0, 1.1, 0.9, 1.05)]
HIT = {"poisson": 0.33, "speed": 0.1, "cutoff": 12.5}


def ring(decay_time):
    return stoss.rod_chain(RODS, circumference=40, temperature=1, collisions=200, decay_time=decay_time)


def middle(speed):
    hit = stoss.impact(poisson=0.33, speed=speed, cutoff=12.5)
    return hit.field(time=hit.contact_time / 2)


def below():
    hit = stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.1, cutoff=4)
    return hit.wave(time=[4, 8], distance=np.linspace(0, 9, 28), depth=np.linspace(0, 9, 28))


PICTURES = {
    "pair table": (
        lambda plot: plot.pair_table(
            stoss.pair_table(poisson=0.33, ratio=(1, 1.5), speed=(0.02, 0.3), error=2e-2), ratio=[1, 1.5]
        ),
        ("speed of approach v / c", "restitution ε", "ratio 1", "ratio 1.5"),
    ),
    "bounces": (
        lambda plot: stoss.bounce(poisson=0.33, speed=0.2, count=20, flight_time=30, cutoff=8).plot(),
        ("restitution ε", "impact", "unexcited"),
    ),
    "cooling": (lambda plot: plot.cooling(ring(0)), ("time", "energy / initial energy", "translation")),
    "histogram": (
        lambda plot: plot.restitution_histogram(ring(5)),
        ("coefficient of restitution ε", "probability density", "mean"),
    ),
    "mode shape": (
        lambda plot: plot.mode_shape(stoss.modes(poisson=0.33, cutoff=10), order=2, index=0),
        ("x / R", "(n, l) = (2, 0), ω = 1.439 c/R"),
    ),
    "ledger": (
        lambda plot: plot.ledger(stoss.impact(**HIT)),
        ("angular order n", "energy after impact / initial"),
    ),
    "static contact": (
        lambda plot: plot.static_contact(stoss.quasistatic.static_contact(poisson=0.33, compression=0.03)),
        ("pressure p / E", "Hertz"),
    ),
    "restitution": (
        lambda plot: plot.restitution(
            stoss.restitution(poisson=[[0.0], [0.33]], speed=[1e-3, 0.3]), quantity="lost_fraction"
        ),
        ("speed v / c", "lost fraction 1 − ε²", "ν = 0", "ν = 0.33"),
    ),
    "sequence": (
        lambda plot: plot.sequence(stoss.impact(poisson=0.33, speed=0.2, cutoff=12.5), count=3),
        ("t = −0.80 R/c", "3.97", "8.74"),
    ),
    "disk": (lambda plot: plot.disk(middle(0.2)), ("x / R", "y / R")),
    "stress": (
        lambda plot: plot.stress(middle(0.1), quantity="fringes", fringe=0.03),
        ("intensity sin²(π (σ₁ − σ₂)/f), f = 0.03 E",),
    ),
    "wave": (lambda plot: plot.wave(below()), ("t = 3.99 R/c",)),
}


def words(figure):
    for axes in figure.axes:
        yield from (axes.get_xlabel(), axes.get_ylabel(), axes.get_title())
        yield from (text.get_text() for text in axes.texts)
        yield from axes.get_legend_handles_labels()[1]


@pytest.mark.parametrize("name", PICTURES)
def test_axes_say_what_they_show(name):
    draw, expected = PICTURES[name]
    shown = set(words(draw(stoss.plot).figure))
    assert set(expected) <= shown, shown
