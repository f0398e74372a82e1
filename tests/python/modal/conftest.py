"""What the tests of stoss.modal share: skipped where DOLFINx, SLEPc or Gmsh is not installed."""

import importlib.util
import json
import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

import stoss

NEEDED = ("dolfinx", "slepc4py", "gmsh", "mpi4py")
SPHERE = 'SetFactory("OpenCASCADE");\nSphere(1) = {0, 0, 0, 1};\n'
BALL = "--point 0.6,0,0.8 --normal 0.6,0,0.8"
UNITS = "--young 1 --density 1"
SMALL = f"sphere.geo {BALL} {UNITS} --poisson 0.3 --size 0.4 --size-at-point 0.055 --modes 13"
ENVIRONMENT = {
    **os.environ,
    "PYTHONPATH": os.pathsep.join(
        [str(Path(stoss.__file__).parents[1]), os.environ.get("PYTHONPATH", "")]
    ),
    "OMP_NUM_THREADS": "1",
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
}


def missing():
    return [name for name in NEEDED if importlib.util.find_spec(name) is None]


def pytest_collection_modifyitems(items):
    here = Path(__file__).parent
    for item in items:
        if here in Path(item.fspath).parents:
            item.add_marker("elements")
            if missing():
                item.add_marker(pytest.mark.skip(reason=f"not installed: {', '.join(missing())} (make modal-tools)"))


class Modal:
    """The command, in a folder of its own."""

    def __init__(self, folder):
        self.folder = folder

    def run(self, words, launcher=(), program=("-m", "stoss.modal")):
        """The completed process."""
        command = [*launcher, sys.executable, *program, *shlex.split(words)]
        options = {"capture_output": True, "text": True, "timeout": 500}
        return subprocess.run(command, cwd=self.folder, env=ENVIRONMENT, **options)

    def body(self, words, name="body.json", **options):
        """The file that it writes."""
        done = self.run(f"{words} -o {name}", **options)
        assert done.returncode == 0, done.stderr
        return json.loads((self.folder / name).read_text())

    def gmsh(self, shape, name, size, order=2):
        """A mesh file of a shape, with edges of one size."""
        (self.folder / "shape.geo").write_text(shape + "\n")
        code = (
            "import gmsh; gmsh.initialize(); option = gmsh.option.setNumber\n"
            "option('General.Terminal', 0); gmsh.open('shape.geo')\n"
            f"option('Mesh.MeshSizeMax', {size}); option('Mesh.ElementOrder', {order})\n"
            f"gmsh.model.mesh.generate(3); gmsh.write('{name}'); gmsh.finalize()"
        )
        subprocess.run([sys.executable, "-c", code], cwd=self.folder, check=True, timeout=100)


@pytest.fixture(scope="session")
def modal(tmp_path_factory):
    """The command, in a folder with a sphere of radius 1."""
    folder = tmp_path_factory.mktemp("modal")
    (folder / "sphere.geo").write_text(SPHERE)
    return Modal(folder)


@pytest.fixture(scope="session")
def small_sphere(modal):
    """Its file on a small mesh, in units with R = E = ρ = 1."""
    return modal.body(SMALL)
