"""What the command takes of the processor, in processor time: it ends, or refuses before it computes."""

import resource
import subprocess

import pytest
from conftest import number, rows

pytestmark = pytest.mark.usefixtures("usual_build")


def bounded(stoss, arguments, seconds):
    """Runs the command, which is killed after so much processor time; returns the process and what it has used."""

    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))

    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = subprocess.run(
        [stoss.path, *arguments.split()], capture_output=True, text=True, stdin=subprocess.DEVNULL, preexec_fn=limit
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return result, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


BALL = "--body sphere --poisson 0.3 --speed 0.01"
MANY = "thickness=0.1" + "".join(f"/thickness=0.1,young={(1000, 1)[i % 2]}" for i in range(19))


@pytest.mark.parametrize(
    "against",
    [
        "plate,thickness=0.02,young=0.3,density=0.001",  # of which almost nothing comes back
        "plate,thickness=0.002,young=0.3,density=0.001",  # a sheet, in which a wave crosses the thickness at once
        "plate,thickness=0.5/thickness=0.1,young=0.001,density=100",  # a slow layer where no wave goes
        pytest.param("plate,thickness=0.5,young=0.001/thickness=0.1,young=1000", marks=pytest.mark.long),
        "plate," + MANY,
    ],
)
def test_plates_of_all_layers_end(stoss, against):
    result, used = bounded(stoss, f"restitution {BALL} --against {against}", 20)
    assert result.returncode == 0, result.stderr
    assert used < 8.0


@pytest.mark.parametrize("what", ["--against same --oblique", "--against same", "--against same --ratio 1:2"])
def test_a_name_that_c_cannot_have_is_refused_before_the_table(stoss, what):
    result, used = bounded(stoss, f"table --body sphere --poisson 0.3 --speed 1e-4:1e-2 {what} --name a-b", 20)
    assert result.returncode == 3
    assert result.stderr.startswith("stoss: error: name: got 'a-b'")
    assert used < 1.0


@pytest.mark.parametrize("against, speed", [("half-space", 1e-4), ("half-space,young=0.1,density=10", 1e-4), ("plate,thickness=1", 0.01),
                                            pytest.param("half-space", 1e-8, marks=pytest.mark.long)])  # fmt: skip
def test_one_impact_needs_no_cutoff(stoss, against, speed):
    """On what has no end, the modes that are kept by default are few, and enough."""
    ball = f"--body sphere --poisson 0.3 --speed {speed} --against {against}"
    result, used = bounded(stoss, f"impact {ball} --format csv", 10)
    assert result.returncode == 0, result.stderr
    assert used < 2.0
    row, = rows(result.stdout)
    exact, = stoss.data(f"restitution {ball} --tolerance 1e-4")
    allowed = number(exact, "restitution_error") + (2e-5 if speed == 0.01 else 2e-6)
    assert abs(number(row, "restitution") - number(exact, "restitution")) < allowed


@pytest.mark.parametrize(
    "range_and_plate",
    [
        "1e-3:1e-2 --against plate,thickness=0.1",
        "1e-3:1e-2 --against plate,thickness=0.02,young=0.3,density=0.001",
    ],
)
def test_a_table_of_balls_that_stay_refuses_at_once_an_error_that_it_cannot_have(stoss, range_and_plate):
    result, used = bounded(stoss, f"table --oblique --body sphere --poisson 0.3 --speed {range_and_plate}", 20)
    assert result.returncode != 0
    assert "the body stays" in result.stderr and "allow an error from 0.003" in result.stderr
    assert used < 2.0


@pytest.mark.long
def test_a_table_of_balls_that_stay_ends_with_an_error_that_it_can_have(stoss):
    arguments = "table --oblique --body sphere --poisson 0.3 --speed 1e-3:1e-2 --against plate,thickness=0.1 --error 0.004"
    result, used = bounded(stoss, arguments, 20)
    assert result.returncode == 0, result.stderr
    assert used < 6.0


@pytest.mark.parametrize(
    "arguments",
    [
        "--speed 1e-3 --tolerance 1e-5 --against plate,thickness=0.1",  # what no run tells of a ball that stays
        # too many points
        pytest.param("--speed 9e-4 --tolerance 1e-6 --against half-space,young=1e-3,density=1e3", marks=pytest.mark.long),
    ],
)
def test_an_oblique_ladder_without_hope_ends_with_the_best_value(stoss, arguments):
    friction = "oblique --body sphere --poisson 0.3 --tangential 1e-3 --friction 0.1 --format json"
    result, used = bounded(stoss, f"{friction} {arguments}", 30)
    assert '"converged": false' in result.stdout, result.stderr
    assert "use a larger tolerance, from" in result.stderr
    assert used < 12.0


@pytest.mark.parametrize(
    "who",
    [
        "--speed 0.01 --against plate,thickness=0.001,young=0.05",
        "--speed 0.3 --rigid-body --against plate,thickness=0.01",
        "--speed 0.01 --rigid-body --against plate,thickness=0.01",
    ],
)
def test_a_ball_that_stays_unseen_on_a_thin_plate_is_told_at_once(stoss, who):
    result, used = bounded(stoss, f"restitution --body sphere --poisson 0.3 {who}", 20)
    assert result.returncode == 1
    assert "stays on it for longer than is computed" in result.stderr
    assert used < 1.0


@pytest.mark.long
def test_a_table_of_a_rule_refuses_in_seconds_what_its_points_never_resolve(stoss):
    """It said after 80 s of processor time "use a larger tolerance, from 0.021", which is more than it was given."""
    plate = "--against plate,thickness=0.02,young=0.3,density=0.001"
    words = f"table --oblique --body sphere --poisson 0.3 --speed 1e-3:1e-2 {plate} --error 1e-2"
    result, used = bounded(stoss, words, 60)
    assert result.returncode == 1 and "(allow a larger tolerance, from 0.04" in result.stderr, result.stderr
    assert used < 10.0
