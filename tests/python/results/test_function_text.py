"""A function of the speed as a header in C and as two columns."""

import ctypes
import math
import shutil
import subprocess

import numpy as np
import pytest

import stoss


@pytest.fixture(scope="module")
def disk():
    return stoss.restitution_function(poisson=0.33, speed=(1e-3, 0.3), beyond="clamp")


@pytest.fixture(scope="module")
def steel():
    ball = stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"])
    return stoss.restitution_function(ball, against="same", speed=(0.01, 0.5))


def loaded(folder, name="stoss"):
    """The function of a header, and its error, as a shared library has them."""
    if shutil.which("cc") is None:
        pytest.skip("needs cc")
    words = f'#include "{name}.h"\n'
    for function in ("restitution", "restitution_error"):
        words += f"double {function}(double v) {{ return {name}_{function}(v); }}\n"
    (folder / "shared.c").write_text(words)
    command = "cc -std=c89 -pedantic -Wall -Wextra -Wconversion -Werror -shared -fPIC shared.c -o shared.so -lm"
    subprocess.run(command.split(), cwd=folder, check=True, timeout=60)
    library = ctypes.CDLL(str(folder / "shared.so"))
    for function in (library.restitution, library.restitution_error):
        function.restype, function.argtypes = ctypes.c_double, [ctypes.c_double]
    return library.restitution, library.restitution_error


def test_header_is_the_function(disk, tmp_path):
    disk.to_c(tmp_path / "stoss.h")
    value, error = loaded(tmp_path)
    for speed in np.append(np.geomspace(*disk.range, 300), -0.1):
        assert value(speed) == pytest.approx(disk(speed), abs=1e-14) and error(speed) == disk.error(speed)
    assert value(1e-9) == disk(1e-9) and error(1e-9) == math.inf == disk.error(1e-9)


def test_header_has_the_unit_of_the_function(steel, tmp_path):
    steel.to_c(str(tmp_path / "ball.h"), name="ball")
    value, error = loaded(tmp_path, "ball")
    for speed in np.geomspace(0.0101, 0.499, 50):
        assert value(speed) == pytest.approx(steel(speed), abs=1e-14)
    assert math.isnan(value(0.6)) and error(0.6) == math.inf
    text = (tmp_path / "ball.h").read_text()
    assert "in m/s; its sign" in text and f"stoss {stoss.__version__}: function" in text and "radius=0.005" in text


def test_columns_are_as_accurate_as_asked_for(steel, tmp_path):
    for error in (None, 5e-3):
        steel.to_two_column(tmp_path / "ball.txt", error=error)
        speed, restitution = np.loadtxt(tmp_path / "ball.txt").T
        at = np.geomspace(0.0101, 0.499, 500)
        distance = np.abs(np.interp(at, speed, restitution) - steel(at))
        assert np.all(distance + steel.error(at) <= (error or 2 * steel.greatest_error))


def test_refusals(disk, tmp_path):
    with pytest.raises(stoss.InvalidInput, match="name: got '1x', allowed"):
        disk.to_c(tmp_path / "x.h", name="1x")
    with pytest.raises((stoss.InvalidInput, TypeError), match="name"):
        disk.to_c(tmp_path / "x.h", name=3)
    with pytest.raises(stoss.InvalidInput, match="error: got 1e-09, allowed"):
        disk.to_two_column(tmp_path / "x.txt", error=1e-9)
    law = stoss.restitution_function(poisson=0.33, speed=(1e-3, 0.3), beyond="law")
    with pytest.raises(stoss.InvalidInput, match="beyond: got law, allowed error or clamp"):
        law.to_c(tmp_path / "x.h")
    with pytest.raises(OSError):
        disk.to_c(tmp_path / "no" / "x.h")
    assert not list(tmp_path.iterdir())
