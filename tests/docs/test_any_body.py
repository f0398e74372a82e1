"""What docs/tutorials/cad.md, docs/understand/findings/any_body.md and docs/developer/bodies.md
print and tell of the bodies in examples/any_body is what the command says of them."""

import os
import re
import shlex
import subprocess

import pytest
from conftest import ROOT, command, page, with_error

PAGE = "".join(page(f"docs/{name}.md")[0] for name in ("tutorials/cad", "understand/findings/any_body", "developer/bodies"))
BODIES = ROOT / "examples/any_body"


def lost(arguments):
    """1 − ε² with its error."""
    (row,) = command(f"restitution --tolerance 0.4 {arguments}")
    return row["lost_fraction"], row["lost_fraction_error"]


def test_command_prints_what_the_page_shows():
    words = re.search(r"stoss (restitution --body sphere .*?)\n```", PAGE, re.DOTALL)[1].replace("\\\n", " ")
    found = subprocess.run([os.environ["STOSS"], *shlex.split(words)], capture_output=True, text=True, timeout=60, cwd=BODIES)
    assert found.stdout.rstrip() in PAGE


@pytest.mark.parametrize("place", [0, 30, 55, 95])
def test_sweet_spot(place):
    struck = f"--body sphere --radius 0.005 --material 'bearing steel' --against @{BODIES}/beam_{place}.json"
    slow, fast = (lost(f"{struck} --speed {speed}") for speed in (0.05, 0.5))
    assert f"| {place} mm | {with_error(*slow)} | {with_error(*fast)} |" in PAGE


def test_bars_and_balls():
    names = ("bar", "hollow_sphere", "hollow_sphere_mesh", "sphere")
    bar, hollow, meshed, sphere = (f"--body @{BODIES}/{name}.json" for name in names)
    assert lost(f"{bar} --against same --speed 0.05") == pytest.approx((2.362e-4, 0.029e-4), rel=0.1)
    assert lost(f"{bar} --against same --speed 5") == pytest.approx((2.533e-2, 0.0119e-2), rel=0.1)
    exact = lost(f"{hollow} --speed 0.5")
    assert exact == pytest.approx((7.625e-4, 1.7e-6), rel=0.1) and "7.625(17)·10⁻⁴" in PAGE
    of_mesh = lost(f"{meshed} --speed 0.5")
    assert of_mesh == pytest.approx((7.5e-4, 2.3e-4), rel=0.1) and "7.5(23)·10⁻⁴" in PAGE
    assert abs(of_mesh[0] - exact[0]) < of_mesh[1]
    assert lost(f"{sphere} --speed 5") == pytest.approx((2.35e-4, 0.151e-4), rel=0.1) and "2.35(15)·10⁻⁴" in PAGE


def test_plate_of_sixty_thicknesses():
    """It is the infinite plate until its rim echoes, within an error of a tenth of the loss at most."""
    ball = "--body sphere --radius 0.01 --material 'structural steel' --speed 0.05"
    (infinite,) = command(f"restitution {ball} --against 'plate,thickness=0.005,material=structural steel' --tolerance 0.01")
    (finite,) = command(f"restitution {ball} --against @{BODIES}/plate.json --tolerance 0.05")
    off = abs(finite["lost_fraction"] - infinite["lost_fraction"])
    assert off < finite["lost_fraction_error"] < 0.1 * finite["lost_fraction"]
    assert finite["contact_time_si"] == pytest.approx(infinite["contact_time_si"], rel=0.02)
    assert f"{finite['lost_fraction']:.3f}({1e3 * finite['lost_fraction_error']:.0f}) of its energy" in PAGE
    assert f"{infinite['lost_fraction']:.6f}(2)" in PAGE
