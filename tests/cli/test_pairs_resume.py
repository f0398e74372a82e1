"""Curves of pairs that are interrupted and resumed."""

import signal
import subprocess

import pytest
from conftest import resume, rows, wait_for_rows


@pytest.mark.parametrize("number_of_signal", [signal.SIGINT, signal.SIGKILL])
def test_interrupted_or_killed_and_resumed(stoss, tmp_path, number_of_signal):
    path = tmp_path / "curve.csv"
    job = "restitution --poisson 0.33,0.2 --speed log:0.01:0.2:40 --tolerance 1e-2 --against disk,radius=2"
    command = stoss.start(f"{job} --threads 1 --resume {path}", stderr=subprocess.DEVNULL)
    wait_for_rows(command, path, 3)
    command.send_signal(number_of_signal)
    assert command.wait(timeout=60) == (130 if number_of_signal == signal.SIGINT else -signal.SIGKILL)
    assert resume(stoss, path, job).returncode == 0
    assert rows(path.read_text()) == rows(stoss.run(job, "--format csv").stdout)


@pytest.mark.parametrize(
    "bodies, others",
    [
        (
            "--poisson 0.33 --against disk,radius=2",
            [
                "--poisson 0.33 --against disk,radius=2.5",
                "--poisson 0.33 --against same",
                "--poisson 0.33",
                "--body rod",
            ],
        ),
        ("--body rod --against rod,length=2.5", ["--body rod --against same", "--body rod", "--poisson 0.33"]),
    ],
)
def test_resume_keeps_to_the_bodies(stoss, tmp_path, bodies, others):
    path = tmp_path / "curve.csv"
    job = "restitution --speed 0.1,0.2 --tolerance 0.1"
    whole = stoss.run(job, bodies, "--format csv").stdout
    path.write_text(whole[: whole.rindex("\n", 0, -1) + 1])
    before = path.read_text()
    for other in others:
        result = resume(stoss, path, f"{job} {other}")
        assert result.returncode == 3 and "another job needs another file" in result.stderr
        assert path.read_text() == before
    assert resume(stoss, path, f"{job} {bodies}").returncode == 0
    assert rows(path.read_text()) == rows(whole)
