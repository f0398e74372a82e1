"""examples/cluster/: the estimate, the sweep by two processes of MPI, and the job of Slurm, on a small grid."""

import contextlib
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import numpy as np
import pytest

import stoss

CLUSTER = Path(__file__).parents[3] / "examples/cluster"
SMALL = """
speed = [0.05, 0.2]
tolerance = 1e-2
bodies = {kind = "sphere", radius = "log:1e-3:1e-2:4", material = ["bearing steel", "glass"]}
against = ["wall"]
"""
ALLOWED = ("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "OMPI_MCA_rmaps_base_oversubscribe")


@pytest.fixture
def folder(tmp_path):
    for name in ("cases.py", "cases.sbatch"):
        shutil.copy(CLUSTER / name, tmp_path)
    (tmp_path / "small.toml").write_text(SMALL)
    return tmp_path


@pytest.fixture
def environment(interpreter, folder):
    """Where `python3` is this one, and `scontrol` writes down what it is told."""
    programs = folder / "bin"
    programs.mkdir()
    (programs / "python3").write_text(f'#!/bin/sh\nexec {sys.executable} "$@"\n')
    (programs / "scontrol").write_text(f'#!/bin/sh\necho "$@" >{folder}/told\n')
    for each in programs.iterdir():
        each.chmod(0o755)
    path = os.pathsep.join([str(programs), os.environ.get("PATH", os.defpath)])
    slurm = {"SLURM_NTASKS": "3", "SLURM_JOB_ID": "17", "GRID": "small.toml"}
    return {**interpreter.environment, **dict.fromkeys(ALLOWED, "1"), **slurm, "PATH": path}


def needs_mpi():
    pytest.importorskip("mpi4py", reason="python3-mpi4py is not installed")
    pytest.importorskip("netCDF4")
    if shutil.which("mpirun") is None:
        pytest.skip("mpirun (openmpi-bin) is not installed")


def test_the_grid_has_as_many_cases_as_it_says():
    text = (CLUSTER / "grid.toml").read_text(encoding="utf-8")
    given = tomllib.loads(text)
    bodies = 40 * len(given["bodies"]["material"])
    partners = 99 * len(given["against"][0]["material"]) + len(given["against"][1]["material"])
    assert bodies * partners == 10**5 and "10⁵ cases: 200 balls, each with 495 balls and on 5 blocks, at 5 speeds" in text
    few = {**given["bodies"], "radius": [2e-3, 2e-2]}, [{**given["against"][0], "radius": [2.1e-3, 1.9e-2]}, given["against"][1]]
    assert len(stoss.Grid.from_dict({**given, "bodies": few[0], "against": few[1]}).cases()) == 10 * 15


def test_estimate(folder, environment):
    words = [sys.executable, "cases.py", "small.toml", "--estimate", "3"]
    done = subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    each = float(re.search(r"^measured: 3 cases, ([\d.]+) ± [\d.]+ s of a core each", done.stdout)[1])
    hours, error = map(float, re.search(r"^extrapolated, not measured: 8 cases, ([\d.]+) ± ([\d.]+) core hours",
                                        done.stdout, re.M).groups())  # fmt: skip
    total = float(re.search(r"^on 32 cores like this one ([\d.e-]+) hours", done.stdout, re.M)[1])
    assert hours / 32 - error < total < hours + error
    assert 0 < each < 60 and hours == pytest.approx(8 * each / 3600, rel=0.2, abs=2 * error)
    assert sorted(path.name for path in folder.iterdir()) == ["bin", "cases.py", "cases.sbatch", "small.toml"]


@pytest.mark.cluster
def test_job_on_two_processes_is_requeued_and_continues(folder, environment):
    needs_mpi()
    whole = stoss.sweep(folder / "small.toml", store=folder / "whole")
    job = subprocess.Popen(["sh", "cases.sbatch"], cwd=folder, env=environment, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL, start_new_session=True)  # fmt: skip
    try:
        deadline = time.monotonic() + 200
        while not list((folder / "values").glob("worker*.csv")) and time.monotonic() < deadline:
            time.sleep(0.01)
        job.send_signal(signal.SIGUSR1)  # as Slurm does before the limit
        assert job.wait(timeout=60) == 0
        assert (folder / "told").read_text() == "requeue 17\n"
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(job.pid, signal.SIGKILL)  # and then ends what is left
    before = np.count_nonzero(stoss.open_sweep(folder / "values").computed)
    again = subprocess.run(["sh", "cases.sbatch"], cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
    assert again.returncode == 0, again.stderr
    assert before <= 16 and "16 of 16 values" in again.stdout and "written: values.nc" in again.stdout
    assert stoss.open_sweep(folder / "values").rows.tobytes() == whole.rows.tobytes()


def test_job_says_what_slurm_needs():
    text = (CLUSTER / "cases.sbatch").read_text(encoding="utf-8")
    for each in ("--ntasks=33", "--cpus-per-task=1", "--signal=B:USR1@", "--requeue", "--time="):
        assert re.search(rf"^#SBATCH {re.escape(each)}", text, re.M), each
    commands = [k for k, line in enumerate(text.splitlines()) if line and not line.startswith("#")]
    options = [k for k, line in enumerate(text.splitlines()) if line.startswith("#SBATCH")]
    assert max(options) < min(commands)  # sbatch reads no further
    assert subprocess.run(["sh", "-n", str(CLUSTER / "cases.sbatch")]).returncode == 0
