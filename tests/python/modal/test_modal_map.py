"""Maps of ε over a surface: against files of single points, by symmetry, and where there is no value."""

import shlex
import signal
import subprocess
import sys
import warnings
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
import stoss
from conftest import ENVIRONMENT, UNITS

STEEL = "--material 'structural steel'"
BALL = "--against 'sphere,radius=0.005,material=bearing steel'"
ROUND = 'SetFactory("OpenCASCADE");\nSphere(1) = {0, 0, 0, 10};\n'
BLOCK = """SetFactory("OpenCASCADE");
Box(1) = {-20, -15, -10, 40, 30, 20};
Physical Surface("end") = {1};
Physical Volume("block") = {1};
"""
ON_ROUND = f"round.geo --unit mm {STEEL} --size 1.5 --modes 20"


class Read:
    """Both files of numbers of a map."""

    def __init__(self, folder, name):
        self.table = stoss.read_csv(folder / f"{name}.csv")
        grid = ElementTree.parse(folder / f"{name}.vtu").getroot().find("UnstructuredGrid/Piece")
        self.fields = {
            each.get("Name"): np.array(each.text.split(), dtype=float).reshape(-1, int(each.get("NumberOfComponents")))
            for each in grid.iter("DataArray")
        }
        self.points, self.triangles = self.fields["points"], self.fields["connectivity"].reshape(-1, 3).astype(int)

    def at(self, speed):
        """Rows of the table at one speed."""
        return self.table[np.isclose(self.table["speed"], speed)]


@pytest.fixture(scope="module")
def mapped(modal):
    """Runs it, and reads what it writes."""
    (modal.folder / "round.geo").write_text(ROUND)
    (modal.folder / "block.geo").write_text(BLOCK)

    def made(words, name):
        done = modal.run(f"{words} --map {name}.vtu")
        assert done.returncode == 0, done.stderr
        assert (modal.folder / f"{name}.png").stat().st_size > 5000
        return Read(modal.folder, name), done.stderr

    return made


@pytest.fixture(scope="module")
def sphere(mapped):
    return mapped(f"{ON_ROUND} {BALL} --speed 0.1,1 --points 30", "sphere")[0]


def test_files_agree(sphere):
    for speed in (0.1, 1.0):
        rows = sphere.at(speed)
        assert np.allclose(np.stack([rows[name] for name in "xyz"], axis=1), sphere.points)
        field = sphere.fields[f"restitution {speed:g} m/s"].ravel()
        assert np.array_equal(rows["restitution"], field, equal_nan=True)
        assert np.sum(np.isfinite(field)) >= 20
    assert sphere.table.units["contact_time"] == "s"


def test_surface_is_closed_and_faces_outward(sphere):
    corners = sphere.points[sphere.triangles]
    edges = np.sort(sphere.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    assert np.all(np.unique(edges, axis=0, return_counts=True)[1] == 2)
    volume = np.sum(corners[:, 0] * np.cross(corners[:, 1], corners[:, 2])) / 6.0
    assert 0.6 < volume / (4.0 / 3.0 * np.pi * 1e-6) < 1.0


def test_normals_are_those_of_the_sphere(sphere):
    known = sphere.fields["reason"].ravel() == 0
    off = np.linalg.norm(sphere.fields["normal"] - sphere.points / 0.01, axis=1)
    assert np.max(off[known]) < 2e-3


def test_all_points_of_a_sphere_are_alike(sphere):
    """What they differ by is that of the mesh, which their errors cover."""
    for speed in (0.1, 1.0):
        rows = sphere.at(speed)
        value, error = rows["restitution"], rows["restitution_error"]
        good = np.isfinite(value)
        assert np.all(np.abs(value - np.median(value[good]))[good] < error[good])
        assert np.all(error[good] < 0.5 * (1 - value[good] ** 2))  # twenty modes tell that much of the loss


def test_is_what_files_of_points_have(modal):
    """On the same two meshes a map is the body files of its points: it has no other engine."""
    modal.gmsh(ROUND, "round_fine.msh", 1.5)
    modal.gmsh(ROUND, "round_coarse.msh", 1.9)
    common = f"round_fine.msh round_coarse.msh --unit mm {STEEL} --modes 8"
    done = modal.run(f"{common} {BALL} --speed 0.3 --points 12 --map both.vtu")
    assert done.returncode == 0, done.stderr
    table = Read(modal.folder, "both").table
    ball = stoss.Sphere(radius=0.005, material=stoss.materials["bearing steel"])
    for at in np.flatnonzero(np.isfinite(table["restitution"]))[[0, -1]]:
        row = table[int(at)]
        place = ",".join(f"{1e3 * row[name]:.12g}" for name in "xyz")
        normal = ",".join(f"{row[f'normal_{name}']:.12g}" for name in "xyz")
        body = modal.body(f"{common} --point {place} --normal {normal}", name="one.json")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", stoss.StossWarning)
            hit = stoss.restitution(ball, against=stoss.ModalBody.from_dict(body), speed=[0.3], tolerance=0.01)
        assert row["restitution"] == pytest.approx(hit.restitution[0], rel=1e-5)
        assert row["restitution_error"] == pytest.approx(hit.restitution_error[0], rel=1e-2)


@pytest.mark.long
def test_errors_cover_meshes_that_are_fine_at_the_point(modal, sphere):
    ball = stoss.Sphere(radius=0.005, material=stoss.materials["bearing steel"])
    rows = sphere.at(1.0)
    places = np.flatnonzero(np.isfinite(rows["restitution"]))[[0, 4, 8, 12, 16]]
    covered = []
    for at in places:
        row = rows[int(at)]
        place = ",".join(f"{1e3 * row[name]:.9g}" for name in "xyz")
        normal = ",".join(f"{row[f'normal_{name}']:.9g}" for name in "xyz")
        body = modal.body(
            f"{ON_ROUND} --point {place} --normal {normal} --size 2.5 --size-at-point 0.5", name="fine.json"
        )
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", stoss.StossWarning)
            hit = stoss.restitution(ball, against=stoss.ModalBody.from_dict(body), speed=[1.0], tolerance=0.01)
        off = abs(row["restitution"] - hit.restitution[0])
        covered.append(off <= row["restitution_error"] + hit.restitution_error[0])
    assert len(covered) >= 5 and all(covered), covered


def test_what_is_held_or_has_an_edge_has_no_value(mapped):
    words = (
        f"block.geo --unit mm {STEEL} --size 3 --modes 10 --clamp end {BALL} --speed 0.5 --points 150 --errors-unknown"
    )
    block, said = mapped(words, "block")
    rows = block.at(0.5)
    known = np.isfinite(rows["restitution"])
    assert "no value at" in said and "held there, or beside it" in said and "a sharp edge" in said
    assert 10 < np.sum(known) < 100
    x, y, z = (1e3 * rows[name] for name in "xyz")
    inside = np.sort(np.stack([20 - np.abs(x), 15 - np.abs(y), 10 - np.abs(z)]), axis=0)
    assert np.all(np.abs(inside[0]) < 1e-6)  # on a face
    assert np.all(inside[1][known] > 6.0)  # but not near its edges
    assert np.all(rows["reason"][known] == 0) and np.all(rows["reason"][~known] > 0)
    # Upper and lower face are alike, and so are y and −y: a smooth function of x and y² has all values on them.
    there = known & (np.abs(z) > 9.9)
    terms = np.stack([np.ones(np.sum(there)), x[there], x[there] ** 2, y[there] ** 2], axis=1)
    value = rows["restitution"][there]
    smooth = terms @ np.linalg.lstsq(terms, value, rcond=None)[0]
    assert np.sum(there) > 8 and np.max(np.abs(value - smooth)) < 0.1 * np.ptp(value)


def test_goes_on_after_ctrl_c(modal, mapped):
    """What one mesh has told is not asked again."""
    words = f"block.geo --unit mm {STEEL} --size 3 --modes 5 {BALL} --points 60 --map stopped.vtu"
    command = [sys.executable, "-m", "stoss.modal", *shlex.split(f"{words} --speed 1")]
    with subprocess.Popen(command, cwd=modal.folder, env=ENVIRONMENT, stderr=subprocess.PIPE, text=True) as run:
        for line in run.stderr:
            if "modes, and the compliance" in line:
                run.send_signal(signal.SIGINT)
                break
        rest = run.stderr.read()
    assert run.returncode == 130 and "interrupted" in rest
    again = modal.run(f"{words} --speed 1,2")
    assert again.returncode == 0 and again.stderr.count("results of an earlier run") == 1
    assert not (modal.folder / "stopped.vtu.part").exists()


def test_refuses_what_cannot_be_written_before_it_begins(modal, mapped):
    (modal.folder / "taken.csv").mkdir()
    failed = modal.run(f"{ON_ROUND} {BALL} --speed 1 --map taken.vtu")
    assert failed.returncode == 4 and "taken.csv" in failed.stderr and "mesh" not in failed.stderr


@pytest.mark.parametrize(
    "words, said",
    [
        ("", "speed: missing"),
        ("--speed 0", "speed: got 0.0, allowed above 0"),
        ("--speed 1 --points 3", "points: got 3, allowed 4 or more"),
        ("--speed 1 --point 0,0,10", "point: is of one point, not of a map"),
        ("--speed 1 -o x.json", "output: is of one point, not of a map"),
        ("--speed 1 --plate 1x1x0.1", "plate: is of one point, not of a map"),
        ("--speed 1 --against ball", "against: got 'ball', allowed wall, half-space, sphere"),
        ("--speed 1 --against sphere,material=glass", "against sphere radius: missing"),
        ("--speed 1 --against sphere,radius=x,material=glass", "against sphere radius: got 'x', allowed a number"),
        ("--speed 1 --against sphere,radius=1", "against sphere material: missing"),
        ("--speed 1 --against wall,radius=1", "against wall: got 'radius=1', allowed KEY=VALUE with no key"),
        ("--speed 1 --clamp end", "against: a body that is held does not move"),
    ],
)
def test_refusals(modal, words, said):
    done = modal.run(f"{ON_ROUND} --map refused.vtu {words}")
    assert done.returncode == 2 and said in done.stderr, done.stderr
    assert "Traceback" not in done.stderr and len(done.stderr.splitlines()) == 1


def test_only_a_map_has_speeds(modal):
    done = modal.run(f"sphere.geo --point 0,0,1 --normal 0,0,1 {UNITS} --poisson 0.3 --size 1 --speed 1 -o x.json")
    assert done.returncode == 2 and "speed: is of a map" in done.stderr
    done = modal.run(f"sphere.geo {UNITS} --poisson 0.3 --size 1 --speed 1 --map x.json")
    assert done.returncode == 2 and "allowed a name that ends in .vtu" in done.stderr
