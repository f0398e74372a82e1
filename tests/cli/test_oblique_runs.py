"""stoss oblique: values that are in doubt, runs that end early, refusals."""

import json
import signal
import subprocess

import pytest
from conftest import number, resume, rows, wait_for_rows

pytestmark = pytest.mark.numbers

BALL = "oblique --body sphere --poisson 0.3 --friction 0.2"
STEEL = "oblique --body sphere --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01 --friction 0.1"


def test_not_converged_is_marked_told_and_exits_with_1(stoss):
    arguments = f"{BALL} --speed 0.1 --tangential 0.02 --tolerance 1e-5"
    result = stoss.run(arguments)
    assert result.returncode == 1 and " !" in result.stdout
    why, _, summary = result.stderr.splitlines()
    assert why.startswith("stoss: warning: speed 0.1 c, tangential 0.02 c: the tolerance asks for more points across")
    assert summary.startswith("stoss: warning: 1 of 1 values")
    record = json.loads(stoss.run(arguments, "--format json").stdout)["records"][0]
    assert record["converged"] is False and record["reason"] in why


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


def test_result_does_not_depend_on_threads(stoss):
    disk = "oblique --body disk --poisson 0.33 --speed 0.2 --angle 20,60 --friction 0.3"
    for job in (f"{BALL} --speed 0.05,0.1 --angle lin:0:80:40", disk):
        one, eight = (stoss.data(f"{job} --threads {threads}") for threads in (1, 8))
        assert one == eight


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGKILL])
def test_interrupted_or_killed_and_resumed(stoss, tmp_path, sent):
    path = tmp_path / "angles.csv"
    job = f"{BALL} --speed log:0.01:0.1:4 --angle lin:-80:80:100"
    command = stoss.start(f"{job} --threads 1 --format csv -o {path}", stderr=subprocess.DEVNULL)
    wait_for_rows(command, path, 33)
    command.send_signal(sent)
    assert command.wait(timeout=60) == (-sent if sent == signal.SIGKILL else 130)
    begun = len(rows(path.read_text()))
    assert 33 <= begun < 400
    result = resume(stoss, path, job)
    assert (result.returncode, result.stderr) == (0, "")
    assert rows(path.read_text()) == stoss.data(job)


def test_file_of_other_motion_is_refused(stoss, tmp_path):
    path = tmp_path / "x.csv"
    assert resume(stoss, path, f"{BALL} --speed 0.05 --tangential 0.01").returncode == 0
    before = path.read_text()
    for other in (f"{BALL} --speed 0.05 --tangential 0.02", f"{BALL} --speed 0.05 --angle 1"):
        result = resume(stoss, path, other)
        assert result.returncode == 3 and "another job needs another file" in result.stderr
        assert path.read_text() == before


@pytest.mark.parametrize(
    "arguments, said",
    [
        ("oblique --body rod --friction 0.3 --speed 0.1", "friction: not available for 'rod', but for disks"),
        (f"{BALL} --speed 0.05 --against exponential", "against: got exponential, allowed wall, same or a body"),
        (f"{BALL} --speed 2", "speed: got 2, allowed 1e-8 to 1 c"),
        (f"{BALL} --speed 0.05 --tangential 1.5", "tangential: got 1.5, allowed -1 to 1 c"),
        (f"{STEEL} --speed 1 --tangential 1e6", "tangential: got 1000000, allowed -5172.19 to 5172.19 m/s"),
        (f"{BALL} --speed 0.05 --angle 90", "angle: got 90, allowed above -90 to below 90 degrees"),
        (f"{BALL} --speed 0.5 --angle 80", "tangential: got 2.8"),
        (f"{BALL} --speed 0.05 --spin 1.5", "spin: got 1.5, allowed -1 to 1 c/R"),
        (f"{BALL} --speed 0.05 --second-spin 0.1", "second_spin: got one that is not 0, allowed only 0"),
        (f"{BALL} --speed 0.05 --spin x", "spin: got 'x'"),
        ("oblique --body disk --poisson 0.3 --speed 0.05 --friction 5.5", "friction: got 5.5, allowed 0 to 5"),
        (f"{BALL} --speed 0.05 --tolerance 1e-9", "tolerance: got 1e-09, allowed 1e-6 to 0.5"),
        (f"{BALL} --speed 0.05 --threads -1", "threads: got -1"),
        (f"{BALL} --speed lin:0.1:1:2000 --spin lin:0:1:2000", "speed: got 4000000 values in all"),
    ],
)
def test_refused_in_one_line(stoss, tmp_path, arguments, said):
    path = tmp_path / "x.csv"
    result = stoss.run(arguments, "-o", str(path), "--format csv")
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {said}") and not path.exists()


@pytest.mark.parametrize(
    "arguments, said",
    [
        ("oblique --body disk --poisson 0.3 --speed 0.05", "--friction is required"),
        ("oblique --body disk --poisson 0.3 --friction 0.1", "--speed or --height is required"),
        (f"{BALL} --speed 0.05 --angle 30 --tangential 0.01", "--tangential excludes --angle"),
    ],
)
def test_usage(stoss, arguments, said):
    result = stoss.run(arguments)
    assert (result.returncode, result.stdout) == (2, "") and said in result.stderr


def test_examples_of_the_help_are_its_options(stoss):
    text = stoss.run("oblique --help").stdout
    for name in ("--speed", "--tangential", "--angle", "--spin", "--second-spin", "--friction", "--height"):
        assert name in text
