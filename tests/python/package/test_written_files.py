"""The package writes the files that it was told to, and no other: not for a moment, nowhere."""

import re
import sys
from pathlib import Path

import pytest

import stoss

sys.path.insert(0, str(Path(__file__).parents[2] / "support"))
from written import Watched  # noqa: E402

BALL = "ball = stoss.Sphere(radius=5e-3, material=stoss.materials['glass'])"
BODY = """body = stoss.ModalBody(mass=0.0785, curvature=0, young=2.1e11, poisson=0.3, density=7850, compliance=5e-8,
    frequency=[5319], displacement=[7.14], complete_to=5319)"""
HIT = "hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=12)"
GRID = "grid = stoss.Grid(bodies={'kind': 'rod'}, speed=[0.01, 0.1], tolerance=0.1, absolute=0.1)"
SILENT = [
    "", "stoss.restitution(poisson=0.33, speed=0.1, tolerance=0.1)", HIT, GRID, BODY,
    f"{BALL}; stoss.predict(ball, against='same', speed=1.0)", "list(stoss.materials)",
    "stoss.restitution_function(poisson=0.33, speed=(0.01, 0.1), error=0.1)",
]  # fmt: skip
WRITTEN = [
    ("out", "stoss.restitution(poisson=0.33, speed=0.1, tolerance=0.1).to_csv('out')"),
    ("out", f"{BODY}; body.save('out')"),
    ("out.npz", f"{BODY}; body.save('out.npz')"),
    ("out", f"{BALL}; stoss.impact(ball, against='same', speed=1.0, cutoff=12).sound(duration=0.01, slower=1000).save('out')"),
    ("out", f"{BALL}; stoss.fit(ball, against='same', law='linear', speed=(0.01, 0.1), program='lammps').write('out')"),
]
# A file that takes the place of another at the end, in the same folder.
BESIDE = re.compile(r"(?:.*/)?\.(?:stoss|grid)-\w+(?:\.\w+)?")


@pytest.fixture
def watched(tmp_path):
    return Watched(tmp_path)


@pytest.fixture
def run(watched):
    def run(code):
        """What the code writes under names that stay; only this is there then."""
        package = f"import sys; sys.path.insert(0, {str(Path(stoss.__file__).parents[1])!r}); import stoss"
        done, written = watched.run(sys.executable, "-c", f"{package}\n{code.replace('; ', chr(10))}")
        assert done.returncode == 0, done.stderr
        left = {str(path.relative_to(watched.here)) for path in watched.here.rglob("*")}
        written = {name for name in written if not BESIDE.fullmatch(name)}
        assert left == written
        return written

    return run


@pytest.mark.parametrize("code", SILENT)
def test_nothing_is_written_without_a_name(run, code):
    assert run(code) == set()


@pytest.mark.parametrize(("name", "code"), WRITTEN)
def test_only_what_is_named_is_written(run, name, code):
    if ".fit(" in code:
        pytest.importorskip("scipy")
    assert run(code) == {name}


def test_a_sweep_writes_into_its_store_only(run):
    names = run(f"{GRID}; stoss.sweep(grid, store='store')")
    assert {"store", "store/grid.json"} < names
    rows = names - {"store", "store/grid.json"}
    assert rows and all(re.fullmatch(r"store/worker-[\w-]+\.csv", name) for name in rows)


def test_a_merge_writes_one_file(run):
    pytest.importorskip("netCDF4")
    names = run(f"{GRID}; stoss.sweep(grid, store='store'); stoss.merge('store', 'out.nc')")
    assert {name for name in names if not name.startswith("store")} == {"out.nc"}
