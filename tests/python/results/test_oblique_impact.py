"""One oblique impact: its ledger, and its course in time, obey what oblique impacts obey."""

import copy
import json
import pickle

import numpy as np
import pytest
import stoss

BALL, PLATE = stoss.Sphere(poisson=0.3), stoss.Disk(poisson=0.33)
STEEL = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
SHOT = stoss.Sphere(radius=0.01, material=STEEL)
CASES = {
    "ball": (BALL, {"tangential": 0.02, "friction": 0.3}),
    "balls": (BALL, {"angle": 40, "spin": 0.02, "second_spin": 0.03, "friction": 0.2, "against": stoss.Sphere(
        poisson=0.2, radius=2)}),
    "block": (BALL, {"angle": 30, "friction": 0.2, "against": stoss.HalfSpace(), "cutoff": 8}),
    "disk": (PLATE, {"angle": -20, "friction": 0.3, "cutoff": 12.5}),
    "disks": (PLATE, {"angle": 20, "spin": 0.01, "friction": 0.3, "cutoff": 12.5, "against": stoss.Disk(
        poisson=0.1, radius=2)}),
    "smooth": (PLATE, {"angle": 20, "friction": 0.0, "cutoff": 12.5}),
}  # fmt: skip


@pytest.fixture(scope="module", params=CASES, ids=list(CASES))
def hit(request):
    body, given = CASES[request.param]
    return stoss.oblique_impact(body, **{"speed": 0.05, "cutoff": 20} | given)


@pytest.fixture(scope="module")
def path(hit):
    return hit.trajectory()


def test_shapes(hit, path):
    rows = hit.steps + 1
    points = hit.nodes * (1 if isinstance(hit.body, stoss.Sphere) else 2)
    assert len(path) == rows == path.shift.size and path.touching.dtype.kind == "i"
    for name in ("point_pressure", "point_friction", "slip", "grip"):
        assert getattr(path, name).shape == (rows, points)
    assert path.place.shape == path.measure.shape == (points,) and (np.diff(path.place) > 0).all()
    assert path.grip.dtype == np.int8 and set(np.unique(path.grip)) <= {-1, 0, 1, 2}
    pair = isinstance(hit.against, (stoss.Sphere, stoss.Disk))
    assert path.x.shape == (rows,) and np.shape(path.second_x) == ((rows,) if pair else ())


def test_it_begins_and_ends_as_the_impact(hit, path):
    assert (path.velocity[0], path.tangential[0]) == (hit.speed, hit.tangential)
    assert (path.spin[0], path.second_spin[0], path.shift[0], path.angle[0]) == (hit.spin, hit.second_spin, 0, 0)
    assert path.velocity[-1] == pytest.approx(-hit.restitution * hit.speed, abs=1e-13)
    assert path.tangential[-1] == pytest.approx(hit.tangential_after, abs=1e-13)
    assert path.spin[-1] == pytest.approx(hit.spin_after, abs=1e-13)
    assert path.second_spin[-1] == pytest.approx(hit.second_spin_after, abs=1e-13)


def test_points_add_up_and_obey_coulombs_law(hit, path):
    pressure, friction = path.point_pressure, path.point_friction
    assert np.abs(pressure.sum(axis=1) - path.force).max() < 1e-14
    assert np.abs(friction.sum(axis=1) - path.friction).max() < 1e-14
    assert (pressure >= 0).all() and (np.abs(friction) <= hit.friction * pressure * (1 + 1e-8)).all()
    assert ((path.grip == 2) == (pressure == 0)).all()
    slips = np.abs(path.grip) == 1
    assert friction[slips] == pytest.approx(path.grip[slips] * hit.friction * pressure[slips], rel=1e-7, abs=1e-16)
    assert ((path.grip != 2).sum(axis=1) == path.touching).all()


def test_energy_is_kept(hit, path):
    energy = path.translation + path.across + path.rotation + path.second_rotation + path.elastic + path.friction_loss
    assert np.abs(energy - 1).max() < 3e-3
    assert hit.energy.total == pytest.approx(1 - hit.energy_error, abs=1e-12)
    assert hit.energy.friction == pytest.approx(path.friction_loss[-1], abs=1e-12)
    assert set(hit.energy.entries()) == set(hit.to_dict()["energy"])
    assert hit.momentum_error < 1e-12 and hit.angular_momentum_error < 1e-12
    assert (np.diff(path.friction_loss) > -1e-4).all()


def test_without_friction_it_is_the_central_impact():
    smooth = stoss.oblique_impact(BALL, speed=0.05, tangential=0.1, spin=0.02, friction=0, cutoff=20)
    central = stoss.impact(BALL, speed=0.05, cutoff=20)
    assert smooth.restitution == central.restitution and smooth.steps == central.steps
    assert (smooth.tangential_after, smooth.spin_after) == (0.1, 0.02) and smooth.tangential_restitution == -1
    ours, theirs = smooth.trajectory(), central.trajectory()
    assert np.abs(ours.force - theirs.force).max() < 1e-15 and np.abs(ours.center - theirs.center).max() < 1e-13
    assert set(np.unique(ours.grip)) == {1, 2} and not ours.friction.any()


def test_gross_sliding_slips_one_way_and_a_slow_one_sticks():
    slides = stoss.oblique_impact(BALL, speed=0.05, tangential=0.5, friction=0.1).trajectory()
    assert set(np.unique(slides.grip)) == {1, 2}
    sticks = stoss.oblique_impact(BALL, speed=0.05, tangential=0.01, friction=0.5).trajectory()
    assert (sticks.grip == 0).sum() > 0.5 * (sticks.grip != 2).sum()
    assert sticks.friction.max() > 0 > sticks.friction.min()


def test_every_so_many_steps():
    hit = stoss.oblique_impact(BALL, speed=0.05, tangential=0.02, friction=0.3)
    whole, part = hit.trajectory(), hit.trajectory(every=7)
    rows = np.unique(np.append(np.arange(0, hit.steps + 1, 7), hit.steps))
    assert part.time.tolist() == whole.time[rows].tolist() and (part.slip == whole.slip[rows]).all()


def test_rows_and_tables(hit, path, tmp_path):
    part = path[10:30:5]
    assert len(part) == 4 and part.grip.shape == (4, path.place.size) and (part.place == path.place).all()
    row = path[7]
    assert row["time"] == path.time[7] and row["slip"] == path.slip[7].tolist() and "place" not in row
    assert len(path[path.touching > 0]) == np.count_nonzero(path.touching)
    with pytest.raises(stoss.InvalidInput, match="index: got"):
        path[None]
    path.to_csv(tmp_path / "path.csv")
    head = next(line for line in (tmp_path / "path.csv").read_text().splitlines() if not line.startswith("#"))
    unit = "piRE" if isinstance(hit.body, stoss.Disk) else "mc^2/R"
    assert head.split(",")[:7] == [
        "time[R/c]", "center[R]", "shift[R]", "velocity[c]", "tangential[c]", "angle[rad]", "second_angle[rad]"
    ]  # fmt: skip
    assert f"force[{unit}]" in head and stoss.read_csv(tmp_path / "path.csv")["shift"].tolist() == path.shift.tolist()
    json.dumps(hit.to_dict())


def test_it_is_repeated_where_it_is_copied(hit):
    for again in (pickle.loads(pickle.dumps(hit)), copy.deepcopy(hit)):
        assert again.sliding_after == hit.sliding_after and again.energy.to_dict() == hit.energy.to_dict()
        assert again.trajectory().slip.tobytes() == hit.trajectory().slip.tobytes()


def test_lines_say_the_essential(hit, path):
    assert repr(hit).startswith("ObliqueImpact(") and "speed=0.05 c, tangential=" in repr(hit)
    assert f"{len(path)} rows, {path.place.size} points, time 0 to " in repr(path)
    assert repr(hit.energy).startswith("ObliqueLedger(translation 0.")


def test_vibration_before():
    ringing = stoss.Oscillation(order=2, index=0, energy=0.1, phase=2.0)
    hit = stoss.oblique_impact(BALL, speed=0.05, tangential=0.02, friction=0.3, state=ringing)
    path = hit.trajectory()
    assert path.elastic[0] > 0.05 and hit.state.size == 1
    assert path.velocity[-1] == pytest.approx(-hit.restitution * hit.speed, abs=1e-13)


@pytest.mark.parametrize(
    "given, said",
    [
        ({"speed": 2}, "speed: got 2, allowed 1e-8 to 1"),
        ({"speed": [0.1, 0.2]}, "speed: got 2 of them, allowed one impact (use stoss.oblique for several)"),
        ({"friction": [0.1, 0.2, 0.3]}, "friction: got 3 of them, allowed one"),
        ({"tangential": 1.5}, "tangential: got 1.5, allowed -1 to 1"),
        ({"angle": 3, "tangential": 0.1}, "angle: got tangential and angle, allowed one of them"),
        ({"second_spin": 0.1}, "second_spin: got one that is not 0, allowed only 0"),
        ({"friction": 6}, "friction: got 6, allowed 0 to 5"),
        ({"cutoff": -1}, "cutoff: got -1"),
        ({"nodes": 2.5}, "nodes: got 2.5"),
        ({"body": stoss.Rod()}, "friction: not available for 'rod', but for disks"),
        ({"against": stoss.ExponentialWall()}, "against: got "),
        ({"body": SHOT, "speed": 1, "tangential": 1e4}, "; with this material c is 5172.19 m/s"),
    ],
)
def test_refused_in_one_line(given, said):
    with pytest.raises(stoss.InvalidInput) as refused:
        stoss.oblique_impact(**{"body": BALL, "speed": 0.1, "friction": 0.1} | given)
    assert said in str(refused.value) and "\n" not in str(refused.value)


def test_an_interval_out_of_range_is_refused():
    hit = stoss.oblique_impact(BALL, speed=0.05, tangential=0.02, friction=0.3)
    with pytest.raises(stoss.InvalidInput, match="every: got 0, allowed 1 or more"):
        hit.trajectory(every=0)


def test_curves_have_ledgers():
    fan = stoss.oblique(BALL, speed=[[0.01], [0.05]], angle=[5, 30, 60], friction=0.2)
    assert fan.energy.friction.shape == (2, 3) and len(fan.energy) == 2
    assert fan.energy.total == pytest.approx(1 - fan.energy_error)
    assert fan.energy.friction == pytest.approx(fan.friction_loss)
    assert fan[1].energy[2].across == fan.energy.across[1, 2]
    one = stoss.oblique(BALL, speed=0.05, angle=60, friction=0.2)
    assert one.energy.rotation == fan.energy.rotation[1, 2] and isinstance(one.energy.rotation, float)
    assert one.energy.to_dataframe().shape == (1, 10) and len(fan.energy.to_dict()["friction"]) == 2
    with pytest.raises(TypeError):
        len(one.energy)
