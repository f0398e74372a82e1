"""Bodies that vibrate before the impact (--mode), lose energy (--loss-time), and come back (stoss bounce)."""

import json
import signal

import pytest
from conftest import number, resume, rows, wait_for_rows

BALL = "--body sphere --poisson 0.3"
RINGING = "--mode 2,0,energy=0.1,phase=2"


def test_ledger_says_what_modes_had_before(stoss):
    job = f"impact {BALL} --speed 0.01 --cutoff 15 {RINGING} --mode 3,0,energy=0.02"
    result = json.loads(stoss.run(job, "--format json").stdout)
    before = {(m["order"], m["index"]): m["before"] for m in result["modes"] if m["before"] > 0}
    assert before == {(2, 0): pytest.approx(0.1 / 1.12, rel=1e-9), (3, 0): pytest.approx(0.02 / 1.12, rel=1e-9)}
    assert result["inputs"]["vibration"][0] == {"body": "first", "order": 2, "index": 0, "energy": 0.1, "phase": 2.0}
    table = stoss.run(job).stdout
    names = table.split("most energetic modes")[1].splitlines()[1].split()
    assert names == ["n", "l", "omega", "before", "average", "after"]
    assert "0.0892857" in table
    assert "before" not in stoss.run(f"impact {BALL} --speed 0.01 --cutoff 15").stdout


def test_restitution_exceeds_one(stoss):
    (row,) = stoss.data(f"restitution {BALL} --speed 0.01 {RINGING}")
    assert number(row, "restitution") > 1.005 and number(row, "lost_fraction") < 0
    assert row["converged"] == "true"


def test_second_body(stoss):
    (row,) = stoss.data(f"restitution {BALL} --against same --speed 0.01 --mode 2,0,energy=0.1,phase=2,of=second")
    (other,) = stoss.data(f"restitution {BALL} --against same --speed 0.01 {RINGING},of=first")
    assert number(row, "restitution") == pytest.approx(number(other, "restitution"), abs=1e-9)


def test_another_vibration_is_another_job(stoss, tmp_path):
    path = tmp_path / "curve.csv"
    job = f"restitution {BALL} --speed 0.01,0.02"
    assert resume(stoss, path, f"{job} {RINGING}").returncode == 0
    whole = path.read_text()
    for other in (job, f"{job} --mode 2,0,energy=0.1", f"{job} {RINGING} --mode 3,0,energy=0.1"):
        result = resume(stoss, path, other)
        assert result.returncode == 3 and result.stderr.startswith("stoss: error: vibration: got")
    assert path.read_text() == whole
    assert resume(stoss, path, f"{job} --mode 2,0,phase=2.0,energy=1e-1").returncode == 0  # the same numbers
    assert path.read_text() == whole


@pytest.mark.parametrize(
    "mode, message",
    [
        ("2,0", "mode: got '2,0', allowed ORDER,INDEX,energy=SHARE"),
        ("2,0,phase=1", "without energy, allowed ORDER,INDEX,energy=SHARE, also with phase, of"),
        ("2,0,energ=1", "did you mean energy?"),
        ("2,0,energy=1,energy=2", "mode: got energy twice"),
        ("2,0,energy", "mode: got 'energy' without a value"),
        ("2.5,0,energy=1", "mode: got '2.5'"),
        ("2,0,energy=nan", "mode energy: got 'nan'"),
        ("2,0,energy=-1", "energy: got -1, allowed 0 to 1e12"),
        ("2,0,energy=0.1,of=third", "mode of: got 'third', allowed first, second"),
        ("2,0,energy=0.1,of=second", "mode of body 1, allowed 0 (a wall has no modes)"),
        ("2,400,energy=0.1", "mode"),
    ],
)
@pytest.mark.parametrize("what", ["impact", "restitution"])
def test_refusals_leave_the_file_alone(stoss, tmp_path, what, mode, message):
    path = tmp_path / "there.txt"
    path.write_text("mine")
    result = stoss.run(f"{what} {BALL} --speed 0.01 --mode {mode} -o {path}")
    assert result.returncode == 3 and message in result.stderr and result.stderr.count("\n") == 1
    assert path.read_text() == "mine"


def test_a_mode_comes_once(stoss):
    result = stoss.run(f"restitution {BALL} --speed 0.01 {RINGING} {RINGING}")
    assert result.returncode == 3 and "twice, allowed once" in result.stderr


LOSSY = "restitution --body sphere --poisson 0.3 --speed 0.01"


def test_a_lossy_sphere_loses_what_an_independent_program_says(stoss):
    (row,) = stoss.data(LOSSY, "--loss-time 0.3")
    assert abs(number(row, "restitution") - 0.86565) <= number(row, "restitution_error") + 1e-5
    assert number(row, "dissipated") == pytest.approx(number(row, "lost_to_first"), rel=5e-3)
    (none,) = stoss.data(LOSSY, "--loss-time 0")
    assert none == stoss.data(LOSSY)[0]
    assert none["dissipated"] == "0"


def test_each_of_two_bodies_has_its_own_loss_time(stoss):
    (row,) = stoss.data(LOSSY, "--loss-time 0.01 --against sphere,loss_time=0.05,radius=2")
    (other,) = stoss.data(
        "restitution --body sphere --poisson 0.3 --speed 0.01 --loss-time 0.025 --against sphere,loss_time=0.005,radius=0.5"
    )
    assert number(row, "restitution") == pytest.approx(number(other, "restitution"), rel=1e-9)
    assert number(row, "lost_to_second") == pytest.approx(number(other, "lost_to_first"), rel=1e-9)
    assert number(row, "lost_to_second") > 2 * number(row, "lost_to_first")
    (same,) = stoss.data(LOSSY, "--loss-time 0.3 --against same")
    assert number(same, "lost_to_first") == pytest.approx(number(same, "lost_to_second"), rel=1e-9)


@pytest.mark.parametrize(
    "body, sizes",
    [
        ("disk --poisson 0.3", "--young 2.1e11 --density 7850 --radius 0.01"),
        ("sphere --poisson 0.3", "--young 2.1e11 --density 7850 --radius 0.01"),
        ("rod", "--young 2.1e11 --density 7850 --length 0.01 --area 1e-4"),
    ],
)
def test_in_si_it_is_in_seconds(stoss, body, sizes):
    wave = (2.1e11 / 7850) ** 0.5
    (own,) = stoss.data(f"impact --body {body} --speed 0.01 --cutoff 25 --loss-time 0.1")
    (si,) = stoss.data(
        f"impact --body {body} {sizes} --speed {0.01 * wave!r} --cutoff 25 --loss-time {0.1 * 0.01 / wave!r}"
    )
    assert number(si, "restitution") == pytest.approx(number(own, "restitution"), rel=1e-9)
    assert number(si, "dissipated") == pytest.approx(number(own, "dissipated"), rel=1e-9)


@pytest.mark.parametrize(
    "arguments, complaint",
    [
        (f"{LOSSY} --loss-time -1", "loss_time: got -1, allowed 0 to 100000"),
        (f"{LOSSY} --loss-time nan", "loss"),
        (f"{LOSSY} --against sphere,loss_time=1e9", "against loss_time: got 1000000000, allowed 0 to 100000"),
    ],
)
def test_impossible_loss_times_are_refused(stoss, arguments, complaint):
    result = stoss.run(arguments)
    assert result.returncode == 3
    assert complaint in result.stderr and result.stderr.count("\n") == 1


BOUNCE = "bounce --body sphere --poisson 0.3 --speed 0.05 --cutoff 12"
STEEL = "--poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01"


def test_without_memory_every_impact_is_that_of_the_subcommand_impact(stoss):
    for row in stoss.data(BOUNCE, "--count 3 --flight-time 20 --decay-time 0"):
        speed = row["speed[c]"]
        (rest,) = stoss.data(f"impact --body sphere --poisson 0.3 --cutoff 12 --speed {speed}")
        assert row["restitution"] == rest["restitution"]
        assert row["contact_time[R/c]"] == rest["contact_time[R/c]"]


@pytest.mark.parametrize(
    "against",
    ["", "--tail static", "--against exponential,hardness=100", "--against half-space", "--decay-time 30"],
)
def test_energies_add_up(stoss, against):
    sequence = stoss.data(BOUNCE, "--count 5 --flight-time 20", against)
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
    result = stoss.run(BOUNCE, "--count 2 --flight-time 0.001 --format csv")
    assert result.returncode == 0
    assert rows(result.stdout)[1]["short_flight"] == "true"
    assert "1 flights too short" in result.stderr


def test_json_has_the_inputs_and_units(stoss):
    document = json.loads(stoss.run(BOUNCE, "--count 2 --gravity 0.01 --format json").stdout)
    assert document["schema"].startswith("stoss/bounce/")
    assert document["inputs"]["gravity"] == 0.01 and document["complete"]
    assert document["units"]["flight_time"] == "R/c" and len(document["records"]) == 2


def test_a_sequence_that_ends_early_keeps_its_rows(stoss):
    result = stoss.run("bounce --body disk --poisson 0.33 --speed 1e-8 --count 3 --flight-time 9 --format csv")
    assert result.returncode == 1
    assert len(rows(result.stdout)) == 1
    assert "1e-8 to 1" in result.stderr


@pytest.mark.parametrize("stop, code", [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_ctrl_c_keeps_what_is_done(stoss, tmp_path, stop, code):
    path = tmp_path / "sequence.csv"
    process = stoss.start(f"{BOUNCE} --count 1000000 --flight-time 30 --format csv -o {path}")
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
        ("--flight-time 1 --against same", ["against", "free"]),
        ("--flight-time 1 --against exponential --tail static", ["tail"]),
        ("--flight-time nan", ["nan"]),
    ],
)
def test_bad_input_is_one_line(stoss, arguments, said):
    result = stoss.run(BOUNCE, arguments)
    assert result.returncode == 3, result.stderr
    assert result.stdout == "" and result.stderr.count("\n") == 1
    for part in said:
        assert part in result.stderr
