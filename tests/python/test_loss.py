"""Lossy bodies: loss_time of disks, spheres and rods."""

import numpy as np
import pytest
import stoss


@pytest.mark.parametrize("body", [stoss.Disk(poisson=0.3, loss_time=0.1), stoss.Rod(loss_time=0.1)])
def test_what_is_lost_to_the_material_is_in_the_ledger(body):
    hit = stoss.impact(body, speed=0.05, cutoff=40)
    total = hit.translation + hit.vibration + hit.dissipated + hit.unresolved
    assert total == pytest.approx(1, abs=5e-3)
    path = hit.trajectory()
    assert path.dissipated[0] == 0 and path.dissipated[-1] == pytest.approx(hit.dissipated, abs=1e-14)
    assert np.all(np.diff(path.dissipated) > -1e-6)
    assert hit.lost_to_first == pytest.approx(hit.lost_fraction, abs=5e-3)


def test_a_lossy_sphere_loses_what_an_independent_program_says():
    ball = stoss.Sphere(poisson=0.3, loss_time=0.3)
    value = stoss.restitution(ball, speed=0.01)
    assert abs(value.restitution - 0.86565) <= value.restitution_error + 1e-5
    assert value.dissipated == pytest.approx(value.lost_to_first, rel=5e-3)
    assert stoss.restitution(poisson=0.3, speed=0.01).dissipated == 0


def test_a_material_makes_it_seconds():
    steel = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
    scales = stoss.Sphere(radius=0.01, material=steel).scales
    ball = stoss.Sphere(radius=0.01, material=steel, loss_time=0.1 * scales.time)
    here = stoss.impact(ball, speed=0.01 * scales.speed, cutoff=20)
    there = stoss.impact(stoss.Sphere(poisson=0.3, loss_time=0.1), speed=0.01, cutoff=20)
    assert here.restitution == pytest.approx(there.restitution, rel=1e-9)
    assert here.dissipated == pytest.approx(there.dissipated, rel=1e-9)


def test_each_of_two_bodies_has_its_own():
    lossy, lossless = stoss.Sphere(poisson=0.3, loss_time=0.1), stoss.Sphere(poisson=0.3)
    one = stoss.impact(lossy, against=lossless, speed=0.02, cutoff=20)
    other = stoss.impact(lossless, against=lossy, speed=0.02, cutoff=20)
    assert one.restitution == pytest.approx(other.restitution, rel=1e-10)
    assert one.lost_to_first == pytest.approx(other.lost_to_second, rel=1e-9)
    assert one.lost_to_first > 20 * one.lost_to_second


def test_the_call_that_makes_it_is_shown():
    assert repr(stoss.Disk(poisson=0.3, loss_time=0.1)) == "Disk(poisson=0.3, loss_time=0.1)"
    assert repr(stoss.Rod(loss_time=2)) == "Rod(loss_time=2)"
    assert repr(stoss.Sphere(poisson=0.3, loss_time=0)) == "Sphere(poisson=0.3)"


@pytest.mark.parametrize("bad", [-1, float("nan"), float("inf"), 1e6, "much"])
@pytest.mark.parametrize("make", [stoss.Rod, lambda **its: stoss.Disk(poisson=0.3, **its)])
def test_impossible_loss_times_are_refused(make, bad):
    with pytest.raises(stoss.InvalidInput, match="loss_time: got"):
        make(loss_time=bad)
