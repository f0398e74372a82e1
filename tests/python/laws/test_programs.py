"""The lines that stoss writes for a program, in that program: two balls collide as the law says, and near to stoss."""

import dataclasses
import functools
import shutil
import subprocess

import numpy as np
import pytest

import stoss
import two_balls

pytestmark = pytest.mark.particles
SPEEDS = np.geomspace(1e-3, 0.1, 5)
SLIDING = np.array([0.5, 1.0, 2.0, 3.0, 4.0, 6.0])  # over μv: angles from 3 to 31 degrees
FRICTION = 0.1
# At an angle a law is the limit of little overlap: programs shorten the arm of friction by half of it, and turn the
# normal. At 0.03 m/s balls of steel overlap by 1.3e-4 of the radius, which takes 4e-4 of ε_t.
ANGLED = np.geomspace(1e-3, 0.03, 5)


@functools.cache
def has(program):
    """Whether it is there."""
    header = {"mujoco": "mujoco/mujoco.h", "simbody": "Simbody.h"}.get(program)
    if header is not None:
        find = ["cc", "-include", header, "-I/usr/include/simbody", "-x", "c++", "-E", "/dev/null"]
        return subprocess.run(find, capture_output=True).returncode == 0
    return shutil.which({"lammps": "lmp"}.get(program, program)) is not None


def ball_of(material):
    return stoss.Sphere(radius=5e-3, material=stoss.materials[material])


@functools.cache
def elastic(material):
    return stoss.restitution(ball_of(material), against="same", speed=SPEEDS)


@functools.cache
def at_angles(material):
    given = {"speed": ANGLED[:, None], "tangential": FRICTION * ANGLED[:, None] * SLIDING, "friction": FRICTION}
    return stoss.oblique(ball_of(material), against="same", **given)


def collide(law, program, material, friction, folder, among=SPEEDS):
    """A fit, and ε and ε_t of its program at each of these speeds; ε_t at each sliding."""
    if not has(program):
        pytest.skip(f"needs {program}")
    ball = ball_of(material)
    fit = stoss.fit(ball, against="same", law=law, speed=(SPEEDS[0], SPEEDS[-1]), friction=friction, program=program)
    slidings = np.concatenate([[0.0], SLIDING if friction else []])
    speeds = np.repeat(among, slidings.size)
    along = np.tile(slidings, among.size) * friction * speeds
    pairs = two_balls.Pairs(ball, speeds, along, fit.fitted.contact_time(among))
    found = getattr(two_balls, program)(pairs, fit.lines, folder)
    normal, along = (each.reshape(among.size, slidings.size) for each in found)
    return fit, normal, along[:, 1:]


HEAD_ON = [(law, program) for program in ("lammps", "liggghts") for law in ("linear", "tsuji", "viscoelastic")]
HEAD_ON += [("mujoco", "mujoco"), ("hunt-crossley", "simbody")]
YADE = [pytest.param(law, "yade", marks=pytest.mark.long) for law in ("linear", "tsuji")]


@pytest.mark.parametrize("law, program", [*HEAD_ON, *YADE])
def test_head_on(law, program, tmp_path):
    fit, normal, _ = collide(law, program, "rubber", 0.0, tmp_path)
    expected = fit.fitted.restitution(SPEEDS)
    assert 1 - normal[:, 0] == pytest.approx(1 - expected, rel=1e-3)  # the loss, 0.03 to 0.08
    assert np.abs(normal[:, 0] - elastic("rubber").restitution).max() <= fit.misfit["restitution"].maximum + 1e-4


@pytest.mark.parametrize("law, program", [*HEAD_ON[:-2], *YADE])
def test_at_angles(law, program, tmp_path):
    fit, normal, along = collide(law, program, "structural steel", FRICTION, tmp_path, ANGLED)
    assert normal == pytest.approx(np.repeat(fit.fitted.restitution(ANGLED)[:, None], 7, axis=1), abs=1e-3)
    assert along == pytest.approx(fit.fitted.tangential_restitution(ANGLED, SLIDING), abs=1e-3)
    misfit = fit.misfit["tangential_restitution"].maximum
    assert np.abs(along - at_angles("structural steel").tangential_restitution).max() <= misfit + 1e-3


def test_friction_hardly_acts_in_mujoco(tmp_path):
    """What docs/reference/laws.md says: it brakes sliding with the dashpot of the normal, which almost elastic balls lack."""
    one = SPEEDS[2:3]
    fit, normal, along = collide("mujoco", "mujoco", "structural steel", FRICTION, tmp_path, one)
    assert normal == pytest.approx(fit.fitted.restitution(one)[0], abs=1e-3)
    assert np.all(along < -0.999) and "tangential_restitution" not in fit.misfit


LAWS = {"mujoco": ("mujoco",), "simbody": ("hunt-crossley",)}
SPRINGS = ("linear", "tsuji", "viscoelastic")


@pytest.mark.parametrize("program", ["lammps", "liggghts", "simbody"])
def test_unequal_balls(program, tmp_path):
    """The constants are those of their reduced mass and radius."""
    if not has(program):
        pytest.skip(f"needs {program}")
    stiffer = stoss.Material(young=2e7, poisson=0.3, density=3000)
    ball, second = ball_of("rubber"), stoss.Sphere(radius=8e-3, material=stiffer)
    for law in LAWS.get(program, SPRINGS):
        fit = stoss.fit(ball, against=second, law=law, speed=(1e-3, 0.1), program=program)
        pairs = two_balls.Pairs(ball, SPEEDS[::2], 0 * SPEEDS[::2], fit.fitted.contact_time(SPEEDS[::2]), second)
        normal, _ = getattr(two_balls, program)(pairs, fit.lines, tmp_path)
        assert 1 - normal == pytest.approx(1 - fit.fitted.restitution(SPEEDS[::2]), rel=1e-3)


def test_simbody_combines_two_materials(tmp_path):
    """As docs/reference/laws.md says: moduli by their powers 2/3, the dissipation of the softer one the more."""
    if not has("simbody"):
        pytest.skip("needs simbody")
    ball, young, c = ball_of("rubber"), (3e6, 2e7), (0.3, 1.1)
    names = ("material", "other")
    lines = [f"SimTK::ContactMaterial {name}({e}, {d}, 0, 0, 0);" for name, e, d in zip(names, young, c)]
    first, second = (each ** (2 / 3) for each in young)
    share = second / (first + second)
    modulus, hysteresis = (share * first) ** 1.5, 1.5 * (share * c[0] + (1 - share) * c[1])
    fit = stoss.fit(ball, against="same", law="hunt-crossley", speed=(1e-3, 0.1))
    stiffness = 4 / 3 * np.sqrt(fit.fitted.pair.radius) * modulus
    law = dataclasses.replace(fit.fitted, stiffness=stiffness, damping=hysteresis * stiffness)
    pairs = two_balls.Pairs(ball, SPEEDS, 0 * SPEEDS, law.contact_time(SPEEDS))
    normal, _ = two_balls.simbody(pairs, lines, tmp_path)
    assert 1 - normal == pytest.approx(1 - law.restitution(SPEEDS), rel=2e-3)


@pytest.mark.parametrize("program", ["lammps", "liggghts", "mujoco", "simbody"])
def test_a_wall(program, tmp_path):
    """A ball meets a plane: the reduced mass and radius are its own."""
    if not has(program):
        pytest.skip(f"needs {program}")
    ball = ball_of("rubber")
    for law in LAWS.get(program, SPRINGS):
        fit = stoss.fit(ball, law=law, speed=(1e-3, 0.1), program=program)
        rebound = two_balls.drop(program, ball, 0.05, fit.lines, float(fit.law_contact_time.min()), tmp_path)
        expected = fit.fitted.restitution(np.array([0.05]))[0]
        assert 1 - rebound == pytest.approx(1 - expected, rel=1e-3)
