"""stoss oblique: what is neglected, and what no rule has."""


import pytest
from conftest import number

pytestmark = pytest.mark.numbers

BALL = "oblique --body sphere --poisson 0.3 --friction 0.2"


def test_table_tells_what_neglected_coupling_may_change(stoss):
    motion = "--speed 0.01 --angle 0.5,60"
    result = stoss.run(f"{BALL} {motion}")
    near, far = stoss.data(f"{BALL} {motion}")
    added, normal = (float(near[f"coupling_{name}restitution"]) for name in ("tangential_", ""))
    assert result.stderr == (
        "stoss: warning: neglected coupling may change tangential_restitution by up to "
        f"{abs(added):.2g}, restitution by up to {abs(normal):.2g}\n"
    )
    assert 0.08 < added < 0.2 and abs(float(far["coupling_tangential_restitution"])) < 0.002
    assert -1e-3 < normal == float(far["coupling_restitution"]) < -3e-4
    assert number(near, "coupling_sliding_after") == pytest.approx(-added * number(near, "sliding"), rel=1e-12)
    assert float(near["dundurs"]) == pytest.approx(2 / 7, rel=1e-9)


def test_nothing_is_neglected_between_equal_balls_and_of_disks(stoss):
    smooth = BALL.replace("0.2", "0")
    for bodies in (f"{BALL} --against same", "oblique --body disk --poisson 0.3 --friction 0.2", smooth):
        arguments = f"{bodies} --speed 0.05 --tangential 0.01"
        (row,) = stoss.data(arguments)
        assert [value for name, value in row.items() if name.startswith(("dundurs", "coupling"))] == 4 * ["0"]
        assert stoss.run(arguments).stderr == ""
