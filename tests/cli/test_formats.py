"""Each format that the command writes is named with its version, as docs/versions.md says, and a later one is refused."""

import csv
import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs/versions.md").read_text(encoding="utf-8").partition("## Formats")[2]
FORMATS = {row.split("|")[1].strip(): row.split("|")[2].strip(" `") for row in re.findall(r"^\| .*$", PAGE, re.M)[1:]}
COARSE = "--speed 0.1 --tolerance 0.05"
SPHERE = "--body sphere --poisson 0.3"
KINDS = {
    "modes": "modes --body disk --poisson 0.33 --cutoff 3",
    "impact": "impact --body disk --poisson 0.33 --speed 0.1 --cutoff 6",
    "bounce": "bounce --body disk --poisson 0.33 --speed 0.1 --cutoff 6 --count 2 --flight-time 10",
    "restitution": f"restitution --body disk --poisson 0.33 {COARSE}",
    "oblique": f"oblique {SPHERE} --speed 0.01 --friction 0.1 --tangential 0.002",
    "distribution": "distribution --body disk --poisson 0.33 --speed 0.1 --spectrum 2,0,energy=0.1 --samples 2",
    "quasistatic": "quasistatic --body disk --poisson 0.33 --speed 1e-6",
    "predict": "predict --body sphere --material 'structural steel' --radius 0.005 --speed 1 --against half-space,material=glass",
    "materials": "materials",
    "table": "table --body disk --poisson 0.33 --speed 0.09:0.1 --error 0.05",
}


def version(stoss):
    return stoss.run("--version").stdout.split()[1]


@pytest.mark.parametrize("kind", KINDS)
def test_json_names_its_format(stoss, kind):
    document = json.loads(stoss.run(KINDS[kind], "--format json").stdout)
    assert document["schema"] == FORMATS["results in JSON"].replace("KIND", kind)
    assert document["version"] == version(stoss)


def test_these_are_all_kinds_of_json(stoss):
    listed = re.findall(r"^  ([a-z]+) ", stoss.run("--help").stdout.partition("Subcommands:")[2], re.MULTILINE)
    without = {"fit", "schema", "sweep", "merge"}  # which write lines for other programs, a schema, and what Python writes
    assert set(KINDS) == set(listed) - without


def test_csv_names_the_version_of_stoss(stoss):
    for kind in ("modes", "restitution"):
        first = stoss.run(KINDS[kind], "--format csv").stdout.splitlines()[0]
        assert first == f"# stoss {version(stoss)}: {kind}"


@pytest.mark.parametrize("kind", ["materials", "predict"])
def test_texts_with_commas_are_one_cell_of_csv(stoss, kind):
    lines = [line for line in stoss.run(KINDS[kind], "--format csv").stdout.splitlines() if not line.startswith("#")]
    names, *rows = csv.reader(lines)
    assert rows and all(len(row) == len(names) for row in rows)


def test_a_header_in_c_names_the_version_of_stoss(stoss):
    comment = stoss.run(KINDS["table"]).stdout.partition("*/")[0]
    assert f"stoss {version(stoss)}" in comment


def test_two_columns_are_numbers_only(stoss):
    rows = stoss.run(KINDS["table"], "--format two-column").stdout.splitlines()
    assert all(len([float(cell) for cell in row.split()]) == 2 for row in rows)


def test_the_schema_has_the_version_in_its_name(stoss):
    schema = json.loads(stoss.run("schema").stdout)
    assert schema["$id"] == f"urn:{FORMATS['encounter'].replace(' ', ':')}"
    assert schema["properties"]["format"]["const"] == FORMATS["encounter"]
    assert schema["$defs"]["modal_body"]["properties"]["format"]["const"] == FORMATS["body by its modes"]


def test_a_later_body_file_is_refused(stoss, tmp_path):
    file = tmp_path / "later.json"
    file.write_text('{"format": "stoss modal body 2", "mass": 1}')
    done = stoss.run(f"restitution --body @{file} --speed 1")
    assert (done.returncode, done.stdout) == (3, "")
    assert 'got "stoss modal body 2", allowed "stoss modal body 1" (written by a later stoss)' in done.stderr


def test_a_file_of_another_stoss_is_not_continued(stoss, tmp_path):
    file = tmp_path / "rows.csv"
    words = f"restitution --body disk --poisson 0.33 {COARSE} --format csv"
    stoss.run(words, f"--resume {file}")
    file.write_text(file.read_text().replace(f"# stoss {version(stoss)}", "# stoss 99.0.0", 1))
    done = stoss.run(words, f"--resume {file}")
    assert done.returncode == 3 and "version of stoss: got" in done.stderr and "99.0.0" in done.stderr
