"""The package writes the files that it was told to, and no other: not for a moment, nowhere. In a folder that has been
removed it writes none: OSError at once."""

import os
import re
import resource
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


MADE = """
import os, stoss
ball = stoss.Sphere(poisson=0.3)
curve = stoss.restitution(ball, speed=[0.01, 0.1], tolerance=0.1)
function = stoss.restitution_function(ball, speed=(0.05, 0.1), error=0.05)
grid = {"bodies": {"kind": "sphere", "poisson": 0.3}, "speed": 0.1, "tolerance": 0.1}
swept, store = stoss.sweep(grid, store="store"), os.path.abspath("store")
body = stoss.ModalBody.from_dict({
    "format": "stoss modal body 1", "name": "ball", "mass": 0.5, "curvature": [10.0, 8.0], "young": 1e11,
    "poisson": 0.3, "density": 8000.0, "compliance": -2e-12, "complete_to": 30000.0,
    "modes": {"frequency": [20000.0, 30000.0], "displacement": [0.1, 0.2]}})
os.mkdir("gone"); os.chdir("gone"); os.rmdir("../gone")
def writes(call):
    try:
        call()
    except OSError as error:
        print(error.errno == 2)
    except stoss.InvalidInput as error:
        print("InvalidInput", error)
    else:
        print("written")
"""
WAYS = [
    'curve.to_csv("x.csv")', 'function.to_c("x.h")', 'function.to_csv("x.csv")', 'swept.to_netcdf("x.nc")', 'body.save("x.json")',
    'body.save("x.npz")', 'stoss.sweep(grid, store="s")', 'stoss.merge(store, "x.nc")',
]  # fmt: skip


def test_no_writer_tries_for_ever(interpreter, tmp_path):
    pytest.importorskip("netCDF4")
    code = MADE + "".join(f"writes(lambda: {way})\n" for way in WAYS)
    limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (50, 50))  # noqa: E731
    done = interpreter.run(code, cwd=tmp_path, preexec_fn=limit)
    assert (done.returncode, done.stdout) == (0, "True\n" * len(WAYS)), done.stdout + done.stderr
    assert os.listdir(tmp_path) == ["store"]
