"""Each file that the package writes names its format with a version, as docs/developer/versions.md says; later ones are refused in
one line, with what was got and what is allowed."""

import json
import re
from pathlib import Path

import pytest

import stoss

PAGE = Path(__file__).parents[3] / "docs/developer/versions.md"
ROWS = re.findall(r"^\| (.*?) \| (.*?) \|", PAGE.read_text(encoding="utf-8").partition("## Formats")[2], re.MULTILINE)
FORMATS = {name: version.strip("`") for name, version in ROWS}
GRID = {"bodies": {"kind": "disk", "poisson": 0.33}, "speed": [0.1], "tolerance": 0.05}
NEXT = f"{int(stoss.__version__.split('.')[0]) + 1}.0.0"


def refusal(call, *arguments, **options):
    with pytest.raises(stoss.InvalidInput) as refused:
        call(*arguments, **options)
    assert "\n" not in str(refused.value)
    return str(refused.value)


def test_csv_of_later_versions_is_refused_and_of_earlier_ones_read(tmp_path):
    path = tmp_path / "modes.csv"
    stoss.modes(poisson=0.33, cutoff=3).to_csv(path)
    text = path.read_text()
    assert text.startswith(f"# stoss {stoss.__version__}: modes\n")
    own = stoss.__version__.split(".")[0]
    for version in ("0.1.0", f"{own}.999.0", f"{own}.0.0-beta"):
        path.write_text(text.replace(stoss.__version__, version, 1))
        assert stoss.read_csv(path).version == version
    path.write_text(text.replace(stoss.__version__, NEXT, 1))
    said = refusal(stoss.read_csv, path)
    assert f"of stoss {NEXT}, allowed one of stoss {own} or earlier" in said and "modes.csv" in said


@pytest.fixture
def store(tmp_path):
    stoss.sweep(GRID, store=tmp_path / "values")
    return tmp_path / "values"


def test_a_grid_names_its_format(store):
    grid = json.loads((store / "grid.json").read_text())
    assert grid["format"] == FORMATS["grid of a sweep"]
    assert stoss.Grid.from_dict(grid) == stoss.Grid(**GRID) == stoss.Grid.from_dict({**GRID, "format": grid["format"]})
    later = {**GRID, "format": "stoss grid 2", "colour": "red"}
    assert refusal(stoss.Grid.from_dict, later) == (
        "format: got 'stoss grid 2', allowed 'stoss grid 1' (written by a later stoss)"
    )
    assert "later" not in refusal(stoss.Grid.from_dict, {**GRID, "format": "of mine"})
    (store / "grid.json").write_text(json.dumps({**grid, "format": "stoss grid 2"}))
    assert "written by a later stoss" in refusal(stoss.open_sweep, store)


def test_a_store_without_the_format_of_its_grid_is_read(store):
    grid = json.loads((store / "grid.json").read_text())
    del grid["format"]
    (store / "grid.json").write_text(json.dumps(grid))
    assert stoss.open_sweep(store).complete


def test_a_store_of_a_later_version_is_refused_even_where_others_are_taken(store):
    (file,) = store.glob("*.csv")
    text = file.read_text()
    assert text.startswith(f"# stoss {stoss.__version__}: sweep\n")
    file.write_text(text.replace(stoss.__version__, NEXT, 1))
    for mix in (False, True):
        assert f"of stoss {NEXT}, allowed" in refusal(stoss.open_sweep, store, mix=mix)
    file.write_text(text.replace(stoss.__version__, "0.0.1", 1))
    assert "another version needs another store" in refusal(stoss.open_sweep, store)
    assert stoss.open_sweep(store, mix=True).complete


def test_netcdf_names_its_format(store, tmp_path):
    netcdf = pytest.importorskip("netCDF4")
    stoss.merge(store, tmp_path / "values.nc")
    with netcdf.Dataset(tmp_path / "values.nc") as file:
        assert file.format == FORMATS["sweep in NetCDF"] and file.Conventions == "CF-1.8"
        assert file.source == f"stoss {stoss.__version__}"


def test_a_collision_rule_names_its_format(tmp_path):
    rule = stoss.collision_rule(stoss.Sphere(poisson=0.3), speed=(1e-2, 2e-2), error=0.1)
    own = FORMATS["collision rule in JSON and NetCDF from Python"]
    rule.to_json(tmp_path / "rule.json")
    document = json.loads((tmp_path / "rule.json").read_text())
    assert (document["format"], document["version"]) == (own, stoss.__version__)
    netcdf = pytest.importorskip("netCDF4")
    rule.to_netcdf(tmp_path / "rule.nc")
    with netcdf.Dataset(tmp_path / "rule.nc") as file:
        assert file.format == own


def test_a_body_by_its_modes_names_its_format(tmp_path):
    body = stoss.ModalBody(
        mass=1.0, curvature=100.0, young=2e11, poisson=0.3, density=7800.0, compliance=1e-12,
        frequency=[1e4], displacement=[1.0],
    )  # fmt: skip
    own = FORMATS["body by its modes"]
    for name in ("body.json", "body.npz"):
        body.save(tmp_path / name)
        assert stoss.ModalBody.read(tmp_path / name).to_dict() == body.to_dict()
    document = json.loads((tmp_path / "body.json").read_text())
    assert document["format"] == own == body.to_dict()["format"]
    (tmp_path / "later.json").write_text(json.dumps({**document, "format": "stoss modal body 2"}))
    assert "written by a later stoss" in refusal(stoss.ModalBody.read, tmp_path / "later.json")
