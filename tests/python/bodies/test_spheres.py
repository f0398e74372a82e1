"""Spheres: values against other programs, units, SI, pairs, what is inside, and refusals."""

import json
import math
import pickle

import numpy as np
import pytest

import stoss

BALL = stoss.Sphere(poisson=0.3)
MASS = 4 * math.pi / 3  # ρR³
STEEL = stoss.materials["structural steel"]


@pytest.fixture(scope="module")
def bounce():
    return stoss.impact(BALL, speed=0.1, cutoff=25)


@pytest.fixture(scope="module")
def uneven():
    return stoss.impact(BALL, against=stoss.Sphere(poisson=0.2, radius=2, young=3, density=0.7), speed=0.1, cutoff=25)


def test_absolute_is_the_companion_of_tolerance():
    coarse, fine = (stoss.restitution(BALL, speed=1e-3, absolute=each) for each in (1e-4, 0.0))
    assert (coarse.absolute, fine.absolute, stoss.restitution(BALL, speed=0.1).absolute) == (1e-4, 0.0, 1e-6)
    assert coarse.converged and coarse.lost_fraction_error <= 1e-4 and coarse.cutoff < fine.cutoff
    assert fine.lost_fraction_error <= 1e-3 * fine.lost_fraction
    assert fine.to_dict()["absolute"] == 0.0 and "absolute" in fine._inputs()
    for bad in (-1e-9, 0.6, math.nan, "small"):
        with pytest.raises(stoss.InvalidInput, match="^absolute: got .*allowed .*$"):
            stoss.restitution(BALL, speed=0.1, absolute=bad)


def test_units_are_those_of_a_sphere(bounce, tmp_path):
    for result in (bounce, bounce.trajectory(every=50), stoss.restitution(BALL, speed=0.1)):
        result.to_csv(tmp_path / "result.csv")
        head = next(line for line in (tmp_path / "result.csv").read_text().splitlines() if line[0] != "#").split(",")
        assert {"max_force[mc^2/R]", "force[mc^2/R]"} & set(head), head
        assert json.loads(json.dumps(result.to_dict()))
    impulse = np.trapezoid if hasattr(np, "trapezoid") else np.trapz
    path = bounce.trajectory()
    assert impulse(path.force, path.time) == pytest.approx(0.1 * (1 + bounce.restitution), rel=1e-3)  # in mc


def test_pairs(uneven):
    equal = stoss.restitution(BALL, against="same", speed=0.2)
    assert equal.restitution == stoss.restitution(BALL, against=BALL, speed=0.2).restitution
    wall = stoss.restitution(BALL, speed=0.1)
    assert abs(equal.lost_fraction - wall.lost_fraction) <= equal.lost_fraction_error + wall.lost_fraction_error
    assert equal.lost_to_first == pytest.approx(equal.lost_to_second, rel=1e-6)
    assert uneven.lost_to_first + uneven.lost_to_second == pytest.approx(uneven.lost_fraction, abs=2e-3)
    assert "against Sphere(poisson=0.2, radius=2, young=3, density=0.7)" in repr(uneven)


def test_the_order_of_two_spheres_does_not_matter():
    small = stoss.Sphere(radius=5e-3, material=STEEL)
    large = stoss.Sphere(radius=8e-3, material=stoss.materials["glass"])
    one, other = (stoss.restitution(a, against=b, speed=20.0) for a, b in ((small, large), (large, small)))
    assert abs(one.lost_fraction - other.lost_fraction) <= one.lost_fraction_error + other.lost_fraction_error
    assert one.max_force_si == pytest.approx(other.max_force_si, rel=5e-3)
    assert one.contact_time_si == pytest.approx(other.contact_time_si, rel=2e-2)
    assert one.lost_to_first == pytest.approx(other.lost_to_second, rel=2e-2)


def test_field_at_a_wall(bounce):
    angle = np.linspace(-np.pi, np.pi, 121)
    field = bounce.field(time=bounce.contact_time / 2, angle=angle)
    assert isinstance(field, stoss.SphereField) and isinstance(field, stoss.Field)
    assert field.x.max() < 1e-3  # nothing is beyond the wall
    for values, sign in ((field.x, 1), (field.y, -1), (field.stress_tt, 1), (field.stress_rt, -1)):
        assert values == pytest.approx(sign * values[:, ::-1], abs=1e-12)
    # No traction away from the contact; on the axis no direction across it is special.
    free = np.abs(angle) > 3 * np.arcsin(field.contact_half_width)
    peak = np.abs(field.stress_rr).max()
    assert np.abs(field.stress_rr[-1, free]).max() < 5e-3 * peak
    assert np.abs(field.stress_rt[-1, free]).max() < 5e-3 * peak
    on_axis = np.abs(angle) < 1e-12
    assert field.stress_tt[:, on_axis] == pytest.approx(field.stress_pp[:, on_axis], abs=1e-9)
    difference = np.hypot(field.stress_rr - field.stress_tt, 2 * field.stress_rt)
    assert field.principal_difference == pytest.approx(difference, abs=1e-14)
    assert field.plot() is not None


def pull(field, scale):
    """Force on the surface of a sphere along its axis, in E R² of the first: −∮ (σ_rr cos θ − σ_rθ sin θ) dA."""
    angle = field.angle
    density = (field.stress_rr[-1] * np.cos(angle) - field.stress_rt[-1] * np.sin(angle)) * np.sin(angle)
    total = np.sum(0.5 * (density[1:] + density[:-1]) * np.diff(angle))
    return -2 * math.pi * scale**2 * total


def test_both_spheres_feel_the_force_of_the_contact(uneven):
    angle = np.concatenate((np.linspace(0, 0.8, 4001), np.linspace(0.8, np.pi, 400)[1:]))
    time = 0.4 * uneven.contact_time
    for of, scale in ((0, 1.0), (1, 2.0)):
        field = uneven.field(time=time, angle=angle, radius=[0.0, 1.0], of=of)
        assert field.size == scale
        assert pull(field, scale) == pytest.approx(field.force * MASS, rel=0.01)


def test_energies_and_trajectory(bounce):
    energies = bounce.energies_at(time=[0.0, bounce.contact_time + 1.0])["energy"]
    assert energies.shape == (2, bounce.modes) and energies[0] == pytest.approx(0.0, abs=1e-12)
    assert energies[1] == pytest.approx(bounce.mode_energies["after"], abs=1e-12)
    path = bounce.trajectory()
    total = path.translation + path.vibration + path.stored + path.unresolved
    assert total == pytest.approx(1.0, abs=2e-3)


def test_copies_are_the_same(bounce, uneven):
    ball = stoss.Sphere(radius=5e-3, material=STEEL)
    assert pickle.loads(pickle.dumps(ball)) == ball and hash(ball) == hash(eval(repr(ball), vars(stoss)))
    for hit in (bounce, uneven):
        again = pickle.loads(pickle.dumps(hit))
        assert again.restitution == hit.restitution and again.steps == hit.steps
    modes = pickle.loads(pickle.dumps(stoss.modes(BALL, cutoff=5)))
    assert modes.body == BALL and "Sphere(poisson=0.3)" in repr(modes)


@pytest.mark.parametrize(
    "make, said",
    [
        (lambda: stoss.Sphere(), "poisson: missing"),
        (lambda: stoss.Sphere(poisson=0.5), "poisson: got 0.5, allowed"),
        (lambda: stoss.Sphere(poisson=-0.96), "poisson: got -0.96, allowed"),
        (lambda: stoss.Sphere(poisson=0.3, radius=0), "radius: got 0, allowed"),
        (lambda: stoss.Sphere(material=STEEL), "radius: missing"),
        (lambda: stoss.Sphere(poisson=0.2, material=STEEL, radius=1), "poisson: got 0.2, allowed none"),
        (lambda: stoss.restitution(BALL, against=stoss.Disk(poisson=0.3), speed=0.1), "against: got .* a sphere sph"),
        (lambda: stoss.restitution(BALL, against=stoss.Sphere(radius=1, material=STEEL), speed=0.1), "against: got"),
        (lambda: stoss.restitution(BALL, speed=2), "speed: got 2, allowed"),
        (lambda: stoss.modes(BALL, cutoff=1001), "cutoff: got 1001, allowed"),
        (lambda: stoss.Material(young=1, poisson=0, density=1, yield_strength=-1), "yield_strength: got -1"),
    ],
)
def test_refusals_are_one_line(make, said):
    with pytest.raises(stoss.InvalidInput, match=f"^{said}") as caught:
        make()
    assert "\n" not in str(caught.value)


def test_frozen_and_without_a_plane():
    with pytest.raises(AttributeError):
        BALL.poisson = 0.2
    with pytest.raises(TypeError):
        stoss.Sphere(poisson=0.3, plane="stress")
    with pytest.raises(AttributeError, match="no material"):
        _ = BALL.scales
    assert stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=2e9).yield_strength == 2e9


def test_pictures_name_degrees_and_units(bounce, uneven, closed, tmp_path):
    modes = stoss.modes(BALL, cutoff=10)
    assert stoss.plot.ledger(bounce).get_xlabel() == "degree n" == stoss.plot.spectrum(modes).get_xlabel()
    assert stoss.plot.force(bounce.trajectory()).get_ylabel() == "force F / (mc²/R)"
    assert stoss.plot.half_width(bounce.trajectory()).get_ylabel() == "contact radius / R"
    points = {"radius": np.linspace(0, 1, 9), "angle": np.linspace(-np.pi, np.pi, 33)}
    field = uneven.field(time=uneven.contact_time / 2, **points)
    for quantity in ("von_mises", "principal_difference", "fringes"):
        assert len(stoss.plot.stress(field, quantity=quantity).collections) == 2  # of both
    assert stoss.plot.sphere(field).get_xlabel() == "x / R"
    assert len(stoss.plot.sequence(bounce, count=3).texts) == 3
    stoss.animate(bounce, tmp_path / "ball.gif", frames=3)
    assert (tmp_path / "ball.gif").stat().st_size > 1000
    assert stoss.plot.restitution(stoss.restitution(BALL, speed=[0.1, 0.2])).get_legend() is not None


def test_shape_of_a_mode_is_that_of_its_polynomial(closed):
    modes = stoss.modes(BALL, cutoff=3)
    ax = stoss.plot.mode_shape(modes, order=2, index=0, amplitude=0.1)
    x, y = ax.collections[0].get_segments()[5].T  # the surface, from −π to π
    front, side, between = 96, 144, 120  # 0, π/2, π/4
    k = modes.find(2, 0)
    ratio = modes.tangential[k] / modes.radial[k]
    moved = x[front] - 1.0
    assert abs(moved) > 0.05
    assert y[side] - 1.0 == pytest.approx(-0.5 * moved, rel=1e-9)  # P_2(0)
    half = math.sqrt(0.5)
    assert half * (x[between] + y[between]) - 1.0 == pytest.approx(0.25 * moved, rel=1e-9)  # P_2(cos π/4)
    assert half * (y[between] - x[between]) == pytest.approx(-1.5 * ratio * moved, rel=1e-9)  # its derivative
