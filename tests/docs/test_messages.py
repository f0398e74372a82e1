"""docs/reference/messages.md lists what the command says: each of these lines gets a message of a row, and rows that some
line can get are got by one."""

import os
import re
import subprocess

import pytest
from conftest import ROOT, page

STOSS = os.environ.get("STOSS", str(ROOT / "build/release/cli/stoss"))
PAGE, _ = page("docs/reference/messages.md")
ROWS = [said for row in re.findall(r"^\| (`.*?`(?:, `.*?`)*) \|", PAGE, re.MULTILINE) for said in re.findall(r"`(.*?)`", row)]
BALL = "--body sphere --poisson 0.3"
GLASS = "--body sphere --material glass --radius 0.005"
LINES = f"""
restitution {BALL} --speed 2
restitution --body sphere --speed 0.1
restitution --body sphere --poisson 0.6 --speed 0.1
restitution --body sphere --material stel --radius 0.1 --speed 1
predict {BALL} --speed 0.1
restitution --body sphere --material glass --speed 1
restitution {GLASS} --speed 1 --against half-space
restitution {BALL} --speed 0.1 --against half-space,material=glass
restitution {BALL} --speed 0.1 --against disk
restitution {BALL} --speed 0.1 --against sphere,radius=50
restitution {BALL} --speed 0.1 --against plate
restitution {BALL} --speed 0.1 --rigid-body
oblique --body rod --speed 0.1 --tangential 0.1 --friction 0.1
bounce {BALL} --speed 0.1 --count 3
restitution {BALL} --speed 0.001 --tolerance 1e-7 --absolute 0
restitution --body rod --speed 0.1
quasistatic --body disk --poisson 0.33 --speed 0.1
restitution --body sphere --material bearing_steel --radius 0.005 --speed 1
predict --body sphere --material bearing_steel --radius 0.005 --speed 1 --against same
predict --body sphere --material ice --radius 1e-6 --speed 1 --against same
predict --body sphere --material alumina --radius 0.005 --speed 1 --against same
restitution {GLASS} --speed 1
restitution --radius 0.01 --material glass --speed 1 --tolerance 0.05 --against plate,thickness=0.003,material=glass
restitution --body sphere --material granite --radius 1 --speed 1
restitution {BALL} --speed 0.3
oblique --body sphere --poisson 0.49 --speed 0.05 --tangential 0.02 --spin 0.1 --friction 1
oblique {BALL} --speed 0.01 --angle 1 --friction 0.1
restitution {BALL} --speed 0.5 --against plate,thickness=0.1
restitution --body @nofile.json --speed 1
""".strip().splitlines()
# Made by files, other programs, long runs or Python.
ELSEWHERE = ("poisson: missing", "body format", "Python package", "another process has", "oblique: at speed")


def pattern(row):
    return ".*".join(map(re.escape, row.split("…")))


@pytest.fixture(scope="module")
def said():
    def run(line):
        words = [word.replace("bearing_steel", "bearing steel") for word in line.split()]
        return subprocess.run([STOSS, *words], capture_output=True, text=True, timeout=120).stderr

    return {line: run(line) for line in LINES}


def test_what_is_said_is_in_the_page(said):
    assert not [line for line, text in said.items() if not any(re.search(pattern(row), text) for row in ROWS)]


def test_rows_are_said(said):
    text = "\n".join(said.values())
    assert len(ROWS) > 30
    assert not [row for row in ROWS if not row.startswith(ELSEWHERE) and not re.search(pattern(row), text)]
