"""Grids of cases, and what a sweep over them gives."""

import json

import numpy as np
import pytest

import stoss
import stoss._core

BALLS = {"kind": "sphere", "poisson": [0.1, 0.3]}
STEEL = stoss.materials["structural steel"]


def grid(**changed):
    usual = {"bodies": BALLS, "against": ["wall", "same"], "speed": [0.01, 0.03, 0.1], "tolerance": 1e-2}
    return stoss.Grid(**{**usual, **changed})


def equal(one, other):
    return one.rows.tobytes() == other.rows.tobytes() and bool(np.all(one.computed == other.computed))


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The sweep over the usual grid, and its store."""
    store = tmp_path_factory.mktemp("sweep") / "store"
    return stoss.sweep(grid(), store=store), store


def test_partner_takes_the_poisson_number_of_the_first():
    cases = grid(against=[{"kind": "sphere", "radius": [1.0, 2.0]}, stoss.HalfSpace()]).cases()
    assert [case.against.poisson for case in cases] == [0.1, 0.1, 0.1, 0.3, 0.3, 0.3]
    assert [getattr(case.against, "radius", None) for case in cases[:3]] == [1.0, 2.0, None]


def test_same_call_again_computes_nothing(whole, monkeypatch):
    result, store = whole
    monkeypatch.setattr(stoss._core, "restitution_curve", None)
    assert equal(stoss.sweep(grid(), store=store), result)
    assert equal(stoss.open_sweep(store), result) and result.complete and result.versions == (stoss.__version__,)


def test_only_what_is_missing_is_computed_and_no_bit_differs(whole, tmp_path):
    """Rows are taken away; speeds that are computed alone have the bits of those computed
    together."""
    result, store = whole
    (file,) = store.glob("*.csv")
    lines = file.read_text().splitlines(keepends=True)
    rows = [i for i, line in enumerate(lines) if not line.startswith("#")][1:]
    for lost in ([rows[0], rows[4], rows[5], rows[11]], rows[:7], rows):
        (tmp_path / "grid.json").write_text((store / "grid.json").read_text())
        kept = "".join(line for i, line in enumerate(lines) if i not in lost)
        (tmp_path / "a.csv").write_text(kept)
        assert np.count_nonzero(~stoss.open_sweep(tmp_path).computed) == len(lost)
        assert equal(stoss.sweep(grid(), store=tmp_path), result)
        added = list(tmp_path.glob("worker*.csv"))
        computed = [line for path in added for line in path.read_text().splitlines()[2:] if line[0] != "#"]
        assert len(computed) == len(lost)
        for path in added:
            path.unlink()


def test_grid_of_toml(tmp_path, whole):
    path = tmp_path / "grid.toml"
    path.write_text(
        'against = ["wall", "same"]\nspeed = "log:0.01:0.1:3"\ntolerance = 1e-2\n'
        '[[bodies]]\nkind = "sphere"\npoisson = "lin:0.1:0.3:2"\n'
    )
    one = stoss.Grid.from_toml(path)
    assert one.speed.tolist() == [0.01, 0.03162277660168379, 0.1] and one.bodies == grid().bodies
    assert one == stoss.Grid.from_dict(json.loads(json.dumps(one.to_dict())))
    assert one != grid() and grid() == grid()
    path.write_text('speed = 1.0\nbodies = {kind = "disk", radius = 0.01, material = "structural steel", plane = "strain"}\n')
    (disk,) = stoss.Grid.from_toml(path).bodies
    assert disk == stoss.Disk(radius=0.01, material=STEEL, plane="strain")


@pytest.mark.parametrize("given", [{}, {"speed": 1}, {"bodies": BALLS, "speed": 0.1, "colour": 1}, 3, [1]])
def test_no_grid(given, tmp_path):
    with pytest.raises(stoss.InvalidInput, match="grid: got"):
        stoss.sweep(given, store=tmp_path / "store")
    assert not (tmp_path / "store").exists()


@pytest.mark.parametrize("executor", [0, -1, 2.5, "2", True])
def test_no_executor(executor, tmp_path):
    with pytest.raises(stoss.InvalidInput, match="executor: got"):
        stoss.sweep(grid(), executor, store=tmp_path)


def test_netcdf_of_what_is_not_complete(tmp_path):
    xarray = pytest.importorskip("xarray")
    netcdf = pytest.importorskip("netCDF4")
    balls = [stoss.Sphere(radius=radius, material=STEEL) for radius in (0.005, 0.01)]
    part = grid(bodies=balls, against="wall", speed=[0.5, 1.0])
    stoss.sweep(part, store=tmp_path / "store")
    (file,) = (tmp_path / "store").glob("*.csv")
    file.write_text("".join(file.read_text().splitlines(keepends=True)[:-1]))  # loses the last row
    result = stoss.merge(tmp_path / "store", tmp_path / "a.nc")
    assert not result.complete and np.isnan(result.restitution[1, 0, 1])
    with xarray.open_dataset(tmp_path / "a.nc") as data:
        assert (data.complete, data.missing_values) == ("false", 1)
        assert data.computed.values.tolist() == [[[1, 1]], [[1, 0]]]
        assert np.isnan(data.restitution.values[1, 0, 1]) and not np.isnan(data.restitution.values[1, 0, 0])
        assert (data.speed.units, data.contact_time_si.units, data.max_force_si.units) == ("m/s", "s", "N")
        direct = stoss.restitution(balls[0], speed=[0.5, 1.0], tolerance=1e-2)
        assert np.allclose(data.contact_time_si.values[0, 0], direct.contact_time_si, rtol=1e-14)
    with netcdf.Dataset(tmp_path / "a.nc") as data:
        assert data["restitution"][1, 0, 1] is np.ma.masked


def test_what_cannot_be_computed_is_kept_as_nan(tmp_path, monkeypatch):
    def fails(contact, speeds, tolerance, absolute, threads, state, rows, reasons, tick):
        for k in range(len(speeds)):
            rows[k]["restitution"] = rows[k]["restitution_error"] = np.nan
            tick()

    with monkeypatch.context() as patch:
        patch.setattr(stoss._core, "restitution_curve", fails)
        with pytest.warns(stoss.StossWarning, match="12 of 12"):
            stoss.sweep(grid(), store=tmp_path)
    monkeypatch.setattr(stoss._core, "restitution_curve", None)  # they are not computed again
    with pytest.warns(stoss.StossWarning, match="12 of 12"):
        again = stoss.sweep(grid(), store=tmp_path)
    assert again.complete and np.all(np.isnan(again.restitution)) and not again.converged.any()


def test_ctrl_c_keeps_what_is_done(tmp_path, monkeypatch, whole):
    real, calls = stoss._core.restitution_curve, []

    def stops(*arguments):
        calls.append(1)
        if len(calls) > 2:
            raise KeyboardInterrupt
        return real(*arguments)

    with monkeypatch.context() as patch:
        patch.setattr(stoss._core, "restitution_curve", stops)
        with pytest.raises(stoss.Interrupted, match="after 6 of 12 values") as stopped:
            stoss.sweep(grid(), store=tmp_path)
    assert np.count_nonzero(stopped.value.best.computed) == 6
    assert equal(stoss.sweep(grid(), store=tmp_path), whole[0])
