"""One impact where no cutoff is given: what restitution computes, impact computes too, at a cutoff that both bodies have."""

import pytest
from conftest import number, rows
from test_cost import bounded

pytestmark = pytest.mark.numbers

BALL = "--body sphere --poisson 0.3 --speed 0.01 --against"
SOFT = "young=1e-3,density=1e3"


@pytest.mark.parametrize(
    "words",
    [
        f"{BALL} sphere,radius=20",
        f"{BALL} sphere,radius=30",
        f"{BALL} sphere,radius=0.03",
        f"{BALL} sphere,young=0.001",
        f"{BALL} sphere,density=1000",
        "--body disk --poisson 0.3 --speed 0.01 --against disk,radius=20",
        "--body disk --poisson 0.3 --speed 0.01 --against disk,radius=300",
        "--body disk --poisson 0.3 --speed 0.01 --against disk,radius=0.03",  # at 50 c/R of the first it had hardly any modes
        "--body disk --poisson 0.3 --speed 0.01 --against disk,young=0.001",
        "--body disk --poisson 0.3 --speed 0.01 --against disk,density=1000",
        "--body rod --speed 0.01 --against rod,length=0.01",
        "--body sphere --radius 0.005 --material glass --rigid-body --speed 0.1 "
        "--against sphere,radius=0.005,material=rubber",
        # longer than Hertz' contact on what is so soft and heavy
        f"--body disk --poisson 0.3 --speed 0.0005 --against half-plane,{SOFT}",
        f"--body sphere --poisson 0.3 --speed 0.0005 --against half-space,{SOFT}",
        # the body stays
        "--body sphere --poisson -0.191 --speed 0.175 --against plate,thickness=0.0668,young=24.9,density=2.47",
    ],
)
def test_one_impact_is_that_of_the_restitution(stoss, words):
    one, used = bounded(stoss, f"impact {words} --format csv", 5)
    assert one.returncode == 0, one.stderr
    assert used < 5
    best = rows(stoss.run("restitution", words, "--tolerance 0.01 --format csv").stdout)[0]
    error = 4 * number(best, "restitution_error") + 2e-3  # near sides of disks lack the curvature (stoss::contact)
    assert number(rows(one.stdout)[0], "restitution") == pytest.approx(number(best, "restitution"), abs=error)


@pytest.mark.parametrize(
    "against, said",
    [
        ("sphere,radius=100", "allowed a body whose R/c is at most 37 times that of the other"),
        ("sphere,radius=1e300", "radius ratio: got 1e+300, allowed 0.001 to 1000"),
        ("half-space,density=1e300", "density ratio: got 1e+300, allowed 0.001 to 1e6 (of the half-space"),
    ],
)
@pytest.mark.parametrize("command", ["impact", "restitution"])
def test_bodies_too_unequal_are_refused_for_what_was_given(stoss, command, against, said):
    result = stoss.run(command, BALL, against)
    assert (result.returncode, result.stderr.count("\n")) == (3, 1)
    assert said in result.stderr and "cutoff" not in result.stderr
