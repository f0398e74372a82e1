"""Real executors: processes, MPI, Dask. Whatever computes a sweep, the bits are the same."""

import concurrent.futures
import os
import shutil
import subprocess
import sys

import pytest

import stoss
import stoss.sweeps._sweep
from sweep_grids import TOMLS, grid_of


@pytest.fixture(scope="module")
def grids(tmp_path_factory):
    """Those of all kinds."""
    folder = tmp_path_factory.mktemp("grids")
    return {kind: grid_of(kind, folder) for kind in TOMLS}


@pytest.fixture(scope="module")
def rows(grids, tmp_path_factory):
    """The rows of their sweeps in this process."""
    return {kind: stoss.sweep(grid, store=tmp_path_factory.mktemp(kind)).rows.tobytes() for kind, grid in grids.items()}


@pytest.fixture
def alone(rows):
    return rows["restitution"]


@pytest.fixture
def grid(grids):
    return grids["restitution"]


@pytest.mark.parametrize("executor", [2, concurrent.futures.ProcessPoolExecutor, concurrent.futures.ThreadPoolExecutor])
def test_pools_of_this_machine(alone, grid, executor, tmp_path):
    pool = executor if isinstance(executor, int) else executor(2)
    assert stoss.sweep(grid, pool, store=tmp_path).rows.tobytes() == alone
    assert len(list(tmp_path.glob("worker*.csv"))) in (1, 2)
    if not isinstance(pool, int):
        assert pool.submit(int, 3).result() == 3  # left open for its owner
        pool.shutdown()


SCRIPT = """
import sys
from {module} import {name}
import stoss

if __name__ == "__main__":
    with {made} as opened:
        for kind in sys.argv[1:]:
            pool = {pool}
            print(stoss.sweep(f"{{kind}}.toml", pool, store=kind))
"""


def run(words, folder, environment):
    """The rows of sweeps of all kinds by one script."""
    for kind in TOMLS:
        grid_of(kind, folder)
    done = subprocess.run([*words, *TOMLS], cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    return {kind: stoss.open_sweep(folder / kind).rows.tobytes() for kind in TOMLS}


@pytest.mark.cluster
def test_mpi(rows, interpreter, tmp_path):
    pytest.importorskip("mpi4py", reason="python3-mpi4py is not installed")
    if shutil.which("mpiexec") is None:
        pytest.skip("mpiexec (openmpi-bin) is not installed")
    script = SCRIPT.format(module="mpi4py.futures", name="MPIPoolExecutor", made="MPIPoolExecutor()", pool="opened")
    (tmp_path / "script.py").write_text(script)
    allowed = ("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "OMPI_MCA_rmaps_base_oversubscribe")
    environment = {**interpreter.environment, **dict.fromkeys(allowed, "1")}
    words = ["mpiexec", "-n", "3", sys.executable, "-m", "mpi4py.futures", "script.py"]
    assert run(words, tmp_path, environment) == rows


@pytest.mark.cluster
def test_dask(rows, interpreter, tmp_path):
    pytest.importorskip("distributed", reason="python3-distributed is not installed")
    made = "Client(n_workers=2, threads_per_worker=1, dashboard_address=None)"
    script = SCRIPT.format(module="distributed", name="Client", made=made, pool="opened.get_executor()")
    (tmp_path / "script.py").write_text(script)
    assert run([sys.executable, "script.py"], tmp_path, interpreter.environment) == rows
    assert len(list((tmp_path / "restitution").glob("worker*.csv"))) in (1, 2)


def _dies(*_):
    os._exit(9)


def test_a_worker_that_dies_costs_nothing_that_was_finished(alone, grid, tmp_path, monkeypatch):
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
        stoss.sweep(grid, pool, store=tmp_path)
    assert stoss.open_sweep(tmp_path).computed.sum() >= 6 and jobs[0] is real
    assert stoss.sweep(grid, 2, store=tmp_path).rows.tobytes() == alone
