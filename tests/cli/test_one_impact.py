"""One impact where no cutoff is given: what restitution computes, impact computes too, at a cutoff that both bodies have."""

import json

import pytest
from conftest import number, rows
from test_cost import bounded

pytestmark = pytest.mark.numbers

BALL = "--body sphere --poisson 0.3 --speed 0.01 --against"
SOFT = "young=1e-3,density=1e3"


@pytest.mark.usefixtures("usual_build")
@pytest.mark.parametrize(
    "words",
    [
        f"{BALL} sphere,radius=20",
        f"{BALL} sphere,young=0.001",
        "--body disk --poisson 0.3 --speed 0.01 --against disk,radius=300",
        "--body disk --poisson 0.3 --speed 0.01 --against disk,radius=0.03",  # at 50 c/R of the first it had hardly any modes
        "--body rod --speed 0.01 --against rod,length=0.01",
        "--body sphere --radius 0.005 --material glass --rigid-body --speed 0.1 "
        "--against sphere,radius=0.005,material=rubber",
        # longer than Hertz' contact on what is so soft and heavy
        f"--body disk --poisson 0.3 --speed 0.0005 --against half-plane,{SOFT}",
        f"--body sphere --poisson 0.3 --speed 0.0005 --against half-space,{SOFT}",
        # the body stays
        "--body sphere --poisson -0.191 --speed 0.175 --against plate,thickness=0.0668,young=24.9,density=2.47",
    ],
)
def test_one_impact_is_that_of_the_restitution(stoss, words):
    one, used = bounded(stoss, f"impact {words} --format csv", 5)
    assert one.returncode == 0, one.stderr
    assert used < 5
    best = rows(stoss.run("restitution", words, "--tolerance 0.01 --format csv").stdout)[0]
    error = 4 * number(best, "restitution_error") + 2e-3  # near sides of disks lack the curvature (stoss::contact)
    assert number(rows(one.stdout)[0], "restitution") == pytest.approx(number(best, "restitution"), abs=error)


def test_ledger_says_what_modes_had_before(stoss):
    job = "impact --body sphere --poisson 0.3 --speed 0.01 --cutoff 15 --mode 2,0,energy=0.1,phase=2 --mode 3,0,energy=0.02"
    result = json.loads(stoss.run(job, "--format json").stdout)
    before = {(m["order"], m["index"]): m["before"] for m in result["modes"] if m["before"] > 0}
    assert before == {(2, 0): pytest.approx(0.1 / 1.12, rel=1e-9), (3, 0): pytest.approx(0.02 / 1.12, rel=1e-9)}
    assert result["inputs"]["vibration"][0] == {"body": "first", "order": 2, "index": 0, "energy": 0.1, "phase": 2.0}
    table = stoss.run(job).stdout
    names = table.split("most energetic modes")[1].splitlines()[1].split()
    assert names == ["n", "l", "omega", "before", "average", "after"]
    assert "0.0892857" in table
    assert "before" not in stoss.run("impact --body sphere --poisson 0.3 --speed 0.01 --cutoff 15").stdout


def test_a_sequence_that_ends_early_keeps_its_rows(stoss):
    result = stoss.run("bounce --body disk --poisson 0.33 --speed 1e-8 --count 3 --flight-time 9 --format csv")
    assert result.returncode == 1
    assert len(rows(result.stdout)) == 1
    assert "1e-8 to 1" in result.stderr


PAIR = "impact --body disk --poisson 0.33 --speed 0.2 --cutoff 25 --against disk,radius=2"


def test_the_table_of_an_impact_has_its_modes(stoss):
    lines = stoss.run("impact --body disk --poisson 0.33 --speed 0.1").stdout.splitlines()
    first = lines[lines.index("most energetic modes (shares of the initial energy)") + 2]
    assert first.split()[:2] == ["2", "0"]
    lines = stoss.run(PAIR).stdout.splitlines()
    assert [line.split()[0] for line in lines[-11:-9]] == ["body", "second"]
    assert {mode["body"] for mode in json.loads(stoss.run(PAIR, "--format json").stdout)["modes"]} == {"first", "second"}
    rigid = "--body sphere --poisson 0.3 --rigid-body --speed 0.1 --against half-space --cutoff 12"
    assert "most energetic" not in stoss.run("impact", rigid).stdout  # waves of a half-space are none


def test_a_trajectory_is_that_of_the_impact(stoss, tmp_path):
    path = tmp_path / "t.csv"
    (record,) = stoss.data(PAIR, f"--step 0.005 --every 5 --trajectory {path}")
    instants = rows(path.read_text())
    times = [number(row, "time") for row in instants]
    assert times == sorted(times) and times[0] == 0 and times[1] == pytest.approx(5 * 0.005)
    assert number(instants[0], "velocity") == 0.2
    assert number(instants[-1], "velocity") == pytest.approx(-0.2 * number(record, "restitution"), rel=1e-12)
    assert '# against: {"kind":"disk",' in path.read_text() and '"radius":2.0' in path.read_text()


def test_a_trajectory_has_the_units_of_its_inputs(stoss, tmp_path):
    path = tmp_path / "t.csv"
    words = f"impact --body sphere --material glass --radius 0.001 --speed 0.1 --cutoff 6 --quiet --trajectory {path}"
    assert stoss.run(words).returncode == 0
    *head, names, first = path.read_text().splitlines()[: path.read_text().count("\n# ") + 3]
    given = dict(line[2:].split(": ", 1) for line in head if ": " in line)
    assert float(given["speed[m/s]"]) == 0.1
    names = names.split(",")
    assert names[-5:] == ["time_si[s]", "center_si[m]", "velocity_si[m/s]", "force_si[N]", "contact_half_width_si[m]"]
    row = dict(zip(names, map(float, first.split(","))))
    assert row["velocity_si[m/s]"] == pytest.approx(0.1, rel=1e-12)
    for name, unit in (("center", "R"), ("time", "R/c")):
        si = f"{name}_si[{'m' if unit == 'R' else 's'}]"
        scale = 0.001 if unit == "R" else 0.001 * float(given["speed"]) / 0.1
        assert row[si] == pytest.approx(scale * row[f"{name}[{unit}]"], rel=1e-12)
    # Without a material there is nothing to be in SI.
    assert stoss.run(f"impact --body disk --poisson 0.33 --speed 0.1 --cutoff 6 --quiet --trajectory {path}").returncode == 0
    assert "_si" not in path.read_text()
