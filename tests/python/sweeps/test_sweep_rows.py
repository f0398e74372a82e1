"""Sweeps of rows of bodies: the values are those of stoss.row, whoever computes them."""

import json
import subprocess
import sys

import numpy as np
import pytest

import stoss

BALL = {"kind": "sphere", "poisson": 0.3}
TOML = """
speed = "log:1e-3:0.1:4"
tolerance = 1e-2
[row]
bodies = [{kind = "sphere", poisson = [0.2, 0.3], radius = [1, 2]}, {kind = "sphere", poisson = 0.25}]
count = 3
"""


def run(*words, **options):
    return subprocess.run([sys.executable, "-m", "stoss", *map(str, words)], capture_output=True, text=True, **options)


@pytest.fixture(scope="module")
def toml(tmp_path_factory):
    path = tmp_path_factory.mktemp("rows") / "grid.toml"
    path.write_text(TOML)
    return path


@pytest.fixture(scope="module")
def whole(toml, tmp_path_factory):
    return stoss.sweep(toml, store=tmp_path_factory.mktemp("rows") / "store")


def test_values_are_those_of_row(whole):
    assert whole.grid.shape == (4, 1, 4, 3) and whole.grid.dimensions == ("body", "against", "speed", "number")
    balls = [stoss.Sphere(poisson=0.2, radius=2), stoss.Sphere(poisson=0.25)]
    speeds = whole.grid.speed[:, None]
    direct = stoss.row([balls[0], balls[1], balls[0]], speed=speeds, tolerance=1e-2)
    assert np.array_equal(whole.velocity_after[1, 0], direct.velocities_after)
    assert np.array_equal(whole.velocity_after_error[1, 0], direct.velocities_after_error)
    assert np.array_equal(whole.velocity[1, 0], direct.velocities)
    assert np.array_equal(whole.translation[1, 0, :, 0], direct.translation)
    assert whole.converged.all() and whole.complete


def test_shards_and_a_pool_find_the_same(whole, toml, tmp_path):
    for k in (1, 2):
        done = run("sweep", toml, "--store", tmp_path / "shards", "--shard", f"{k}/2")
        assert done.returncode == 0 and "24 values, 24 computed now" in done.stdout + done.stderr, done.stderr
    again = run("sweep", toml, "--store", tmp_path / "shards")
    assert "48 values, 0 computed now" in again.stdout + again.stderr
    shards, pool = stoss.open_sweep(tmp_path / "shards"), stoss.sweep(toml, 2, store=tmp_path / "pool")
    for name in ("velocity_after", "velocity_after_error", "duration"):
        assert np.array_equal(getattr(shards, name), getattr(whole, name))
        assert np.array_equal(getattr(pool, name), getattr(whole, name))


def test_what_was_killed_goes_on(whole, toml, tmp_path):
    store = tmp_path / "store"
    run("sweep", toml, "--store", store, "--shard", "1/2")
    (file,) = store.glob("*.csv")
    lines = file.read_text().splitlines(keepends=True)
    file.write_text("".join(lines[:6]) + lines[6][:40])  # between the bodies of one row
    found = stoss.open_sweep(store)
    assert not found.complete and 0 < np.count_nonzero(found.computed) < 24
    merged = run("merge", store, "-o", tmp_path / "part.nc")
    assert merged.returncode == 1 and "missing: sphere" in merged.stderr and "number 0" in merged.stderr, merged.stderr
    rest = stoss.sweep(toml, store=store)
    assert rest.complete and np.array_equal(rest.velocity_after, whole.velocity_after)


def test_merges_to_netcdf(whole, tmp_path):
    xarray = pytest.importorskip("xarray")
    whole.to_netcdf(tmp_path / "values.nc")
    with xarray.open_dataset(tmp_path / "values.nc") as data:
        assert data.velocity_after.dims == ("body", "against", "speed", "number")
        assert data.velocity_after.attrs["units"] == "c"
        assert np.array_equal(data.velocity_after.values, whole.velocity_after)
        assert str(data.body.values[0]).startswith("sphere,poisson=0.2 | sphere,poisson=0.25 | sphere")


def test_with_materials_speeds_and_velocities_are_in_si(tmp_path):
    steel = {"kind": "sphere", "material": "bearing steel", "radius": 0.01}
    both = {"bodies": [steel, {**steel, "radius": 0.004}], "moving": 2, "after": "wall"}
    grid = stoss.Grid(row=both, speed=[0.05, 0.1])
    found = stoss.sweep(grid, store=tmp_path / "store")
    balls = [stoss.Sphere(material=stoss.materials["bearing steel"], radius=each) for each in (0.01, 0.004)]
    direct = stoss.row(balls, speed=[[0.05, 0.05], [0.1, 0.1]], against="wall")
    table = found.to_dataframe()
    assert table["velocity_after_si"].to_numpy() == pytest.approx(direct.velocities_after.ravel(), rel=1e-12)
    assert table["speed"].unique() == pytest.approx([0.05, 0.1])


def test_materials_of_all_neighbours_are_looked_at(tmp_path):
    steel, brass = ({"kind": "sphere", "material": each, "radius": 0.01} for each in ("bearing steel", "brass"))
    grid = stoss.Grid(row={"bodies": [steel, steel, brass]}, speed=0.1, tolerance=1e-2)
    with pytest.warns(stoss.StossWarning, match="other ball yields above 0.0166"):
        stoss.sweep(grid, store=tmp_path / "store")


def test_a_row_may_be_a_file(tmp_path):
    (tmp_path / "row.json").write_text(json.dumps({"format": "stoss row 1", "bodies": [BALL] * 3, "gaps": [0, 0.1]}))
    (tmp_path / "grid.toml").write_text('row = "row.json"\nspeed = [0.01]\n')
    grid = stoss.Grid.from_toml(tmp_path / "grid.toml")
    assert repr(grid) == "Grid(1 rows, 1 speeds, 3 bodies in each)"
    assert stoss.Grid.from_dict(grid.to_dict()) == grid
    found = stoss.sweep(grid, store=tmp_path / "store")
    direct = stoss.row([stoss.Sphere(poisson=0.3)] * 3, speed=[0.01], gaps=[0, 0.1])
    assert np.array_equal(found.velocity_after.ravel(), direct.velocities_after)


@pytest.mark.parametrize("given, line", [
    ({"row": {"bodies": [BALL]}}, "bodies: got 1, allowed 2 to 100"),
    ({"row": {"bodies": [BALL] * 2, "speed": 1}}, "row: got"),
    ({"row": {"bodies": [BALL] * 2, "moving": 3}}, "moving: got 3, allowed 1 to 2"),
    ({"row": {"bodies": [BALL], "count": 101}}, "count: got 101, allowed 1 to 100"),
    ({"row": {"bodies": [BALL], "count": 3}, "against": "wall"}, "row: got row and against"),
    ({"row": {"bodies": [BALL], "count": 3}, "friction": 0.1}, "row: got row and friction"),
    ({"row": {"bodies": [BALL], "count": 3}, "absolute": 0.1}, "absolute: got 0.1, allowed none together with row"),
    ({"row": {"bodies": [BALL], "count": 3}, "tolerance": 0}, "tolerance: got 0, allowed 1e-6 to 1"),
    ({"row": [{"bodies": [BALL] * 2}, {"bodies": [BALL] * 3}]}, "row: got rows of [2, 3] bodies"),
    ({"row": {"bodies": [BALL] * 2}, "speed": [0.1, 2]}, "speed: got 2, allowed -1 to 1"),
    ({"row": {"bodies": [BALL] * 2}, "speed": [-0.1]}, "speed: got no two bodies that meet"),
    ({"row": {"bodies": [{"kind": "modal", "file": "x.json"}]}}, "x.json"),
    ({"row": {"bodies": []}}, "count: got 0"),
    ({"row": [{"bodies": [BALL] * 2}] * 2}, "twice"),
])  # fmt: skip
def test_refuses(given, line):
    with pytest.raises((stoss.InvalidInput, OSError)) as refused:
        stoss.Grid(**{"speed": 0.1, **given})
    assert line in str(refused.value)
