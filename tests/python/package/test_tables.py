"""Files, frames and rows of results: where files go, what the command writes, dimensions, indices."""

import os
import stat
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import pytest
import stoss
from every_result import STEEL_BALL, computed

NOBODY = 65534  # whom modes of files bind even where the tests run as root


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


def test_dimensions_of_xarray():
    pytest.importorskip("xarray")
    curve = computed("curve").to_xarray()
    assert dict(curve.sizes) == {"poisson": 2, "speed": 3} and curve.speed.values.tolist() == [0.01, 0.1, 0.2]
    assert curve.restitution.sel(poisson=0.33, speed=0.1) == computed("curve").restitution[1, 1]
    pairs = computed("pair table").to_xarray()
    assert pairs.restitution.dims == ("speed",
     "ratio") and pairs.ratio.values.tolist() == computed("pair table").ratio.tolist()
    assert pairs.restitution.values.tolist() == computed("pair table").restitution.tolist()
    sweep = computed("sweep-si").to_xarray()
    assert sweep.restitution.dims == ("body", "against", "speed") and sweep.speed.values.tolist() == [0.5, 1.0]
    assert sweep.body_radius.dims == ("body",) and sweep.body_radius.values.tolist() == [0.005, 0.01]
    assert sweep.against.values.tolist() == ["wall", "same"] and sweep.body.values[0].startswith("sphere,radius=0.005")
    assert computed("atlas-si").to_xarray().restitution.shape == (2, 1)
    names = {"restitution-strain": "speed", "atlas": "speed", "modes": "mode", "trajectory": "time",
     "distribution": "sample", "bounce": "number"}
    for kind, dimension in names.items():
        assert tuple(computed(kind).to_xarray().sizes) == (dimension,)
    assert computed("restitution").to_xarray().restitution.ndim == 0


def test_files_become_frames_too(tmp_path):
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    computed("trajectory").to_csv(tmp_path / "path.csv")
    table = stoss.read_csv(tmp_path / "path.csv")
    assert table.to_dataframe().equals(computed("trajectory").to_dataframe())
    assert table.to_xarray().equals(computed("trajectory").to_xarray())


def test_a_sweep_is_a_row_for_each_value(tmp_path):
    sweep = computed("sweep-si")
    got = sweep.to_dict()
    assert stoss.Grid.from_dict(got["grid"]) == sweep.grid and got["restitution"] == sweep.restitution.tolist()
    sweep.to_csv(tmp_path / "sweep.csv")
    table = stoss.read_csv(tmp_path / "sweep.csv")
    assert table.size == 8 and table["against"].tolist() == ["wall", "wall", "same", "same"] * 2
    assert table.units["speed"] == "m/s" and table.units["contact_time_si"] == "s" and table["computed"].all()
    direct = stoss.restitution(STEEL_BALL, speed=[0.5, 1.0], tolerance=1e-2)
    assert table["contact_time_si"][:2] == pytest.approx(direct.contact_time_si, rel=1e-12)
    assert table["restitution"][:2].tolist() == direct.restitution.tolist()


@pytest.mark.parametrize("module, method", [("pandas", "to_dataframe"), ("xarray", "to_xarray")])
def test_a_missing_package_is_named(module, method, interpreter):
    code = (
        f"import sys; sys.modules[{module!r}] = None\n"
        f"import stoss\ntry: stoss.modes(poisson=0.3, cutoff=3).{method}()\nexcept ImportError as e: print(e)\n"
    )
    assert f"needs {module}: pip install" in interpreter.run(code).stdout


@pytest.mark.parametrize("kind", ["modes", "trajectory", "distribution", "bounce"])
def test_rows_are_indexed_and_sliced(kind):
    result = computed(kind)
    columns = {name: column for name, column in result._table().items() if column.size == len(result)}
    assert len(result) >= 3
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


def test_samples_are_summed_up_anew():
    part = computed("distribution")[:3]
    assert part.mean == pytest.approx(np.mean(part.restitution), rel=1e-14) and len(part.reason) == 3
    assert part.spread == pytest.approx(np.std(part.restitution, ddof=1))
    assert np.isnan(computed("distribution")[:0].mean)


def test_a_curve_is_indexed_like_its_arrays():
    curve = computed("curve")
    assert len(curve) == 2 and len(computed("restitution-strain")) == 2 and len(computed("empty")) == 0
    assert bool(computed("empty")) and bool(computed("restitution"))
    one = curve[1, 2]
    assert type(one.restitution) is float and one.restitution == curve.restitution[1, 2]
    assert one.body == stoss.Disk(poisson=0.33) and one.reason == "" and repr(one)
    assert curve[0].body == stoss.Disk(poisson=0.2) and curve[0].speed.shape == (3,)
    assert curve[:, 1:].restitution.shape == (2, 2) and curve[:, 1:].body is None
    fast = curve[curve.speed > 0.05]
    assert fast.restitution.tolist() == curve.restitution[:, 1:].ravel().tolist()
    assert [each.poisson for each in (part.body for part in curve)] == [0.2, 0.33]
    for scalar in (computed("restitution"), one):
        for call in (len, lambda each: each[0]):
            with pytest.raises(TypeError):
                call(scalar)
    with pytest.raises(IndexError):
        curve[2]
    strained = computed("restitution-strain")
    assert strained[1].speed_si == strained.speed_si[1] and strained[1].body == strained.body


def test_csv_goes_where_it_should(hit, tmp_path):
    target, link = tmp_path / "a file.csv", tmp_path / "link.csv"
    hit.to_csv(str(target))
    text = target.read_text()
    link.touch()  # with the mode of any new file
    assert target.stat().st_mode == link.stat().st_mode
    link.unlink()
    target.write_text("old")
    target.chmod(0o640)
    link.symlink_to(target.name)
    hit.to_csv(link)
    assert link.is_symlink() and target.read_text() == text and stat.S_IMODE(target.stat().st_mode) == 0o640
    for bad in (tmp_path, tmp_path / "none" / "x.csv", target / "x.csv"):
        with pytest.raises(OSError):
            hit.to_csv(bad)
    if os.path.exists("/dev/full"):
        with pytest.raises(OSError):
            hit.to_csv("/dev/full")
    assert sorted(os.listdir(tmp_path)) == ["a file.csv", "link.csv"]


# Files that may not be written, and a disk that is full after 100 bytes.
FORBIDDEN = """
import os, resource, signal, stoss
hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=8)
def refused(path):
    try:
        hit.to_csv(path)
    except OSError:
        return True
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
unlimited = resource.getrlimit(resource.RLIMIT_FSIZE)
resource.setrlimit(resource.RLIMIT_FSIZE, (100, unlimited[1]))
assert refused("free/old.csv") and refused("free/new.csv")
resource.setrlimit(resource.RLIMIT_FSIZE, unlimited)
if os.geteuid() == 0:
    os.setuid({user})
assert refused("locked/new.csv") and refused("free/read-only.csv")
"""


def test_csv_appears_whole_or_not_at_all(interpreter):
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        for name, mode in (("locked", 0o555), ("free", 0o777)):
            place = Path(folder, name)
            place.mkdir()
            for old, its_mode in (("old.csv", 0o666), ("read-only.csv", 0o444)):
                (place / old).write_text("kept")
                (place / old).chmod(its_mode)
            place.chmod(mode)
        done = interpreter.run(FORBIDDEN.format(user=NOBODY), cwd=folder)
        assert done.returncode == 0, done.stderr
        left = {str(path.relative_to(folder)): path.read_text() for path in Path(folder).glob("*/*")}
        assert left == {f"{name}/{old}.csv": "kept" for name in ("locked", "free") for old in ("old", "read-only")}


def test_arrays_are_not_copied(hit):
    for array in (hit.mode_energies, hit.trajectory().force, stoss.modes(poisson=0.33, cutoff=6).omega):
        assert not array.flags.owndata
    # The memory stays while an array is in use.
    omega = stoss.modes(poisson=0.33, cutoff=6).omega
    energies = stoss.impact(poisson=0.33, speed=0.1, cutoff=6).mode_energies
    expected = omega.tolist()
    _ = [stoss.impact(poisson=0.2, speed=0.1, cutoff=6).trajectory() for _ in range(9)]
    assert omega.tolist() == expected and sorted(energies["omega"].tolist()) == sorted(expected)
