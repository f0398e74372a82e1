"""stoss bounce: a body that comes back, again and again."""

import json
import signal

import pytest
from conftest import number, rows, wait_for_rows

BALL = "bounce --body sphere --poisson 0.3 --speed 0.05 --cutoff 12"
STEEL = "--poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01"


def test_without_memory_every_impact_is_that_of_the_subcommand_impact(stoss):
    for row in stoss.data(BALL, "--count 3 --flight-time 20 --decay-time 0"):
        speed = row["speed[c]"]
        (rest,) = stoss.data(f"impact --body sphere --poisson 0.3 --cutoff 12 --speed {speed}")
        assert row["restitution"] == rest["restitution"]
        assert row["contact_time[R/c]"] == rest["contact_time[R/c]"]


@pytest.mark.parametrize(
    "against",
    ["", "--tail static", "--against exponential,hardness=100", "--against half-space", "--decay-time 30"],
)
def test_energies_add_up(stoss, against):
    sequence = stoss.data(BALL, "--count 5 --flight-time 20", against)
    assert [int(row["number"]) for row in sequence] == [1, 2, 3, 4, 5]
    for row in sequence:
        after = sum(float(row[name]) for name in ("translation", "vibration", "dissipated", "unresolved"))
        assert after + float(row["energy_error"]) == pytest.approx(1, abs=1e-12)
        assert abs(float(row["energy_error"])) < 1e-3
    for row, following in zip(sequence, sequence[1:]):
        assert number(following, "speed") == number(row, "speed") * float(row["restitution"])
        kept, left = float(following["vibration_before"]), float(row["vibration"])
        assert kept < left if "decay" in against else kept == pytest.approx(left, abs=1e-12)


def test_a_material_has_times_and_gravity_in_si(stoss):
    in_si = stoss.data(f"bounce --body sphere {STEEL} --speed 1 --count 3 --gravity 9.81 --decay-time 0.001")
    for row in in_si:
        speed = float(row["speed_si[m/s]"]) * float(row["restitution"])
        assert float(row["flight_time_si[s]"]) == pytest.approx(2 * speed / 9.81, rel=1e-12)
    unit = float(in_si[0]["flight_time_si[s]"]) / number(in_si[0], "flight_time")
    gravity = 9.81 * unit / (float(in_si[0]["speed_si[m/s]"]) / number(in_si[0], "speed"))
    speed = in_si[0]["speed[c]"]
    own = stoss.data(
        f"bounce --body sphere --poisson 0.3 --speed {speed} --count 3 --gravity {gravity!r} "
        f"--decay-time {0.001 / unit!r}"
    )
    expected = [float(row["restitution"]) for row in in_si]
    assert [float(row["restitution"]) for row in own] == pytest.approx(expected, rel=1e-9)


def test_a_short_flight_is_said(stoss):
    result = stoss.run(BALL, "--count 2 --flight-time 0.001 --format csv")
    assert result.returncode == 0
    assert rows(result.stdout)[1]["short_flight"] == "true"
    assert "1 flights too short" in result.stderr


def test_json_has_the_inputs_and_units(stoss):
    document = json.loads(stoss.run(BALL, "--count 2 --gravity 0.01 --format json").stdout)
    assert document["schema"].startswith("stoss/bounce/")
    assert document["inputs"]["gravity"] == 0.01 and document["complete"]
    assert document["units"]["flight_time"] == "R/c" and len(document["records"]) == 2


def test_a_sequence_that_ends_early_keeps_its_rows(stoss):
    result = stoss.run("bounce --poisson 0.33 --speed 1e-8 --count 3 --flight-time 9 --format csv")
    assert result.returncode == 1
    assert len(rows(result.stdout)) == 1
    assert "1e-8 to 1" in result.stderr


@pytest.mark.parametrize("stop, code", [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_ctrl_c_keeps_what_is_done(stoss, tmp_path, stop, code):
    path = tmp_path / "sequence.csv"
    process = stoss.start(f"{BALL} --count 1000000 --flight-time 30 --format csv -o {path}")
    wait_for_rows(process, path, 5)
    process.send_signal(stop)
    assert process.wait(timeout=20) == code
    done = rows(path.read_text())
    assert [int(row["number"]) for row in done] == list(range(1, len(done) + 1))
    assert path.read_text().splitlines()[-1].startswith("# interrupted")


@pytest.mark.parametrize(
    "arguments, said",
    [
        ("", ["flight_time", "neither"]),
        ("--flight-time 1 --gravity 1", ["flight_time", "exactly one"]),
        ("--flight-time 0", ["flight_time", "above 0"]),
        ("--flight-time 1e99", ["flight_time", "1e12"]),
        ("--gravity -1", ["gravity"]),
        ("--flight-time 1 --decay-time -1", ["decay_time"]),
        ("--flight-time 1 --count 0", ["count"]),
        ("--flight-time 1 --against same", ["against", "free"]),
        ("--flight-time 1 --against exponential --tail static", ["tail"]),
        ("--flight-time nan", ["nan"]),
    ],
)
def test_bad_input_is_one_line(stoss, arguments, said):
    result = stoss.run(BALL, arguments)
    assert result.returncode == 3, result.stderr
    assert result.stdout == "" and result.stderr.count("\n") == 1
    for part in said:
        assert part in result.stderr
