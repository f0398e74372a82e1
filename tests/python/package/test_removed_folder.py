"""Every writer of the package in a folder that has been removed: OSError at once, and no file."""

import os
import resource

import pytest

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
