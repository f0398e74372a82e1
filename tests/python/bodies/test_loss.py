"""Lossy bodies: loss_time of disks, spheres and rods."""

import dataclasses

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


RUBBER = stoss.Material(young=2e6, poisson=0.49, density=1100, quality=(10, 2 * np.pi * 500))


def test_a_quality_is_that_of_one_frequency():
    assert RUBBER.loss_time == pytest.approx(1 / (10 * 2 * np.pi * 500), rel=1e-15)
    same = stoss.Material(young=2e6, poisson=0.49, density=1100, loss_time=RUBBER.loss_time)
    assert same == RUBBER and hash(same) == hash(RUBBER) and eval(repr(RUBBER), vars(stoss)) == RUBBER
    assert dataclasses.replace(RUBBER, young=1e6).loss_time == RUBBER.loss_time


@pytest.mark.parametrize(
    "make",
    [
        lambda **its: stoss.Sphere(radius=5e-3, **its),
        lambda **its: stoss.Disk(radius=5e-3, **its),
        lambda **its: stoss.Rod(length=5e-3, area=1e-4, **its),
        stoss.HalfSpace,
        stoss.HalfPlane,
    ],
)
def test_bodies_have_the_loss_time_of_their_material(make):
    lossy, elastic = make(material=RUBBER), make(material=RUBBER, loss_time=0)
    assert lossy.loss_time == RUBBER.loss_time and elastic.loss_time == 0
    assert lossy == make(material=RUBBER, loss_time=RUBBER.loss_time) != elastic
    assert "loss_time" not in repr(lossy).partition("material=")[0] and "loss_time=0" in repr(elastic)


# Ting's law to second order; a finite ball is a little stiffer than Hertz' contact.
def test_a_rubber_ball_loses_what_its_material_takes():
    ball = stoss.Sphere(radius=5e-3, material=RUBBER)
    slow = stoss.restitution(ball, speed=0.001)
    stiffness = 4 / 3 * ball.young / (1 - ball.poisson**2) * ball.radius**0.5
    mass = 4 / 3 * np.pi * ball.radius**3 * ball.density
    x = 1.5 * ball.loss_time * (stiffness / mass) ** 0.4 * 0.001**0.2
    assert 1 - slow.restitution == pytest.approx(1.153449 * x - 1.08872 * x**2, rel=0.02)
    assert slow.dissipated == pytest.approx(slow.lost_fraction, rel=2e-3)


def test_a_lossy_half_space_in_si():
    ball = stoss.Sphere(radius=5e-3, material=RUBBER, loss_time=0)
    scale = ball.scales
    found = stoss.impact(ball, against=stoss.HalfSpace(material=RUBBER), speed=0.05 * scale.speed, cutoff=6)
    like = stoss.HalfSpace(loss_time=RUBBER.loss_time / scale.time)
    other = stoss.impact(stoss.Sphere(poisson=0.49), against=like, speed=0.05, cutoff=6)
    for name in ("restitution", "dissipated", "lost_to_second"):
        assert getattr(found, name) == pytest.approx(getattr(other, name), rel=1e-9), name
    assert found.dissipated > 0.05 and repr(like).startswith("HalfSpace(loss_time=")


@pytest.mark.parametrize(
    "call, said",
    [
        (lambda: stoss.Material(young=1, poisson=0, density=1, quality=(10, 1), loss_time=1), "none with loss_time"),
        (lambda: stoss.Material(young=1, poisson=0, density=1, quality=10), r"\(Q, ω\)"),
        (lambda: stoss.Material(young=1, poisson=0, density=1, quality=(0, 1)), "quality: got 0"),
        (lambda: stoss.Material(young=1, poisson=0, density=1, quality=(1, float("nan"))), "frequency: got nan"),
        (lambda: stoss.Material(young=1, poisson=0, density=1, loss_time=-1), "loss_time: got -1"),
        (lambda: stoss.Material(young=1, poisson=0, density=1, loss_time=float("inf")), "loss_time: got inf"),
        (lambda: stoss.HalfSpace(loss_time=-1), "loss_time: got -1"),
        (lambda: stoss.Sphere(poisson=0.3, loss_time=0.1, rigid=True), "0 of a rigid body"),
        (lambda: stoss.Disk(poisson=0.3, loss_time=0.1, rigid=True), "0 of a rigid body"),
    ],
)
def test_refusals_of_materials_and_rigid_bodies(call, said):
    with pytest.raises(stoss.InvalidInput, match=said):
        call()


def test_a_rigid_body_loses_nothing():
    rigid = stoss.Sphere(radius=5e-3, material=RUBBER, rigid=True)
    assert rigid.loss_time == 0 and eval(repr(rigid), vars(stoss)) == rigid
