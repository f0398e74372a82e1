"""Results as tables: read_csv of all that stoss writes, pandas, xarray, notebooks, indices."""

import json
import os
import subprocess
import tempfile

import numpy as np
import pytest

import stoss

Q = stoss.quasistatic
BALL = stoss.Sphere(poisson=0.3)
STEEL = stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"])


@pytest.fixture(scope="module")
def results():
    hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=10)
    return {
        "curve": stoss.restitution(poisson=[[0.2], [0.33]], speed=[0.01, 0.1, 0.2]),
        "number": stoss.restitution(BALL, speed=0.1),
        "steel": stoss.restitution(STEEL, against=stoss.HalfSpace(material=STEEL.material), speed=[0.1, 0.2]),
        "empty": stoss.restitution(BALL, speed=[]),
        "modes": stoss.modes(poisson=0.33, cutoff=6),
        "impact": hit,
        "trajectory": hit.trajectory(every=10),
        "field": hit.field(time=[2, 1], radius=[0.0, 0.5, 1.0], angle=[0.0, 3.0]),
        "distribution": stoss.restitution_distribution(BALL, speed=0.01, temperature=0.01, samples=6),
        "bounces": stoss.bounce(BALL, speed=0.05, count=5, flight_time=30),
        "slow": Q.slow_impact(poisson=0.33, speed=[1e-3, 1e-2]),
        "rayleigh": Q.rayleigh(BALL, speed=[1e-3, 1e-2], cutoff=10),
        "static": Q.static_contact(poisson=0.33, compression=0.01),
        "pairs": stoss.pair_table(poisson=0.33, speed=(0.05, 0.2), ratio=(1, 1.5), error=2e-2),
        "atlas": stoss.atlas(BALL, speed=[0.01, 0.1]),
        "atlas in SI": stoss.atlas(stoss.Disk(radius=0.01, loss_time=0, material=STEEL.material), speed=[[1.0], [9.0]]),
        "sweep": swept({"kind": "sphere", "poisson": [0.1, 0.3]}, [0.01, 0.1]),
        "sweep in SI": swept([STEEL, stoss.Sphere(radius=0.01, material=stoss.materials["glass"])], [0.5, 1.0]),
        "chain": stoss.rod_chain([stoss.Rod(), stoss.Rod(length=2)], circumference=9, temperature=1, collisions=9),
    }


def swept(bodies, speed):
    with tempfile.TemporaryDirectory() as store:
        grid = {"bodies": bodies, "against": ["wall", "same"], "speed": speed, "tolerance": 1e-2}
        return stoss.sweep(grid, store=store)


KINDS = ("curve", "number", "steel", "empty", "modes", "impact", "trajectory", "field", "distribution", "bounces",
         "slow", "rayleigh", "static", "chain", "pairs", "atlas", "atlas in SI", "sweep", "sweep in SI")  # fmt: skip


@pytest.fixture(params=KINDS)
def result(request, results):
    return results[request.param]


def test_read_csv_gives_back_what_to_csv_wrote(result, tmp_path):
    result.to_csv(tmp_path / "result.csv")
    table = stoss.read_csv(tmp_path / "result.csv")
    columns = result._columns()
    assert list(table) == list(columns) and table.version == stoss.__version__
    assert table.kind == result._name and table.size == min(column.size for column in columns.values())
    assert dict(table.inputs) == {key: str(value) for key, value in result._inputs().items()}
    for name, column in columns.items():
        if table.size:
            assert table[name].dtype.kind == column.dtype.kind, name
        assert table[name].tolist() == column.ravel().tolist(), name
        assert table.units.get(name, "") == result._unit(name)
    with pytest.raises(ValueError, match="read-only"):
        table[list(table)[0]][...] = 0


JOBS = {
    "modes": "modes --body disk --poisson 0.33 --cutoff 6",
    "impact": "impact --body disk --poisson 0.33 --speed 0.1 --cutoff 10",
    "restitution": "restitution --body disk --poisson 0.2,0.33 --speed 0.01,0.1",
    "distribution": "distribution --body sphere --poisson 0.3 --speed 0.01 --temperature 0.01 --samples 3",
    "bounce": "bounce --body sphere --poisson 0.3 --speed 0.05 --count 3 --flight-time 30",
    "quasistatic": "quasistatic --body disk --poisson 0.33 --speed 0.01,0.02",
}


@pytest.mark.parametrize("kind", JOBS)
def test_read_csv_reads_what_the_command_writes(kind, command, tmp_path):
    words = [os.environ["STOSS"], *JOBS[kind].split(), "--format", "csv", "--quiet", "-o", str(tmp_path / "job.csv")]
    subprocess.run(words, check=True, capture_output=True, timeout=120)
    table = stoss.read_csv(tmp_path / "job.csv")
    assert table.kind == kind and table.inputs["command"].startswith(f"stoss {kind}")
    rows = command(JOBS[kind])
    lists = [each for each in rows.values() if isinstance(each, list) and each and isinstance(each[0], dict)]
    assert any(len(each) == table.size for each in lists)
    same = next(each for each in lists if len(each) == table.size)
    for name in set(table) & set(same[0]):
        if not isinstance(same[0][name], (dict, list)):
            assert table[name].tolist() == [row[name] for row in same], name


def test_pandas(result):
    pytest.importorskip("pandas")
    frame = result.to_dataframe()
    columns = result._columns()
    assert list(frame.columns) == list(columns)
    for name, column in columns.items():
        assert frame[name].tolist() == column.ravel().tolist()
    assert frame.attrs["units"] == {name: result._unit(name) for name in columns if result._unit(name)}


def test_xarray(result):
    pytest.importorskip("xarray")
    data = result.to_xarray()
    for name, column in result._columns().items():
        assert data[name].attrs.get("units", "") == result._unit(name)
        if name not in data.dims and not name.startswith("body_"):  # those of a sweep do not depend on the speed
            assert data[name].values.ravel().tolist() == column.ravel().tolist(), name
    assert data.attrs == {key: str(value) for key, value in result._inputs().items()}


def test_dimensions_of_xarray(results):
    pytest.importorskip("xarray")
    curve = results["curve"].to_xarray()
    assert dict(curve.sizes) == {"poisson": 2, "speed": 3} and curve.speed.values.tolist() == [0.01, 0.1, 0.2]
    assert curve.restitution.sel(poisson=0.33, speed=0.1) == results["curve"].restitution[1, 1]
    pairs = results["pairs"].to_xarray()
    assert pairs.restitution.dims == ("speed", "ratio") and pairs.ratio.values.tolist() == results["pairs"].ratio.tolist()
    assert pairs.restitution.values.tolist() == results["pairs"].restitution.tolist()
    sweep = results["sweep in SI"].to_xarray()
    assert sweep.restitution.dims == ("body", "against", "speed") and sweep.speed.values.tolist() == [0.5, 1.0]
    assert sweep.body_radius.dims == ("body",) and sweep.body_radius.values.tolist() == [0.005, 0.01]
    assert sweep.against.values.tolist() == ["wall", "same"] and sweep.body.values[0].startswith("sphere,radius=0.005")
    assert results["atlas in SI"].to_xarray().restitution.shape == (2, 1)
    names = {"steel": "speed", "atlas": "speed", "modes": "mode", "trajectory": "time", "distribution": "sample", "bounces": "number"}
    for kind, dimension in names.items():
        assert tuple(results[kind].to_xarray().sizes) == (dimension,)
    assert results["number"].to_xarray().restitution.ndim == 0


def test_files_become_frames_too(results, tmp_path):
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    results["trajectory"].to_csv(tmp_path / "path.csv")
    table = stoss.read_csv(tmp_path / "path.csv")
    assert table.to_dataframe().equals(results["trajectory"].to_dataframe())
    assert table.to_xarray().equals(results["trajectory"].to_xarray())


def test_dicts_are_plain(result):
    got = result.to_dict()
    assert json.loads(json.dumps(got)) == got


def test_a_sweep_is_a_row_for_each_value(results, tmp_path):
    sweep = results["sweep in SI"]
    got = sweep.to_dict()
    assert stoss.Grid.from_dict(got["grid"]) == sweep.grid and got["restitution"] == sweep.restitution.tolist()
    sweep.to_csv(tmp_path / "sweep.csv")
    table = stoss.read_csv(tmp_path / "sweep.csv")
    assert table.size == 8 and table["against"].tolist() == ["wall", "wall", "same", "same"] * 2
    assert table.units["speed"] == "m/s" and table.units["contact_time_si"] == "s" and table["computed"].all()
    direct = stoss.restitution(STEEL, speed=[0.5, 1.0], tolerance=1e-2)
    assert table["contact_time_si"][:2] == pytest.approx(direct.contact_time_si, rel=1e-12)
    assert table["restitution"][:2].tolist() == direct.restitution.tolist()


@pytest.mark.parametrize("module, method", [("pandas", "to_dataframe"), ("xarray", "to_xarray")])
def test_a_missing_package_is_named(module, method, interpreter):
    code = (
        f"import sys; sys.modules[{module!r}] = None\n"
        f"import stoss\ntry: stoss.modes(poisson=0.3, cutoff=3).{method}()\nexcept ImportError as e: print(e)\n"
    )
    assert f"needs {module}: pip install" in interpreter.run(code).stdout


def test_notebooks_get_a_compact_escaped_table(result):
    text = result._repr_html_()
    assert text.count("<tr>") <= 12 and text.count("<table") == text.count("</table>") == 1 and len(text) < 20_000


@pytest.mark.parametrize("kind", ["modes", "trajectory", "distribution", "bounces"])
def test_rows_are_indexed_and_sliced(kind, results):
    result = results[kind]
    columns = {name: column for name, column in result._table().items() if column.size == len(result)}
    assert len(result) > 3
    for k in (0, -1, 2):
        row = result[k]
        assert all(row[name] == column[k].item() for name, column in columns.items())
    part, chosen = result[1:3], result[np.arange(len(result)) % 2 == 0]
    assert type(part) is type(chosen) is type(result) and len(part) == 2
    for name, column in columns.items():
        assert getattr(part, name).tolist() == column[1:3].tolist()
        assert getattr(chosen, name).tolist() == column[::2].tolist()
        assert not getattr(part, name).flags.writeable
    assert len(list(result)) == len(result) and repr(part) and part.to_dict()
    with pytest.raises(IndexError):
        result[len(result)]


def test_samples_are_summed_up_anew(results):
    part = results["distribution"][:3]
    assert part.mean == pytest.approx(np.mean(part.restitution), rel=1e-14) and len(part.reason) == 3
    assert part.spread == pytest.approx(np.std(part.restitution, ddof=1))
    assert np.isnan(results["distribution"][:0].mean)


def test_a_curve_is_indexed_like_its_arrays(results):
    curve = results["curve"]
    assert len(curve) == 2 and len(results["steel"]) == 2 and len(results["empty"]) == 0
    assert bool(results["empty"]) and bool(results["number"])
    one = curve[1, 2]
    assert type(one.restitution) is float and one.restitution == curve.restitution[1, 2]
    assert one.body == stoss.Disk(poisson=0.33) and one.reason == "" and repr(one)
    assert curve[0].body == stoss.Disk(poisson=0.2) and curve[0].speed.shape == (3,)
    assert curve[:, 1:].restitution.shape == (2, 2) and curve[:, 1:].body is None
    fast = curve[curve.speed > 0.05]
    assert fast.restitution.tolist() == curve.restitution[:, 1:].ravel().tolist()
    assert [each.poisson for each in (part.body for part in curve)] == [0.2, 0.33]
    for scalar in (results["number"], one):
        for call in (len, lambda each: each[0]):
            with pytest.raises(TypeError):
                call(scalar)
    with pytest.raises(IndexError):
        curve[2]
    steel = results["steel"][1]
    assert steel.speed_si == results["steel"].speed_si[1] and steel.body == STEEL
