"""Limits and conventions that several pages state are those of the command: sizes, speeds, whose speed v is."""

import json
import os
import re
import subprocess

import pytest
from conftest import ROOT, page

STOSS = os.environ.get("STOSS", str(ROOT / "build/release/cli/stoss"))


def stoss(*arguments):
    return subprocess.run([STOSS, *" ".join(arguments).split()], capture_output=True, text=True, timeout=120)


def largest(command, kind):
    """The largest ratio of R/c that a refusal names; a body of that size is taken, one a little larger is refused."""
    said = re.search(r"at most (\d+) times", stoss(command, f"--against {kind},radius=1000").stderr)
    assert said, "a ratio of 1000 is refused, with the largest that is taken"
    beyond = stoss(command, f"--against {kind},radius={int(said[1]) + 1}")
    assert (beyond.returncode, beyond.stderr.count("\n")) == (3, 1) and f"at most {said[1]} times" in beyond.stderr
    assert stoss(command, f"--against {kind},radius={said[1]}").returncode in (0, 1)  # 1: not to its tolerance
    return int(said[1])


def test_ratios_of_size_are_those_that_the_pages_name():
    spheres = largest("restitution --body sphere --poisson 0.3 --speed 0.1 --tolerance 0.1", "sphere")
    at_an_angle = largest("oblique --body disk --poisson 0.3 --speed 0.1 --tangential 0.1 --friction 0.2 --tolerance 0.2", "disk")
    assert stoss("restitution --body disk --poisson 0.3 --speed 0.1 --against disk,radius=1000").returncode == 0
    _, words = page("docs/reference/limits.md")
    assert f"of two spheres, over that of the other | up to {spheres}" in words
    assert f"at an angle, over that of the other | up to {at_an_angle}" in words


@pytest.mark.parametrize("speed, code", [("1e-8", 0), ("0.99e-8", 3), ("1", 0), ("1.01", 3)])
def test_range_of_speeds_is_that_of_the_page(speed, code):
    assert "10⁻⁸ c to c" in page("docs/reference/limits.md")[1]
    assert stoss(f"impact --body disk --poisson 0.3 --cutoff 5 --speed {speed}").returncode == code


def test_v_of_the_results_is_the_speed_of_each_of_two_equal_bodies():
    row = re.search(r"^\| 0\.01 \|(.*)\|$", page("docs/understand/findings/oblique.md")[0], re.MULTILINE)[1].split("|")
    shown = float(row[2])  # x = 1
    for partner, factor in (("wall", 1), ("same", 2)):
        run = stoss(f"oblique --body sphere --poisson 0.3 --against {partner} --speed {0.01 * factor}",
                    f"--tangential {0.001 * factor} --friction 0.1 --format json")
        (record,) = json.loads(run.stdout)["records"]
        assert abs(record["tangential_restitution"] - shown) <= record["tangential_restitution_error"] + 5e-4


def test_friction_of_a_body_by_its_modes_needs_a_tangent():
    body = f"--body sphere --material glass --radius 0.005 --against @{ROOT}/examples/any_body/bar.json"
    refused = stoss(f"oblique {body} --speed 0.1 --tangential 0.1 --friction 0.1")
    assert refused.returncode == 3 and "tangent" in refused.stderr
    assert "`tangent`" in page("docs/tutorials/cad.md")[1] and "`tangent`" in page("docs/reference/limits.md")[1]


def test_programs_in_python_are_counted():
    count = len(list((ROOT / "examples").glob("[0-9]*.py")))
    assert f"has {count} short programs" in page("docs/reference/python.md")[1]
