"""What the subcommands compute and how they write it; the manual explains every key."""

import json
import math
import re
from pathlib import Path

import pytest
from conftest import rows


@pytest.mark.parametrize("subcommand", ["", "modes", "impact", "restitution", "bounce", "quasistatic"])
def test_help_has_units_and_an_example(stoss, subcommand):
    result = stoss.run(subcommand, "--help")
    assert result.returncode == 0
    assert result.stderr == ""
    if subcommand:
        assert "Example" in result.stdout
        assert f"stoss {subcommand}" in result.stdout
        assert "(default:" in result.stdout
    else:
        assert "Exit codes" in result.stdout
    assert max(map(len, result.stdout.splitlines())) <= 100


def test_modes_are_the_reference(stoss):
    modes = stoss.data("modes --body disk --poisson 0.3 --cutoff 3")
    lowest = min(modes, key=lambda mode: float(mode["omega[c/R]"]))
    assert (lowest["order"], lowest["index"], lowest["family"]) == ("2", "0", "radial")
    assert math.isclose(float(lowest["omega[c/R]"]), 1.45465510, abs_tol=5e-9)
    assert math.isclose(float(lowest["radial"]), 1.392441, abs_tol=5e-7)
    assert math.isclose(float(lowest["tangential"]), -0.435470, abs_tol=5e-7)


def test_number_of_modes(stoss):
    assert len(stoss.data("modes --body disk --poisson 0.33 --cutoff 25")) == 295


def test_csv_has_provenance_and_units(stoss):
    text = stoss.run("impact --body disk --poisson 0.33 --speed 0.1 --cutoff 12.5 --format csv").stdout
    head = [line for line in text.splitlines() if line.startswith("#")]
    assert re.fullmatch(r"# stoss \d+\.\d+\.\d+: impact", head[0])
    assert head[1] == "# command: stoss impact --body disk --poisson 0.33 --speed 0.1 --cutoff 12.5 --format csv"
    assert "# against: wall" in head
    (row,) = rows(text)
    assert {"speed[c]", "contact_time[R/c]", "max_force[piRE]", "max_compression[R]"} <= set(row)


def test_si_material(stoss):
    steel = "--body disk --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01"
    (row,) = stoss.data(f"restitution {steel} --speed 10")
    c = math.sqrt(2.1e11 / 7850)
    assert float(row["speed_si[m/s]"]) == pytest.approx(10, rel=1e-14)
    assert float(row["speed[c]"]) == pytest.approx(10 / c, rel=1e-14)
    assert float(row["contact_time_si[s]"]) == pytest.approx(float(row["contact_time[R/c]"]) * 0.01 / c, rel=1e-14)
    (plain,) = stoss.data(f"restitution --body disk --poisson 0.3 --speed {float(row['speed[c]'])!r}")
    assert plain["restitution"] == row["restitution"]


def test_plane_strain(stoss):
    solid = "--body disk --poisson 0.25 --young 1e10 --density 2500 --radius 1"
    c = math.sqrt(1e10 / (1 - 0.25**2) / 2500)
    (strain,) = stoss.data(f"restitution {solid} --plane strain --speed {0.1 * c!r}")
    (plane,) = stoss.data(f"restitution --body disk --poisson {0.25 / 0.75!r} --speed 0.1")
    assert float(strain["restitution"]) == pytest.approx(float(plane["restitution"]), abs=1e-12)


def test_exponential_wall(stoss):
    (row,) = stoss.data("impact --body disk --poisson 0.33 --speed 0.1 --against exponential,hardness=500 --cutoff 25")
    assert float(row["lost_fraction"]) == pytest.approx(0.099881, abs=3e-5)


def test_static_tail(stoss):
    (row,) = stoss.data("impact --body disk --poisson 0.33 --speed 0.1 --tail static --cutoff 25 --step 0.02")
    assert float(row["lost_fraction"]) == pytest.approx(0.1009, abs=2e-4)
    assert row["unresolved"] == "0"


def test_impact_json_has_every_mode(stoss):
    document = json.loads(stoss.run("impact --body disk --poisson 0.33 --speed 0.1 --cutoff 25 --format json").stdout)
    (record,) = document["records"]
    assert len(document["modes"]) == record["modes"] == 295
    after = sum(mode["after"] for mode in document["modes"])
    assert after == pytest.approx(record["vibration"], rel=1e-12)
    ledger = record["translation"] + record["vibration"] + record["unresolved"]
    assert ledger == pytest.approx(1 - record["energy_error"], abs=1e-12)


def test_impact_table_ranks_the_quadrupole_first(stoss):
    lines = stoss.run("impact --body disk --poisson 0.33 --speed 0.1").stdout.splitlines()
    first = lines[lines.index("most energetic modes (shares of the initial energy)") + 2]
    assert first.split()[:2] == ["2", "0"]


def test_trajectory(stoss, tmp_path):
    path = tmp_path / "t.csv"
    result = stoss.run(f"impact --body disk --poisson 0.33 --speed 0.1 --cutoff 12.5 --every 5 --format csv --trajectory {path}")
    assert result.returncode == 0
    (record,) = rows(result.stdout)
    instants = rows(path.read_text())
    times = [float(row["time[R/c]"]) for row in instants]
    assert times == sorted(times) and times[0] == 0
    assert times[1] == pytest.approx(5 * float(record["step[R/c]"]))
    assert float(instants[0]["velocity[c]"]) == 0.1
    assert float(instants[-1]["velocity[c]"]) == pytest.approx(-0.1 * float(record["restitution"]), rel=1e-12)
    for row in instants:
        energy = sum(float(row[key]) for key in ("translation", "vibration", "stored", "unresolved"))
        assert energy == pytest.approx(1, abs=2e-3)


MANUAL = Path(__file__).resolve().parents[2] / "cli/stoss.1.in"
SUMMARY = {f"{name}_{kind}_error" for name in ("restitution", "lost_fraction") for kind in ("statistical", "numerical")}
QUANTITIES = {"energy_error", "momentum_error", *SUMMARY}
EVERYWHERE = {"poisson", "speed"}  # explained as options


def keys(value):
    """All keys of nested records, without what _si and _error add."""
    if isinstance(value, list):
        return {key for each in value for key in keys(each)}
    if not isinstance(value, dict):
        return set()
    here = {key if key in QUANTITIES else re.sub(r"(_si)?(_error)?$", "", key) for key in value}
    return here | keys(list(value.values()))


@pytest.mark.parametrize(
    "arguments",
    [
        "restitution --body disk --poisson 0.33 --speed 0.1",
        "impact --body disk --poisson 0.33 --speed 0.1 --cutoff 12",
        "bounce --body disk --poisson 0.33 --speed 0.1 --count 2 --flight-time 9 --cutoff 12",
        "distribution --body disk --poisson 0.33 --speed 0.1 --temperature 0.1 --samples 1",
        "quasistatic --body disk --poisson 0.33 --speed 1e-3",
        "quasistatic --body disk --poisson 0.33 --compression 0.01",
        "quasistatic --body sphere --poisson 0.3 --young 1e9 --density 1e3 --radius 1 --yield 1e6 --speed 0.1",
        "quasistatic --body sphere --poisson 0.3 --compression 0.01",
        "modes --body disk --poisson 0.33 --cutoff 3",
        "table --body disk --poisson 0.33 --speed 0.1:0.2",
        "modes --body sphere --poisson 0.3 --cutoff 3",
        "impact --body sphere --poisson 0.3 --young 1e9 --density 1e3 --radius 1 --yield 1e6 --speed 1 --cutoff 12",
    ],
)
def test_every_key_is_explained(stoss, arguments):
    document = json.loads(stoss.run(arguments, "--format json").stdout)
    words = set(re.findall(r"[a-z]+(?:_[a-z]+)*", MANUAL.read_text(encoding="utf-8").replace("\\f", " ")))
    found = keys([document["records"], document.get("modes", []), document.get("summary", {})])
    assert found and found - EVERYWHERE <= words
