"""`stoss sweep` and `stoss merge`: shards, workers that are killed, exit codes."""

# ruff: noqa: F811 (a fixture is an argument that has the name of what is imported)
import functools
import os
import random
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import stoss
import stoss.sweeps._store
from stoss.sweeps._rows import Layout
from stoss.sweeps._tasks import Worker
from sweep_command import SMALL, command  # noqa: F401 (a fixture)

TOML = """
speed = "log:1e-3:0.1:12"
tolerance = 1e-4
absolute = 0
against = ["wall", {kind = "half-space"}]
bodies = {kind = "sphere", poisson = "lin:0:0.4:8"}
"""


def test_shards_and_merge(command):
    pytest.importorskip("netCDF4")
    for shard in (1, 2, 3):
        code, error = command.run("sweep", "grid.toml", "--store", "store", "--shard", f"{shard}/3", "--threads", "1")
        values = 0 if shard == 3 else 2  # two cases have three shards
        assert code == 0 and error == f"stoss: shard {shard}/3: {values} values, {values} computed now\n"
        code, error = command.run("merge", "store", "-o", "all.nc")
        assert code == (1 if shard == 1 else 0) and ("2 of 4 values are missing" in error) == (shard == 1)
    assert command.run("sweep", "grid.toml", "--store", "store")[1] == "stoss: shard 1/1: 4 values, 0 computed now\n"
    whole = stoss.sweep(command.folder / "grid.toml", store=command.folder / "whole")
    assert stoss.open_sweep(command.folder / "store").rows.tobytes() == whole.rows.tobytes()


def test_what_did_not_converge_makes_no_job_fail(command):
    (command.folder / "grid.toml").write_text(SMALL.replace("1e-2", "1e-12\nabsolute = 0").replace("[0.1, 0.3]", "0.3"))
    for computed in (2, 0):  # and is not computed again
        code, error = command.run("sweep", "grid.toml", "--store", "store")
        assert code == 0 and error.startswith(f"stoss: shard 1/1: 2 values, {computed} computed now\nstoss: warning: 2 of 2 ")
    swept = stoss.open_sweep(command.folder / "store")
    assert swept.complete and not swept.converged.any() and (swept.restitution_error < 1e-3).all()


def test_a_store_of_other_shards_is_continued(command):
    """Which case was in which file does not count."""
    whole = stoss.sweep(command.folder / "grid.toml", store=command.folder / "whole")
    store = stoss.sweeps._store.create(command.folder / "store", whole.grid)
    (first, _), rows = whole.grid.cases(), whole.rows[0, 0]
    with Worker(store, Layout(whole.grid.computation), "shard-2-of-2") as worker:
        for speed, row in zip(whole.grid.speed.tolist(), rows):
            worker.append(first.key, first.inputs, (speed,), row.item())
    for shard in ("1/2", "2/2"):
        assert command.run("sweep", "grid.toml", "--store", "store", "--shard", shard)[0] == 0
    assert stoss.open_sweep(store).rows.tobytes() == whole.rows.tobytes()
    assert sum(path.read_text().count(first.key + ",") for path in store.glob("*.csv")) == 2


def test_merge_tells_what_is_missing(command):
    pytest.importorskip("netCDF4")
    (command.folder / "grid.toml").write_text(TOML)
    stoss.sweeps._store.create(command.folder / "store", stoss.Grid.from_toml(command.folder / "grid.toml"))
    code, error = command.run("merge", "store", "-o", "all.nc")
    assert code == 1 and error.count("stoss: missing: Sphere(poisson=0) against wall, speed") == 5
    assert "and 187 more" in error and "192 of 192 values are missing" in error


@pytest.mark.parametrize(
    "words, code, message",
    [
        (["sweep"], 2, "the following arguments are required: GRID, --store"),
        (["sweep", "grid.toml"], 2, "--store"),
        (["sweep", "grid.toml", "--store", "s", "--colour"], 2, "--colour"),
        (["merge", "s"], 2, "--output"),
        (["sweep", "grid.toml", "--store", "s", "--threads", "x"], 2, "--threads"),
        (["sweep", "grid.toml", "--store", "s", "--threads", "-1"], 3, "threads: got -1"),
        (["sweep", "grid.toml", "--store", "s", "--threads", "1" * 5000], 2, "--threads: invalid"),
        (["sweep", "two\nlines.toml", "--store", "s"], 4, "two lines.toml"),
        *[(["sweep", "grid.toml", "--store", "s", "--shard", shard], 3, "shard: got")
          for shard in ("0/3", "4/3", "1", "1/0", "a/b", "1/3/5", "1.0/3", "")],
        (["sweep", "grid.toml", "--store", "s", "--shard=-1/3"], 3, "shard: got"),
        (["sweep", "none.toml", "--store", "s"], 4, "none.toml"),
        (["sweep", ".", "--store", "s"], 4, "directory"),
        (["sweep", "bad.toml", "--store", "s"], 3, "grid: got 'bad.toml', allowed TOML"),
        (["sweep", "nan.toml", "--store", "s"], 3, "tolerance: got nan, allowed 1e-15 to 0.5"),
        (["sweep", "long.toml", "--store", "s"], 3, "speed: got 'log:.1:.2:1000000000', allowed"),
        (["sweep", "empty.toml", "--store", "s"], 3, "grid: got []"),
        (["merge", "s", "-o", "x.nc"], 3, "store: got 's', allowed the directory of a sweep"),
    ],
)  # fmt: skip
def test_exit_codes(command, words, code, message):
    (command.folder / "bad.toml").write_text("speed = = 3\n")
    (command.folder / "empty.toml").write_text("")
    (command.folder / "nan.toml").write_text(SMALL.replace("1e-2", "nan"))
    (command.folder / "long.toml").write_text(SMALL.replace("[0.01, 0.1]", '"log:.1:.2:1000000000"'))
    got, error = command.run(*words)
    assert got == code and message in error
    assert error.startswith("stoss: error: ") and error.count("\n") == 1 and len(error) < 600


def test_a_second_one_of_the_same_shard_is_refused(command):
    grid = stoss.Grid.from_toml(command.folder / "grid.toml")
    path = stoss.sweeps._store.create(command.folder / "store", grid)
    with Worker(path, Layout(grid.computation), "shard-1-of-2"):
        code, error = command.run("sweep", "grid.toml", "--store", "store", "--shard", "1/2")
        assert code == 4 and "another process is writing it" in error
        assert command.run("sweep", "grid.toml", "--store", "store", "--shard", "2/2")[0] == 0


def wait_for_rows(store):
    """Until a worker has written a value."""
    for _ in range(3000):
        if any(line[:1] not in b"#c" for path in store.glob("*.csv") for line in path.read_bytes().splitlines()):
            return
        time.sleep(0.1)
    raise AssertionError("no worker has begun")


def test_ctrl_c(command):
    (command.folder / "grid.toml").write_text(TOML)
    # Ctrl-C may be ignored where the tests run; a terminal's is not.
    heeded = functools.partial(signal.signal, signal.SIGINT, signal.SIG_DFL)
    process = command.start("sweep", "grid.toml", "--store", "store", preexec_fn=heeded)
    wait_for_rows(command.folder / "store")
    process.send_signal(signal.SIGINT)
    _, error = process.communicate(timeout=60)
    assert (process.returncode, error) == (130, "stoss: error: interrupted (what was finished is in the store)\n")
    assert 0 < np.count_nonzero(stoss.open_sweep(command.folder / "store").computed) < 192


@pytest.mark.long
def test_kills(command, kills=30):
    """Four workers, killed so many times at random instants, then two shards and one: as if nothing had
    happened."""
    (command.folder / "grid.toml").write_text(TOML)
    store, dice = command.folder / "store", random.Random(17)
    words = ("sweep", "grid.toml", "--store", "store", "--threads", "1")
    workers = [command.start(*words, "--shard", f"{k}/4") for k in range(1, 5)]
    killed, amid = 0, 0
    wait_for_rows(store)
    while killed < kills:
        time.sleep(dice.uniform(0.0, 0.5))
        k = dice.randrange(4)
        amid += workers[k].poll() is None
        workers[k].kill()  # one that has finished is begun again all the same
        workers[k].communicate(timeout=60)
        killed += 1
        workers[k] = command.start(*words, "--shard", f"{k + 1}/4")
    before = stoss.open_sweep(store).computed  # also while workers write
    for worker in workers:
        worker.kill()
        worker.communicate(timeout=60)
    after = stoss.open_sweep(store)
    assert np.all(after.computed[before]) and 0 < np.count_nonzero(after.computed)
    assert amid >= kills // 3  # of the kills, so many met a worker at work
    for shard in ("1/2", "2/2", "1/1"):
        assert command.run(*words, "--shard", shard)[0] == 0
    whole = stoss.sweep(command.folder / "grid.toml", 2, store=command.folder / "whole")
    merged = stoss.open_sweep(store)
    assert merged.complete and merged.rows.tobytes() == whole.rows.tobytes()


@pytest.mark.skipif("STOSS" not in os.environ, reason="needs the command in STOSS")
class TestHandOver:
    """The command becomes Python, and takes only a package of its own version."""

    def run(self, command, *words, **changed):
        path = os.pathsep.join([os.path.dirname(sys.executable), os.environ.get("PATH", os.defpath)])
        return subprocess.run(
            [os.environ["STOSS"], *words], cwd=command.folder, env={**command.environment, "PATH": path, **changed},
            capture_output=True, text=True, timeout=120,
        )  # fmt: skip

    def test_it_computes_and_merges(self, command):
        pytest.importorskip("netCDF4")
        done = self.run(command, "sweep", "grid.toml", "--shard", "1/1", "--store", "store")
        assert (done.returncode, done.stdout) == (0, "") and "4 values, 4 computed now" in done.stderr
        assert self.run(command, "merge", "store", "-o", "all.nc").returncode == 0
        assert self.run(command, "merge", "none", "--mix", "-o", "all.nc").returncode == 3
        assert self.run(command, "sweep", "--store=s", "--shard=5/1", "--", "grid.toml").returncode == 3

    def test_without_python_or_package(self, command, tmp_path):
        words = ("sweep", "grid.toml", "--store", "store")
        done = self.run(command, *words, PATH=str(tmp_path))
        assert done.returncode == 0 or "cannot run python3" in done.stderr  # that of the system, where it has one
        (tmp_path / "other/stoss").mkdir(parents=True)
        package = tmp_path / "other/stoss/__init__.py"
        for text in (f"__version__ = '{stoss.__version__}'", "raise ImportError('broken')"):
            package.write_text(text)
            done = self.run(command, *words, PYTHONPATH=str(tmp_path / "other"))
            assert done.returncode == 4 and "Python package: got none" in done.stderr
        package.write_text("__version__ = '0.0.9'")
        done = self.run(command, *words, PYTHONPATH=str(tmp_path / "other"))
        assert done.returncode == 4 and f"got 0.0.9, allowed {stoss.__version__}" in done.stderr

    def test_usage(self, command):
        done = self.run(command, "sweep", "grid.toml")
        assert done.returncode == 2 and "--store is required" in done.stderr
