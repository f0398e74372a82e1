"""The package gives the core's numbers: against references, against the command bit for bit, and against itself."""

import dataclasses
import pickle

import numpy as np
import pytest

import stoss

ERRORS = ("lost_fraction", "contact_time", "max_compression", "max_force")
ARRAYS = [field.name for field in dataclasses.fields(stoss.Restitution) if field.name.endswith("_error")]
integral = getattr(np, "trapezoid", None) or np.trapz
STEEL = "--poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01"


def same(result, record, names):
    """Bit for bit."""
    for name in names:
        assert getattr(result, name) == record[name], name


def test_restitution_is_that_of_the_fine_references(references):
    rows = references("restitution_fine.csv")
    result = stoss.restitution(
        poisson=[row["poisson"] for row in rows], speed=[row["speed"] for row in rows], tolerance=1e-3
    )
    assert result.converged.all()
    for name in ERRORS:
        reference = np.array([row[name] for row in rows])
        key = "uncertainty" if name == "lost_fraction" else name + "_uncertainty"
        uncertainty = np.array([row[key] for row in rows])
        off = np.abs(getattr(result, name) - reference) / (getattr(result, name + "_error") + uncertainty)
        # The true error is within the estimated one in 95 % of all cases: here at most one of twelve may be outside.
        assert np.count_nonzero(off > 1.0) <= 1 and off.max() < 2.0, name


def test_restitution_is_that_of_cutoff_100(references):
    for row in references("restitution_hard_wall.csv"):
        result = stoss.restitution(poisson=row["poisson"], speed=row["speed"])
        uncertainty = result.lost_fraction_error + row["uncertainty"]
        assert result.lost_fraction == pytest.approx(row["lost_fraction"], abs=uncertainty)


def test_restitution_is_that_of_finite_elements(references):
    rows = [row for row in references("restitution_hard_wall.csv") if "finite_elements_restitution" in row]
    assert len(rows) == 8
    for row in rows:
        result = stoss.restitution(poisson=row["poisson"], speed=row["speed"])
        uncertainty = result.restitution_error + row["finite_elements_uncertainty"]
        assert result.restitution == pytest.approx(row["finite_elements_restitution"], abs=uncertainty)


def test_contact_is_that_of_finite_elements(references):
    for row in references("contact_hard_wall.csv"):
        hit = stoss.impact(poisson=row["poisson"], speed=row["speed"])
        assert hit.contact_time == pytest.approx(row["contact_time"], abs=row["contact_time_uncertainty"] + 2 * hit.step)
        assert hit.max_compression == pytest.approx(row["max_compression"], rel=3e-4)
        # The references are averaged over 0.05 R/c, and a node more or less is in contact.
        assert hit.max_force == pytest.approx(row["max_force_over_piRE"], rel=0.01)
        half_width = np.degrees(hit.max_half_width)
        assert half_width == pytest.approx(row["max_contact_half_angle_deg"], abs=0.5 + np.degrees(hit.half_width / 32))


def test_modes_are_the_published_ones(references):
    rows = references("disk_modes.csv")
    lists = {nu: stoss.modes(poisson=nu, cutoff=28) for nu in {row["poisson"] for row in rows}}
    for row in rows:
        modes = lists[row["poisson"]]
        k = modes.find(int(row["n"]), int(row["l"]))
        assert modes.omega[k] == pytest.approx(row["omega"], abs=2e-8)
        assert modes.radial[k] == pytest.approx(row["C"], abs=2e-6)
        assert modes.tangential[k] == pytest.approx(row["S"], abs=2e-6)
        u_r, u_phi = modes.displacement(order=int(row["n"]), index=int(row["l"]), radius=1.0)
        assert (u_r, u_phi) == pytest.approx((modes.radial[k], modes.tangential[k]), abs=1e-10)


def test_modes_are_those_of_high_precision(references):
    rows = references("modes_mpmath.csv")
    for nu in sorted({row["poisson"] for row in rows}):
        mine = [row for row in rows if row["poisson"] == nu]
        modes = stoss.modes(poisson=nu, cutoff=max(row["window_high"] for row in mine))
        for row in mine:
            near = (modes.order == row["n"]) & (abs(modes.omega - row["omega"]) < 1e-9 * row["omega"])
            (k,) = np.flatnonzero(near)
            assert modes.omega[k] == pytest.approx(row["omega"], rel=1e-12)
            assert (modes.radial[k], modes.tangential[k]) == pytest.approx((row["C"], row["S"]), abs=1e-8)


def test_exponential_wall_tends_to_its_reference(references):
    rows = [row for row in references("restitution_exponential_wall.csv") if row["hardness"] == 500]
    for row in (row for row in rows if row["speed"] == 0.1):
        wall = stoss.ExponentialWall(hardness=row["hardness"])
        at = {"poisson": row["poisson"], "speed": row["speed"], "against": wall}
        coarse, fine = (stoss.impact(cutoff=cutoff, **at).lost_fraction for cutoff in (30, 60))
        # What the truncation takes falls with 1/cutoff.
        assert 2 * fine - coarse == pytest.approx(1 - row["restitution"] ** 2, abs=1e-3)


def test_rod_is_exact():
    hit = stoss.impact(stoss.Rod(), speed=0.1, cutoff=1500)
    assert hit.restitution == pytest.approx(1, abs=1e-3)
    assert hit.contact_time == pytest.approx(2, abs=1e-3)
    path = hit.trajectory()
    inside = (path.time > 0.1) & (path.time < 1.9)
    assert path.force[inside] == pytest.approx(0.1, rel=0.01)
    assert path.center[inside].max() == pytest.approx(-0.5 + 0.1 / 2, rel=0.01)


def test_restitution_is_that_of_the_command(command):
    records = command("restitution --poisson 0.33,-0.5 --speed 0.1,0.01,1e-6 --tolerance 1e-3")["records"]
    result = stoss.restitution(poisson=[[0.33], [-0.5]], speed=[0.1, 0.01, 1e-6])
    for i, record in enumerate(records):
        record = {**record, "runs": len(record["runs"])}
        for name in [*ARRAYS, "poisson", "speed", "restitution", *ERRORS, "cutoff", "energy_error", "modes", "runs",
                     "steps", "converged", "beyond_small_strain"]:  # fmt: skip
            assert getattr(result, name).ravel()[i] == record[name], name


@pytest.mark.parametrize("plane", ["stress", "strain"])
def test_si_is_that_of_the_command(command, plane):
    disk = stoss.Disk(radius=0.01, material=stoss.materials["steel"], plane=plane)
    names = ("speed", "contact_time_si", "max_force_si", "max_compression_si", "restitution", "poisson")
    records = command(f"restitution {STEEL} --plane {plane} --speed 5,50")["records"]
    for speed, record in zip((5, 50), records):
        result = stoss.restitution(disk, speed=speed)
        same(result, record, names)
        assert result.speed_si == pytest.approx(record["speed_si"], rel=1e-15)
    (record,) = command(f"impact {STEEL} --plane {plane} --speed 5 --cutoff 12")["records"]
    same(stoss.impact(disk, speed=5, cutoff=12), record, names[:-1])
    modes = stoss.modes(disk, cutoff=9)
    assert modes.omega.tolist() == [m["omega"] for m in command(f"modes {STEEL} --plane {plane} --cutoff 9")["records"]]
    bar_speed = disk.scales.speed
    assert bar_speed == pytest.approx((2.1e11 / 7850 / (1 if plane == "stress" else 1 - 0.3**2)) ** 0.5, rel=1e-14)
    assert disk.scales.time == pytest.approx(0.01 / bar_speed)
    assert disk.scales.force == pytest.approx(np.pi * 0.01 * 7850 * bar_speed**2, rel=1e-14)


@pytest.mark.parametrize(
    "options, arguments",
    [
        ({}, ""),
        ({"against": stoss.HardWall(tail="static")}, "--tail static"),
        ({"against": stoss.ExponentialWall(hardness=99, strength=2)}, "--against exponential,hardness=99,strength=2"),
        ({"step": 0.01, "nodes": 100}, "--step 0.01 --nodes 100"),
    ],
)
def test_impact_is_that_of_the_command(command, options, arguments):
    answer = command(f"impact --poisson 0.33 --speed 0.1 --cutoff 15 {arguments}")
    hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=15, **options)
    (record,) = answer["records"]
    assert {"restitution", "vibration", "max_force", "energy_error"} < set(record)
    same(hit, record, [name for name in record if name != "poisson"])
    for name in ("order", "index", "omega", "after", "average"):
        assert hit.mode_energies[name].tolist() == [mode[name] for mode in answer["modes"]]


def test_modes_are_those_of_the_command(command):
    modes = stoss.modes(poisson=0.9, cutoff=20)
    records = command("modes --poisson 0.9 --cutoff 20")["records"]
    for name in ("order", "index", "omega", "radial", "tangential"):
        assert getattr(modes, name).tolist() == [record[name] for record in records]
    assert modes.radial_family.tolist() == [record["family"] == "radial" for record in records]


def test_extrapolation_is_that_of_the_command(command):
    (record,) = command("restitution --method extrapolate --poisson 0.33 --speed 0.3")["records"]
    result = stoss.extrapolated_restitution(poisson=0.33, speed=0.3)
    same(result, record, ("restitution", "restitution_error", "lost_fraction", "lost_fraction_error"))
    assert result.to_dict()["impacts"] == record["impacts"]
    assert result.steps == sum(impact["steps"] for impact in record["impacts"])
    best = stoss.restitution(poisson=0.33, speed=0.3)
    assert abs(best.lost_fraction - result.lost_fraction) < 2 * result.lost_fraction_error


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
