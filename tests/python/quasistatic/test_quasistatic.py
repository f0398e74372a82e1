"""stoss.quasistatic: the command's numbers bit for bit, shapes, and what is said of the speeds."""

import dataclasses
import re
import warnings
from pathlib import Path

import numpy as np
import pytest
import stoss
from stoss import quasistatic

BALL = stoss.Sphere(poisson=0.3)
HARD = stoss.Sphere(
    radius=0.01, material=stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=1e9)
)
THEORY = Path(__file__).parents[3] / "docs/developer/derivations/points.md"


@pytest.mark.parametrize("body, words, law", [
    (stoss.Disk(poisson=0.33), "disk --poisson 0.33", "center"), (stoss.Disk(poisson=0.33), "disk --poisson 0.33", "diameter"),
    (BALL, "sphere --poisson 0.3", "center"), (BALL, "sphere --poisson 0.3", "hertz"),
])  # fmt: skip
def test_compressions_are_those_of_the_command(command, body, words, law):
    nodes = 160 if isinstance(body, stoss.Disk) else 80
    for record in command(f"quasistatic --body {words} --compression 1e-12,1e-4,0.02 --law {law}")["records"]:
        force = quasistatic.compression_force(body, compression=record["compression"], law=law)
        assert force == record["force"]
        assert quasistatic.compression_energy(body, force=force, law=law) == record["energy"]
        assert quasistatic.compression(body, force=force, law=law) == pytest.approx(record["compression"], rel=1e-7)
        if body is BALL:
            assert quasistatic.contact_radius(body, force=force) == record["contact_radius"]
        contact = quasistatic.static_contact(body, compression=record["compression"], nodes=nodes)
        assert (contact.force, contact.force_error) == (record["static_force"], record["static_force_error"])


def test_stresses_have_their_names():
    """K. L. Johnson, Contact Mechanics: eqs. 4.45 of lines, 3.45 of points."""
    depth, root = np.array([0.05, 0.2]), np.hypot(0.1, np.array([0.05, 0.2]))
    below = quasistatic.hertz_stress(force=0.0025, depth=depth, y=0)
    assert below.xx == pytest.approx(-0.5 * 0.01 / root, rel=1e-13) and not np.any(below.xy)
    assert below.yy == pytest.approx(-0.5 * ((0.01 + 2 * depth**2) / root - 2 * depth), rel=1e-12)
    force = 1e-4
    a = quasistatic.contact_radius(BALL, force=force)
    peak = quasistatic.hertz_pressure(BALL, force=force, y=0.0)
    ball = quasistatic.hertz_stress(BALL, force=force, depth=[0, a], y=0)
    assert ball.axial == pytest.approx([-peak, -peak / 2], rel=1e-7) and not np.any(ball.shear)
    assert ball.radial == pytest.approx(ball.hoop) and ball.radial[1] != pytest.approx(ball.axial[1], rel=0.1)
    greatest = quasistatic.greatest_shear(BALL, force=force)
    assert (greatest.depth / a, greatest.shear / peak) == pytest.approx((0.481, 0.310), abs=5e-4)


def test_shapes_broadcast():
    nus, speeds = np.array([[0.2], [0.5]]), [1e-3, 1e-9, 1e-6]
    for make in (quasistatic.slow_impact, lambda **at: quasistatic.rayleigh(cutoff=6, **at)):
        many = make(poisson=nus, speed=speeds)
        for i, j in np.ndindex(2, 3):
            alone = make(poisson=nus[i, 0], speed=speeds[j])
            for field in dataclasses.fields(alone):
                value = getattr(alone, field.name)
                if field.name not in ("law", "cutoff", "body", "mode_energies", "max_radius", "mean_lost_fraction"):
                    assert type(value) in (float, int, bool) and getattr(many, field.name)[i, j] == value
    assert type(quasistatic.compression(force=0.01, poisson=0.3)) is float
    assert type(quasistatic.greatest_shear(BALL, force=0.01).depth) is float
    assert type(quasistatic.maw(psi1=0.7, chi=0.5).psi2) is float
    assert quasistatic.compression(force=[[0.01]], poisson=[0.3, 0.2]).shape == (1, 2)
    assert quasistatic.hertz_stress(force=[0.01, 0.02], depth=[[0.1]], y=0).xy.shape == (1, 2)
    assert quasistatic.limit_speed(poisson=nus).shape == quasistatic.limit_force(poisson=nus).shape == (2, 1)
    assert quasistatic.maw(psi1=[[0.5], [2.0]], chi=[1.0, 1.2, 1.4]).impulse.shape == (2, 3)
    assert quasistatic.mindlin_traction(tangential=0.3, distance=np.linspace(0, 2, 5)).shape == (5,)


def test_values_beyond_perturbation_are_warned_of():
    with pytest.warns(stoss.StossWarning, match="^1 of 2 values beyond perturbation theory") as caught:
        estimate = quasistatic.rayleigh(poisson=0.33, speed=[0.01, 0.1])
    assert caught[0].filename == __file__ and estimate.beyond_perturbation.tolist() == [False, True]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert quasistatic.rayleigh(poisson=0.33, speed=0.02).beyond_perturbation is False


def test_yield_speed():
    found = quasistatic.yield_speed(HARD)
    slow = quasistatic.slow_impact(BALL, speed=found / HARD.scales.speed, law="hertz")
    assert 2.1e11 * quasistatic.hertz_pressure(BALL, force=slow.max_force, y=0.0) == pytest.approx(1.6e9, rel=1e-12)
    for equal in ("same", HARD, dataclasses.replace(HARD)):
        assert quasistatic.yield_speed(HARD, against=equal) == pytest.approx(2 * found, rel=1e-13)
    glass = stoss.materials["glass"]
    plain, block = stoss.Sphere(radius=0.02, material=glass), stoss.HalfSpace(material=glass)
    rigid = dataclasses.replace(HARD, rigid=True)
    for nobody in ((plain, None), (plain, plain), (rigid, block)):
        assert quasistatic.yield_speed(nobody[0], against=nobody[1]) is None
    assert quasistatic.yield_speed(HARD, against=plain) == quasistatic.yield_speed(plain, against=HARD) > 0
    plate = stoss.Plate(thickness=0.01, material=glass)
    assert quasistatic.yield_speed(HARD, against=plate) == quasistatic.yield_speed(HARD, against=block)


def test_the_table_of_the_theory():
    rows = re.findall(r"^\| ([\d.]+) \| (1\.\d{4}) \| (.*) \|$", THEORY.read_text(encoding="utf-8"), re.MULTILINE)
    assert len(rows) == 4
    for poisson, chi, psi2 in rows:
        exact = 1.75 * quasistatic.mindlin_ratio(poisson=float(poisson))
        assert float(chi) == pytest.approx(exact, abs=5e-5)
        given = [float(each.replace("−", "-")) for each in psi2.split(" | ")]
        made = quasistatic.maw(psi1=[0.5, 1, 2, 3, 4, 5, 6], chi=exact, tolerance=1e-6).psi2
        assert given == pytest.approx(made.tolist(), abs=6e-5)
