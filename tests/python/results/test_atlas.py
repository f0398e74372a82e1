"""The atlas against direct values at random places."""

import time

import numpy as np
import pytest

import stoss

PLACES = {
    "spheres at a wall": (stoss.Sphere, None, (0.0, 0.48)),
    "spheres on a block": (stoss.Sphere, stoss.HalfSpace(), (0.0, 0.48)),
    "pairs of spheres": (stoss.Sphere, "ratio", (0.0, 0.48)),
    "disks at a wall": (stoss.Disk, None, (0.0, 0.9)),
    "disks on a block": (stoss.Disk, stoss.HalfPlane(), (0.0, 0.9)),
    "pairs of disks": (stoss.Disk, "ratio", (0.0, 0.9)),
}


@pytest.fixture(scope="module")
def deviations():
    """|atlas − direct| over the stated error at 50 random places of each kind; the direct error is
    far smaller."""
    dice, found = np.random.default_rng(4), {}
    for name, (kind, against, poissons) in PLACES.items():
        found[name] = []
        for _ in range(50):
            body = kind(poisson=dice.uniform(*poissons))
            met = kind(poisson=body.poisson, radius=np.exp(dice.uniform(0, np.log(10)))) if against == "ratio" else against
            speed = np.exp(dice.uniform(np.log(1e-4), np.log(0.3)))
            value = stoss.atlas(body, against=met, speed=speed)
            direct = stoss.restitution(body, against=met, speed=speed, tolerance=3e-4, absolute=3e-6)
            allowed = value.restitution_error + direct.restitution_error
            found[name].append(abs(value.restitution - direct.restitution) / allowed)
    return found


@pytest.mark.parametrize("name", PLACES)
def test_errors_are_honest(deviations, name):
    assert max(deviations[name]) <= 3.0


def test_errors_hold_in_95_of_100_places(deviations):
    everywhere = np.concatenate(list(deviations.values()))
    assert everywhere.size == 300 and np.mean(everywhere <= 1.0) >= 0.95


def test_errors_are_of_use():
    """Known to a percent of a percent at a wall where spheres are slow, and to a few percent
    anywhere."""
    speeds = np.geomspace(1e-4, 0.3, 200)
    for kind, against, poissons in PLACES.values():
        for poisson in np.linspace(*poissons, 7):
            body = kind(poisson=poisson)
            met = kind(poisson=poisson, radius=2.5) if against == "ratio" else against
            assert stoss.atlas(body, against=met, speed=speeds).restitution_error.max() < 0.05


def test_who_is_first_does_not_matter_nor_size_nor_units():
    small, large = stoss.Disk(poisson=0.3), stoss.Disk(poisson=0.3, radius=2.5)
    speeds = [0.001, 0.1]
    one, other = (stoss.atlas(a, against=b, speed=speeds) for a, b in ((small, large), (large, small)))
    assert np.array_equal(one.restitution, other.restitution)
    steel = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
    ball = stoss.Sphere(radius=0.01, material=steel)
    c = ball.scales.speed
    si = stoss.atlas(ball, against=stoss.HalfSpace(material=steel), speed=0.01 * c)
    assert si.restitution == pytest.approx(
        stoss.atlas(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.01).restitution, rel=1e-12
    )
    assert np.shape(stoss.atlas(poisson=0.3, speed=[[0.1], [0.2]]).restitution) == (2, 1)
    # Two equal bodies are one at a wall at half the speed.
    pair, wall = (stoss.atlas(small, against=met, speed=speed) for met, speed in (("same", 0.02), (None, 0.01)))
    assert abs(pair.restitution - wall.restitution) <= pair.restitution_error + wall.restitution_error


def test_many_values_are_those_of_a_few():
    """They are computed in blocks, between which Ctrl-C is heeded."""
    body, speeds = stoss.Disk(poisson=0.31), np.geomspace(1e-4, 0.3, 70_000)
    all_at_once = stoss.atlas(body, speed=speeds)
    for part in (slice(0, 9), slice(65_530, 65_540), slice(69_990, None)):
        alone = stoss.atlas(body, speed=speeds[part])
        assert np.array_equal(alone.restitution, all_at_once.restitution[part])
        assert np.array_equal(alone.restitution_error, all_at_once.restitution_error[part])
    assert stoss.atlas(body, speed=[]).restitution.shape == (0,)


def test_it_is_instant():
    body = stoss.Sphere(poisson=0.31)
    stoss.atlas(body, speed=0.1)
    begin = time.process_time()
    stoss.atlas(body, speed=np.geomspace(1e-4, 0.3, 10_000))
    assert time.process_time() - begin < 1.0
