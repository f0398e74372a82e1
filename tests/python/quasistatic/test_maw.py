"""stoss.quasistatic.maw and Mindlin's statics: limits in closed form, shapes, and that docs/theory/points.md has them."""

import re
from pathlib import Path

import numpy as np
import pytest

import stoss
from stoss import quasistatic

THEORY = Path(__file__).parents[3] / "docs" / "theory" / "points.md"


def test_sliding_and_sticking_throughout():
    chi = 1.75 * quasistatic.mindlin_ratio(poisson=0.3)
    fast = quasistatic.maw(psi1=[5, 50], chi=chi)
    assert fast.psi2 == pytest.approx(np.array([5, 50]) - 4 * chi, rel=1e-15)
    assert (fast.sliding == 1).all() and (fast.psi2_error == 0).all()
    stuck = quasistatic.maw(psi1=0.7, chi=0.5)
    assert stuck.psi2 == pytest.approx(-0.7, abs=1e-4) and stuck.friction_loss < 1e-4 and type(stuck.psi2) is float


def test_arrays_broadcast():
    assert quasistatic.maw(psi1=[[0.5], [2.0]], chi=[1.0, 1.2, 1.4]).impulse.shape == (2, 3)
    assert quasistatic.mindlin_traction(tangential=0.3, distance=np.linspace(0, 2, 5)).shape == (5,)
    with pytest.raises(stoss.InvalidInput, match=r"^psi1, chi: got shapes \(2,\) and \(3,\), allowed shapes that"):
        quasistatic.maw(psi1=[1, 2], chi=[1, 2, 3])


def test_the_table_of_the_theory():
    rows = re.findall(r"^\| ([\d.]+) \| (1\.\d{4}) \| (.*) \|$", THEORY.read_text(encoding="utf-8"), re.MULTILINE)
    assert len(rows) == 4
    for poisson, chi, psi2 in rows:
        exact = 1.75 * quasistatic.mindlin_ratio(poisson=float(poisson))
        assert float(chi) == pytest.approx(exact, abs=5e-5)
        given = [float(each.replace("−", "-")) for each in psi2.split(" | ")]
        made = quasistatic.maw(psi1=[0.5, 1, 2, 3, 4, 5, 6], chi=exact, tolerance=1e-6).psi2
        assert given == pytest.approx(made.tolist(), abs=6e-5)
