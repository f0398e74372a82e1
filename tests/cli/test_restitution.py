"""stoss restitution: its values, its rows, its record of how they were reached."""

import json
import math

import pytest
from conftest import rows

pytestmark = pytest.mark.numbers

KEYS = (
    "poisson speed restitution restitution_error lost_fraction lost_fraction_error contact_time contact_time_error "
    "impulse_time impulse_time_error max_compression max_compression_error max_force max_force_error "
    "lost_to_first lost_to_second dissipated cutoff modes runs steps energy_error converged stays strain "
    "beyond_small_strain"
).split()
RUN_KEYS = (
    "cutoff step nodes lost_fraction dissipated unresolved contact_time impulse_time max_force max_compression energy_error steps"
).split()
SERIES = "restitution --body disk --poisson 0.33 --speed"


def test_restitution_is_the_reference_within_its_error(stoss):
    (row,) = stoss.data("restitution --body disk --poisson 0.33 --speed 0.1")
    assert abs(float(row["restitution"]) - 0.94706) <= float(row["restitution_error"]) + 1e-5
    assert row["converged"] == "true"
    assert row["beyond_small_strain"] == "false"


def test_error_is_within_the_default_tolerance(stoss):
    for row in stoss.data("restitution --body disk --poisson 0.33 --speed log:1e-6:0.3:6"):
        assert float(row["lost_fraction_error"]) <= 1e-3 * float(row["lost_fraction"])


def test_smaller_tolerance_takes_more_and_stays_within_the_error(stoss):
    rough, fine = (stoss.data(f"restitution --body disk --poisson 0.33 --speed 0.1 --tolerance {t}")[0] for t in (1e-2, 1e-4))
    assert int(fine["steps"]) > int(rough["steps"]) and int(fine["runs"]) > int(rough["runs"])
    for key in ("restitution", "lost_fraction", "contact_time[R/c]", "max_compression[R]", "max_force[piRE]"):
        name, bracket, unit = key.partition("[")
        error = float(rough[f"{name}_error{bracket}{unit}"])
        assert error > float(fine[f"{name}_error{bracket}{unit}"])
        assert abs(float(rough[key]) - float(fine[key])) <= error


def test_formats_agree(stoss):
    arguments = "restitution --body disk --poisson 0.33 --speed 0.05,0.2"
    table = stoss.data(arguments)
    document = json.loads(stoss.run(arguments, "--format json").stdout)
    assert document["schema"] == "stoss/restitution/2"
    assert document["complete"] is True
    assert document["inputs"]["first"] == {"kind": "disk", "poisson": 0.33}
    assert document["inputs"]["speed"] == "0.05,0.2"
    assert document["inputs"]["tolerance"] == 0.001 and document["inputs"]["absolute"] == 1e-6
    assert document["units"]["contact_time"] == document["units"]["contact_time_error"] == "R/c"
    assert document["command"].startswith("stoss restitution --body disk --poisson 0.33")
    assert [list(record) for record in document["records"]] == 2 * [KEYS + ["ledger"]]
    assert [key.partition("[")[0] for key in table[0]] == KEYS
    for row, record in zip(table, document["records"], strict=True):
        assert int(row["runs"]) == len(record["runs"])
        for column, cell in row.items():
            key = column.partition("[")[0]
            if key != "runs":
                assert json.loads(cell) == record[key]


def test_json_tells_how_the_value_was_reached(stoss):
    document = json.loads(stoss.run("restitution --body disk --poisson 0.33 --speed 0.1 --format json").stdout)
    (record,) = document["records"]
    runs = record["runs"]
    assert [list(run) for run in runs] == len(runs) * [RUN_KEYS]
    cutoffs = [run["cutoff"] for run in runs]
    assert len(runs) >= 3 and cutoffs == sorted(cutoffs)
    for key in ("cutoff", "contact_time", "impulse_time", "max_force", "max_compression", "energy_error"):
        assert runs[-1][key] == record[key]
    assert sum(run["steps"] for run in runs) == record["steps"]
    ledger = record["ledger"]
    assert list(ledger) == ["translation", "vibration", "dissipated", "unresolved", "stored"]
    assert sum(ledger.values()) == pytest.approx(1 - record["energy_error"], abs=1e-12)
    assert ledger["translation"] == pytest.approx(1 - runs[-1]["lost_fraction"], rel=1e-12)


def test_series(stoss):
    logarithmic = [float(row["speed[c]"]) for row in stoss.data(f"{SERIES} log:0.01:0.16:5")]
    assert logarithmic == pytest.approx([0.01, 0.02, 0.04, 0.08, 0.16], rel=1e-14)
    linear = [float(row["speed[c]"]) for row in stoss.data(f"{SERIES} lin:0.1:0.3:3")]
    assert linear == pytest.approx([0.1, 0.2, 0.3], rel=1e-14)


def test_each_poisson_number_with_all_speeds(stoss):
    table = stoss.data("restitution --body disk --poisson -0.5,0.33 --speed 0.1,0.05,0.1")
    got = [(float(row["poisson"]), float(row["speed[c]"])) for row in table]
    assert got == [(poisson, speed) for poisson in (-0.5, 0.33) for speed in (0.1, 0.05, 0.1)]
    assert table[0] == table[2]
    (alone,) = stoss.data("restitution --body disk --poisson 0.33 --speed 0.05")
    assert alone["restitution"] == table[4]["restitution"]
    series = stoss.data("restitution --body disk --poisson lin:-0.9:0.9:3 --speed 0.1")
    assert [float(row["poisson"]) for row in series] == pytest.approx([-0.9, 0, 0.9])


def test_more_speeds_than_the_core_gets_at_once(stoss):
    speeds = [float(row["speed[c]"]) for row in stoss.data(f"{SERIES} lin:0.1:0.2:1030 --tolerance 0.05")]
    assert len(speeds) == 1030 and speeds == sorted(speeds)


def test_result_does_not_depend_on_threads(stoss):
    arguments = "restitution --body disk --poisson 0.33 --speed log:0.01:0.3:7 --threads"
    one, eight = (stoss.data(f"{arguments} {threads}") for threads in (1, 8))
    assert one == eight


def test_si_errors_have_their_units(stoss):
    (row,) = stoss.data("restitution --body disk --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01 --speed 10")
    c = math.sqrt(2.1e11 / 7850)
    time, force = 0.01 / c, math.pi * 0.01 * 2.1e11
    for key, unit, si_unit, scale in [
        ("contact_time", "R/c", "s", time),
        ("max_force", "piRE", "N/m", force),
        ("max_compression", "R", "m", 0.01),
    ]:
        error = float(row[f"{key}_error[{unit}]"]) * scale
        assert float(row[f"{key}_si_error[{si_unit}]"]) == pytest.approx(error, rel=1e-14)


def test_speed_beyond_small_strain_is_flagged(stoss):
    result = stoss.run("restitution --body disk --poisson 0.33 --speed 0.1,0.7 --format csv", strain=True)
    assert result.returncode == 0
    assert [row["beyond_small_strain"] for row in rows(result.stdout)] == ["false", "true"]
    assert "above 0.1: linear elasticity is no longer accurate" in result.stderr
    assert f"strain of some {float(rows(result.stdout)[1]['strain']):.3g}," in result.stderr
    assert stoss.run("restitution --body disk --poisson 0.33 --speed 0.7 --quiet").stderr == ""


PAPER = "restitution --body sphere --poisson 0.3 --young 2e11 --density 7850 --radius 0.005 --speed 1.6 --against plate"


@pytest.mark.parametrize("under", ["", "/thickness=0.05,young=2e11,poisson=0.3,density=7850"])
def test_a_sheet_of_paper_is_strained_too_much(stoss, under):
    result = stoss.run(f"{PAPER},thickness=1e-4,young=3e9,density=800,poisson=0.3{under} --format csv", strain=True)
    (row,) = rows(result.stdout)
    assert row["beyond_small_strain"] == "true" and "linear elasticity" in result.stderr
    assert stoss.data(f"{PAPER},thickness=0.02,young=2e11,density=7850")[0]["beyond_small_strain"] == "false"


@pytest.mark.parametrize("form", ["table", "csv", "json"])
def test_not_converged_is_marked_told_and_exits_with_1(stoss, form):
    result = stoss.run(f"restitution --body disk --poisson 0.33 --speed 0.1 --tolerance 1e-12 --absolute 0 --format {form}")
    assert result.returncode == 1
    why, summary = result.stderr.splitlines()
    assert why.startswith("stoss: warning: poisson 0.33, speed 0.1 c: ") and "tolerance" in why
    assert summary.startswith("stoss: warning: 1 of 1 values")
    if form == "table":
        assert "0.94705" in result.stdout and " !" in result.stdout
        assert max(map(len, result.stdout.splitlines())) <= 80
        return
    (record,) = rows(result.stdout) if form == "csv" else json.loads(result.stdout)["records"]
    assert record["converged"] == ("false" if form == "csv" else False)
    error = float(record["lost_fraction_error"])
    assert 1e-12 * float(record["lost_fraction"]) < error < 1e-4
    assert abs(float(record["restitution"]) - 0.94706) < 1e-5 + error
    if form == "json":
        assert record["reason"] in why


def test_rows_after_one_that_does_not_converge(stoss):
    tolerance = 1e-3  # between what the two can reach
    result = stoss.run(f"restitution --body disk --poisson=-0.95 --speed 1,0.01 --tolerance {tolerance} --format csv")
    assert [row["converged"] for row in rows(result.stdout)] == ["false", "true"]
    for row in rows(result.stdout):
        within = float(row["lost_fraction_error"]) <= tolerance * float(row["lost_fraction"])
        assert row["converged"] == str(within).lower()
    assert result.returncode == 1
    assert "1 of 2 values" in result.stderr
