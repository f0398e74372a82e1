"""The command: one line for bad input, runs that go on, and the same numbers on two processes."""

import json
import re
import shutil

import numpy as np
import pytest
from conftest import BALL, SMALL, SPHERE, UNITS

STEEL = "--material 'structural steel'"
QUICK = f"{UNITS} --poisson 0.3 --size 0.6 --size-at-point 0.09 --modes 5"
MESHES = "fine.msh coarse.msh"
EDGES_OF_HALF = r"too coarse at the point: edges of (\S+) m, allowed (\S+) m, better a fourth of that"
BOX_ENDS = r"too coarse at the point: edges of (\S+) m, the surface ends or turns away within (\S+) m"


@pytest.fixture(scope="module")
def meshes(modal):
    modal.gmsh(SPHERE, "fine.msh", 0.16)
    modal.gmsh(SPHERE, "coarse.msh", 0.22)
    modal.gmsh(SPHERE + "Sphere(2) = {4, 0, 0, 1};", "two.msh", 0.5)
    dent = "Sphere(2) = {0, 0, 1.5, 1}; BooleanDifference{Volume{1}; Delete;}{Volume{2}; Delete;}"
    modal.gmsh(SPHERE + dent, "dent.msh", 0.12)
    (modal.folder / "shell.msh").write_text(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
        "$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n"
    )
    box = 'SetFactory("OpenCASCADE");\nBox(1) = {-1, -1, -1, 2, 2, 2};\n'
    (modal.folder / "box.geo").write_text(box)
    (modal.folder / "text.msh").write_text("no mesh\n")
    modal.gmsh('SetFactory("OpenCASCADE");\nBox(1) = {0, 0, 0, 20, 12, 0.4};', "wall.msh", 1.0)
    modal.gmsh('SetFactory("OpenCASCADE");\nBox(1) = {0, 0, 0, 20, 12, 0.4};', "wall_coarse.msh", 1.4)
    nodes = "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
    (modal.folder / "inverted.msh").write_text(
        f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n{nodes}$EndNodes\n"
        "$Elements\n1\n1 4 2 0 1 1 3 2 4\n$EndElements\n"
    )


@pytest.mark.parametrize(
    "words, said",
    [
        (f"none.msh {BALL} {STEEL} --errors-unknown", "none.msh: no such file"),
        (f"text.msh {BALL} {STEEL} --errors-unknown", "text.msh"),
        (f"shell.msh {BALL} {STEEL} --errors-unknown", "no tetrahedra"),
        (f"two.msh {BALL} {STEEL} --errors-unknown", "two.msh: the mesh is in 2 parts"),
        (f"fine.msh {BALL} {STEEL}", "give a coarser one"),
        (f"fine.msh fine.msh {BALL} {UNITS} --poisson 0.3 --modes 1", "fine.msh: has"),
        (f"{MESHES} --point 0,0,1.2 --normal 0,0,1 {STEEL}", "0.2 m beside the surface, nearest"),
        (f"{MESHES} --point 0,0,1.02 --normal 0,0,1 {STEEL}", "point: 0.0"),
        (f"{MESHES} --unit mm --point 600,0,800 --normal 6,0,8 {STEEL}", "--unit mm"),
        (f"{MESHES} --point 0,0,1 --normal 0,0,0 {STEEL}", "normal: got length 0"),
        (f"{MESHES} --point 0,0,1 --normal 0,0.2,1 {STEEL}", "normal: 11."),
        (f"{MESHES} --point 0,0,1 --normal 0,0,-1 {STEEL}", "normal: the surface does not face"),
        (f"dent.msh --point 0,0,0.5 --normal 0,0,1 {STEEL} --errors-unknown", "a hollow"),
        (f"{MESHES} {BALL}", "material: missing"),
        (f"{MESHES} {BALL} --material stone", "allowed"),
        (f"{MESHES} {BALL} {UNITS} --poisson 0.5", "poisson"),
        ("box.geo --point 1,0.3,1 --normal 1,0,1 --size 0.5 --size-at-point 0.1 " + STEEL, "a sharp edge, where faces meet at 90 degrees"),
        ("inverted.msh --point 0.2,0.2,0 --normal 0,0,-1 --errors-unknown " + STEEL, "1 of 1 tetrahedra are inside out or flat"),
        ("wall.msh wall_coarse.msh --point 9,6,0.4 --normal 0,0,1 " + STEEL, "of the volume is only one tetrahedron thick"),
        (f"sphere.geo {BALL} {STEEL}", "size: missing"),
        (f"sphere.geo {BALL} {STEEL} --size 1 --size-at-point 0.5", EDGES_OF_HALF),
        (f"box.geo --point 0.9,0,1 --normal 0,0,1 {STEEL} --size 1 --size-at-point 0.1", BOX_ENDS),
        (f"{MESHES} --point 1,2 --normal 0,0,1 {STEEL}", "--point"),
        (f"{MESHES} {BALL} {STEEL} --modes 0", "modes: got 0"),
        (f"{MESHES} {BALL} --material steel", "'structural steel' (yields at 235 MPa) or 'bearing steel'"),
    ],
)
def test_refusals(modal, meshes, words, said):
    done = modal.run(f"{words} -o refused.json")
    lines = [line for line in done.stderr.splitlines() if "error" in line]
    assert done.returncode == 2, done.stderr
    assert len(lines) == 1, done.stderr
    assert "Traceback" not in done.stderr and not (modal.folder / "refused.json").exists()
    if "coarse at" not in said:
        assert said in lines[0], done.stderr
        return
    edge, other = map(float, re.search(said, lines[0]).groups())
    if "allowed" in said:
        assert other < edge and "ends" not in lines[0]
        assert other == pytest.approx(0.45 / 3, rel=0.05)  # of radii of curvature
    else:
        assert other == pytest.approx(3 * edge, rel=0.01) and "allowed" not in lines[0]


def test_says_what_looks_like_another_unit(modal, meshes):
    modal.gmsh("SetFactory(\"OpenCASCADE\");\nSphere(1) = {0, 0, 0, 20};", "large.msh", 8.0)
    for unit, count in (("", 1), ("--unit m", 0), ("--unit mm", 0)):
        done = modal.run(f"large.msh --point 0,0,21 --normal 0,0,1 {STEEL} {unit} --errors-unknown -o refused.json")
        assert done.stderr.count("if its lengths are in mm, --unit mm") == count, done.stderr


def test_file(small_sphere):
    required = {"format", "name", "mass", "curvature", "young", "poisson", "density"}
    required |= {"compliance", "compliance_error"}
    assert required < set(small_sphere) and small_sphere["format"] == "stoss modal body 1"
    lengths = {len(values) for values in small_sphere["modes"].values()}
    assert len(small_sphere["modes"]) == 5 and len(lengths) == 1
    assert small_sphere["complete_to"] >= small_sphere["modes"]["frequency"][-1]
    assert "loss_time" not in small_sphere


def test_mesh_files_and_units(modal, meshes):
    """A sphere of 1 mm in a unit of the mesh, of steel; modes up to a frequency."""
    words = f"{MESHES} {BALL} --unit mm {STEEL} --up-to 1.45e6 --name ball"
    body = modal.body(words, name="ball.json")
    speed = np.sqrt(body["young"] / body["density"])
    omega = 2 * np.pi * np.array(body["modes"]["frequency"]) * 1e-3 / speed
    moved = np.array(body["modes"]["displacement"]) * np.sqrt(body["mass"])
    assert body["name"] == "ball" and body["complete_to"] <= 1.45e6
    assert omega[moved > 0.1][0] == pytest.approx(1.641, rel=0.02)
    assert moved[moved > 0.1][0] == pytest.approx(1.838, rel=0.02)
    assert body["curvature"] == pytest.approx([1000, 1000], rel=0.05)


def test_goes_on(modal):
    """What an earlier run has solved is not solved again; another question does not take it."""
    part = modal.folder / "whole.json.part"
    whole = modal.body(f"sphere.geo {BALL} {QUICK}", name="whole.json")
    assert not part.exists()
    # A run that cannot write its output leaves what it has solved.
    (modal.folder / "taken.json").mkdir()
    failed = modal.run(f"sphere.geo {BALL} {QUICK} -o taken.json")
    assert failed.returncode == 4 and "taken.json" in failed.stderr
    (modal.folder / "taken.json.part").rename(part)
    again = modal.run(f"sphere.geo {BALL} {QUICK} -o whole.json")
    assert again.returncode == 0 and again.stderr.count("results of an earlier run") == 2
    assert json.loads((modal.folder / "whole.json").read_text()) == whole


@pytest.mark.long
@pytest.mark.skipif(shutil.which("mpirun") is None, reason="mpirun is not installed")
def test_two_processes(modal, small_sphere):
    both = modal.body(SMALL, launcher=("mpirun", "-n", "2"), name="both.json")
    assert both["compliance"] == pytest.approx(small_sphere["compliance"], rel=1e-6)
    for name in ("frequency", "displacement"):
        assert both["modes"][name] == pytest.approx(small_sphere["modes"][name], rel=1e-6, abs=1e-5)


@pytest.mark.parametrize("handler", ["default_int_handler", "SIG_IGN"])
def test_ctrl_c_stays_with_the_program(interpreter, handler):
    code = (
        f"import signal; signal.signal(signal.SIGINT, signal.{handler})\n"
        f"import stoss.modal._run; assert signal.getsignal(signal.SIGINT) is signal.{handler}"
    )
    done = interpreter.run(code)
    assert done.returncode == 0, done.stderr
