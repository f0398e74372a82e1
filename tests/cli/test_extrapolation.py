"""stoss restitution --method extrapolate: the paper's two extrapolations."""

import json
import signal
import subprocess

import pytest
from conftest import rows, wait_for_rows

pytestmark = pytest.mark.numbers

EXTRAPOLATED = (
    "poisson speed restitution restitution_error lost_fraction lost_fraction_error impacts steps"
).split()
ONE = "restitution --method extrapolate --poisson 0.33 --speed 0.1"
MANY = "restitution --method extrapolate --poisson 0.33 --speed lin:0.1:0.2:3"


def test_meets_the_hard_wall_within_its_error(stoss):
    (row,) = stoss.data(ONE)
    (hard,) = stoss.data("restitution --poisson 0.33 --speed 0.1")
    assert [key.partition("[")[0] for key in row] == EXTRAPOLATED
    for key in ("restitution", "lost_fraction"):
        assert abs(float(row[key]) - float(hard[key])) <= float(row[f"{key}_error"])
    assert int(row["steps"]) > int(hard["steps"])


def test_json_has_every_impact_and_the_intercepts(stoss):
    document = json.loads(stoss.run(f"{ONE} --format json").stdout)
    assert document["schema"] == "stoss/extrapolation/2"
    assert document["inputs"]["method"] == "extrapolate"
    assert "tolerance" not in document["inputs"]
    (record,) = document["records"]
    assert list(record) == EXTRAPOLATED + ["hard_wall"]
    impacts = record["impacts"]
    assert sum(impact["steps"] for impact in impacts) == record["steps"]
    assert all(list(impact) == ["cutoff", "modes", "hardness", "lost_fraction", "steps"] for impact in impacts)
    hard_wall = record["hard_wall"]
    cutoffs = sorted({impact["cutoff"] for impact in impacts})
    assert [limit["cutoff"] for limit in hard_wall] == cutoffs
    for limit in hard_wall:
        series = [impact for impact in impacts if impact["cutoff"] == limit["cutoff"]]
        assert {impact["modes"] for impact in series} == {limit["modes"]}
        assert max(impact["lost_fraction"] for impact in series) < limit["lost_fraction"]


def test_table_fits_80_columns(stoss):
    lines = stoss.run(ONE).stdout.splitlines()
    assert lines[0].split() == ["poisson", "speed", "restitution", "lost_fraction", "impacts"]
    assert max(map(len, lines)) <= 80


def test_material(stoss):
    result = stoss.run(
        "restitution --method extrapolate --poisson 0.3 --young 1e6 --density 1e3 --radius 1 --speed 3 --format csv"
    )
    (row,) = rows(result.stdout)
    assert float(row["speed_si[m/s]"]) == pytest.approx(3, rel=1e-14)


@pytest.mark.parametrize(
    "more, name",
    [
        ("--tolerance 1e-3", "tolerance"),
        ("--threads 1", "threads"),
        ("--speed 1e-4", "speed"),
        ("--speed 0.6", "speed"),
    ],
)
def test_what_it_does_not_take(stoss, tmp_path, more, name):
    path = tmp_path / "precious"
    path.write_text("precious")
    base = ONE if name != "speed" else ONE.replace("--speed 0.1", "")
    result = stoss.run(base, more, f"-o {path}")
    assert result.returncode == 3
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: got ") and "allowed" in line and "extrapolate" in line
    assert path.read_text() == "precious"


@pytest.fixture(scope="module")
def many(stoss):
    return stoss.run(MANY, "--format csv").stdout


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
def test_interrupt_and_resume(stoss, tmp_path, many, number):
    path = tmp_path / "curve.csv"
    command = stoss.start(f"{MANY} --format csv -o {path}", stderr=subprocess.PIPE)
    wait_for_rows(command, path, 1)
    command.send_signal(number)
    assert command.wait(timeout=30) == (130 if number == signal.SIGINT else -number)
    before = len(rows(path.read_text()))
    assert 1 <= before < 3
    assert path.read_text().endswith("missing\n") == (number == signal.SIGINT)
    result = stoss.run(MANY, f"--resume {path}")
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    assert rows(path.read_text()) == rows(many)
    other = stoss.run(MANY.replace("extrapolate", "converge"), f"--resume {path}")
    assert other.returncode == 3
    assert "kind of result: got restitution, allowed extrapolation" in other.stderr
