"""stoss oblique: its values, its rows, its units."""

import json
import math

import pytest
from conftest import number, rows

pytestmark = pytest.mark.numbers

BALL = "oblique --body sphere --poisson 0.3 --friction 0.2"
STEEL = "oblique --body sphere --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01 --friction 0.1"
KEYS = (
    "speed tangential spin second_spin friction restitution restitution_error tangential_restitution "
    "tangential_restitution_error sliding sliding_after sliding_after_error tangential_after tangential_after_error "
    "spin_after spin_after_error second_spin_after second_spin_after_error friction_loss friction_loss_error "
    "vibration vibration_error dundurs coupling_restitution coupling_tangential_restitution coupling_sliding_after "
    "contact_time cutoff runs steps energy_error converged unstable stays strain beyond_small_strain "
    "turned beyond_small_turn"
).split()
LEDGER = (
    "translation across rotation second_rotation vibration second_vibration dissipated friction unresolved stored"
).split()


def document(stoss, arguments):
    result = stoss.run(arguments, "--format json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def test_a_fast_spin_is_warned_of_with_its_angle(stoss):
    fast = stoss.run(BALL, "--speed 0.05 --tangential 0.5 --spin -0.5 --format csv")
    (row,) = rows(fast.stdout)
    assert row["beyond_small_turn"] == "true"
    assert float(row["turned"]) == pytest.approx(0.5 * float(row["contact_time[R/c]"]), rel=0.03)
    assert f"turn by {float(row['turned']):.2g} rad" in fast.stderr
    slow = stoss.run(BALL, "--speed 0.05 --tangential 0.01 --spin -0.01 --format csv")
    assert slow.stderr == "" and rows(slow.stdout)[0]["beyond_small_turn"] == "false"


def test_disk_is_that_of_finite_elements(stoss):
    """0.94595(5), 0.4926(2) of linear kinematics; see docs/theory/oblique.md."""
    (row,) = stoss.data("oblique --body disk --poisson 0.33 --speed 0.1 --tangential 0.1 --friction 0.3")
    assert abs(float(row["restitution"]) - 0.94595) < float(row["restitution_error"])
    assert abs(float(row["tangential_restitution"]) - 0.4926) < float(row["tangential_restitution_error"])
    assert row["converged"] == "true"


def test_normal_restitution_of_a_ball_is_the_central_one(stoss):
    central = stoss.data("restitution --body sphere --poisson 0.3 --speed 0.05,0.1")
    oblique = stoss.data(f"{BALL} --speed 0.05,0.1 --tangential 0.03")
    for one, other in zip(central, oblique, strict=True):
        assert one["restitution"] == other["restitution"]
        assert one["restitution_error"] == other["restitution_error"]


def test_without_friction_only_the_normal_motion_changes(stoss):
    (row,) = stoss.data("oblique --body disk --poisson 0.33 --speed 0.1 --tangential 0.05 --spin 0.02 --friction 0")
    (central,) = stoss.data("restitution --body disk --poisson 0.33 --speed 0.1")
    assert row["restitution"] == central["restitution"]
    assert (row["tangential_restitution"], row["tangential_restitution_error"]) == ("-1", "0")
    assert (row["tangential_after[c]"], row["spin_after[c/R]"], row["friction_loss"]) == ("0.05", "0.02", "0")


def test_all_combinations_in_order(stoss):
    table = stoss.data(f"{BALL} --speed 0.05,0.01,0.05 --tangential lin:0:0.02:3 --spin -0.01,0.01")
    got = [(number(row, "speed"), number(row, "tangential"), number(row, "spin")) for row in table]
    assert got == [(v, t, w) for v in (0.05, 0.01, 0.05) for t in (0, 0.01, 0.02) for w in (-0.01, 0.01)]
    assert table[:6] == table[12:]
    (alone,) = stoss.data(f"{BALL} --speed 0.01 --tangential 0.02 --spin -0.01")
    assert alone == table[10]


def test_motion_and_its_mirror_image(stoss):
    there, back = stoss.data(f"{BALL} --speed 0.05 --tangential -0.02,0.02")
    for name in ("sliding", "sliding_after", "tangential_after", "spin_after"):
        assert number(there, name) == -number(back, name)
    assert there["tangential_restitution"] == back["tangential_restitution"]


def test_angles_are_those_of_the_velocity(stoss):
    table = stoss.data(f"{BALL} --speed 0.05 --angle -30,45")
    assert [float(row["angle[deg]"]) for row in table] == [-30, 45]
    assert number(table[0], "tangential") == pytest.approx(-0.05 / math.sqrt(3), rel=1e-14)
    assert number(table[1], "tangential") == pytest.approx(0.05, rel=1e-14)


def test_formats_agree(stoss):
    arguments = f"{BALL} --speed 0.05 --tangential 0.01,0.02 --spin 0.01"
    table, whole = stoss.data(arguments), document(stoss, arguments)
    assert whole["schema"] == "stoss/oblique/2" and whole["complete"] is True
    for name, value in [("speed", 0.05), ("tangential", "0.01,0.02"), ("spin", 0.01), ("friction", 0.2)]:
        assert whole["inputs"][name] == value
    assert whole["inputs"]["tolerance"] == 0.01
    assert whole["units"]["spin_after_error"] == "c/R" and whole["units"]["sliding"] == "c"
    assert [list(record) for record in whole["records"]] == 2 * [[*KEYS, "ledger"]]
    assert [key.partition("[")[0] for key in table[0]] == KEYS
    for row, record in zip(table, whole["records"], strict=True):
        assert int(row["runs"]) == len(record["runs"])
        for column, cell in row.items():
            key = column.partition("[")[0]
            if key != "runs":
                assert json.loads(cell) == record[key]


def test_json_has_the_ledger_and_the_runs(stoss):
    (record,) = document(stoss, f"{BALL} --speed 0.05 --tangential 0.05 --against same")["records"]
    ledger, runs = record["ledger"], record["runs"]
    assert list(ledger) == LEDGER
    assert sum(ledger.values()) == pytest.approx(1 - record["energy_error"], abs=1e-12)
    assert ledger["friction"] == record["friction_loss"] > 0
    assert ledger["rotation"] == ledger["second_rotation"] > 0
    assert len(runs) >= 3 and runs[-1]["sliding_after"] == record["sliding_after"]
    assert sum(run["steps"] for run in runs) == record["steps"]


def test_second_spin_slides_like_the_first(stoss):
    one, other = (
        stoss.data(f"{BALL} --speed 0.05 --against same {spin} 0.02")[0] for spin in ("--spin", "--second-spin")
    )
    assert number(one, "sliding") == number(other, "sliding") == 0.02
    assert number(one, "sliding_after") == pytest.approx(number(other, "sliding_after"), rel=1e-9)
    assert number(one, "second_spin_after") == pytest.approx(number(other, "spin_after"), rel=1e-9)


def test_si(stoss):
    c = math.sqrt(2.1e11 / 7850)
    (row,) = stoss.data(f"{STEEL} --speed 5 --tangential 2 --spin 100")
    motion = f"--speed {5 / c!r} --tangential {2 / c!r} --spin {100 * 0.01 / c!r}"
    (own,) = stoss.data(f"oblique --body sphere --poisson 0.3 --friction 0.1 {motion}")
    for name, unit, scale in [
        ("speed", "m/s", c),
        ("tangential", "m/s", c),
        ("spin", "rad/s", c / 0.01),
        ("sliding", "m/s", c),
        ("sliding_after", "m/s", c),
        ("spin_after", "rad/s", c / 0.01),
    ]:
        assert float(row[f"{name}_si[{unit}]"]) == pytest.approx(number(own, name) * scale, rel=1e-9)
    assert float(row["spin_after_si_error[rad/s]"]) == pytest.approx(number(own, "spin_after_error") * c / 0.01)
    assert row["restitution"] == own["restitution"]
    assert float(row["sliding_si[m/s]"]) == pytest.approx(3)


@pytest.mark.parametrize("more", ["", "--spin 0.01", "--angle 30,60"])
def test_table_fits_a_terminal(stoss, more):
    tangential = "" if "angle" in more else "--tangential 0.01,-0.02"
    lines = stoss.run(f"{BALL} --speed 0.05 {tangential} {more}").stdout.splitlines()
    assert len(lines) == 4 and max(map(len, lines)) <= 80
    assert "tangential_restitution" in lines[0] and ("angle" in lines[0]) == ("angle" in more)
    motion = more.replace("--spin 0.01", "--spin 123456")
    si = stoss.run(f"{STEEL} --speed 1 {tangential} {motion}").stdout.splitlines()
    assert "speed_si" in si[0] and "m/s" in si[1] and max(map(len, si)) <= 80


@pytest.mark.long
def test_disks_as_unequal_as_is_documented_have_a_value(stoss):
    job = "oblique --body disk --poisson 0.3 --speed 0.01 --angle 30 --friction 0.3 --against disk,radius="
    (known,) = stoss.data(job + "100")
    for radius in (130, 176):  # of which three cutoffs can be computed
        (found,) = stoss.data(f"{job}{radius}")
        assert found["converged"] == "true"
        for name in ("restitution", "tangential_restitution"):
            error = number(found, f"{name}_error") + number(known, f"{name}_error")
            assert abs(number(found, name) - number(known, name)) < error < 2e-3


def test_nothing_slides(stoss):
    (record,) = document(stoss, f"{BALL} --speed 0.05 --tangential 0.01 --spin -0.01")["records"]
    assert record["sliding"] == 0 and record["tangential_restitution"] == 0
    assert record["tangential_restitution_error"] == "unknown"
    assert 0 < abs(record["sliding_after"]) < 1e-4 and record["converged"] is True  # arms beside the middle are shorter


def test_lossy_vibrating_and_rigid_bodies_take_part(stoss):
    (plain,) = stoss.data(f"{BALL} --speed 0.02 --tangential 0.02")
    others = ("--rigid-body --against sphere", "--against half-space,poisson=0.2")
    for more in ("--loss-time 0.1", "--mode 2,0,energy=0.1,phase=1", *others):
        (row,) = stoss.data(f"{BALL} --speed 0.02 --tangential 0.02 {more}")
        assert row["sliding_after[c]"] != plain["sliding_after[c]"] and row["converged"] == "true"
