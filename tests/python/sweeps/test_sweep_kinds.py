"""Restitution, oblique rules, ensembles and bodies of files: one store, which survives whatever is killed."""

# ruff: noqa: F811 (a fixture is an argument that has the name of what is imported)
import json
import signal
import subprocess
import sys

import numpy as np
import pytest

import stoss
import stoss.sweeps._bodies
from stoss._subcommands import sample
from sweep_command import command  # noqa: F401 (a fixture)
from sweep_grids import RING, TOMLS, direct, grid_of

KINDS = sorted(TOMLS)


@pytest.fixture(scope="module")
def alone(tmp_path_factory):
    """The sweep of each kind in this process, computed once."""
    made = {}

    def of(kind):
        if kind not in made:
            folder = tmp_path_factory.mktemp(kind)
            made[kind] = stoss.sweep(grid_of(kind, folder), store=folder / "store"), folder / "store"
        return made[kind]

    return of


@pytest.mark.parametrize("kind", KINDS)
def test_values_are_those_of_a_direct_call(alone, kind):
    result, _ = alone(kind)
    assert result.complete and result.converged.all()
    for case in result.grid.cases():
        name, values = direct(kind, case.body, case.against)
        assert np.array_equal(getattr(result, name)[case.place], values), case.body


@pytest.mark.parametrize("kind", KINDS)
def test_two_processes_give_the_same_bits(alone, kind, tmp_path):
    result, _ = alone(kind)
    assert stoss.sweep(result.grid, 2, store=tmp_path).rows.tobytes() == result.rows.tobytes()


KILLED = """
import os, signal, sys
import stoss
from stoss.sweeps._tasks import Worker

write, left = Worker._write, int(sys.argv[2])

def torn(self, text):
    global left
    left -= 1
    if left == 0:
        os.write(self._descriptor, text[: len(text) // 2].encode())
        os.kill(os.getpid(), signal.SIGKILL)
    write(self, text)

Worker._write = torn
executor = int(sys.argv[3]) or None
stoss.sweep(sys.argv[1], executor, store="store")
"""


@pytest.mark.parametrize("kind, processes", [*((kind, 0) for kind in KINDS), ("restitution", 2)])
def test_killed_amid_a_row_and_continued(alone, interpreter, kind, processes, tmp_path):
    """A worker is killed by SIGKILL while it writes its n-th line: with what is there the sweep goes on."""
    result, _ = alone(kind)
    grid_of(kind, tmp_path)
    (tmp_path / "script.py").write_text(KILLED)
    done = []
    for line in (2, 3):  # the first is the head of a file
        words = [sys.executable, "script.py", f"{kind}.toml", str(line), str(processes)]
        process = subprocess.run(words, cwd=tmp_path, env=interpreter.environment, capture_output=True, timeout=120)
        assert process.returncode == (-signal.SIGKILL if processes == 0 else 1), process.stderr
        done.append(np.count_nonzero(stoss.open_sweep(tmp_path / "store").computed))
    assert done[0] <= done[1] < result.computed.size and done[1] > 0
    torn = [path for path in (tmp_path / "store").glob("*.csv") if not path.read_bytes().endswith(b"\n")]
    assert torn
    again = stoss.sweep(tmp_path / f"{kind}.toml", 2, store=tmp_path / "store")
    assert again.rows.tobytes() == result.rows.tobytes()


@pytest.mark.parametrize("kind", KINDS)
def test_netcdf(alone, kind, tmp_path):
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("netCDF4")
    result, store = alone(kind)
    stoss.merge(store, tmp_path / "a.nc")
    with xarray.open_dataset(tmp_path / "a.nc") as data:
        assert data.restitution.dims == result.grid.dimensions and data.complete == "true"
        assert stoss.Grid.from_dict(json.loads(data.grid)) == result.grid
        for name in result.rows.dtype.names:
            assert np.array_equal(data[name].values, result.rows[name]), name
        for name, values in result.grid.axes.items():
            assert np.array_equal(data[name].values, values)
        if kind == "oblique":
            assert (data.angle.units, data.spin.units, data.sliding_after.units) == ("deg", "c/R", "c")
        if kind == "modal":
            assert data.speed.units == "m/s" and data.contact_time_si.units == "s"
    table = result.to_dataframe()
    assert len(table) == result.computed.size and list(table.columns[:1]) == ["body"]


def test_summary_of_ensembles(alone):
    result, _ = alone("ensemble")
    sums = result.summary()
    assert sums.shape == (2, 1, 1, 2)
    one = stoss.restitution_distribution(result.grid.bodies[1], speed=0.01, temperature=0.02, samples=7, seed=5, error=1e-2)
    for name in sums.dtype.names:
        assert sums[name][1, 0, 0, 1] == getattr(one, name), name
    with pytest.raises(stoss.InvalidInput, match="summary: got a sweep without samples"):
        alone("oblique")[0].summary()


def test_body_of_a_file_that_has_changed(tmp_path):
    body = stoss.ModalBody.read(RING)
    body.save(tmp_path / "ring.json")
    text = TOMLS["modal"].replace(str(RING), "ring.json").replace("[6e-3, 8e-3]", "8e-3").replace("[0.1, 0.2]", "0.1")
    path, store = tmp_path / "grid.toml", tmp_path / "store"
    path.write_text(text)
    first = stoss.sweep(path, store=store)
    (kept,) = store.glob("body-*.json")
    assert str(tmp_path) not in "".join(each.read_text() for each in store.iterdir())
    assert (store / "grid.json").stat().st_size < 2000 < kept.stat().st_size
    stoss.ModalBody.from_dict({**body.to_dict(), "mass": 1.01 * body.mass}).save(tmp_path / "ring.json")
    with pytest.raises(stoss.InvalidInput, match="of other numbers of body 'ring 4 mm thick', allowed the same .its file"):
        stoss.sweep(path, store=store)
    (tmp_path / "ring.json").unlink()
    with pytest.raises(OSError, match="ring.json"):
        stoss.sweep(path, store=store)
    assert stoss.open_sweep(store).rows.tobytes() == first.rows.tobytes()  # the store needs no other file
    body.save(tmp_path / "ring.json")
    assert stoss.sweep(path, store=store).rows.tobytes() == first.rows.tobytes()
    kept.write_text(kept.read_text().replace("7", "8", 1))
    stoss.sweeps._bodies._read.cache_clear()  # as in another process
    with pytest.raises(stoss.InvalidInput, match="got a missing or damaged '.*body-"):
        stoss.open_sweep(store)


def test_store_refers_to_no_file_outside_of_it(tmp_path):
    named = {"kind": "modal", "name": "x", "sha256": "../../secret"}
    (tmp_path / "grid.json").write_text(json.dumps({"bodies": [named], "against": ["wall"], "speed": [0.1]}))
    with pytest.raises(stoss.InvalidInput, match="store: sha256: got '../../secret', allowed 16 hexadecimal digits"):
        stoss.open_sweep(tmp_path)


@pytest.mark.parametrize(
    "changed, message",
    [
        ({"angle": 30}, "angle: got 30, allowed only together with friction"),
        ({"samples": 10}, "samples: got 10, allowed only together with temperature"),
        ({"seed": 1}, "seed: got 1, allowed only together with temperature"),
        ({"friction": 0.1, "temperature": 0.1}, "friction: got friction and temperature, allowed one of them"),
        ({"friction": 0.1, "angle": 3, "tangential": 0.1}, "angle: got angle and tangential, allowed one of them"),
        ({"friction": 0.1, "absolute": 1e-3}, "absolute: got 0.001, allowed none together with friction"),
        ({"temperature": 0.1, "tolerance": 1e-3}, "tolerance: got 0.001, allowed none together with temperature"),
        ({"friction": [0.1, 0.1]}, "friction: got 0.1 twice"),
        ({"friction": []}, "friction: got none"),
        ({"friction": 6.0}, "friction: got 6"),
        ({"friction": 0.1, "angle": 90}, "angle: got 90"),
        ({"friction": 0.1, "angle": "lin:0:80"}, "angle: got 'lin:0:80'"),
        ({"friction": 0.1, "tolerance": float("nan")}, "tolerance: got nan"),
        ({"temperature": -1.0}, "temperature: got -1"),
        ({"temperature": 0.1, "samples": 0}, "samples: got 0"),
        ({"temperature": 0.1, "samples": 2.5}, "samples: got 2.5, allowed an integer"),
        ({"temperature": 0.1, "samples": 1_000_001}, "grid: got 1000001 values"),
        ({"temperature": 0.1, "seed": -1}, "seed: got -1, allowed 0 to 2147483647"),
        ({"temperature": 0.1, "error": 1.0}, "error: got 1"),
        ({"bodies": {"kind": "modal", "file": 3}}, "bodies: got"),
        ({"bodies": {"kind": "modal", "file": "a.json", "radius": 1}}, "bodies: got ['file', 'radius']"),
    ],
)
def test_refused(changed, message):
    with pytest.raises(stoss.InvalidInput) as error:
        stoss.Grid(**{"bodies": stoss.Sphere(poisson=0.3), "speed": 0.01, **changed})
    assert str(error.value).startswith(message) and "\n" not in str(error.value)


def test_one_case_has_work_for_many_shards():
    warm = stoss.Grid(bodies=stoss.Sphere(poisson=0.3), speed=0.01, temperature=0.01, samples=10_000)
    assert len(warm.cases()) == 1
    for shards in (2, 7):
        parts = [sample(warm, shard, shards) for shard in range(1, shards + 1)]
        ranges = sorted(tuple(part.range) for each in parts for part in each)
        assert [begin for begin, _ in ranges] == [0, *(end for _, end in ranges[:-1])] and ranges[-1][1] == 10_000
        assert max(map(len, parts)) - min(map(len, parts)) <= 1


@pytest.mark.parametrize("kind, shape, begins", [
    ("restitution", (300,), [0, 128, 256]),
    ("oblique", (3, 20, 2), [0, 40, 80]),
    ("oblique", (2, 40, 2), [0, 64, 80, 144]),
    ("ensemble", (1, 2, 300), [0, 256, 300, 556]),
    ("ensemble", (3, 2, 100), [0, 200, 400]),
])  # fmt: skip
def test_tasks_keep_together_what_shares_work(kind, shape, begins, tmp_path):
    ranges = grid_of(kind, tmp_path).computation.ranges(shape)
    assert [each.begin for each in ranges] == begins and ranges[-1].end == np.prod(shape)
