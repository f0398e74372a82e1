"""Real executors: processes, MPI, Dask. Whatever computes a sweep, the bits are the same."""

import concurrent.futures
import os
import shutil
import subprocess
import sys

import pytest

import stoss

GRID = {
    "bodies": {"kind": "sphere", "poisson": [0.1, 0.2, 0.3]},
    "against": ["wall", stoss.HalfSpace()],
    "speed": [0.01, 0.1],
    "tolerance": 1e-2,
}


@pytest.fixture(scope="module")
def alone(tmp_path_factory):
    """The rows of a sweep in this process."""
    return stoss.sweep(GRID, store=tmp_path_factory.mktemp("alone")).rows.tobytes()


@pytest.mark.parametrize("executor", [2, concurrent.futures.ProcessPoolExecutor, concurrent.futures.ThreadPoolExecutor])
def test_pools_of_this_machine(alone, executor, tmp_path):
    pool = executor if isinstance(executor, int) else executor(2)
    assert stoss.sweep(GRID, pool, store=tmp_path).rows.tobytes() == alone
    assert len(list(tmp_path.glob("worker*.csv"))) in (1, 2)
    if not isinstance(pool, int):
        assert pool.submit(int, 3).result() == 3  # left open for its owner
        pool.shutdown()


SCRIPT = """
import sys
from {module} import {name}
import stoss

if __name__ == "__main__":
    grid = stoss.Grid.from_toml("grid.toml")
    {lines}
"""
TOML = """
against = ["wall", {kind = "half-space"}]
speed = [0.01, 0.1]
tolerance = 1e-2
bodies = {kind = "sphere", poisson = [0.1, 0.2, 0.3]}
"""


def run(words, folder, environment):
    (folder / "grid.toml").write_text(TOML)
    done = subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    return stoss.open_sweep(folder / "store")


def test_mpi(alone, interpreter, tmp_path):
    pytest.importorskip("mpi4py", reason="python3-mpi4py is not installed")
    if shutil.which("mpiexec") is None:
        pytest.skip("mpiexec (openmpi-bin) is not installed")
    lines = """with MPIPoolExecutor() as pool:
        result = stoss.sweep(grid, pool, store="store")
    print(result)"""
    script = SCRIPT.format(module="mpi4py.futures", name="MPIPoolExecutor", lines=lines)
    (tmp_path / "script.py").write_text(script)
    allowed = ("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "OMPI_MCA_rmaps_base_oversubscribe")
    environment = {**interpreter.environment, **dict.fromkeys(allowed, "1")}
    words = ["mpiexec", "-n", "3", sys.executable, "-m", "mpi4py.futures", "script.py"]
    assert run(words, tmp_path, environment).rows.tobytes() == alone


def test_dask(alone, interpreter, tmp_path):
    pytest.importorskip("distributed", reason="python3-distributed is not installed")
    lines = """with Client(n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
        result = stoss.sweep(grid, client.get_executor(), store="store")
    print(result)"""
    script = SCRIPT.format(module="distributed", name="Client", lines=lines)
    (tmp_path / "script.py").write_text(script)
    assert run([sys.executable, "script.py"], tmp_path, interpreter.environment).rows.tobytes() == alone
    assert len(list((tmp_path / "store").glob("worker*.csv"))) in (1, 2)


def _dies(*_):
    os._exit(9)


def test_a_worker_that_dies_costs_nothing_that_was_finished(alone, tmp_path, monkeypatch):
    real, jobs = stoss.sweeps._sweep.compute, []

    class Fragile(concurrent.futures.ProcessPoolExecutor):
        def submit(self, function, *arguments):
            jobs.append(function)
            if len(jobs) == 4:
                concurrent.futures.wait(self.begun)
                return super().submit(_dies)
            self.begun = [*getattr(self, "begun", []), super().submit(function, *arguments)]
            return self.begun[-1]

    with Fragile(2) as pool, pytest.raises(concurrent.futures.BrokenExecutor):
        stoss.sweep(GRID, pool, store=tmp_path)
    assert stoss.open_sweep(tmp_path).computed.sum() >= 6 and jobs[0] is real
    assert stoss.sweep(GRID, 2, store=tmp_path).rows.tobytes() == alone
