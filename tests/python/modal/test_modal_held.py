"""Bodies in clamps and on springs, and with a mass on a surface, against beams and rods in closed form."""

import math

import numpy as np
import pytest
import stoss
from conftest import UNITS
from scipy.optimize import brentq

LENGTH, WIDTH, HEIGHT = 12.0, 1.2, 1.0
BAR = f"""SetFactory("OpenCASCADE");
Box(1) = {{0, {-WIDTH / 2}, {-HEIGHT / 2}, {LENGTH}, {WIDTH}, {HEIGHT}}};
Physical Surface("root") = {{1}};
Physical Surface("tip") = {{2}};
Physical Volume("bar") = {{1}};
"""
MASS, POISSON = LENGTH * WIDTH * HEIGHT, 0.0  # of which a clamp holds nothing else
PLACE = 9.0
ABOVE = f"--point {PLACE},0,{HEIGHT / 2} --normal 0,0,1"
AT_TIP = f"--point {LENGTH},0,0 --normal 1,0,0"
COMMON = f"bar.geo --size 0.8 --size-at-point 0.14 {UNITS} --poisson {POISSON} --errors-unknown"


@pytest.fixture(scope="module")
def held(modal):
    """Runs it on one mesh, with so many modes."""
    (modal.folder / "bar.geo").write_text(BAR)

    def made(words, modes=6):
        return modal.body(f"{COMMON} --modes {modes} {words}", name="held.json")

    return made


@pytest.fixture(scope="module")
def cantilever(held):
    return held(f"{ABOVE} --clamp root")


def omega(body, least=0.0):
    """Angular frequencies of modes that move the point, by their shares of a rigid body's displacement."""
    f, moved = (np.array(body["modes"][name]) for name in ("frequency", "displacement"))
    return 2 * math.pi * f[np.abs(moved) * math.sqrt(MASS) > least]


def left(body):
    """What the modes leave of the compliance."""
    f, moved = (np.array(body["modes"][name]) for name in ("frequency", "displacement"))
    return body["compliance"] - np.sum((moved / (2 * math.pi * f)) ** 2)


def timoshenko():
    """The lowest ω of a cantilever with E = ρ = 1: y = ψ = 0 at its root, ψ′ = y′ − ψ = 0 at its tip."""
    s, i = 10 * (1 + POISSON) / (12 + 11 * POISSON) / (2 * (1 + POISSON)), HEIGHT**2 / 12

    def determinant(w):
        squares = np.roots([s, -(w**2) * (1 + s), w**4 - w**2 * s / i]).astype(complex)
        k = np.concatenate([np.sqrt(squares), -np.sqrt(squares)])
        psi = (w**2 - s * k**2) / (1j * k * s)
        end = np.exp(1j * k * LENGTH)
        value = np.linalg.det([np.ones(4), psi, 1j * k * psi * end, (1j * k - psi) * end])
        return value.real + value.imag

    grid = np.linspace(1e-4, 0.1, 2000)
    signs = np.sign([determinant(w) for w in grid])
    place = np.flatnonzero(signs[1:] * signs[:-1] < 0)[:2]
    return [brentq(determinant, grid[at], grid[at + 1]) for at in place]


def test_cantilever(cantilever):
    expected = timoshenko()
    euler = 1.8751**2 / LENGTH**2 * HEIGHT / math.sqrt(12)
    assert expected[0] == pytest.approx(euler, rel=0.02)
    assert omega(cantilever, 0.05)[:2] == pytest.approx(expected, rel=0.01)
    assert cantilever["held"] and "rotation" not in cantilever
    assert cantilever["mass"] == pytest.approx(MASS)


def test_static_compliance_of_a_cantilever(cantilever):
    """s³/3EI + s/κGA, and a local share of about one."""
    second = WIDTH * HEIGHT**3 / 12
    shear = 10 * (1 + POISSON) / (12 + 11 * POISSON) / (2 * (1 + POISSON)) * WIDTH * HEIGHT
    expected = PLACE**3 / 3 / second + PLACE / shear
    assert cantilever["compliance"] == pytest.approx(expected, rel=5e-3)
    assert 0.5 < left(cantilever) < 3.0


def test_a_heavy_ball_meets_a_spring(cantilever):
    """In touch for π √(mc₀), half a period on the static compliance of the cantilever."""
    body = stoss.ModalBody.from_dict(cantilever)
    ball = stoss.Sphere(radius=1.0, material=stoss.Material(young=1.0, poisson=0.3, density=1000.0), loss_time=0)
    hit = stoss.impact(ball, against=body, speed=1e-3)
    expected = math.pi * math.sqrt(4 / 3 * math.pi * 1000.0 * body.compliance)
    assert hit.contact_time_si == pytest.approx(expected, rel=0.01)
    assert hit.restitution > 0.95


def test_stiff_springs_are_a_clamp(held, cantilever):
    stiff = held(f"{ABOVE} --spring root=1e4N/m3")
    assert omega(stiff) == pytest.approx(omega(cantilever), rel=1e-3)
    assert left(stiff) == pytest.approx(left(cantilever), rel=1e-3)


def test_soft_springs_are_nothing(held):
    """Elastic modes of the free body; along the axis it swings as a mass on a spring of its own stiffness."""
    free, soft = held(AT_TIP), held(f"{AT_TIP} --spring root=1e-5N/m", 12)
    swings = omega(soft, 0.9)[0]
    assert swings == pytest.approx(math.sqrt(1e-5 / MASS), rel=1e-3)
    found = omega(soft)
    assert found[found > 0.03][:5] == pytest.approx(omega(free)[:5], rel=2e-3)
    assert soft["compliance"] == pytest.approx(1e5, rel=1e-3)


def test_rod_with_a_mass(held):
    """Along a rod with a mass at its far end: tan kL = −(M/m) kL."""
    ratio = 0.5
    body = held(f"{AT_TIP} --extra-mass root={ratio * MASS}", 10)
    expected = brentq(lambda x: math.tan(x) + ratio * x, math.pi / 2 + 1e-6, math.pi) / LENGTH
    assert omega(body, 0.5)[0] == pytest.approx(expected, rel=3e-3)
    assert body["mass"] == pytest.approx((1 + ratio) * MASS)
    centre = (LENGTH / 2) / (1 + ratio)
    assert body["rotation"]["point"][0] == pytest.approx(LENGTH - centre)


@pytest.mark.parametrize(
    "words, said",
    [
        (f"{ABOVE} --clamp grip", "surface: got 'grip', allowed 'root', 'tip'"),
        (f"{AT_TIP} --clamp tip", "point: it lies on 'tip', or beside it: tip clamped"),
        (f"{ABOVE} --spring root=1,0N/m", "held: the body can still move as a whole in 3 ways"),
        (f"{ABOVE} --spring root=1", "spring: got 'root=1', allowed SURFACE=KN[,KT]UNIT"),
        (f"{ABOVE} --spring root=0N/m", "finite stiffnesses of 0 or more, one above 0"),
        (f"{ABOVE} --extra-mass root=-1", "extra-mass: got 'root=-1', allowed SURFACE=KG"),
        (f"{ABOVE} --clamp root --spring root=1N/m", "root: it is held twice"),
        (f"{ABOVE} --clamp root --extra-mass root=1", "is clamped, so its mass does not count"),
    ],
)  # fmt: skip
def test_refusals(modal, held, words, said):
    done = modal.run(f"{COMMON} --modes 2 {words} -o refused.json")
    assert done.returncode == 2, done.stderr
    assert said in done.stderr and "Traceback" not in done.stderr
