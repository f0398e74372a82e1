"""Lossy bodies: --loss-time and loss_time= in --against."""

import pytest
from conftest import number

BALL = "restitution --body sphere --poisson 0.3 --speed 0.01"


def test_a_lossy_sphere_loses_what_an_independent_program_says(stoss):
    (row,) = stoss.data(BALL, "--loss-time 0.3")
    assert abs(number(row, "restitution") - 0.86565) <= number(row, "restitution_error") + 1e-5
    assert number(row, "dissipated") == pytest.approx(number(row, "lost_to_first"), rel=5e-3)
    (none,) = stoss.data(BALL, "--loss-time 0")
    assert none == stoss.data(BALL)[0]
    assert none["dissipated"] == "0"


def test_each_of_two_bodies_has_its_own_loss_time(stoss):
    (row,) = stoss.data(BALL, "--loss-time 0.01 --against sphere,loss_time=0.05,radius=2")
    (other,) = stoss.data(
        "restitution --body sphere --poisson 0.3 --speed 0.01 --loss-time 0.025 --against sphere,loss_time=0.005,radius=0.5"
    )
    assert number(row, "restitution") == pytest.approx(number(other, "restitution"), rel=1e-9)
    assert number(row, "lost_to_second") == pytest.approx(number(other, "lost_to_first"), rel=1e-9)
    assert number(row, "lost_to_second") > 2 * number(row, "lost_to_first")
    (same,) = stoss.data(BALL, "--loss-time 0.3 --against same")
    assert number(same, "lost_to_first") == pytest.approx(number(same, "lost_to_second"), rel=1e-9)


@pytest.mark.parametrize(
    "body, sizes",
    [
        ("disk --poisson 0.3", "--young 2.1e11 --density 7850 --radius 0.01"),
        ("sphere --poisson 0.3", "--young 2.1e11 --density 7850 --radius 0.01"),
        ("rod", "--young 2.1e11 --density 7850 --length 0.01 --area 1e-4"),
    ],
)
def test_in_si_it_is_in_seconds(stoss, body, sizes):
    wave = (2.1e11 / 7850) ** 0.5
    (own,) = stoss.data(f"impact --body {body} --speed 0.01 --cutoff 25 --loss-time 0.1")
    (si,) = stoss.data(
        f"impact --body {body} {sizes} --speed {0.01 * wave!r} --cutoff 25 --loss-time {0.1 * 0.01 / wave!r}"
    )
    assert number(si, "restitution") == pytest.approx(number(own, "restitution"), rel=1e-9)
    assert number(si, "dissipated") == pytest.approx(number(own, "dissipated"), rel=1e-9)


@pytest.mark.parametrize(
    "arguments, complaint",
    [
        (f"{BALL} --loss-time -1", "loss_time: got -1, allowed 0 to 100000"),
        (f"{BALL} --loss-time nan", "loss"),
        (f"{BALL} --against sphere,loss_time=1e9", "against loss_time: got 1000000000, allowed 0 to 100000"),
        ("restitution --poisson 0.3 --speed 0.1 --method extrapolate --loss-time 1", "loss-time: got --loss-time"),
    ],
)
def test_impossible_loss_times_are_refused(stoss, arguments, complaint):
    result = stoss.run(arguments)
    assert result.returncode == 3
    assert complaint in result.stderr and result.stderr.count("\n") == 1
