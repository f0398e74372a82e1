"""A slender free beam against Timoshenko's frequencies, and where its first mode does not move."""

import math

import numpy as np
import pytest
from conftest import UNITS
from scipy.optimize import brentq

LENGTH, WIDTH, HEIGHT = 20.0, 1.5, 1.0
POISSON = 0.3
BOX = f"{-LENGTH / 2}, {-WIDTH / 2}, {-HEIGHT / 2}, {LENGTH}, {WIDTH}, {HEIGHT}"
BEAM = f'SetFactory("OpenCASCADE");\nBox(1) = {{{BOX}}};\n'


def timoshenko(height, count):
    """ω of a free beam with E = ρ = 1: no moment ψ′ and no shear y′ − ψ at its ends.

    y = Y exp(ikx) and ψ = Ψ exp(ikx) in s(y″ − ψ′) = −ω²y and ψ″ + (s/i)(y′ − ψ) = −ω²ψ with
    s = κG by Cowper and i = height²/12.
    """
    s, i = 10 * (1 + POISSON) / (12 + 11 * POISSON) / (2 * (1 + POISSON)), height**2 / 12

    def determinant(omega):
        squares = np.roots([s, -(omega**2) * (1 + s), omega**4 - omega**2 * s / i]).astype(complex)
        k = np.concatenate([np.sqrt(squares), -np.sqrt(squares)])
        psi = (omega**2 - s * k**2) / (1j * k * s)
        ends = [np.exp(1j * k * x) for x in (-LENGTH / 2, LENGTH / 2)]
        value = np.linalg.det([row * end for end in ends for row in (1j * k * psi, 1j * k - psi)])
        return value.real + value.imag  # one of both is 0

    grid = np.linspace(1e-3, 0.3, 3000)
    signs = np.sign([determinant(omega) for omega in grid])
    places = np.flatnonzero(signs[1:] * signs[:-1] < 0)[:count]
    return np.array([brentq(determinant, grid[place], grid[place + 1]) for place in places])


@pytest.fixture(scope="module")
def struck(modal):
    """The beam struck in its middle, at a node of the first mode, and near its end."""
    (modal.folder / "beam.geo").write_text(BEAM)
    sizes = "--size 0.5 --size-at-point 0.15 --modes 10"  # two tetrahedra thick
    words = f"beam.geo --normal 0,0,1 {UNITS} --poisson {POISSON} {sizes}"
    return {
        x: modal.body(f"{words} --point {x},0,{HEIGHT / 2}", name=f"beam_{x}.json")
        for x in (0.0, 5.52, 9.3)
    }


def bending(body):
    """Angular frequencies and displacements of the modes that move its upper face."""
    f, moved = (np.array(body["modes"][name]) for name in ("frequency", "displacement"))
    return 2 * math.pi * f, moved * math.sqrt(body["mass"])


def test_frequencies(struck):
    expected = timoshenko(HEIGHT, 3)
    euler = np.array([4.73004, 7.85320, 10.99561]) ** 2 / LENGTH**2 * HEIGHT / math.sqrt(12)
    assert expected[0] == pytest.approx(euler[0], rel=0.02)
    omega, moved = bending(struck[9.3])
    assert omega[moved > 0.5][:3] == pytest.approx(expected, rel=1e-2)


@pytest.mark.long
def test_frequencies_on_a_finer_mesh(modal, struck):
    place = f"--point 9.3,0,{HEIGHT / 2} --normal 0,0,1"
    sizes = "--size 0.35 --size-at-point 0.15 --modes 12"
    body = modal.body(f"beam.geo {place} {UNITS} --poisson {POISSON} {sizes}", name="finer.json")
    omega, moved = bending(body)
    assert omega[moved > 0.5][:3] == pytest.approx(timoshenko(HEIGHT, 3), rel=2e-3)


def test_displacements_along_it(struck):
    """Euler's first mode: 2 at the ends, −1.216 in the middle, 0 at 0.224 of the length."""
    lowest = timoshenko(HEIGHT, 1)[0]
    bodies = [bending(body) for body in struck.values()]
    first = [moved[np.argmin(np.abs(omega - lowest))] for omega, moved in bodies]
    assert first[0] == pytest.approx(1.216, rel=0.02)
    assert first[1] < 0.05
    assert first[2] == pytest.approx(2 - 4.65 * 2 * 0.7 / LENGTH, rel=0.02)
    # Odd modes do not move the middle.
    assert np.sum(bodies[0][1] > 0.3) < np.sum(bodies[2][1] > 0.3)


def test_flat_face(struck):
    assert struck[0.0]["curvature"] == [0, 0]
    assert struck[9.3]["rotation"]["point"] == pytest.approx([9.3, 0, HEIGHT / 2], abs=1e-9)
    inertia = np.diag(struck[0.0]["rotation"]["inertia"])
    mass = LENGTH * WIDTH * HEIGHT
    squares = np.array([WIDTH**2 + HEIGHT**2, LENGTH**2 + HEIGHT**2, LENGTH**2 + WIDTH**2])
    assert inertia == pytest.approx(mass / 12 * squares, rel=1e-6)
