"""What an impact holds agrees with itself: ledger, trajectory, field, and a copy."""

import pickle

import numpy as np
import pytest

import stoss

integral = getattr(np, "trapezoid", None) or np.trapz


def test_energy_ledger(hit):
    soft = stoss.impact(poisson=0.33, speed=0.1, cutoff=12, against=stoss.ExponentialWall())
    for each in (hit, soft, stoss.impact(stoss.Rod(), speed=0.2, cutoff=200)):
        total = each.translation + each.vibration + each.unresolved
        assert total == pytest.approx(1 - each.energy_error, abs=1e-12)
        assert abs(each.energy_error) < 2e-3
        assert abs(each.momentum_error) < 1e-12
        assert each.mode_energies["after"].sum() == pytest.approx(each.vibration, abs=1e-12)
        assert each.translation == pytest.approx(each.restitution**2, abs=1e-12)
        assert each.lost_fraction == pytest.approx(1 - each.restitution**2, abs=1e-12)
        assert len(each.mode_energies) == each.modes


def test_trajectory_is_the_impact(hit):
    path = hit.trajectory()
    assert len(path) == hit.steps + 1
    # It starts less than a step in front of the contact grid's first touch.
    assert (path.time[0], path.velocity[0]) == (0, hit.speed)
    assert -1 - 2 * hit.step * hit.speed < path.center[0] < -1
    assert path.time[-1] == pytest.approx(hit.steps * hit.step, rel=1e-14)
    assert path.velocity[-1] == pytest.approx(-hit.restitution * hit.speed, rel=1e-14)
    assert (path.vibration[-1], path.unresolved[-1]) == pytest.approx((hit.vibration, hit.unresolved), abs=1e-14)
    # Compression counts from the touch of the continuous surface, a part of the spacing of the nodes before.
    spacing = hit.half_width / hit.nodes
    assert 0 < hit.max_compression - (1 + path.center.max()) < spacing**2 / 20
    assert path.force.max() == pytest.approx(hit.max_force, rel=1e-3)
    assert path.contact_half_width.max() == pytest.approx(hit.max_half_width, rel=1e-3)
    touching = path.time[path.force > 0]
    assert np.ptp(touching) == pytest.approx(hit.contact_time, abs=2 * hit.step)
    # Force is m dv/dt, and m is 1 in these units.
    assert integral(path.force, path.time) == pytest.approx(hit.speed * (1 + hit.restitution), rel=2e-3)
    some = hit.trajectory(every=7)
    assert some.time[:-1].tolist() == path.time[::7][: len(some) - 1].tolist() and some.time[-1] == path.time[-1]


def test_field_is_that_of_the_impact(hit):
    radius, weight = (0.5 * (x + y) for x, y in zip(np.polynomial.legendre.leggauss(40), (1, 0)))
    angle = np.linspace(-np.pi, np.pi, 361)[:-1]
    field = hit.field(time=[[3.0, 1.0], [0.2, 5.0]], radius=radius, angle=angle)
    assert field.x.shape == (2, 2, 40, 360) and field.force.shape == (2, 2)
    assert field.time == pytest.approx(np.array([[3.0, 1.0], [0.2, 5.0]]), abs=hit.step / 2 + 1e-12)
    # Nothing is beyond the wall, and the centre of mass is the mean position.
    assert hit.field(time=np.linspace(0, 7, 15)).x.max() < 1e-3
    mean = (field.x * (radius * weight)[:, None]).sum((-1, -2)) * 2 / angle.size
    assert mean == pytest.approx(field.center, abs=1e-12)
    assert (field.y * (radius * weight)[:, None]).sum((-1, -2)) == pytest.approx(np.zeros((2, 2)), abs=1e-12)
    # Each instant is that of the trajectory, and alone it is the same.
    path = hit.trajectory()
    for at in np.ndindex(2, 2):
        k = np.argmin(abs(path.time - field.time[at]))
        assert (path.time[k], path.center[k], path.force[k]) == (field.time[at], field.center[at], field.force[at])
        alone = hit.field(time=field.time[at], radius=radius, angle=angle)
        assert isinstance(alone.center, float) and alone.center == field.center[at]
        assert np.array_equal(alone.x, field.x[at]) and np.array_equal(alone.stress_rr, field.stress_rr[at])


def test_field_is_elasticity(hit):
    field = hit.field(time=2.9)
    rr, pp, rp = field.stress_rr, field.stress_pp, field.stress_rp
    assert field.von_mises == pytest.approx(np.sqrt(rr**2 - rr * pp + pp**2 + 3 * rp**2), abs=1e-14)
    assert field.principal_difference == pytest.approx(np.hypot(rr - pp, 2 * rp), abs=1e-14)
    # The pressure on the edge is the force of the wall, and the rest of the edge is free.
    near = hit.field(time=2.9, radius=1, angle=np.linspace(-0.6, 0.6, 2001))
    assert integral(-near.stress_rr[0], near.angle) / np.pi == pytest.approx(near.force, rel=0.1)
    free = hit.field(time=2.9, radius=1, angle=np.linspace(0.7, np.pi, 50))
    assert abs(free.stress_rr).max() < 0.01 * abs(near.stress_rr).max()
    # Before, the disk flies as it was made.
    before = hit.field(time=-2, radius=[0, 0.5, 1], angle=[0, 1, 2])
    start = hit.trajectory().center[0]
    assert before.x == pytest.approx(start - 2 * hit.speed + np.outer([0, 0.5, 1], np.cos([0, 1, 2])), abs=1e-14)
    assert before.von_mises.max() == 0 and before.force == 0


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_impact_survives_pickle(protocol):
    for body in (stoss.Disk(poisson=0.33), stoss.Rod()):
        hit = stoss.impact(body, speed=0.1, cutoff=7)
        again = pickle.loads(pickle.dumps(hit, protocol))
        assert again.to_dict() == hit.to_dict()
        assert again.trajectory().force.tolist() == hit.trajectory().force.tolist()
