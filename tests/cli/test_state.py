"""Modes that vibrate before the impact, on the command line."""

import json

import pytest

from conftest import number, resume

BALL = "--body sphere --poisson 0.3"
RINGING = "--mode 2,0,energy=0.1,phase=2"


def test_ledger_says_what_modes_had_before(stoss):
    job = f"impact {BALL} --speed 0.01 --cutoff 15 {RINGING} --mode 3,0,energy=0.02"
    result = json.loads(stoss.run(job, "--format json").stdout)
    before = {(m["order"], m["index"]): m["before"] for m in result["modes"] if m["before"] > 0}
    assert before == {(2, 0): pytest.approx(0.1 / 1.12, rel=1e-9), (3, 0): pytest.approx(0.02 / 1.12, rel=1e-9)}
    assert result["inputs"]["modes"][0] == {"body": "first", "order": 2, "index": 0, "energy": 0.1, "phase": 2.0}
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
        assert result.returncode == 3 and result.stderr.startswith("stoss: error: modes: got")
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


def test_extrapolation_starts_at_rest(stoss):
    result = stoss.run(f"restitution --poisson 0.33 --speed 0.1 --method extrapolate {RINGING}")
    assert result.returncode == 3 and "mode: got --mode with --method extrapolate" in result.stderr
