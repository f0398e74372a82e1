"""The package gives the core's numbers: against references, and against the command bit for bit."""

import dataclasses

import numpy as np
import pytest

import stoss

ERRORS = ("lost_fraction", "contact_time", "max_compression", "max_force")
ARRAYS = [field.name for field in dataclasses.fields(stoss.Restitution) if field.name.endswith("_error")]
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
                     "steps", "converged", "strain", "beyond_small_strain"]:  # fmt: skip
            assert getattr(result, name).ravel()[i] == record[name], name


@pytest.mark.parametrize("plane", ["stress", "strain"])
def test_si_is_that_of_the_command(command, plane):
    disk = stoss.Disk(radius=0.01, material=stoss.materials["structural steel"], loss_time=0, plane=plane)
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
        ({"tail": "static"}, "--tail static"),
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
