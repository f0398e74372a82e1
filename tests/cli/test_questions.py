"""What every subcommand that answers has in common: forms of output, units, the manual, threads. What it answers is
compared with the library, quantity by quantity, in parts/test_answers.cpp."""

import csv
import json
import re
from pathlib import Path

import pytest
from conftest import rows

pytestmark = pytest.mark.numbers  # under sanitizers parts/test_answers.cpp asks the same

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs/developer/versions.md").read_text(encoding="utf-8").partition("## Formats")[2]
FORMATS = {row.split("|")[1].strip(): row.split("|")[2].strip(" `") for row in re.findall(r"^\| .*$", PAGE, re.M)[1:]}
MANUAL = (ROOT / "cli/stoss.1.in").read_text(encoding="utf-8")
WORDS = set(re.findall(r"[a-z]+(?:_[a-z]+)*", MANUAL.replace("\\f", " ")))

SPHERE, DISK = "--body sphere --poisson 0.3", "--body disk --poisson 0.33"
HOLLOW = "--body hollow-sphere --inner 0.9 --poisson 0.3"
BALL = "--body sphere --material 'structural steel' --radius 0.005"
PLATE = "--body disk --material brass --radius 0.01 --plane strain"
ROD = "--body rod --material brass --length 0.5 --area 1e-4 --against rod,material=glass,length=1,area=1e-4"
# By subcommand: what it is asked of whom.
CASES = {
    "modes": ("--cutoff 3", [DISK, SPHERE, HOLLOW, PLATE]),
    "impact": ("--speed 0.1 --cutoff 6", [DISK, SPHERE, f"{BALL} --against same", ROD]),
    "bounce": ("--speed 0.1 --cutoff 6 --count 2", [f"{DISK} --flight-time 10", f"{BALL} --gravity 9.81 --decay-time 1e-3"]),
    "restitution": ("--speed 0.1,0.2 --tolerance 0.1 --absolute 1e-3",
                    [DISK.replace("0.33", "0.33,0.3"), SPHERE, HOLLOW, f"{BALL} --against same", PLATE, ROD]),
    "oblique": ("--speed 0.1 --friction 0.1 --tolerance 0.3",
                [f"{SPHERE} --tangential 0.01,-0.02 --spin 0.01", f"{DISK} --angle 30,60", f"{BALL} --angle 0,30"]),
    "distribution": ("--speed 0.1 --samples 3 --error 0.1", [f"{DISK} --spectrum 2,0,energy=0.1", f"{BALL} --temperature 0.01"]),
    "quasistatic": ("", [f"{DISK} --speed 1e-100,1e-6,0.1 --cutoff 9", f"{DISK} --compression 1e-12,0.1",
                         f"{SPHERE} --speed 1e-12,0.1 --cutoff 9", f"{SPHERE} --compression 1e-6,0.1",
                         f"{BALL} --speed 1e-8,1 --cutoff 9",
                         f"{SPHERE} --speed 1e-12,0.1 --against half-space", f"{BALL} --speed 1 --against half-space,material=glass", f"{PLATE} --compression 1e-12,1e-3"]),
    "predict": ("--speed 0.1,1 --tolerance 0.01", [f"{BALL} --against half-space,material=glass"]),
    "pulse": ("--speed 0.1 --tolerance 0.1", [DISK, SPHERE, PLATE, ROD]),
    "row": ("--speed 0.1 --tolerance 0.1 --count 2", [DISK, SPHERE, ROD.partition(" --against")[0], f"{BALL} --against half-space,material=glass"]),
    "materials": ("", [""]),
    "table": ("--speed 0.09:0.1 --error 0.05", [DISK]),
}  # fmt: skip
ALL = [(command, f"{asked} {who}") for command, (asked, bodies) in CASES.items() for who in bodies]
QUANTITIES = {"energy_error", "momentum_error"} | {
    f"{name}_{kind}_error" for name in ("restitution", "lost_fraction") for kind in ("statistical", "numerical")
}
EVERYWHERE = {"poisson", "speed", "young", "density", "name", "loss_time", "source", "strength_source", "surface_source", "uncertainties"}


def keys(value):
    """All keys of nested records, without what _si and _error add."""
    if isinstance(value, list):
        return {key for each in value for key in keys(each)}
    if not isinstance(value, dict):
        return set()
    here = {key if key in QUANTITIES else re.sub(r"(_si)?(_error)?$", "", key) for key in value}
    return here | keys(list(value.values()))


def version(stoss):
    return stoss.run("--version").stdout.split()[1]


def test_these_are_all_that_answer(stoss):
    listed = re.findall(r"^  ([a-z]+) ", stoss.run("--help").stdout.partition("Subcommands:")[2], re.MULTILINE)
    assert set(CASES) == set(listed) - {"fit", "calibrate", "relaxation", "schema", "sweep", "merge"}


@pytest.mark.parametrize("command, words", ALL)
def test_forms_agree(stoss, command, words):
    """JSON is complete, named and explained in the manual, CSV has the same rows, and tables fit a terminal."""
    done = stoss.run(command, words, "--format json --quiet")
    assert done.returncode in (0, 1), done.stderr
    document = json.loads(done.stdout)
    assert document["schema"] == FORMATS["results in JSON"].replace("KIND", command)
    assert (document["version"], document["complete"]) == (version(stoss), True)
    if command != "materials":
        found = keys([document["records"], document.get("modes", []), document.get("summary", {})])
        assert found and found - EVERYWHERE <= WORDS, found - EVERYWHERE - WORDS
    if command == "table":
        return
    text = stoss.run(command, words, "--format csv --quiet").stdout
    head = [line for line in text.splitlines() if line.startswith("#")]
    assert head[0] == f"# stoss {version(stoss)}: {command}" and head[1].startswith(f"# command: stoss {command} ")
    names, *table = csv.reader(line for line in text.splitlines() if not line.startswith("#"))
    if command in ("pulse", "row"):  # whose rows are the series that is in the one record
        assert len(table) == len(document["records"][0]["time" if command == "pulse" else "velocities"])
        assert max(map(len, stoss.run(command, words, "--quiet").stdout.splitlines())) <= 80
        return
    units = {name.partition("[")[0]: name[name.index("[") + 1 : -1] for name in names if "[" in name}
    assert units == document["units"]
    for row, record in zip(table, document["records"], strict=True):
        for name, cell in zip([name.partition("[")[0] for name in names], row, strict=True):
            told = record[name]
            if isinstance(told, list):  # what CSV only counts
                assert int(cell) == len(told)
            elif isinstance(told, (bool, str)):
                assert cell == (str(told).lower() if isinstance(told, bool) else told)
            else:
                assert (told is None and cell == "nan") or float(cell) == told
    shown = stoss.run(command, words, "--quiet").stdout.splitlines()
    assert command in ("bounce", "distribution") or max(map(len, shown)) <= 80


@pytest.mark.parametrize("command", ["restitution", "oblique", "distribution", "predict", "table"])
def test_threads_change_nothing(stoss, command):
    asked, bodies = CASES[command]
    one, three = (json.loads(stoss.run(command, asked, bodies[0], f"--format json --quiet --threads {threads}").stdout)
                  for threads in (1, 3))  # fmt: skip
    assert one["records"] == three["records"] != []


def test_a_format_is_named_with_its_version(stoss, tmp_path):
    """Each format is named with its version, and a later one is refused."""
    schema = json.loads(stoss.run("schema").stdout)
    assert schema["$id"] == f"urn:{FORMATS['encounter'].replace(' ', ':')}"
    assert schema["properties"]["format"]["const"] == FORMATS["encounter"]
    assert schema["$defs"]["modal_body"]["properties"]["format"]["const"] == FORMATS["body by its modes"]
    file = tmp_path / "later.json"
    file.write_text('{"format": "stoss modal body 2", "mass": 1}')
    done = stoss.run(f"restitution --body @{file} --speed 1")
    assert (done.returncode, done.stdout) == (3, "")
    assert 'got "stoss modal body 2", allowed "stoss modal body 1" (written by a later stoss)' in done.stderr


def test_rows_follow_all_combinations_in_order(stoss):
    table = stoss.data("restitution --body disk --poisson -0.5,0.33 --speed 0.1,0.05,0.1 --tolerance 0.1")
    got = [(float(row["poisson"]), float(row["speed[c]"])) for row in table]
    assert got == [(poisson, speed) for poisson in (-0.5, 0.33) for speed in (0.1, 0.05, 0.1)] and table[0] == table[2]
    motion = "--speed 0.05,0.01 --tangential lin:0:0.02:3 --spin -0.01,0.01 --tolerance 0.3"
    table = stoss.data(f"oblique {SPHERE} --friction 0.2 {motion}")
    got = [tuple(float(row[name]) for name in ("speed[c]", "tangential[c]", "spin[c/R]")) for row in table]
    assert got == [(v, t, w) for v in (0.05, 0.01) for t in (0, 0.01, 0.02) for w in (-0.01, 0.01)]


def test_fast_rows_are_flagged_and_warned_of(stoss):
    fast = stoss.run("restitution --body disk --poisson 0.33 --speed 0.1,0.7 --format csv", strain=True)
    assert [row["beyond_small_strain"] for row in rows(fast.stdout)] == ["false", "true"]
    assert f"strain of some {float(rows(fast.stdout)[1]['strain']):.3g}, above 0.1: linear elasticity is no" in fast.stderr
    turning = stoss.run(f"oblique {SPHERE} --friction 0.2 --speed 0.05 --tangential 0.5 --spin -0.5 --format csv --tolerance 0.1")
    (row,) = rows(turning.stdout)
    assert row["beyond_small_turn"] == "true" and f"turn by {float(row['turned']):.2g} rad" in turning.stderr
    bounced = stoss.run(f"bounce {SPHERE} --speed 0.05 --cutoff 6 --count 2 --flight-time 0.001 --format csv")
    assert rows(bounced.stdout)[1]["short_flight"] == "true" and "1 flights too short" in bounced.stderr
    slow = stoss.run("quasistatic --body disk --poisson 0.33 --speed 0.001,0.02,0.03,0.1")
    assert [" !" in line for line in slow.stdout.splitlines()[2:]] == [False, False, True, True]
    assert slow.stderr.startswith("stoss: warning: 2 of 4 rows beyond perturbation theory")
    block = stoss.run(f"quasistatic {SPHERE} --speed 0.01,0.1 --against half-space")
    assert [" !" in line for line in block.stdout.splitlines()[2:]] == [False, True]
    assert block.stderr.startswith("stoss: warning: 1 of 2 rows beyond perturbation theory (marked): lost_fraction is known no better")
    pressed = stoss.run(f"quasistatic {SPHERE} --compression 0.05,0.2")
    assert pressed.stderr.startswith("stoss: warning: 1 of 2 compressions above 0.1 R")
    table = stoss.run("table --body disk --poisson 0.33 --speed 0.6:0.7 --error 0.1", strain=True)
    assert table.returncode == 0 and "above 0.1: linear elasticity" in table.stderr


@pytest.mark.parametrize("form", ["table", "csv", "json"])
def test_what_is_not_accurate_enough_is_marked_told_and_exits_with_1(stoss, form):
    """And rows after it are computed."""
    result = stoss.run(f"restitution --body rod --against rod,length=2.5 --speed 0.1,0.2 --tolerance 1e-6 --format {form}")
    why, _, summary = result.stderr.splitlines()
    assert result.returncode == 1 and why.startswith("stoss: warning: speed 0.1 c: ")
    assert summary == "stoss: warning: 2 of 2 values not as accurate as asked for (marked)"
    if form == "table":
        assert [" !" in line for line in result.stdout.splitlines()[2:]] == [True, True]
    else:
        table = rows(result.stdout) if form == "csv" else json.loads(result.stdout)["records"]
        assert [str(row["converged"]).lower() for row in table] == ["false", "false"]
        assert form == "csv" or table[0]["reason"] in why
        return
    for other in (f"oblique {SPHERE} --friction 0.2 --speed 0.1 --tangential 0.02 --tolerance 1e-5",
                  "distribution --body rod --speed 0.1 --against rod,length=2.5 --temperature 0.1 --samples 1 --error 1e-5"):
        done = stoss.run(other)
        assert done.returncode == 1 and " !" in done.stdout and "1 of 1 values not as accurate" in done.stderr
