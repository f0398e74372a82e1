"""`stoss calibrate`: what the package says, in words, as JSON, as CSV and as a page, and what it refuses."""

import csv
import json
import os
import subprocess

import pytest
import stoss

BALL = "--body sphere --material glass --radius 0.008"


@pytest.fixture
def calibrate(tmp_path):
    """Runs the command on rows of data."""

    def run(rows, words, code=0):
        (tmp_path / "data.csv").write_text("\n".join(rows) + "\n")
        words = [os.environ["STOSS"], "calibrate", "data.csv", *BALL.split(), *words.split()]
        done = subprocess.run(words, capture_output=True, text=True, cwd=tmp_path, timeout=60)
        assert done.returncode == code, done.stderr
        return done.stdout if code == 0 else done.stderr

    return run


DROPS = ["speed,restitution,restitution_uncertainty", "0.5,0.975,0.001", "1,0.974,0.001"]


def test_all_forms_say_the_same(calibrate, tmp_path):
    glass = stoss.Sphere(radius=0.008, material=stoss.materials["glass"])
    data = {"speed": [0.5, 1.0], "restitution": [0.975, 0.974], "restitution_uncertainty": [1e-3, 1e-3]}
    known = stoss.calibrate(data, glass, unknown="quality")
    assert calibrate(DROPS, "--unknown quality") == f"{known}\n"
    told = json.loads(calibrate(DROPS, "--unknown quality --format json"))
    assert told["constants"][0]["value"] == known.constants[0].value
    assert told["encounter"]["first"]["material"]["quality"] == known.constants[0].value
    calibrate(DROPS, "--unknown quality --format csv -o values.csv --report page.html")
    lines = [line for line in (tmp_path / "values.csv").read_text().splitlines() if not line.startswith("#")]
    assert [float(row["fitted"]) for row in csv.DictReader(lines)] == known.fitted.tolist()
    assert "<h1>" in (tmp_path / "page.html").read_text()


def test_two_alike_change_together(calibrate):
    told = json.loads(calibrate(DROPS, "--against same --unknown quality=40 --format json"))
    assert told["against"] == "same"
    assert told["encounter"]["against"] == "same"


def test_options_reach_the_package(calibrate):
    heights = ["drop_height,rebound_height,rebound_height_uncertainty", "1,0.8,0.01"]
    with_air = json.loads(calibrate(heights, "--unknown quality --format json"))
    without = json.loads(calibrate(heights, "--unknown quality --without-air --format json"))
    assert with_air["constants"][0]["value"] > without["constants"][0]["value"]
    held = json.loads(
        calibrate(DROPS, "--unknown quality --uncertainty young=0.5 --format json --against half-space,material=glass")
    )
    assert held["constants"][0]["by_constants"] > 0.0


@pytest.mark.parametrize(("rows", "words", "code", "said"), [
    (DROPS, "--unknown hardness", 3, "unknown"),
    (DROPS, "", 2, "--unknown is required"),
    (DROPS, "--unknown quality=x", 3, "unknown quality"),
    (DROPS, "--unknown quality --unknown quality", 3, "each name once"),
    (DROPS, "--unknown quality --uncertainty young", 3, "young=0.05"),
    (DROPS, "--unknown quality --friction 9", 3, "friction"),
    (DROPS, "--unknown quality -o /nowhere/x", 4, "/nowhere/x"),
    (["speed,restitution", "1,1.5"], "--unknown quality", 3, "restitution: got 1.5"),
    (["a,b", "1,2"], "--unknown quality", 3, "data"),
])  # fmt: skip
def test_one_line_says_what_is_wrong(calibrate, rows, words, code, said):
    error = calibrate(rows, words, code)
    assert said in error
    assert error.count("\n") == 1
