"""Oblique impacts: over arrays, with what goes wrong, and one of them in time."""

import numpy as np
import pytest
import stoss

BALL, PLATE = stoss.Sphere(poisson=0.3), stoss.Disk(poisson=0.33)


@pytest.fixture(scope="module")
def fan():
    return stoss.oblique(BALL, speed=[[0.01], [0.05]], angle=[-30, 5, 45], friction=0.2)


def test_arrays_broadcast_and_are_the_values_one_by_one(fan):
    assert fan.restitution.shape == fan.friction.shape == (2, 3) and len(fan) == 2
    for i, speed in enumerate((0.01, 0.05)):
        for k, angle in enumerate((-30, 5, 45)):
            one = stoss.oblique(BALL, speed=speed, angle=angle, friction=0.2)
            for name in ("restitution", "sliding_after", "spin_after", "friction_loss_error", "steps"):
                assert getattr(fan, name)[i, k] == getattr(one, name)
    assert fan.angle.ravel() == pytest.approx([-30, 5, 45] * 2)


def test_every_number_of_the_motion_broadcasts():
    result = stoss.oblique(
        BALL, against="same", speed=0.05, tangential=[[0.02], [0.0]], spin=[0.0, 0.01], second_spin=0.01,
        friction=[[[0.1]], [[0.4]]],
    )  # fmt: skip
    assert result.restitution.shape == (2, 2, 2)
    one = stoss.oblique(BALL, against="same", speed=0.05, spin=0.01, second_spin=0.01, friction=0.4)
    assert result[1, 1, 1].sliding_after == one.sliding_after
    assert result[1, 1, 1].friction == 0.4 and result[1, 0, 0].friction == 0.4 and result[0].friction.max() == 0.1


def test_selection_keeps_the_inputs(fan):
    part = fan[1, fan.angle[1] > 0]
    assert part.tangential.shape == (2,) and part.body == BALL and part.speed.tolist() == [0.05, 0.05]
    single = part[0]
    assert isinstance(single.restitution, float) and single.angle == pytest.approx(5)
    with pytest.raises(TypeError):
        len(single)


def test_a_line_says_the_essential(fan):
    one = stoss.oblique(BALL, speed=0.05, tangential=0.02, spin=0.01, friction=0.3, against="same")
    assert repr(one).startswith(
        "ObliqueRestitution(Sphere(poisson=0.3) against Sphere(poisson=0.3), speed=0.05 c, tangential=0.02 c, "
        "spin=0.01 c/R, friction=0.3: restitution 0.99"
    )
    values = "6 values, Sphere(poisson=0.3), speed=0.01 to 0.05 c, friction=0.2: tangential restitution 0."
    assert repr(fan).startswith(f"ObliqueRestitution({values}")
    assert repr(fan).endswith("all converged)")


def test_nothing_slides_before():
    result = stoss.oblique(BALL, speed=0.05, tangential=[0.0, 0.01], spin=[0.0, -0.01], friction=0.3)
    assert result.sliding.tolist() == [0, 0] and result.converged.all()
    assert np.isinf(result.tangential_restitution_error).all() and result.sliding_after[0] == 0
    assert result.to_dict()["tangential_restitution_error"] == ["unknown", "unknown"]


def test_what_misses_its_tolerance():
    with pytest.raises(stoss.NotConverged, match="^oblique: the tolerance asks for more points") as missed:
        stoss.oblique(BALL, speed=0.1, tangential=0.02, friction=0.2, tolerance=1e-5)
    assert isinstance(missed.value.best, stoss.ObliqueRestitution) and missed.value.best.sliding_after_error > 0
    assert repr(missed.value.best).endswith("not converged)")


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


def test_every_so_many_steps():
    hit = stoss.oblique_impact(BALL, speed=0.05, tangential=0.02, friction=0.3)
    whole, part = hit.trajectory(), hit.trajectory(every=7)
    rows = np.unique(np.append(np.arange(0, hit.steps + 1, 7), hit.steps))
    assert part.time.tolist() == whole.time[rows].tolist() and (part.slip == whole.slip[rows]).all()


def test_rows_and_units(hit, path):
    part = path[10:30:5]
    assert len(part) == 4 and part.grip.shape == (4, path.place.size) and (part.place == path.place).all()
    row = path[7]
    assert row["time"] == path.time[7] and row["slip"] == path.slip[7].tolist() and "place" not in row
    assert len(path[path.touching > 0]) == np.count_nonzero(path.touching)
    with pytest.raises(stoss.InvalidInput, match="index: got"):
        path[None]
    units = path._units_of(path._columns())
    assert units["force"] == ("piRE" if isinstance(hit.body, stoss.Disk) else "mc^2/R")
    assert (units["shift"], units["tangential"], units["second_angle"]) == ("R", "c", "rad")


def test_curves_have_ledgers():
    fan = stoss.oblique(BALL, speed=[[0.01], [0.05]], angle=[5, 30, 60], friction=0.2)
    assert fan.energy.friction.shape == (2, 3) and len(fan.energy) == 2
    assert fan.energy.total == pytest.approx(1 - fan.energy_error)
    assert fan.energy.friction == pytest.approx(fan.friction_loss)
    assert fan[1].energy[2].across == fan.energy.across[1, 2]
    one = stoss.oblique(BALL, speed=0.05, angle=60, friction=0.2)
    assert one.energy.rotation == fan.energy.rotation[1, 2] and isinstance(one.energy.rotation, float)
    assert one.energy.to_dataframe().shape == (1, 11) and len(fan.energy.to_dict()["friction"]) == 2
    with pytest.raises(TypeError):
        len(one.energy)
