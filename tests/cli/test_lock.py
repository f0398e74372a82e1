"""Two processes that write one file: the second is refused, and nothing of the first is lost."""

import os
import signal
import subprocess

import pytest
from conftest import rows, wait_for_rows

JOB = "restitution --poisson 0.33 --speed log:1e-3:0.1:40 --threads 1"
LONG = "restitution --poisson 0.33 --speed log:1e-3:0.3:100000 --threads 1"


@pytest.fixture(scope="module")
def whole(stoss):
    return rows(stoss.run(JOB, "--format csv").stdout)


@pytest.mark.parametrize("trial", range(3))
def test_two_that_begin_at_once(stoss, tmp_path, whole, trial):
    path = tmp_path / "curve.csv"
    both = [stoss.start(f"{JOB} --resume {path}", stderr=subprocess.PIPE) for _ in range(2)]
    texts = [process.communicate(timeout=100)[1] for process in both]
    assert sorted(process.returncode for process in both) == [0, 4]
    first, second = sorted(both, key=lambda process: process.returncode)
    (line,) = texts[both.index(second)].splitlines()
    assert f"cannot write '{path}': process {first.pid} (stoss restitution " in line
    assert rows(path.read_text()) == whole


@pytest.fixture
def writer(stoss, tmp_path):
    """A process at work on curve.csv in the folder tmp_path."""
    path = tmp_path / "curve.csv"
    process = stoss.start(f"{LONG} --format csv -o {path}", stderr=subprocess.DEVNULL)
    wait_for_rows(process, path, 2)
    yield process
    process.kill()
    process.wait()


@pytest.mark.parametrize("how", ["-o", "--resume", "--trajectory"])
@pytest.mark.parametrize("name", ["curve.csv", "link", "hard"])
def test_a_file_at_work_is_left_alone(stoss, tmp_path, writer, how, name):
    (tmp_path / "link").symlink_to("curve.csv")
    os.link(tmp_path / "curve.csv", tmp_path / "hard")
    before = (tmp_path / "curve.csv").read_text()
    job = "impact --poisson 0.33 --speed 0.1 --trajectory" if how == "--trajectory" else f"{LONG} {how}"
    result = stoss.run(job, str(tmp_path / name))
    assert (result.returncode, result.stdout) == (4, "")
    (line,) = result.stderr.splitlines()
    assert f"process {writer.pid} (stoss " in line and "is writing it" in line
    writer.send_signal(signal.SIGINT)
    assert writer.wait(timeout=30) == 130
    assert (tmp_path / "curve.csv").read_text().startswith(before)


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_a_lock_ends_with_its_process(stoss, tmp_path, writer, number):
    writer.send_signal(number)
    writer.wait(timeout=30)
    path = tmp_path / "curve.csv"
    again = stoss.start(f"{LONG} --resume {path}", stderr=subprocess.PIPE)
    wait_for_rows(again, path, len(rows(path.read_text())) + 1)
    again.send_signal(signal.SIGINT)
    assert again.wait(timeout=30) == 130


def test_trajectory_and_output_in_one_file(stoss, tmp_path):
    path = tmp_path / "x"
    path.write_text("precious")
    os.link(path, tmp_path / "hard")
    (tmp_path / "loose").symlink_to("none")
    result = stoss.run("impact --poisson 0.33 --speed 0.1 -o loose --trajectory none", cwd=tmp_path)
    assert result.returncode == 3 and not (tmp_path / "none").exists()
    for other in (path, tmp_path / "hard", "/proc/self/cwd/x"):
        result = stoss.run(f"impact --poisson 0.33 --speed 0.1 -o {path} --trajectory {other}", cwd=tmp_path)
        assert result.returncode == 3
        assert path.read_text() == "precious"
    with open(path, "a") as stdout:
        words = "impact --poisson 0.33 --speed 0.1 --trajectory /dev/stdout".split()
        assert subprocess.run([stoss.path, *words], stdout=stdout, stderr=subprocess.DEVNULL).returncode == 3
    assert path.read_text() == "precious"
