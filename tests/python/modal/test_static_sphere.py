"""The exact compliance that the finite elements are compared with."""

import numpy as np
import pytest
from static_sphere import compliance, half_space_terms, radial


@pytest.mark.parametrize(
    "poisson, expected", [(0.0, -0.6635193), (0.3, -0.5059087), (0.45, -0.3668284)]
)
def test_series(poisson, expected):
    assert compliance(poisson) == pytest.approx(expected, abs=1e-7)
    assert compliance(poisson, 1000) == pytest.approx(compliance(poisson), abs=1e-6)


@pytest.mark.parametrize("poisson", [0.0, 0.2, 0.45])
def test_two_terms_of_it_are_those_of_a_bent_half_space(poisson):
    front, bend = half_space_terms(poisson)
    n = 1e5
    assert -radial(poisson, n) == pytest.approx(front, rel=1e-4)
    rest = float((-radial(poisson, n) - front) * n)
    assert rest == pytest.approx(front * bend, rel=1e-3, abs=1e-5)


def test_means_under_the_pressure():
    """Of 1/r and ln r between two points under 3/π (1 − r²)², by chance."""
    modal = pytest.importorskip("stoss.modal._compliance")
    rng = np.random.default_rng(1)
    radius = np.sqrt(1 - rng.random((2, 2_000_000)) ** (1 / 3))
    angle = 2 * np.pi * rng.random(radius.shape[1])
    between = np.sqrt(radius[0] ** 2 + radius[1] ** 2 - 2 * radius[0] * radius[1] * np.cos(angle))
    assert np.mean(np.log(between)) == pytest.approx(modal.LOGARITHM, abs=3e-3)
    assert np.mean(1 / between) == pytest.approx(modal.INVERSE, rel=1e-2)
