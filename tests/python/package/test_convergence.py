"""What is not converged, or beyond small strains, says so."""

import warnings

import numpy as np
import pytest

import stoss


def restitution(**changed):
    return stoss.restitution(**{"poisson": 0.33, "speed": 0.1, "tolerance": 0.1, **changed})


def impact(**changed):
    return stoss.impact(**{"poisson": 0.33, "speed": 0.1, "cutoff": 6, **changed})


def test_not_converged_carries_the_best_value():
    with pytest.raises(stoss.NotConverged) as caught:
        stoss.restitution(stoss.Rod(), speed=0.1)
    best = caught.value.best
    assert isinstance(caught.value, RuntimeError) and str(caught.value).startswith("restitution: ")
    assert isinstance(best, stoss.Restitution) and not best.converged and best.reason in str(caught.value)
    assert best.restitution == pytest.approx(1, abs=1e-2) and best.contact_time == pytest.approx(2, abs=1e-2)
    assert "not converged" in repr(best) and len(repr(best)) <= 160
    with pytest.raises(stoss.NotConverged, match="impact: would take more than") as caught:
        impact(against=stoss.ExponentialWall(hardness=1e6))
    assert caught.value.best is None


def test_arrays_mark_what_is_not_converged():
    with pytest.warns(stoss.StossWarning, match="^2 of 2 values not as accurate as asked for") as caught:
        result = stoss.restitution(stoss.Rod(), speed=[0.1, 0.2])
    assert caught[0].filename == __file__
    assert result.converged.tolist() == [False, False] and all(result.reason) and "2 not converged" in repr(result)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert restitution(speed=[0.05, 0.08]).reason.tolist() == ["", ""]


def test_large_strain_is_warned_of():
    for speed in (0.9, [0.1, 0.9]):
        with pytest.warns(stoss.StossWarning, match="^strain of some 0.[0-9]+, above 0.1") as caught:
            result = restitution(speed=speed)
        assert caught[0].filename == __file__ and np.any(result.beyond_small_strain)
    assert impact(speed=0.9).beyond_small_strain and not impact().beyond_small_strain
